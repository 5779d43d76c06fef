"""The limit on a function that would take gigabytes to compile."""

from __future__ import annotations

from typing import Final

from crs_cc.core.errors import CompileError
from crs_cc.ir.program import Function

MOST_WAYS: Final = 250_000
"""Limit on registers times landings of a function; at 160,000 compiling takes half a gigabyte."""


def check_complexity(function: Function, landings: int, lasting: int) -> None:
    """Reject a function that would take gigabytes to compile.

    Each landing is an entry into the middle of the function, and each lasting register has to
    be merged at all of them.

    Raises:
        CompileError: the function is too complex.
    """
    if landings * lasting > MOST_WAYS:
        raise CompileError.at(
            function.location,
            f"'{function.name}' is too complex: {lasting} values"
            f" are live across {landings} calls and loops",
            "split the function, or the expression with many calls",
            "linking",
        )
