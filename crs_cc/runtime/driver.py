"""The module that runs rounds of a fleet in one call from Python.

It holds the robots' `resume` functions in a table. `round()` resumes every robot whose slot has
`run` set: number `current`, and every `stride`th after it below `end`. Its arguments and results
are at the start of the mailbox, in a `HEADER` for each shard of the fleet, at the address in the
exported global `header`: a call without arguments is the cheapest for Python. `current` also
identifies the robot of a trap, which only a bug of ours or unchecked code can cause.

If `timed`, it selects the robots that run by their clocks, and advances these, see `turns`; and as
long as no program asks for anything, it runs further rounds. `begin()` and `end()` do the same for
rounds in which programs may stop before a marked statement.

No two robots share a page, and most of a round of a large fleet is waiting for memory. So before a
batch of robots is resumed, their `prefetch` functions load what each will touch first: these loads
do not depend on one another, and the processor waits for them together. It halves the time of a
round of a thousand robots or more.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.requests import SLOT, slot_offset
from crs_cc.runtime import turns
from crs_cc.runtime.turns import RECORD

if TYPE_CHECKING:
    from crs_cc.runtime.wasm import FuncType, Instr

HEADER: Final = np.dtype(
    {
        "names": [
            "first", "current", "end", "stride", "timed", "most", "rounds", "ran", "asked",
            "loaded", "end_s",
        ],
        "formats": ["<u4"] * 10 + ["<f8"],
        "itemsize": 64,  # a cache line: shards write theirs at the same time
    }
)  # fmt: skip
"""What a driver is told, and what it tells.

