"""Report errors, and gives a file up after too many of them."""

from __future__ import annotations

from typing import Final

from crs_cc.core.source import Diagnostics, Location

MOST_ERRORS: Final = 500
"""After so many errors in one file nothing more is looked for."""


class GiveUp(Exception):  # noqa: N818 - it stops the work, the errors are recorded
    """Going on makes no sense: there are too many errors, or too deep a nesting."""


def report(diagnostics: Diagnostics, place: Location, text: str, hint: str = "") -> None:
    """Record an error; after too many of them gives up.

    Raises:
        GiveUp: when the file is hopeless.
    """
    diagnostics.error(place, text, hint)
    if len(diagnostics.errors) >= MOST_ERRORS:
        raise GiveUp
