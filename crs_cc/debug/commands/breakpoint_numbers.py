"""The numbers of breakpoints that a command's arguments name."""

from __future__ import annotations

import re
from typing import Final

from crs_cc.debug.commands.arguments import parse_numbers
from crs_cc.debug.commands.context import CommandContext

_BREAKPOINTS: Final = re.compile(r"(?:br|breakpoints?)(?:\s+|$)")


def numbers(context: CommandContext, text: str) -> list[int]:
    """Return the numbers in a text, which may begin with `breakpoints`, as in gdb.

    Raises:
        DebugError: it is malformed.
    """
    text = _BREAKPOINTS.sub("", text, count=1)
    newest = max((each.number for each in context.debugger.stop_points.breakpoints), default=None)
    return parse_numbers(text, newest)


def numbers_or_all(context: CommandContext, text: str) -> list[int]:
    """Return the numbers in a text, those of all breakpoints if there are none."""
    return numbers(context, text) or [
        each.number for each in context.debugger.stop_points.breakpoints
    ]
