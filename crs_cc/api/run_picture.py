"""The picture of a session: the world from above and the robots' paths."""

from __future__ import annotations

from copy import copy
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.plot.picture import Picture, RobotPath

if TYPE_CHECKING:
    from crs_cc.session.session import Session

_MAX_POSITIONS: Final = 400
"""Positions that are kept of each robot; when there are more, every other one is dropped."""


class Paths:
    """The positions of robots now and then, in bounded memory.

    >>> paths = Paths(np.zeros((1, 2)))
    >>> for timestep in range(1, 2000):
    ...     if paths.is_due(timestep):
    ...         paths.add(timestep, np.full((1, 2), float(timestep)))
    >>> len(paths.of(0)) <= 400, paths.of(0)[:3, 0].tolist()
    (True, [0.0, 8.0, 16.0])
    """

    def __init__(self, start_m: FloatArray) -> None:
        self._samples = [start_m.copy()]
        self._stride, self._next = 1, 1

    def copy(self) -> Paths:
        """Return a copy; positions that are added later do not change it."""
        copied = copy(self)
        copied._samples = self._samples.copy()
        return copied

    def is_due(self, timestep: int) -> bool:
        """Return whether it is time for positions."""
        return timestep >= self._next

    def timesteps_left(self, timestep: int) -> int:
        """Return after how many timesteps it is time for positions, at least 1."""
        return max(1, self._next - timestep)

    def add(self, timestep: int, position_m: FloatArray) -> None:
        """Add the positions of all robots after a number of timesteps, (robots, 2)."""
        self._samples.append(position_m.copy())
        if len(self._samples) > _MAX_POSITIONS:
            self._samples = self._samples[::2]
            self._stride *= 2
        self._next = timestep // self._stride * self._stride + self._stride

    def of(self, robot: int) -> FloatArray:
        """Return the path of a robot [m], (samples, 2)."""
        rows = [sample[robot] for sample in self._samples if robot < len(sample)]
        return np.array(rows).reshape(-1, 2)


def picture_of(session: Session, paths: Paths) -> str:
    """Return the picture of a run so far as SVG."""
    environment = session.environment
    state, world = environment.state, environment.world_now
    joined, gone = np.isfinite(state.presence.joined_s), np.isfinite(state.presence.left_s)
    robot_paths = [
        RobotPath(
            robot,
            np.vstack([paths.of(number), state.bodies.position_m[number]]),
            float(state.heading_rad[number]),
            left=bool(gone[number]),
        )
        if joined[number]
        else RobotPath(robot, np.zeros((0, 2)), 0.0)
        for number, robot in enumerate(world.robots)
    ]
    collisions = int(state.collisions.sum())
    subtitle = f"{session.time_s:.2f} s simulated, {collisions} contacts"
    return Picture(world.name, subtitle, world, robot_paths).render().decode()
