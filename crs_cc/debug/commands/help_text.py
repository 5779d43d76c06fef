"""The answers of `help` and `apropos`."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from typing import Final

from crs_cc.debug.commands.answer import Answer
from crs_cc.debug.commands.command import Command, Group

_WIDTH: Final = 79

_INTRODUCTION: Final = """\
Command names may be abbreviated as long as they are unambiguous; an empty line
repeats the last command if that moves the run or lists something. For more:
help GROUP, help COMMAND, help all, apropos WORD.
"""


def overview(groups: Sequence[Group]) -> Answer:
    """Answer with the groups and the names of their commands."""
    yield from _INTRODUCTION.splitlines()
    for group in groups:
        yield ""
        yield f"{group.name} - {group.summary}"
        names = ", ".join(each.name for each in group.commands)
        yield textwrap.fill(names, _WIDTH, initial_indent="  ", subsequent_indent="  ")


def summaries(head: str, commands: Sequence[Command]) -> Answer:
    """Answer with a line for each of some commands."""
    yield head
    for command in commands:
        yield f"  {command.name:18} {command.summary}"


def manual(command: Command) -> Answer:
    """Answer with the full help of a command."""
    yield f"{command.usage} - {command.summary}"
    if command.text:
        yield textwrap.fill(command.text, _WIDTH)
    if command.aliases:
        yield f"Aliases: {', '.join(command.aliases)}"


def mentions(command: Command, word: str) -> bool:
    """Return whether the help on a command contains a word, given in lower case."""
    return word in f"{command.usage} {command.summary} {command.text}".lower()
