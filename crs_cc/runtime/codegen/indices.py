"""Indices shared by all modules and functions: memories, globals, runtime functions, locals."""

from __future__ import annotations

from typing import Final

from crs_cc.ir.value_type import ValueType

MAILBOX, MEMORY, SHADOW = range(3)
"""The memories of a robot's module; `SHADOW` exists in checked builds only."""

SLOT_GLOBAL, MARKS_GLOBAL, BEGUN_GLOBAL, WATCHED_GLOBAL, SPAN_GLOBAL = range(5)
"""The globals: address of the robot's slot; in debug builds, address of the active marks of the
statements, and number of statements begun; in watching builds, start and size of the bounds
of the watched ranges."""

OUTSIDE: Final = 0
"""The runtime function of unchecked builds, which precedes the functions of the program."""

INACCESSIBLE, CALLERS, PRODUCT_FITS = range(3)
"""Those of checked builds."""

CALL_TYPE: Final = 1
"""The type of C functions."""

FP, FUEL, SP, LABEL, STATUS, SITE, ADDRESS, STATES, WIDE_STATES = range(9)
"""Parameters and locals of every function: address of its header, fuel; stack pointer, number of a
landing to resume at, status returned, number of the site that failed, address to
report, and shadow states of up to four, or of eight, bytes."""

FIXED_LOCALS: Final[tuple[ValueType, ...]] = ("i32", "i32", "i32", "i32", "i32", "i32", "i64")
"""The types of those that are not parameters."""
