"""Commands: their names, syntax and help, and the functions that run them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from crs_cc.debug.commands.answer import Answer
from crs_cc.debug.commands.context import CommandContext

Completes = Literal[
    "", "command", "place", "expression", "robot", "breakpoint", "display", "file", "catch",
    "checkpoint", "branch", "edit", "macro", "setting",
]  # fmt: skip
"""The kind of an argument, for completion."""


@dataclass(frozen=True, slots=True)
class Command:
    """A command.

    Attributes:
        name: its name; subcommands have two words, such as `info locals`.
        syntax: its arguments as help shows them, optional ones in brackets.
        summary: what it does, in a line.
        run: runs it, given the context and the arguments.
        aliases: further names.
        text: further help.
        repeats: what an empty line after it does: nothing, repeat the command, or repeat it
            without its arguments.
        completes: the kind of its argument, for completion.
    """

    name: str
    syntax: str
    summary: str
    run: Callable[[CommandContext, str], Answer]
    aliases: tuple[str, ...] = ()
    text: str = ""
    repeats: Literal["", "same", "on"] = ""
    completes: Completes = ""

    @property
    def usage(self) -> str:
        """Return the command with its arguments."""
        return f"{self.name} {self.syntax}".rstrip()


@dataclass(frozen=True, slots=True)
class Group:
    """Commands about one subject.

    Attributes:
        name: its name, an argument of `help`.
        summary: its purpose.
        commands: the commands, in the order in which help shows them.
    """

    name: str
    summary: str
    commands: tuple[Command, ...]
