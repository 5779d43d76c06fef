"""What a run does, as bytes of its arrays one after the other: quick to copy, and little to keep.

A timestep of one robot takes half a millisecond, and many arrays of a few numbers would take longer
to keep, and to find again, than to copy. Nothing is computed of them until it is encoded.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.recording.mcap_records import ns
from crs_cc.recording.readings import STATE, Readings

if TYPE_CHECKING:
    from crs_cc.core.arrays import BoolArray, FloatArray
    from crs_cc.sim.engine.step import Served
    from crs_cc.sim.state.env_state import EnvState

Frames = tuple[list[int], "FloatArray"]
"""Times [ns], and the numbers of the frames of these times (frames, columns, rows)."""

_NUMBER: Final = 8  # bytes


class GatheredFrames:
    """Where everything is, of one set of bodies."""

    def __init__(self) -> None:
        """Create one without frames."""
        self._times_s: list[float] = []
        self._present: list[BoolArray] = []
        self._position_m, self._angle_rad = bytearray(), bytearray()  # of all bodies
        self._heading_rad, self._turret_rad = bytearray(), bytearray()  # of the robots

    def __len__(self) -> int:
        """Return the number of frames."""
        return len(self._times_s)

    @property
    def rows(self) -> int:
        """Return how many bodies are in all frames together."""
        return len(self._angle_rad) // _NUMBER

    def add(self, time_s: float, state: EnvState, *, has_turret: bool) -> None:
        """Copy a frame from a state."""
        bodies = state.bodies
        self._times_s.append(time_s)
        self._present.append(state.presence.present)  # never changed in place
        self._position_m += bodies.position_m.tobytes()
        self._angle_rad += bodies.angle_rad.tobytes()
        self._heading_rad += state.heading_rad.tobytes()
        if has_turret:
            self._turret_rad += state.drive.turret_rad.tobytes()

    def since(self, number: int) -> Frames:
        """Return the frames from a number on, at least one."""
        angles_rad, headings_rad = self._rows(self._angle_rad), self._rows(self._heading_rad)
        rows, robots, has_turret = angles_rad.shape[1], headings_rad.shape[1], self._turret_rad
        positions_m = self._rows(self._position_m).reshape(-1, rows, 2)
        block = np.zeros((len(self) - number, 4 if has_turret else 3, rows))
        block[:, :2] = positions_m[number:].swapaxes(1, 2)
        block[:, 2] = angles_rad[number:]
        block[:, 2, :robots] = headings_rad[number:]
        if has_turret:
            block[:, 3, :robots] = self._rows(self._turret_rad)[number:]
        is_there = np.array(self._present[number:])
        if not is_there.all():
            block.swapaxes(1, 2)[:, :robots][~is_there] = np.nan
        return [ns(each) for each in self._times_s[number:]], block

    def _rows(self, column: bytearray) -> FloatArray:
        """Return a column, which must not grow as long as this is used."""
        return np.frombuffer(column).reshape(len(self), -1)


class GatheredOdometry:
    """Where the robots believe to be."""

    def __init__(self) -> None:
        """Create one without frames."""
        self._times_s: list[float] = []
        self._believed = bytearray()

    def __len__(self) -> int:
        """Return the number of frames."""
        return len(self._times_s)

    @property
    def rows(self) -> int:
        """Return how many robots are in all frames together."""
        return len(self._believed) // (3 * _NUMBER)

    def add(self, time_s: float, state: EnvState) -> None:
        """Copy a frame from a state."""
        odometry = state.odometry
        self._times_s.append(time_s)
        self._believed += odometry.x_m.tobytes()
        self._believed += odometry.y_m.tobytes()
        self._believed += odometry.heading_rad.tobytes()

    def since(self, number: int) -> Frames:
        """Return the frames from a number on, at least one."""
        columns = np.frombuffer(self._believed).reshape(len(self), 3, -1)
        return [ns(each) for each in self._times_s[number:]], columns[number:].copy()


class GatheredReadings:
    """The `State` vectors that programs were given.

    Attributes:
        rows: how many vectors.
    """

    def __init__(self) -> None:
        """Create one without readings."""
        self.rows = 0
        self._heads: list[tuple[float, int, int]] = []  # start of the timestep [s], code, rows
        self._robots, self._clock_s, self._states = bytearray(), bytearray(), bytearray()

    def __len__(self) -> int:
        """Return how often a request was answered, of some robots together."""
        return len(self._heads)

    def add(self, time_s: float, answers: Iterable[Served]) -> None:
        """Add the answers of a timestep, of which those without vectors are left out.

        Args:
            time_s: its start.
            answers: the answers.
        """
        for each in answers:
            states = each.states
            if states is not None:
                count = len(states)
                self.rows += count
                self._heads.append((time_s, each.code, count))
                self._robots += each.robots.tobytes()
                self._clock_s += each.clock_s.tobytes()
                self._states += states.tobytes()

    def since(self, number: int) -> tuple[int, Readings]:
        """Return the answers from a number on, at least one, and the time of the first [ns]."""
        heads = self._heads[number:]
        counts = [count for _, _, count in heads]
        first = self.rows - sum(counts)
        return ns(heads[0][0]), Readings(
            np.repeat([code for _, code, _ in heads], counts),
            np.frombuffer(self._robots, np.intp)[first:].copy(),
            np.frombuffer(self._clock_s)[first:].copy(),
            np.frombuffer(self._states, np.int32).reshape(-1, STATE)[first:].copy(),
        )
