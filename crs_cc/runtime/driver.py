"""The module that runs one round of a fleet in one call from Python.

It holds the robots' `resume` functions in a table. `round()` resumes every robot whose slot has
`run` set: number `current`, and every `stride`th after it below `end`. Its arguments and results
are at the start of the mailbox, in a `HEADER` for each shard of the fleet, at the address in the
exported global `header`: a call without arguments is the cheapest for Python. `current` also
identifies the robot of a trap, which only a bug of ours or unchecked code can cause.

No two robots share a page, and most of a round of a large fleet is waiting for memory. So before a
batch of robots is resumed, their `prefetch` functions load what each will touch first: these loads
do not depend on one another, and the processor waits for them together. It halves the time of a
round of a thousand robots or more.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.requests import SLOT, slot_offset

HEADER: Final = np.dtype(
    {
        "names": ["current", "end", "stride", "loaded"],
        "formats": ["<u4", "<u4", "<u4", "<u4"],
        "itemsize": 64,  # a cache line: shards write theirs at the same time
    }
)
"""`loaded` receives what was prefetched, so that the loads are not optimised away."""
CURRENT, END, STRIDE, LOADED = (
    int(HEADER.fields[name][1])  # type: ignore[index]
    for name in HEADER.names  # type: ignore[union-attr]
)
MOST_SHARDS: Final = 64
SLOTS: Final = MOST_SHARDS * HEADER.itemsize
"""Address of the first slot, after the headers."""
BATCH: Final = 16
"""Robots prefetched together: measured; 8 and 32 are as good within a tenth."""
_SLOT_LINES: Final = range(64, SLOT.itemsize, 128)
"""Offsets in a slot that are prefetched: every other cache line, because pairs are loaded."""


def driver() -> bytes:
    """Return the driver of any fleet, in the binary format.

    The tables are empty: the fleet grows them.
    """
    from crs_cc.runtime.wasm import Code, Module  # not needed if the driver is in the cache

    module = Module(
        functions=[Code("round", ((), ()), ["i32"] * 6, _round())],
        memory_imports=[("crs", "mailbox")],
        tables=[0, 0],
        globals=[("i32", 0)],
        exports=[
            ("round", "func", 0),
            ("robots", "table", 0),
            ("prefetches", "table", 1),
            ("header", "global", 0),
        ],
    )
    return module.to_binary()


def _round() -> list[tuple[object, ...]]:
    robot, slot, end, prefetched = range(4)
    return [
        *_argument(CURRENT), ("local.tee", robot), ("local.set", prefetched),
        *_argument(END), ("local.set", end),
        ("block",), ("loop",),
        ("local.get", robot), ("local.get", end), ("i32.ge_u",), ("br_if", 1),
        ("local.get", robot), ("local.get", prefetched), ("i32.ge_u",), ("if",),
        *_prefetch(), ("end",),
        *_if_it_runs(robot, slot),
        ("global.get", 0), ("local.get", robot), ("i32.store", 0, CURRENT),
        ("local.get", slot), ("i32.const", 0), ("i32.store", 0, slot_offset("run")),
        ("local.get", slot), ("i32.const", 0), ("i32.store", 0, slot_offset("code")),
        ("local.get", slot),
        ("local.get", slot), ("local.get", robot), ("call_indirect", 0, 0),
        ("i32.store", 0, slot_offset("status")),
        ("local.get", slot), ("i32.load", 0, slot_offset("stopped")),
        ("if",), ("return",), ("end",),
        ("end",),
        *_advance(robot),
        ("br", 0), ("end",), ("end",),
        ("global.get", 0), ("local.get", end), ("i32.store", 0, CURRENT),
    ]  # fmt: skip


def _prefetch() -> list[tuple[object, ...]]:
    """Prefetch from robot `prefetched` on, as many as there are in a batch."""
    slot, end, prefetched, left, loaded = range(1, 6)
    lines = [
        each
        for offset in _SLOT_LINES
        for each in (("local.get", slot), ("i32.load", 0, offset), ("i32.or",))
    ]
    return [
        ("i32.const", BATCH), ("local.set", left),
        ("block",), ("loop",),
        ("local.get", prefetched), ("local.get", end), ("i32.ge_u",), ("br_if", 1),
        *_if_it_runs(prefetched, slot),
        ("local.get", slot), ("local.get", prefetched), ("call_indirect", 0, 1), *lines,
        ("local.get", loaded), ("i32.or",), ("local.set", loaded),
        ("end",),
        *_advance(prefetched),
        ("local.get", left), ("i32.const", 1), ("i32.sub",), ("local.tee", left), ("br_if", 0),
        ("end",), ("end",),
        ("global.get", 0), ("local.get", loaded), ("i32.store", 0, LOADED),
    ]  # fmt: skip


def _argument(offset: int) -> list[tuple[object, ...]]:
    return [("global.get", 0), ("i32.load", 0, offset)]


def _advance(robot: int) -> list[tuple[object, ...]]:
    return [("local.get", robot), *_argument(STRIDE), ("i32.add",), ("local.set", robot)]


def _if_it_runs(robot: int, slot: int) -> list[tuple[object, ...]]:
    """Set `slot` to the address of a robot's slot, and start an `if` that it is to run."""
    return [
        ("local.get", robot), ("i32.const", SLOT.itemsize), ("i32.mul",),
        ("i32.const", SLOTS), ("i32.add",), ("local.tee", slot),
        ("i32.load", 0, slot_offset("run")), ("if",),
    ]  # fmt: skip
