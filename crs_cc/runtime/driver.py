"""The module that runs one round of the whole fleet in one call from Python.

It holds the robots' `resume` functions in a table. `round()` resumes every robot from number
`current` on whose slot has `run` set. Its arguments and results are at the start of the mailbox
(`HEADER`), because a call without arguments costs Python a third of one with. `current` also
identifies the robot of a trap, which only a bug of ours or unchecked code can cause.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.requests import SLOT, slot_offset

HEADER: Final = np.dtype([("current", "<u4"), ("count", "<u4")])
CURRENT, COUNT = (int(HEADER.fields[name][1]) for name in HEADER.names)  # type: ignore[index,union-attr]
SLOTS: Final = SLOT.itemsize  # address of the first slot, after the header


def driver() -> bytes:
    """Return the driver of any fleet, in the binary format.

    The table is empty: the fleet grows it.
    """
    from crs_cc.runtime.wasm import Code, Module  # not needed if the driver is in the cache

    module = Module(
        functions=[Code("round", ((), ()), ["i32", "i32"], _round())],
        memory_imports=[("crs", "mailbox")],
        tables=[0],
        exports=[("round", "func", 0), ("robots", "table", 0)],
    )
    return module.to_binary()


def _round() -> list[tuple[object, ...]]:
    robot, slot = range(2)
    return [
        ("i32.const", 0), ("i32.load", 0, CURRENT), ("local.set", robot),
        ("block",), ("loop",),
        ("local.get", robot), ("i32.const", 0), ("i32.load", 0, COUNT), ("i32.ge_u",),
        ("br_if", 1),
        ("local.get", robot), ("i32.const", SLOT.itemsize), ("i32.mul",),
        ("i32.const", SLOTS), ("i32.add",), ("local.tee", slot),
        ("i32.load", 0, slot_offset("run")), ("if",),
        ("i32.const", 0), ("local.get", robot), ("i32.store", 0, CURRENT),
        ("local.get", slot), ("i32.const", 0), ("i32.store", 0, slot_offset("run")),
        ("local.get", slot), ("i32.const", 0), ("i32.store", 0, slot_offset("code")),
        ("local.get", slot),
        ("local.get", slot), ("local.get", robot), ("call_indirect", 0, 0),
        ("i32.store", 0, slot_offset("status")),
        ("local.get", slot), ("i32.load", 0, slot_offset("stopped")),
        ("if",), ("return",), ("end",),
        ("end",),
        ("local.get", robot), ("i32.const", 1), ("i32.add",), ("local.set", robot),
        ("br", 0), ("end",), ("end",),
    ]  # fmt: skip
