"""The table of all commands, and the lookup of commands by user input.

Help and completion use it, and `docs/debugger.md` is generated from it.

>>> command, arguments = find("bt 3")
>>> command.name, arguments, find("i b")[0].name, find("reverse-c")[0].name
('backtrace', '3', 'info breakpoints', 'reverse-continue')
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import partial
from typing import Final

from crs_cc.debug.commands.answer import Answer
from crs_cc.debug.commands.arguments import require_argument
from crs_cc.debug.commands.branches import BRANCHES
from crs_cc.debug.commands.breakpoints import BREAKPOINTS
from crs_cc.debug.commands.command import Command, Group
from crs_cc.debug.commands.context import CommandContext
from crs_cc.debug.commands.data import DATA
from crs_cc.debug.commands.help_text import manual, mentions, overview, summaries
from crs_cc.debug.commands.past import PAST
from crs_cc.debug.commands.running import RUNNING
from crs_cc.debug.commands.scripts import SCRIPTS
from crs_cc.debug.commands.stack import STACK
from crs_cc.debug.commands.symbols import SYMBOLS
from crs_cc.debug.commands.why import WHY
from crs_cc.debug.commands.world import CHANGES, WORLD
from crs_cc.debug.errors import DebugError


def _help(_context: CommandContext, text: str) -> Answer:
    groups = {group.name: group for group in GROUPS}
    if not text:
        yield from overview(GROUPS)
    elif text == "all":
        for group in GROUPS:
            yield from summaries(group.summary, group.commands)
    elif text in groups:
        yield from summaries(groups[text].summary, groups[text].commands)
    elif text in (*PREFIXES, "i"):
        word = "info" if text == "i" else text
        followers = [each for each in COMMANDS if each.name.startswith(f"{word} ")]
        yield from summaries(f'Subcommands of "{word}":', followers)
    else:
        yield from manual(find(text)[0])


def _apropos(_context: CommandContext, text: str) -> Answer:
    word = require_argument(text, "a word").lower()
    found = [each for each in COMMANDS if mentions(each, word)]
    if not found:
        raise DebugError(f'no help text contains "{text}"')
    for command in found:
        yield f"{command.name} - {command.summary}"


def _quit(context: CommandContext, _text: str) -> Answer:
    context.has_ended = True
    yield from ()


def _unsupported(_context: CommandContext, _text: str, *, reason: str) -> Answer:
    raise DebugError(reason)


_JUMP: Final = (
    "'jump' is not supported: it would leave the recorded execution; go to another time (\"goto\"),"
    " or set the variable that decides"
)
_SHELL: Final = (
    "'shell' is not supported: scripts that come with a world must not start other programs"
)

SUPPORT: Final = Group(
    "support",
    "Help, and leaving the debugger.",
    (
        Command("help", "[GROUP|COMMAND|all]", "Show help on commands.", _help, ("h",),
                completes="command"),
        Command("apropos", "WORD", "List the commands whose help contains a word.", _apropos),
        Command("quit", "", "Exit the debugger.", _quit, ("q", "exit")),
        Command("jump", "LOCATION", "Not supported; explains why, and what to do instead.",
                partial(_unsupported, reason=_JUMP), ("j",)),
        Command("shell", "COMMAND", "Not supported; explains why.",
                partial(_unsupported, reason=_SHELL), ("!",)),
    ),
)  # fmt: skip

GROUPS: Final[tuple[Group, ...]] = (
    RUNNING, BREAKPOINTS, PAST, WHY, DATA, STACK, SYMBOLS, WORLD, CHANGES, BRANCHES, SCRIPTS,
    SUPPORT,
)  # fmt: skip

COMMANDS: Final[tuple[Command, ...]] = tuple(each for group in GROUPS for each in group.commands)

_FIRST: Final = re.compile(r"[A-Za-z][\w-]*|!")


def _named(commands: Iterable[Command]) -> dict[str, Command]:
    named: dict[str, Command] = {}
    for command in commands:
        for name in (command.name, *command.aliases):
            assert name not in named, name
            named[name] = command
    return named


NAMES: Final = _named(COMMANDS)
"""Every command by each of its names."""

_SHORTENED: Final = {"!"} | {
    name for name, each in NAMES.items() if each.name != name and each.name.startswith(name)
}
"""Aliases that completion does not offer."""

PREFIXES: Final = tuple(sorted({name.split()[0] for name in NAMES if " " in name}))
"""Prefixes of subcommands: `info`, `save`."""

_FIRST_WORDS: Final = {name: name for name in (*NAMES, *PREFIXES) if " " not in name}
_SECOND_WORDS: Final = {
    prefix: {name.partition(" ")[2]: name for name in NAMES if name.startswith(f"{prefix} ")}
    for prefix in PREFIXES
}


class UndefinedCommandError(DebugError):
    """There is no such command."""


def find(text: str) -> tuple[Command, str]:
    """Return the command of a line, and its arguments.

    Raises:
        DebugError: it is undefined or ambiguous.
    """
    first, rest = _word(text)
    name = _choose(first, _FIRST_WORDS, "")
    if name not in PREFIXES:
        return NAMES[name], rest
    if not rest:
        raise DebugError(f'"{name}" needs a subcommand: try "help {name}".')
    second, rest = _word(rest)
    return NAMES[_choose(second, _SECOND_WORDS[name], f"{name} ")], rest


def _word(text: str) -> tuple[str, str]:
    text = text.strip()
    found = _FIRST.match(text)
    end = found.end() if found else (len(text.split(maxsplit=1)[0]) if text else 0)
    return text[:end], text[end:].strip()


def _choose(word: str, names: dict[str, str], before: str) -> str:
    """Return the name that a word is or abbreviates."""
    if word in names:
        return names[word]
    if not before and word == "i":
        return "info"
    fitting = [name for name in names if name.startswith(word)] if word else []
    meant = {NAMES.get(names[name], names[name]): name for name in reversed(fitting)}
    if len(meant) > 1:
        shown = ", ".join(sorted(fitting))
        raise DebugError(f'Ambiguous {before}command "{word}": {shown}.')
    if not meant:
        raise UndefinedCommandError(
            f'Undefined {before}command: "{word}".  Try "help{_after(before)}".'
        )
    return names[next(iter(meant.values()))]


def _after(before: str) -> str:
    return f" {before.strip()}" if before else ""


def matching(beginning: str) -> Iterator[str]:
    """Return the names of commands with a prefix; subcommands only after the first word."""
    for name in sorted({*NAMES, *PREFIXES} - _SHORTENED):
        if name.startswith(beginning) and (" " not in name or " " in beginning):
            yield name
