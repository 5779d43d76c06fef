"""The user's notes on positions of a run, which are kept in its recording.

>>> note = Note(Position(3, 0, 1, 40), 1, 0.16, "here it turns the wrong way")
>>> Note.of(note.as_data()) == note
True
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final, Self

from crs_cc.debug.timeline.position import Position

KIND: Final = "note"
"""What it is called among the input of a recording."""


@dataclass(frozen=True, slots=True)
class Note:
    """A note.

    Attributes:
        position: the instant.
        robot: the robot that was selected.
        time_s: the clock of its program then [s].
        text: what the user wrote.
    """

    position: Position
    robot: int
    time_s: float
    text: str

    def as_data(self) -> dict[str, Any]:
        """Return it as plain data."""
        at = self.position
        return {
            "kind": KIND,
            "robot": self.robot,
            "time_s": self.time_s,
            "text": self.text,
            "position": [at.timestep, at.round, at.robot, at.statements],
        }

    @classmethod
    def of(cls, data: Mapping[str, Any]) -> Self:
        """Return it from plain data.

        Raises:
            ValueError: it is not valid.
            KeyError: something is missing.
            TypeError: something has another type.
        """
        timestep, round_, halted, statements = map(int, data["position"])
        robot, time_s = int(data["robot"]), float(data["time_s"])
        if min(timestep, round_, statements, halted + 1, robot) < 0 or not math.isfinite(time_s):
            raise ValueError("a note has an invalid position")
        place = Position(timestep, round_, halted, statements)
        return cls(place, robot, time_s, str(data["text"]))
