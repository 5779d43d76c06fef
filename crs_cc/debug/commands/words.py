"""Commands about the commands: help, the end, and what there is not."""

from __future__ import annotations

import textwrap
from functools import partial
from typing import TYPE_CHECKING, Final

from crs_cc.debug.commands.arguments import demand, demand_none
from crs_cc.debug.commands.command import Answer, Command, Group
from crs_cc.debug.errors import DebugError

if TYPE_CHECKING:
    from crs_cc.debug.commands.shell import Shell

_WIDTH: Final = 79

_INTRODUCTION: Final = """\
Commands can be abbreviated to any unambiguous prefix. An empty line repeats the
last command if it resumes the run or lists something. For details, type:
help GROUP, help COMMAND, help all, apropos WORD.
"""


def _help(_shell: Shell, text: str) -> Answer:
    from crs_cc.debug.commands.table import GROUPS, PREFIXES, find  # they hold this command

    groups = {group.name: group for group in GROUPS}
    if not text:
        yield from _INTRODUCTION.splitlines()
        for group in GROUPS:
            yield ""
            yield f"{group.name} - {group.summary}"
            names = ", ".join(each.name for each in group.commands)
            yield textwrap.fill(names, _WIDTH, initial_indent="  ", subsequent_indent="  ")
    elif text == "all":
        for group in GROUPS:
            yield from _listed(group.summary, group.commands)
    elif text in groups:
        yield from _listed(groups[text].summary, groups[text].commands)
    elif text in (*PREFIXES, "i"):
        word = "info" if text == "i" else text
        rows = [each for group in GROUPS for each in group.commands]
        followers = [each for each in rows if each.name.startswith(f"{word} ")]
        yield from _listed(f'What can follow "{word}":', followers)
    else:
        yield from manual(find(text)[0])


def _listed(head: str, commands: tuple[Command, ...] | list[Command]) -> Answer:
    yield head
    for command in commands:
        yield f"  {command.name:18} {command.summary}"


def manual(command: Command) -> Answer:
    """Gives all that help says about a command."""
    yield f"{command.usage} - {command.summary}"
    if command.text:
        yield textwrap.fill(command.text, _WIDTH)
    if command.aliases:
        yield f"Also: {', '.join(command.aliases)}"


def _apropos(_shell: Shell, text: str) -> Answer:
    from crs_cc.debug.commands.table import COMMANDS

    word = demand(text, "a word").lower()
    found = [
        each for each in COMMANDS if word in f"{each.usage} {each.summary} {each.text}".lower()
    ]
    if not found:
        raise DebugError(f'no command says "{text}"')
    for command in found:
        yield f"{command.name} - {command.summary}"


def _quit(shell: Shell, text: str) -> Answer:
    demand_none(text)
    shell.has_ended = True
    yield from ()


def _refuse(_shell: Shell, _text: str, *, reason: str) -> Answer:
    raise DebugError(reason)


_JUMP: Final = (
    "there is no jump: a program that goes on elsewhere is no run of that program any more;"
    ' go back to an instant ("goto"), or set a variable that decides'
)
_SHELL: Final = (
    "the debugger starts no other programs: scripts that come with a world could do anything then"
)

WORDS: Final = Group(
    "words",
    "Getting help and quitting.",
    (
        Command("help", "[GROUP|COMMAND|all]", "Describe commands.", _help, ("h",),
                completes="command"),
        Command("apropos", "WORD", "List the commands whose description contains a word.",
                _apropos),
        Command("quit", "", "Quit the debugger.", _quit, ("q", "exit")),
        Command("jump", "PLACE", "Not supported; prints the reason and alternatives.",
                partial(_refuse, reason=_JUMP), ("j",)),
        Command("shell", "COMMAND", "Not supported; prints the reason.",
                partial(_refuse, reason=_SHELL), ("!",)),
    ),
)  # fmt: skip
