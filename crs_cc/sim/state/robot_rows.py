"""The part of the state that kernels change, as one row of memory for each robot.

The arrays of its columns are views of these rows, which lie in the memory of kernels, so that these
need no copies. Those of more robots than the kernels have room for are copied for each call. The
order is that of `struct robot` in `kernels/robot.h`.

>>> from crs_cc.sim.files.world_xml import empty_world
>>> from crs_cc.sim.state.env_state import EnvState
>>> state = EnvState.at_start(empty_world())
>>> rows = state.rows
>>> state.drive.clock_s[0] = 7.0
>>> 7.0 in rows.table[0], rows.table.shape == (1, ROW_SIZE)
(True, True)
"""

from __future__ import annotations

import math
from dataclasses import fields
from operator import attrgetter
from typing import Any, Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray, Int32Array
from crs_cc.sim.kernels.program import (
    ADVANCED,
    ROBOT_BYTES,
    ROBOTS,
    ROBOTS_AT_ONCE,
    Kernels,
    kernels,
)
from crs_cc.sim.state.motion_profile import Axes
from crs_cc.sim.state.rows import Rows, parts, take

ROW_SIZE: Final = ROBOT_BYTES // 8
"""Numbers in a row."""

_PARTS: Final = (
    ("drive.axes", [each.name for each in fields(Axes)]),
    ("odometry", ["shaft", "told", "x_m", "y_m", "heading_rad", "turret_rad"]),
    ("drive", ["slice", "moved_m", "facing_rad", "turret_rad", "clock_s"]),
    ("drive", ["timeout_s", "deadline_s"]),
    ("timers", ["soonest_s"]),
    ("devices.sonar", ["next_s", "heard_s", "listening"]),
    ("drive", ["limp", "hindered"]),
)


class RobotRows:
    """The rows of all robots of a state.

    Attributes:
        table: the rows, (robots, `ROW_SIZE`).
    """

    def __init__(self, state: Any, before: RobotRows | None = None) -> None:
        """Move the columns of a state into rows.

        Args:
            state: the state, an `EnvState`.
            before: the rows of another state, which is not used any more.
        """
        count = len(state.drive.clock_s)
        self._home: Kernels | None = None
        self._drives: FloatArray | None = None  # in the kernels' memory
        if count <= ROBOTS:
            self._home = (before and before._home) or Kernels()
        content = bytearray(count * ROBOT_BYTES) if self._home is None else self._home.robots
        self.table: FloatArray = np.ndarray((count, ROW_SIZE), np.float64, content)
        place = 0
        for path, names in _PARTS:
            part = attrgetter(path)(state)
            for name in names:
                place = self._move(part, name, place)

    def _move(self, part: Any, name: str, place: int) -> int:
        """Move an array into rows, from a byte on; return where the next one begins."""
        array = getattr(part, name)
        size, width = int(array.itemsize), int(math.prod(array.shape[1:]))
        row = self.table.view(np.uint8)[:, place : place + size * width]
        view = row.view(array.dtype).reshape(array.shape)
        view[...] = array
        setattr(part, name, view)
        return place + size * width

    def advance(
        self, rows: Rows, to_s: FloatArray, last_s: float, drives: FloatArray, *, renews: bool
    ) -> int:
        """Advance the axes of robots as commanded, see `Kernels.advance`.

        Args:
            rows: the robots, k of them.
            to_s: the time of each, (k,).
            last_s: the time up to which sensors matter.
            drives: the constants of all robots, see `Drives.table`.
            renews: whether their command timeouts begin anew.

        Returns:
            `ADVANCED`, or what happens to one of them; then some of the others may be advanced.
        """
        if self._home is not None:
            self._hold(drives)
            return self._home.advance(_selected(rows), to_s, last_s, renews=renews)
        own, found = kernels(), ADVANCED
        for some, part in parts(rows, len(to_s), ROBOTS_AT_ONCE):
            _copy(own, take(drives, some), take(self.table, some))
            found = own.advance(None, to_s[part], last_s, renews=renews)
            if found != ADVANCED:
                break
            count = part.stop - part.start
            self.table[some] = np.ndarray((count, ROW_SIZE), np.float64, own.robots)
        return found

    def reports(self, rows: Rows, count: int, drives: FloatArray) -> Int32Array:
        """Return what `State` says of the motions of robots, shape (k, 8), see `Kernels.reports`.

        Args:
            rows: the robots, k of them.
            count: their number.
            drives: the constants of all robots, see `Drives.table`.
        """
        if self._home is not None:
            self._hold(drives)
            return self._home.reports(_selected(rows), count)
        own, reports = kernels(), []
        for some, part in parts(rows, count, ROBOTS_AT_ONCE):
            _copy(own, take(drives, some), take(self.table, some))
            reports.append(own.reports(None, part.stop - part.start))
        return np.concatenate(reports)

    def _hold(self, drives: FloatArray) -> None:
        if drives is not self._drives:
            assert self._home is not None
            self._home.drives[: drives.nbytes] = drives.tobytes()
            self._drives = drives


def _selected(rows: Rows) -> IndexArray | None:
    return None if isinstance(rows, slice) else rows


def _copy(own: Kernels, drives: FloatArray, robots: FloatArray) -> None:
    own.drives[: drives.nbytes] = drives.tobytes()
    own.robots[: robots.nbytes] = robots.tobytes()
