"""The code before and after a program's turn in a round, as WebAssembly for the driver.

Before, it is given the fuel that it needs to reach the end of the cycle, if it runs at all. After,
its clock advances by what it has used. Requests about time depend on nothing but the program's own
clock, so they are answered here, in the same round; for all others the owner of the fleet is asked.

Addresses are those of slots; a program's `TIMING` follows its slot.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.requests import (
    CODES,
    MESSAGE,
    SLOT,
    SUSPENDED,
    SYSTEM_CALL,
    TIMING,
    slot_offset,
    timing_offset,
)

if TYPE_CHECKING:
    from crs_cc.runtime.wasm import Instr

RECORD: Final = np.dtype([("slot", SLOT), ("timing", TIMING)])
"""What the mailbox has of each robot."""

ANSWERED: Final = frozenset({CODES["CLOCK"], CODES["SLEEP"]})
"""The requests that are answered here."""

_SLOT: Final = ("local.get", 0)
_F_0: Final = slot_offset("message") + int(MESSAGE.fields["f"][1])  # type: ignore[index]
_RESULT: Final = slot_offset("message") + int(MESSAGE.fields["result"][1])  # type: ignore[index]
_NEVER_S: Final = float("inf")


CLOCK_S, DUE_S, SPEED_HZ, FUEL, PENDING, ALIVE, ASKS = (
    timing_offset(each)
    for each in ("clock_s", "due_s", "speed_hz", "fuel", "pending", "alive", "asks")
)


def begin(end_s: list[Instr]) -> list[Instr]:
    """Return the body of `(slot) -> runs`: select a program for the round that begins.

    Args:
        end_s: pushes the end of the cycle [s].
    """
    return [
        _SLOT, ("i32.load8_u", 0, ALIVE),
        _SLOT, ("f64.load", 0, CLOCK_S), *end_s, ("f64.lt",), ("i32.and",),
        _SLOT, ("f64.load", 0, DUE_S), ("f64.const", _NEVER_S), ("f64.eq",), ("i32.and",),
        ("i32.eqz",), ("if",), ("i32.const", 0), ("return",), ("end",),
        _SLOT, _SLOT,
        *end_s, _SLOT, ("f64.load", 0, CLOCK_S), ("f64.sub",),
        _SLOT, ("f64.load", 0, SPEED_HZ), ("f64.mul",), ("f64.ceil",), ("i64.trunc_sat_f64_s",),
        ("i64.store", 0, PENDING),
        _SLOT, ("i64.load", 0, PENDING), ("i64.store", 0, slot_offset("fuel")),
        _SLOT, ("i32.const", 1), ("i32.store", 0, slot_offset("run")),
        ("i32.const", 1),
    ]  # fmt: skip


def end(ask: list[Instr]) -> list[Instr]:
    """Return the body of `(slot)`: advance a program's clock, and answer a request about time.

    Args:
        ask: notes that the owner of the fleet is asked for something.
    """
    return [
        _SLOT, ("i64.load", 0, PENDING), ("i64.eqz",), ("if",), ("return",), ("end",),
        *_use([
            _SLOT, ("i64.load", 0, PENDING),
            _SLOT, ("i64.load", 0, slot_offset("fuel")), ("i64.sub",),
        ]),
        _SLOT, ("i64.const", 0), ("i64.store", 0, PENDING),
        _SLOT, ("i32.load", 0, slot_offset("status")), ("i32.const", SUSPENDED), ("i32.eq",),
        ("if",),
        _SLOT, ("i32.load", 0, slot_offset("code")), ("i32.eqz",), ("if",), ("return",), ("end",),
        *_answer(CODES["CLOCK"], _clock()),
        *_answer(CODES["SLEEP"], _sleep()),
        ("end",),
        _SLOT, ("i32.const", 1), ("i32.store", 0, ASKS), *ask,
    ]  # fmt: skip


def _answer(code: int, answer: list[Instr]) -> list[Instr]:
    """Answer a request, if it is that, and return."""
    assert code in ANSWERED
    return [
        _SLOT, ("i32.load", 0, slot_offset("code")), ("i32.const", code), ("i32.eq",), ("if",),
        *_use([("i64.const", SYSTEM_CALL)]), *answer, ("return",), ("end",),
    ]  # fmt: skip


def _use(fuel: list[Instr]) -> list[Instr]:
    """Charge a program for processor time: its clock advances."""
    return [
        *fuel, ("local.set", 1),
        _SLOT, _SLOT, ("i64.load", 0, FUEL), ("local.get", 1), ("i64.add",), ("i64.store", 0, FUEL),
        _SLOT, _SLOT, ("f64.load", 0, CLOCK_S),
        ("local.get", 1), ("f64.convert_i64_s",), _SLOT, ("f64.load", 0, SPEED_HZ), ("f64.div",),
        ("f64.add",), ("f64.store", 0, CLOCK_S),
    ]  # fmt: skip


def _clock() -> list[Instr]:
    """Reply with the program's clock and the processor time that it has used."""
    return [
        _SLOT, _SLOT, ("f64.load", 0, CLOCK_S), ("f64.store", 0, _F_0),
        _SLOT, _SLOT, ("i64.load", 0, FUEL), ("f64.convert_i64_s",),
        _SLOT, ("f64.load", 0, SPEED_HZ), ("f64.div",), ("f64.store", 0, _F_0 + 8),
    ]  # fmt: skip


def _sleep() -> list[Instr]:
    """Advance the clock by a pause, if it is positive and finite."""
    pause_s: list[Instr] = [_SLOT, ("f64.load", 0, _F_0)]
    return [
        _SLOT, ("i32.const", 0), ("i32.store", 0, _RESULT),
        *pause_s, ("f64.const", 0.0), ("f64.gt",),
        *pause_s, ("f64.const", _NEVER_S), ("f64.lt",), ("i32.and",), ("if",),
        _SLOT, _SLOT, ("f64.load", 0, CLOCK_S), *pause_s, ("f64.add",), ("f64.store", 0, CLOCK_S),
        ("end",),
    ]  # fmt: skip
