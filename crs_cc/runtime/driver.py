"""The module that runs one round of the whole fleet in one call from Python.

It holds the robots' `resume` functions in a table. `round(first, count)` resumes every robot from
`first` to `count` whose slot says so. Before each one it notes the robot's number at the start of
the mailbox, so that a trap, which only a bug of ours can cause, is blamed on the right robot.
"""

from __future__ import annotations

from typing import Final

from crs_cc.requests import SLOT
from crs_cc.runtime.function_code import slot_offset
from crs_cc.runtime.wasm import Code, Module

CURRENT: Final = 0  # address of the current robot's number
SLOTS: Final = SLOT.itemsize  # address of the first slot; what lies below is the driver's


def driver(robots: int) -> Module:
    """Gives the driver of a fleet of so many robots."""
    return Module(
        functions=[Code("round", (("i32", "i32"), ("i32",)), ["i32", "i32"], _round())],
        memory_imports=[("crs", "mailbox")],
        tables=[robots],
        exports=[("round", "func", 0), ("robots", "table", 0)],
    )


def _round() -> list[tuple[object, ...]]:
    robot, count, slot, resumed = range(4)
    return [
        ("block",), ("loop",),
        ("local.get", robot), ("local.get", count), ("i32.ge_u",), ("br_if", 1),
        ("local.get", robot), ("i32.const", SLOT.itemsize), ("i32.mul",),
        ("i32.const", SLOTS), ("i32.add",), ("local.tee", slot),
        ("i32.load", 0, slot_offset("run")), ("if",),
        ("i32.const", CURRENT), ("local.get", robot), ("i32.store", 0, 0),
        ("local.get", slot), ("i32.const", 0), ("i32.store", 0, slot_offset("run")),
        ("local.get", slot), ("i32.const", 0), ("i32.store", 0, slot_offset("code")),
        ("local.get", slot),
        ("local.get", slot), ("local.get", robot), ("call_indirect", 0, 0),
        ("i32.store", 0, slot_offset("status")),
        ("local.get", resumed), ("i32.const", 1), ("i32.add",), ("local.set", resumed),
        ("end",),
        ("local.get", robot), ("i32.const", 1), ("i32.add",), ("local.set", robot),
        ("br", 0), ("end",), ("end",),
        ("local.get", resumed),
    ]  # fmt: skip
