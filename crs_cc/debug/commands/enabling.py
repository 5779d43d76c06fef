"""Commands that enable and disable breakpoints and displays."""

from __future__ import annotations

import re
from functools import partial
from typing import Final

from crs_cc.debug.commands.answer import Answer
from crs_cc.debug.commands.arguments import parse_count, parse_numbers, require_argument
from crs_cc.debug.commands.breakpoint_numbers import numbers_or_all
from crs_cc.debug.commands.command import Command
from crs_cc.debug.commands.context import CommandContext
from crs_cc.debug.commands.display import enable_displays

DISPLAY: Final = re.compile(r"display(?:\s+|$)")
"""The word after which numbers are those of displays, not of breakpoints."""

_LIMIT: Final = re.compile(r"(?:breakpoints?\s+)?(once|delete|count)(?:\s+|$)")


def _enable(context: CommandContext, text: str, *, on: bool) -> Answer:
    if display := DISPLAY.match(text):
        enable_displays(context.displays, parse_numbers(text[display.end() :]), on=on)
    elif on and (limit := _LIMIT.match(text)):
        _enable_for(context, limit[1], text[limit.end() :])
    else:
        for number in numbers_or_all(context, text):
            context.debugger.stop_points.enable(number, on=on)
    yield from ()


def _enable_for(context: CommandContext, limit: str, text: str) -> None:
    """Enable breakpoints until they have stopped the run once, or a number of times."""
    stops: int | None = None if limit == "delete" else 1
    if limit == "count":
        count, _, text = require_argument(text, "how many stops: enable count COUNT N").partition(
            " "
        )
        stops = parse_count(count)
    for number in numbers_or_all(context, text):
        context.debugger.stop_points.enable_for(number, stops)


NUMBERS: Final = (
    "N is a number, a range such as 2-4, or $ for the newest breakpoint; default is all."
)

DISABLE: Final = Command(
    "disable", "[display] [N...]", "Disable breakpoints or displays.",
    partial(_enable, on=False), text=NUMBERS, completes="breakpoint",
)  # fmt: skip

ENABLE: Final = Command(
    "enable", "[display|once|count COUNT|delete] [N...]", "Enable breakpoints or displays.",
    partial(_enable, on=True), ("en",), completes="breakpoint",
    text=f"{NUMBERS} With once, a breakpoint is disabled after it has stopped the run; with "
    "count, after it has done so COUNT times; with delete, it is deleted after it has stopped "
    "the run.",
)  # fmt: skip
