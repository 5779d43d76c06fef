"""An expression that is shown at every stop."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from crs_cc.debug.commands.arguments import OutputFormat
from crs_cc.debug.commands.formats import formatted

if TYPE_CHECKING:
    from crs_cc.debug.engine import Debugger


@dataclass(frozen=True, slots=True)
class Display:
    """An expression, and how to show its value."""

    expression: str
    format: OutputFormat

    def text(self, debugger: Debugger) -> str:
        """Return it as it is now.

        Raises:
            DebugError: it means nothing here.
        """
        return (
            f"{self.expression} = {formatted(debugger.view.look_up(self.expression), self.format)}"
        )
