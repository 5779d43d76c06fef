"""The errors that a user can meet, one class for each kind of blame.

>>> from crs_cc.core.source import Location
>>> str(WorldError.at(Location("room.xml", 4), "robot 'r1' stands inside a wall"))
"room.xml:4: error: robot 'r1' stands inside a wall"
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar, Self

from crs_cc.core.source import Diagnostic, Location, Stage


class CrsError(Exception):
    """What went wrong, as messages with their places.

    Attributes:
        diagnostics: the messages, in the order in which they were found.
        exit_status: what `crs` ends with when this error ends it.
    """

    exit_status: ClassVar[int] = 70

    def __init__(self, diagnostics: Sequence[Diagnostic]) -> None:
        self.diagnostics = tuple(diagnostics)
        super().__init__("\n".join(message.render() for message in diagnostics))

    @classmethod
    def at(cls, location: Location, text: str, hint: str = "", stage: Stage = "") -> Self:
        """Make an error of one message."""
        return cls([Diagnostic("error", location, text, hint=hint, stage=stage)])


class CompileError(CrsError):
    """The C source is at fault: preprocessing, parsing, types or linking."""

    exit_status = 121


class WorldError(CrsError):
    """The world or robot file is at fault."""

    exit_status = 122


class ProgramError(CrsError):
    """A running C program did what C forbids; only its robot stops."""

    exit_status = 123


class InternalError(CrsError):
    """We are at fault."""

    exit_status = 70
