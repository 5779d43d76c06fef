"""Expressions that are shown at every stop."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from crs_cc.debug.commands.arguments import OutputFormat
from crs_cc.debug.commands.formats import formatted
from crs_cc.debug.errors import DebugError

if TYPE_CHECKING:
    from crs_cc.debug.engine import Debugger


@dataclass(frozen=True, slots=True)
class Display:
    """An expression and its output format, and whether it is shown at stops."""

    expression: str
    format: OutputFormat
    is_enabled: bool = True

    @property
    def name(self) -> str:
        """The expression, after its format if it has one."""
        letter = self.format.letter
        return f"/{letter} {self.expression}" if letter else self.expression

    def text(self, debugger: Debugger) -> str:
        """Return the expression with its current value; raise DebugError if it is invalid here."""
        return (
            f"{self.name} = {formatted(debugger.view.evaluate_pure(self.expression), self.format)}"
        )


def remove_displays(displays: dict[int, Display], numbers: Sequence[int]) -> None:
    """Remove displays, all if no numbers are given; raise DebugError if one does not exist."""
    for number in numbers or list(displays):
        _find(displays, number)
        del displays[number]


def enable_displays(displays: dict[int, Display], numbers: Sequence[int], *, on: bool) -> None:
    """Enable or disable displays, all if no numbers are given.

    Raises:
        DebugError: one does not exist.
    """
    for number in numbers or list(displays):
        displays[number] = replace(_find(displays, number), is_enabled=on)


def _find(displays: dict[int, Display], number: int) -> Display:
    if number not in displays:
        raise DebugError(f"no display {number}")
    return displays[number]
