"""Indices shared by all modules and functions: memories, globals, runtime functions, locals."""

from __future__ import annotations

from typing import Any, Final

from crs_cc.ir.value_type import ValueType

MAILBOX, MEMORY, SHADOW = range(3)
"""The memories of a robot's module; `SHADOW` exists in checked builds only."""

SLOT_GLOBAL, MARKS_GLOBAL, BEGUN_GLOBAL, WATCHED_GLOBAL, SPAN_GLOBAL, STATUS_GLOBAL = range(6)
"""The globals: address of the robot's slot; in debug builds, address of the active marks of the
statements, and number of statements begun; in watching builds, start and size of the bounds
of the watched ranges; why the program stops, while it does."""

OUTSIDE: Final = 0
"""The runtime function of unchecked builds, which precedes the functions of the program."""

INACCESSIBLE, CALLERS, PRODUCT_FITS, UNSEALED, GAP, UNRELATED, PASSED, UNSET = range(8)
"""Those of checked builds."""

CALL_TYPE: Final = 1
"""The type of C functions in their general form."""

FP, FUEL, SP, LABEL, SITE, ADDRESS, STATES, WIDE_STATES = range(8)
"""Parameters and locals of every function: address of its header, fuel; stack pointer, number of a
landing to resume at, number of the site that failed, address to report, and shadow states of up to
four, or of eight, bytes."""

FIXED_LOCALS: Final[tuple[ValueType, ...]] = ("i32", "i32", "i32", "i32", "i32", "i64")
"""The types of those that are not parameters."""

_OF_LOCALS: Final = frozenset({"local.get", "local.set", "local.tee"})


def passed(number: int) -> int:
    """Return the index of a parameter in a register, until `with_parameters` has run."""
    return -1 - number


def with_parameters(body: list[tuple[Any, ...]], count: int) -> list[tuple[Any, ...]]:
    """Return the code of a function with the indices of its locals after `count` parameters.

    Code is generated for a function without arguments in registers, so that the indices above are
    the same everywhere.
    """
    if count == 0:
        return body
    return [
        (each[0], FUEL - each[1] if each[1] < 0 else each[1] + count)
        if each[0] in _OF_LOCALS and not 0 <= each[1] <= FUEL
        else each
        for each in body
    ]
