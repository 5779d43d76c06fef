"""The one table of commands, and how what a user types finds its command.

Screens take their help and completion from here, `docs/debugger.md` is made of it.

>>> command, arguments = find("bt 3")
>>> command.name, arguments, find("i b")[0].name, find("reverse-c")[0].name
('backtrace', '3', 'info breakpoints', 'reverse-continue')
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Final

from crs_cc.debug.commands.branches import BRANCHES
from crs_cc.debug.commands.breakpoints import BREAKPOINTS
from crs_cc.debug.commands.command import Command, Group
from crs_cc.debug.commands.data import DATA
from crs_cc.debug.commands.edits import CHANGES
from crs_cc.debug.commands.moving import MOVING
from crs_cc.debug.commands.scripts import SCRIPTS
from crs_cc.debug.commands.stack import STACK
from crs_cc.debug.commands.words import WORDS
from crs_cc.debug.commands.world import WORLD
from crs_cc.debug.errors import DebugError

GROUPS: Final[tuple[Group, ...]] = (
    MOVING, BREAKPOINTS, DATA, STACK, WORLD, CHANGES, BRANCHES, SCRIPTS, WORDS,
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
"""Names that nobody needs to be offered."""

PREFIXES: Final = tuple(sorted({name.split()[0] for name in NAMES if " " in name}))
"""The words that others follow: `info`, `save`."""


def find(text: str) -> tuple[Command, str]:
    """Gives the command that a line means, and its arguments.

    Raises:
        DebugError: there is none, or several could be meant.
    """
    first, rest = _word(text)
    singles = {name: name for name in NAMES if " " not in name}
    name = _choose(first, singles | {each: each for each in PREFIXES}, "")
    if name not in PREFIXES:
        return NAMES[name], rest
    followers = {each.partition(" ")[2]: each for each in NAMES if each.startswith(f"{name} ")}
    if not rest:
        raise DebugError(f'"{name}" must be followed by what: try "help {name}".')
    second, rest = _word(rest)
    return NAMES[_choose(second, followers, f"{name} ")], rest


def _word(text: str) -> tuple[str, str]:
    text = text.strip()
    found = _FIRST.match(text)
    end = found.end() if found else (len(text.split(maxsplit=1)[0]) if text else 0)
    return text[:end], text[end:].strip()


def _choose(word: str, names: dict[str, str], before: str) -> str:
    """Gives the one that a word, or the beginning of one, means."""
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
        raise DebugError(f'Undefined {before}command: "{word}".  Try "help{_after(before)}".')
    return names[next(iter(meant.values()))]


def _after(before: str) -> str:
    return f" {before.strip()}" if before else ""


def matching(beginning: str) -> Iterator[str]:
    """Gives the names of commands that begin so, those of two words word by word."""
    for name in sorted({*NAMES, *PREFIXES} - _SHORTENED):
        if name.startswith(beginning) and (" " not in name or " " in beginning):
            yield name
