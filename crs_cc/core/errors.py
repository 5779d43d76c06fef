"""The errors reported to users, one class for each kind of cause.

>>> from crs_cc.core.source import Location
>>> str(WorldError.at(Location("room.xml", 4), "robot 'r1' stands inside a wall"))
"room.xml:4: error: robot 'r1' stands inside a wall"
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar, Self

from crs_cc.core.source import Diagnostic, Location, Stage


class CrsError(Exception):
    """An error with its diagnostics.

    Attributes:
        diagnostics: the messages, in the order in which they were found.
        exit_status: the exit status of `crs` for this error.
    """

    exit_status: ClassVar[int] = 70

    def __init__(self, diagnostics: Sequence[Diagnostic]) -> None:
        self.diagnostics = tuple(diagnostics)
        super().__init__("\n".join(message.render() for message in diagnostics))

    @classmethod
    def at(cls, location: Location, text: str, hint: str = "", stage: Stage = "") -> Self:
        """Return an error with a single diagnostic."""
        return cls([Diagnostic("error", location, text, hint=hint, stage=stage)])


class CompileError(CrsError):
    """Invalid C source: preprocessing, parsing, types or linking."""

    exit_status = 121


class WorldError(CrsError):
    """Invalid world or robot file."""

    exit_status = 122


class RecordingError(CrsError):
    """A recording or a snapshot that is not ours, is damaged, or is of another version."""

    exit_status = 120


class ReplayMismatch(CrsError):  # noqa: N818 - what it reports is no failure of ours
    """A recorded run has taken another course when it ran again."""

    exit_status = 125


class ProgramError(CrsError):
    """Undefined behaviour in a running C program; only its robot stops."""

    exit_status = 123


class DeviceError(CrsError):
    """An installed package has a device that cannot be used."""

    exit_status = 2


class InternalError(CrsError):
    """A bug in crs."""

    exit_status = 70
