"""What a command is: its names, how it is written, what is said about it, and what does it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from crs_cc.debug.commands.shell import Shell

Kind = Literal["text", "stop", "place", "log", "error"]
"""What a line is about: an answer, why a program stopped, where it stands, what a breakpoint
logs, what the user did wrong."""

Completes = Literal[
    "", "command", "place", "expression", "robot", "breakpoint", "display", "file", "catch",
    "checkpoint", "branch", "edit",
]  # fmt: skip
"""What an argument is, to be completed."""


@dataclass(frozen=True, slots=True)
class Line:
    """A line of an answer.

    Attributes:
        text: what it says, without colours.
        kind: what it is about.
    """

    text: str
    kind: Kind = "text"


@dataclass(frozen=True, slots=True)
class SourceLine:
    """A line of C.

    Attributes:
        number: its number in its file.
        code: the line.
        is_current: whether the program stands there.
        has_breakpoint: whether a breakpoint is there.
    """

    number: int
    code: str
    is_current: bool = False
    has_breakpoint: bool = False

    @property
    def head(self) -> str:
        """Gives what stands before the code: marks and the number."""
        mark = "=>" if self.is_current else "  "
        return f"{mark}{'*' if self.has_breakpoint else ' '}{self.number:4}  "

    @property
    def text(self) -> str:
        """Gives the line as plain text.

        >>> SourceLine(12, "x = 3;", is_current=True).text
        '=>   12  x = 3;'
        """
        return (self.head + self.code.expandtabs()).rstrip()


Answer = Iterator[str | Line | SourceLine]
"""What a command answers, line by line, while it is at work; a `str` is a `Line` of text."""


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
    run: Callable[[Shell, str], Answer]
    aliases: tuple[str, ...] = ()
    text: str = ""
    repeats: Literal["", "same", "on"] = ""
    completes: Completes = ""

    @property
    def usage(self) -> str:
        """Gives the command with its arguments."""
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
