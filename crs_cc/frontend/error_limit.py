"""A limit for the number of errors in a file."""

from __future__ import annotations

from typing import Final

from crs_cc.core.source import Diagnostics, Location

MAX_ERRORS: Final = 500
"""Compilation of a file stops after so many errors."""


class CompilationAborted(Exception):  # noqa: N818 - the errors are in the diagnostics
    """Compilation cannot continue: too many errors, or too deep a nesting."""


def report(diagnostics: Diagnostics, location: Location, text: str, hint: str = "") -> None:
    """Record an error.

    Raises:
        CompilationAborted: there are too many.
    """
    diagnostics.error(location, text, hint)
    if len(diagnostics.errors) >= MAX_ERRORS:
        raise CompilationAborted