first, end, stride: the robots
current: the robot to begin with; the one that stopped or trapped, or `end`
timed: whether clocks are read and advanced
most: no further round begins after so many
rounds: rounds that ended; they are counted
ran: whether a program has run in this round
asked: whether a program asks for anything
loaded: receives what was prefetched, so that the loads are not optimised away
end_s: the end of the cycle [s]
"""
_AT: Final = {name: int(field[1]) for name, field in (HEADER.fields or {}).items()}
MAX_SHARDS: Final = 64
SLOTS: Final = MAX_SHARDS * HEADER.itemsize
"""Address of the first slot, after the headers."""
BATCH: Final = 16
"""Robots prefetched together: measured; 8 and 32 are as good within a tenth."""
_SLOT_LINES: Final = range(64, SLOT.itemsize, 128)
"""Offsets in a slot that are prefetched: every other cache line, because pairs are loaded."""

_BEGIN, _END = range(2)  # functions
_ROBOT, _SLOT, _ALL, _PREFETCHED, _LEFT, _LOADED = range(6)  # locals


def driver() -> bytes:
    """Return the driver of any fleet, in the binary format.

    The tables are empty: the fleet grows them.
    """
    from crs_cc.runtime.wasm import Code, Module  # not needed if the driver is in the cache

    begins: FuncType = (("i32",), ("i32",))
    ends: FuncType = (("i32",), ())
    rounds: FuncType = ((), ())
    ask = _store("asked", ("i32.const", 1))
    module = Module(
        functions=[
            Code("begin_turn", begins, [], turns.begin(_load("end_s", "f64.load"))),
            Code("end_turn", ends, ["i64"], turns.end(ask)),
            Code("round", rounds, ["i32"] * 6, _rounds()),
            Code("begin", rounds, ["i32"] * 3, _begin_all()),
            Code("end", rounds, ["i32"] * 3, _for_all([_get(_SLOT), ("call", _END)])),
        ],
        memory_imports=[("crs", "mailbox")],
        tables=[0, 0],
        globals=[("i32", 0)],
        exports=[
            ("round", "func", 2),
            ("begin", "func", 3),
            ("end", "func", 4),
            ("robots", "table", 0),
            ("prefetches", "table", 1),
            ("header", "global", 0),
        ],
    )
    return module.to_binary()


def _rounds() -> list[Instr]:
    """Return the body of `round`."""
    return [
        *_load("end"), _set(_ALL), *_load("current"), _set(_ROBOT),
        ("loop",),
        *_round(),
        *_store("current", _get(_ALL)),
        *_load("ran"), ("i32.eqz",), ("if",), ("return",), ("end",),
        *_store("ran", ("i32.const", 0)),
        *_store("rounds", *_load("rounds"), ("i32.const", 1), ("i32.add",)),
        *_load("asked"), *_load("rounds"), *_load("most"), ("i32.ge_u",), ("i32.or",),
        ("if",), ("return",), ("end",),
        *_load("first"), _set(_ROBOT),
        ("br", 0), ("end",),
    ]  # fmt: skip


def _round() -> list[Instr]:
    """Resume every robot from `_ROBOT` on that is to run."""
    return [
        _get(_ROBOT), _set(_PREFETCHED),
        ("block",), ("loop",),
        _get(_ROBOT), _get(_ALL), ("i32.ge_u",), ("br_if", 1),
        _get(_ROBOT), _get(_PREFETCHED), ("i32.ge_u",), ("if",), *_prefetch(), ("end",),
        *_slot_of(_ROBOT), *_field("run"), ("if",),
        *_store("current", _get(_ROBOT)), *_store("ran", ("i32.const", 1)),
        _get(_SLOT), ("i32.const", 0), ("i32.store", 0, slot_offset("run")),
        _get(_SLOT), ("i32.const", 0), ("i32.store", 0, slot_offset("code")),
        _get(_SLOT),
        _get(_SLOT), _get(_ROBOT), ("call_indirect", 0, 0),
        ("i32.store", 0, slot_offset("status")),
        *_field("stopped"), ("if",), ("return",), ("end",),
        *_load("timed"), ("if",), _get(_SLOT), ("call", _END), ("end",),
        ("end",),
        *_advance(_ROBOT),
        ("br", 0), ("end",), ("end",),
    ]  # fmt: skip


def _prefetch() -> list[Instr]:
    """Select those of a batch of robots that run, from `_PREFETCHED` on, and prefetch them."""
    lines = [
        each
        for offset in _SLOT_LINES
        for each in (_get(_SLOT), ("i32.load", 0, offset), ("i32.or",))
    ]
    return [
        ("i32.const", BATCH), _set(_LEFT),
        ("block",), ("loop",),
        _get(_PREFETCHED), _get(_ALL), ("i32.ge_u",), ("br_if", 1),
        *_slot_of(_PREFETCHED),
        *_load("timed"), ("if",), _get(_SLOT), ("call", _BEGIN), ("drop",), ("end",),
        *_field("run"), ("if",),
        _get(_SLOT), _get(_PREFETCHED), ("call_indirect", 0, 1), *lines,
        _get(_LOADED), ("i32.or",), _set(_LOADED),
        ("end",),
        *_advance(_PREFETCHED),
        _get(_LEFT), ("i32.const", 1), ("i32.sub",), ("local.tee", _LEFT), ("br_if", 0),
        ("end",), ("end",),
        *_store("loaded", _get(_LOADED)),
    ]  # fmt: skip


def _begin_all() -> list[Instr]:
    """Return the body of `begin`, which selects the robots that run: `ran` is whether any does."""
    begin: list[Instr] = [_get(_SLOT), ("call", _BEGIN)]
    return _for_all(_store("ran", *_load("ran"), *begin, ("i32.or",)))


def _for_all(body: list[Instr]) -> list[Instr]:
    return [
        *_load("end"), _set(_ALL), *_load("first"), _set(_ROBOT),
        ("block",), ("loop",),
        _get(_ROBOT), _get(_ALL), ("i32.ge_u",), ("br_if", 1),
        *_slot_of(_ROBOT), *body,
        *_advance(_ROBOT),
        ("br", 0), ("end",), ("end",),
    ]  # fmt: skip


def _get(local: int) -> Instr:
    return ("local.get", local)


def _set(local: int) -> Instr:
    return ("local.set", local)


def _load(name: str, load: str = "i32.load") -> list[Instr]:
    return [("global.get", 0), (load, 0, _AT[name])]


def _store(name: str, *value: Instr) -> list[Instr]:
    return [("global.get", 0), *value, ("i32.store", 0, _AT[name])]


def _field(name: str) -> list[Instr]:
    return [_get(_SLOT), ("i32.load", 0, slot_offset(name))]


def _advance(robot: int) -> list[Instr]:
    return [_get(robot), *_load("stride"), ("i32.add",), _set(robot)]


def _slot_of(robot: int) -> list[Instr]:
    """Set `_SLOT` to the address of a robot's slot."""
    return [
        _get(robot), ("i32.const", RECORD.itemsize), ("i32.mul",),
        ("i32.const", SLOTS), ("i32.add",), _set(_SLOT),
    ]  # fmt: skip
