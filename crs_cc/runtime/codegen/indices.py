"""Numbers of what all modules and functions of programs have: memories, own functions, locals."""

from __future__ import annotations

from typing import Final

from crs_cc.ir.program import ValueType

MAILBOX, MEMORY, SHADOW = range(3)
"""The memories of a robot's module; `SHADOW` is there in checked builds only."""

SLOT_GLOBAL, MARKS_GLOBAL, BEGUN_GLOBAL, WATCHED_GLOBAL, SPAN_GLOBAL = range(5)
"""The globals that hold the address of the robot's slot; in debug builds, where the marks of the
statements are that count now, and how many statements have begun; in watching builds the first
address of the bytes among which something is watched, and how many they are."""

FAULT, OUTSIDE = range(2)
"""The module's own functions, which come before those of the program."""

INACCESSIBLE, CALLERS, PRODUCT_FITS = range(1, 4)
"""Those of checked builds, which have no `OUTSIDE`."""

CALL_TYPE: Final = 1
"""The type of C functions."""

FP, FUEL, SP, LABEL, STATUS, SITE, ADDRESS, STATES, WIDE_STATES = range(9)
"""Parameters and locals of every function: its header's address, its fuel; its stack pointer, the
landing where it goes on, the status it leaves with, the number of the place that failed, the
address to blame, and the states of up to four, or of eight, bytes."""

FIXED_LOCALS: Final[tuple[ValueType, ...]] = ("i32", "i32", "i32", "i32", "i32", "i32", "i64")
"""The types of those that are not parameters."""
