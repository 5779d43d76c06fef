"""Propagation of stops and resumptions between functions, by the fuel.

A function that stops returns its fuel less `STOPPED`, which no program uses up, and one that is
called with so little resumes. Why it stops is in a global. So a call tests the sign of the fuel
alone, and so does a function at its start, where it would have to test it anyway: less than zero is
rare, and then it is one of the two, or the program is out of fuel, which is tested elsewhere.
"""

from __future__ import annotations

from typing import Final

from crs_cc.runtime.codegen.indices import FUEL, STATUS_GLOBAL
from crs_cc.runtime.wasm import UNLIKELY, Instr

STOPPED: Final = 2**62
_LESS: Final[Instr] = ("i64.const", -STOPPED // 2)

PUSH_STOPPED: Final[list[Instr]] = [("local.get", FUEL), ("i64.const", STOPPED), ("i64.sub",)]
"""Push the fuel, as returned by a function that stops, or passed to one that resumes."""

RESTORE: Final[list[Instr]] = [
    ("local.get", FUEL), ("i64.const", STOPPED), ("i64.add",), ("local.set", FUEL),
]  # fmt: skip
"""Make it the fuel that is left again."""

IS_STOPPED: Final[list[Instr]] = [("local.get", FUEL), _LESS, ("i64.lt_s",)]
"""Push whether a function that has returned this fuel has stopped."""

IS_NEGATIVE: Final[list[Instr]] = [("local.get", FUEL), ("i64.const", 0), ("i64.lt_s",)]

IF_STOPPED: Final[list[Instr]] = [*IS_NEGATIVE, UNLIKELY, *IS_STOPPED, UNLIKELY, *RESTORE]
"""Start a conditional for what follows when a function has stopped, to be closed by `END`."""

END: Final[list[Instr]] = [("end",), ("end",)]


def status(value: int) -> list[Instr]:
    """Set why the program stops."""
    return [("i32.const", value), ("global.set", STATUS_GLOBAL)]
