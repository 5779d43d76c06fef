"""Poses for which programs have asked the user: he points at the world, in a page.

>>> pointing = Pointing()
>>> pointing.ask(2, print)
>>> pointing.robots
[2]
>>> pointing.point(2, 1.0, -2.0, 90.0)
(1.0, -2.0, 90.0)
>>> pointing.robots
[]
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

Pose: TypeAlias = tuple[float, float, float]
"""Position [m] and heading [deg]."""


class Pointing:
    """The questions that wait for an answer; in the run's thread."""

    def __init__(self) -> None:
        self._asked: dict[int, Callable[[Pose], None]] = {}

    @property
    def robots(self) -> list[int]:
        """The numbers of the robots whose programs have asked."""
        return sorted(self._asked)

    def ask(self, robot: int, answer: Callable[[Pose], None]) -> None:
        """Ask for a pose; this replaces an earlier request for this robot."""
        self._asked[robot] = answer

    def forget(self, robot: int) -> None:
        """Cancel the request: its client is gone."""
        self._asked.pop(robot, None)

    def point(self, robot: int, x_m: float, y_m: float, heading_deg: float) -> None:
        """Answer a request; raise ValueError if there is none."""
        answer = self._asked.pop(robot, None)
        if answer is None:
            raise ValueError(f"no program has asked for a pose for robot {robot}")
        answer((x_m, y_m, heading_deg))
