"""What `show` shows: settings, printed values, convenience variables."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Final

from crs_cc import __version__
from crs_cc.core.suggest import unknown
from crs_cc.debug.commands.answer import Answer
from crs_cc.debug.commands.arguments import OutputFormat, parse_count, reject_arguments
from crs_cc.debug.commands.command import Command
from crs_cc.debug.commands.context import CommandContext
from crs_cc.debug.commands.formats import formatted
from crs_cc.debug.commands.settings import SETTINGS, WITHOUT_EFFECT
from crs_cc.debug.errors import DebugError

_LISTED_LINES: Final = 10
"""How many values are shown at once."""

_WORDS: Final = re.compile(r"(values|conv(?:enience)?|version)(?:\s+|$)")


def _show(context: CommandContext, text: str) -> Answer:
    found = _WORDS.match(text)
    rest = text[found.end() :] if found else ""
    match found and found[1]:
        case "values":
            yield from _values(context, rest)
        case "version":
            reject_arguments(rest)
            yield f"crs {__version__}"
        case None:
            yield from _settings(context, text)
        case _:
            reject_arguments(rest)
            yield from _variables(context)


def _settings(context: CommandContext, text: str) -> Iterator[str]:
    found = [each for each in SETTINGS if each.name.startswith(text)]
    if not found and text in WITHOUT_EFFECT:
        yield f"'{text}' has no effect here: {WITHOUT_EFFECT[text]}"
    elif not found:
        raise DebugError(unknown("setting", text, [each.name for each in SETTINGS]))
    for each in found:
        yield f"{each.name} = {each.text(context.settings[each.name])}: {each.summary}"


def _values(context: CommandContext, text: str) -> Iterator[str]:
    """Return the last ten printed values, those around one, or those after the last shown."""
    count = context.value_count
    if text == "+":
        first = context.shown_value + 1
    elif text:
        first = max(1, parse_count(text) - _LISTED_LINES // 2)
    else:
        first = max(1, count - _LISTED_LINES + 1)
    if not count:
        yield "No values have been printed."
    for number in range(first, min(count, first + _LISTED_LINES - 1) + 1):
        value = context.debugger.view.convenience_values[str(number)]
        yield f"${number} = {formatted(value, OutputFormat())}"
        context.shown_value = number


def _variables(context: CommandContext) -> Iterator[str]:
    """Return the convenience variables, but not the printed values."""
    found = context.debugger.view.convenience_values
    names = sorted(each for each in found if each and not each.isdigit())
    yield from (f"${name} = {formatted(found[name], OutputFormat())}" for name in names)
    if not names:
        yield "No convenience variables have values."


SHOW: Final = Command(
    "show", "[SETTING|values [N|+]|convenience|version]",
    "Show the settings, or the values that were printed.", _show, ("info set",),
    text="values shows the last ten printed values; with N, those around $N; with +, those after"
    " the ten last shown; convenience shows the convenience variables.", completes="setting",
)  # fmt: skip
