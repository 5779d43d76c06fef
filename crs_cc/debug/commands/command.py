"""What defines a command: names, syntax, help and the function that runs it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from crs_cc.debug.commands.answer import Answer

if TYPE_CHECKING:
    from crs_cc.debug.commands.context import CommandContext

Completes = Literal[
    "", "command", "place", "expression", "robot", "breakpoint", "display", "file", "catch",
    "checkpoint", "branch", "edit",
]  # fmt: skip
"""What an argument is, to be completed."""


@dataclass(frozen=True, slots=True)
class Command:
    """A command.

    Attributes:
        name: its name, of two words for those that follow another, such as `info locals`.
        syntax: its arguments as help shows them, optional ones in brackets.
        summary: what it does, in a line.
        run: does it, given the shell and what stands behind the name.
        aliases: further names.
        text: what else there is to say.
        repeats: what an empty line after it does: nothing, the command again, or the command
            without its arguments.
        completes: what its argument is.
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
        name: the subject, a word that `help` takes.
        summary: what they are for.
        commands: the commands, in the order in which help shows them.
    """

    name: str
    summary: str
    commands: tuple[Command, ...]
