"""Commands that search the source."""

from __future__ import annotations

import re
from functools import partial
from typing import Final

from crs_cc.debug.commands.answer import Answer
from crs_cc.debug.commands.arguments import parse_pattern, require_argument
from crs_cc.debug.commands.command import Command
from crs_cc.debug.commands.context import CommandContext, Listing
from crs_cc.debug.commands.stack import line_count, source_lines
from crs_cc.debug.errors import DebugError

_MAX_LINE: Final = 1000
"""Longer lines are searched only up to this length [characters]."""


def _search(context: CommandContext, text: str, *, by: int) -> Answer:
    pattern = parse_pattern(require_argument(text, "a regular expression"))
    file, start = _last_listed(context)
    lines = context.debugger.view.source(file)
    end = line_count(lines) + 1 if by > 0 else 0
    for number in range(start + by, end, by):
        if _matches(pattern, lines[number - 1]):
            context.listing = Listing(file, number, number, is_found=True)
            context.keep_number("_", number)
            yield from source_lines(context, file, number, number)
            return
    raise DebugError(f"'{text}' not found {'after' if by > 0 else 'before'} line {start} of {file}")


def _matches(pattern: re.Pattern[str], line: str) -> bool:
    return pattern.search(line[:_MAX_LINE]) is not None


def _last_listed(context: CommandContext) -> tuple[str, int]:
    """Return the file and the line that were listed last, or that are current."""
    if context.listing is not None:
        return context.listing.file, context.listing.last
    here = context.debugger.view.location()
    if here is None:
        raise DebugError("no current line: list some lines first, such as list main")
    return here.file, here.line


_TEXT: Final = (
    "REGEX is a regular expression. The search begins {} the line listed last, or the current one;"
    ' $_ is the number of the line found, and "list" shows it with those around it.'
)

FORWARD_SEARCH: Final = Command(
    "forward-search", "REGEX", "Show the next source line that matches.",
    partial(_search, by=1), ("search", "fo"), text=_TEXT.format("after"), repeats="same",
)  # fmt: skip

REVERSE_SEARCH: Final = Command(
    "reverse-search", "REGEX", "Show the previous source line that matches.",
    partial(_search, by=-1), ("rev",), text=_TEXT.format("before"), repeats="same",
)  # fmt: skip
