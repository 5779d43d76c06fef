"""Commands for functions and files that `step` does not enter."""

from __future__ import annotations

from typing import Final

from crs_cc.core.suggest import unknown
from crs_cc.debug.commands.answer import Answer
from crs_cc.debug.commands.arguments import parse_numbers
from crs_cc.debug.commands.command import Command
from crs_cc.debug.commands.context import CommandContext
from crs_cc.debug.commands.stack import frame, functions
from crs_cc.debug.errors import DebugError
from crs_cc.debug.locations import is_file

_CHANGES: Final = ("delete", "enable", "disable")


def _skip(context: CommandContext, text: str) -> Answer:
    kind, _, rest = text.partition(" ")
    if kind in _CHANGES:
        return _change(context, kind, rest)
    if kind == "file":
        return _skip_file(context, rest.strip())
    return _skip_function(context, rest.strip() if kind in ("function", "-fu") else text)


def _skip_function(context: CommandContext, name: str) -> Answer:
    known = [function for function, _ in functions(context)]
    name = name or frame(context).function
    if name not in known:
        raise DebugError(unknown("function", name, known))
    made = context.debugger.navigator.skips.add(name)
    yield f"Skip {made.number}: function {name} will be skipped when stepping."


def _skip_file(context: CommandContext, name: str) -> Answer:
    known = {place.file for _, place in functions(context)}
    name = name or context.debugger.view.current_file()
    if not any(is_file(each, name) for each in known):
        raise DebugError(unknown("file", name, sorted(known)))
    made = context.debugger.navigator.skips.add(file=name)
    yield f"Skip {made.number}: file {name} will be skipped when stepping."


def _change(context: CommandContext, what: str, text: str) -> Answer:
    skips = context.debugger.navigator.skips
    known = [each.number for each in skips]
    for number in parse_numbers(text, known[-1] if known else None) or known:
        if what == "delete":
            skips.remove(number)
        else:
            skips.get(number).enabled = what == "enable"
    yield from ()


def _info_skip(context: CommandContext, _text: str) -> Answer:
    rows = list(context.debugger.navigator.skips)
    if not rows:
        yield "Nothing is skipped."
    for each in rows:
        what = f"function {each.function}" if each.function else f"file {each.file}"
        yield f"{each.number:<3} {'enabled' if each.enabled else 'disabled':11} {what}"


SKIPPING: Final = (
    Command(
        "skip", "[[function] NAME|file [FILE]|delete|enable|disable [N...]]",
        "Do not enter a function when stepping.", _skip,
        text="With file, do not enter any function in a file. step and reverse-step step over "
        "these functions and everything that they call; breakpoints in them still take effect. "
        "The default is the current function. delete removes entries, or all of them if no "
        "number is given.", completes="place",
    ),
    Command("info skip", "", "List the functions and files that are skipped.", _info_skip),
)  # fmt: skip
