"""The part of the state that kernels change, as one row of memory for each robot.

The arrays of its columns are views of these rows, which lie in the memory of kernels, so that these
need no copies. Those of more robots than the kernels have room for are copied for each call. The
order is that of `struct robot` in `kernels/robot.h`.

>>> from crs_cc.sim.files.world_xml import empty_world
>>> from crs_cc.sim.state.env_state import EnvState
>>> state = EnvState.at_start(empty_world())
>>> rows = state.rows
>>> state.drive.clock_s[0] = 7.0
>>> 7.0 in rows.table[0], rows.table.shape == (1, ROBOT_SIZE)
(True, True)
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import fields
from operator import attrgetter
from typing import Any, Final, NamedTuple, TypeAlias

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, Records
from crs_cc.sim.kernels.program import ROBOTS_AT_ONCE, Kernels, kernels
from crs_cc.sim.kernels.tables import (
    ADVANCED,
    BATTERY,
    BATTERY_SIZE,
    BODIES,
    BODY_SIZE,
    KIND,
    KINDS,
    NOT_HANDLED,
    REPLY,
    RING_SIZE,
    RINGS,
    ROBOT_SIZE,
    ROBOTS,
)
from crs_cc.sim.state.motion_profile import Axes
from crs_cc.sim.state.robot_kinds import RobotKinds
from crs_cc.sim.state.rows import ALL, Rows, parts

_Parts: TypeAlias = Sequence[tuple[str, Sequence[str]]]

_NUMBER: Final = 8  # bytes
_UNKNOWN: Final = -1.0
_ROBOT: Final = (
    ("drive.axes", [each.name for each in fields(Axes)]),
    ("odometry", ["shaft", "reported", "x_m", "y_m", "heading_rad", "turret_rad"]),
    ("drive", ["slice", "moved_m", "facing_rad", "turret_rad", "clock_s"]),
    ("drive", ["timeout_s", "deadline_s"]),
    ("timers", ["soonest_s"]),
    ("devices.sonar", ["next_s", "heard_s", "echo_m", "listening"]),
    ("drive", ["ramp", "forward_mps", "ahead_m"]),
    ("", ["heading_rad", "mount_rad", "base_rad", "distance_m"]),
    ("drive", ["command", "command_cycle"]),
    ("", ["commands"]),
    ("devices.bumper", ["pressed"]),
    ("drive", ["limp", "hindered"]),
    ("bodies", ["slipping"]),
    ("", ["connected"]),
)
_BODY: Final = (("bodies", ["position_m", "velocity_mps", "angle_rad", "spin_radps"]),)
_SONARS: Final = (
    ("devices.sonar", ["order", "length", "start_s", "interval_s", "turn", "count", "mode"]),
    ("devices.sonar", ["sent_s", "heard_m", "fired_s", "sent_from", "fired_from"]),
)
_BATTERY: Final = (("devices.motor_battery", ["moved_j", "speed_mps"]),)
_NO_REPLIES: Final = np.zeros(0), np.zeros((0, 3)), np.zeros(0, REPLY)
_TABLES: Final = (
    (_ROBOT, ROBOT_SIZE),
    (_BODY, BODY_SIZE),
    (_BATTERY, BATTERY_SIZE),
    (_SONARS, RING_SIZE),
)


class RobotRows:
    """The rows of all robots, bodies and batteries of a state.

    Attributes:
        table: the rows of robots, (robots, `ROBOT_SIZE`).
        bodies: those of the bodies, the robots first, (bodies, `BODY_SIZE`).
        batteries: those of motor batteries, (batteries, `BATTERY_SIZE`).
        sonars: those of the robots' sonars, (robots, `RING_SIZE`).
    """

    def __init__(self, state: Any, before: RobotRows | None = None) -> None:
        """Move the columns of a state into rows.

        Args:
            state: the state, an `EnvState`.
            before: the rows of another state, which is not used any more.
        """
        self._home: Kernels | None = None
        self._kinds: RobotKinds | None = None  # in the kernels' memory
        if len(state.drive.clock_s) <= ROBOTS and len(state.bodies.angle_rad) <= BODIES:
            self._home = (before and before._home) or Kernels(holds_world=True)
        resident = self._home
        homes: tuple[Any, ...] = (None,) * len(_TABLES)
        if resident is not None:
            rings = resident.sonars if len(state.drive.clock_s) <= RINGS else None
            homes = resident.robots, resident.bodies, resident.batteries, rings
        self.table, self.bodies, self.batteries, self.sonars = (
            _moved(state, parts, size, memory)
            for (parts, size), memory in zip(_TABLES, homes, strict=True)
        )

    def replace_bodies(self, state: Any) -> None:
        """Move the bodies of a state, which are new and not more than before, into rows."""
        memory = None if self._home is None else self._home.bodies
        self.bodies = _moved(state, _BODY, BODY_SIZE, memory)

    def tables(self, kinds: RobotKinds) -> tuple[FloatArray, ...]:
        """Return the rows of robots, with their kinds, of bodies, batteries and sonars."""
        self.resident_kernels(kinds)
        return self.table, self.bodies, self.batteries, self.sonars

    def advance(
        self, rows: Rows, to_s: FloatArray, last_s: float, kinds: RobotKinds, *, renews: bool
    ) -> int:
        """Advance the axes of robots as commanded, see `Kernels.advance`.

        Args:
            rows: the robots, k of them.
            to_s: the time of each, (k,).
            last_s: the time up to which sensors matter.
            kinds: their constants.
            renews: whether their command timeouts restart.

        Returns:
            `ADVANCED`, or what happens to one of them; then some of the others may be advanced.
        """
        resident = self.resident_kernels(kinds)
        if resident is not None:
            return resident.advance(_selected(rows), to_s, last_s, renews=renews)
        found = ADVANCED
        for staged in self._staged(rows, len(to_s), kinds):
            found = staged.own.advance(None, to_s[staged.part], last_s, renews=renews)
            if found != ADVANCED:
                break
            self._copy_back(staged)
        return found

    def set_speeds(
        self,
        rows: Rows,
        speed: FloatArray,
        kinds: RobotKinds,
        *,
        ramp: FloatArray | None = None,
        which: BoolArray | None = None,
    ) -> None:
        """Ramp axes to speeds within their limits, from the time to which they were advanced.

        Args:
            rows: the robots, k of them.
            speed: of each axis, (k, 3).
            kinds: their constants.
            ramp: the accelerations, (k, 3); by default those of commands.
            which: the axes to change, (k, 3); by default all.
        """
        flags = None if which is None else which.astype(np.float64)
        resident = self.resident_kernels(kinds)
        if resident is not None:
            resident.set_speeds(_selected(rows), speed, ramp, flags)
            return
        for staged in self._staged(rows, len(speed), kinds):
            ramps, marks = (None if each is None else each[staged.part] for each in (ramp, flags))
            staged.own.set_speeds(None, speed[staged.part], ramps, marks)
            self._copy_back(staged)

    def reports(self, rows: Rows, count: int, kinds: RobotKinds) -> Int32Array:
        """Return the motion values in `State` of robots, shape (k, 8), see `Kernels.reports`.

        Args:
            rows: the robots, k of them.
            count: their number.
            kinds: their constants.
        """
        resident = self.resident_kernels(kinds)
        if resident is not None:
            return resident.reports(_selected(rows), count)
        staged = self._staged(rows, count, kinds)
        return np.concatenate([each.own.reports(None, each.robots) for each in staged])

    def resident_kernels(self, kinds: RobotKinds) -> Kernels | None:
        """Return the kernels in whose memory the rows lie, with the constants; None if too many."""
        resident = self._home
        if resident is None or len(kinds.table) > KINDS:
            return None
        if kinds is not self._kinds:
            _lay(resident.kinds, kinds.table)
            self.table[:, KIND], self.table[:, BATTERY] = kinds.kind, kinds.battery
            self._kinds = kinds
        return resident

    def replies(self, rows: Rows, for_s: FloatArray, kinds: RobotKinds) -> Records:
        """Return the contents of replies of robots, (k,) of dtype `REPLY`.

        Args:
            rows: the robots, k of them.
            for_s: the time for which each has been in the world, (k,).
            kinds: their constants.
        """
        resident = self.resident_kernels(kinds)
        if resident is not None:
            return resident.replies(_selected(rows), for_s)
        staged = self._staged(rows, len(for_s), kinds)
        return np.concatenate([each.own.replies(None, for_s[each.part]) for each in staged])

    def serve(
        self,
        rows: Rows,
        service: tuple[float, float, int, int],
        asked: tuple[FloatArray, FloatArray, Int32Array],
        kinds: RobotKinds,
    ) -> tuple[int, FloatArray, FloatArray, Records]:
        """Answer requests that need nothing but these rows, see `Kernels.serve`.

        Args:
            rows: the robots, k of them.
            service: what the requests have in common.
            asked: when they arrive, when the robots have joined, and the integers of the messages.
            kinds: the robots' constants.
        """
        resident = self.resident_kernels(kinds)
        if resident is None:
            return NOT_HANDLED, *_NO_REPLIES
        return resident.serve(_selected(rows), service, *asked)

    def fire(
        self,
        rows: Rows,
        to_s: FloatArray,
        numbers: bytes,
        sizes: tuple[int, int, int],
        kinds: RobotKinds,
    ) -> int:
        """Fire sonars that are due, see `Kernels.fire`.

        Args:
            rows: the robots, k of them.
            to_s: up to when, (k,).
            numbers: what echoes depend on.
            sizes: how much of it there is.
            kinds: the robots' constants.
        """
        resident = self.resident_kernels(kinds) if len(self.sonars) <= RINGS else None
        return (
            NOT_HANDLED
            if resident is None
            else resident.fire(_selected(rows), to_s, numbers, sizes)
        )

    def charges(self, rows: Rows, for_s: FloatArray, kinds: RobotKinds) -> FloatArray:
        """Return the charges of the batteries of computers and motors, 0 to 1, (k, 2).

        Args:
            rows: the robots, k of them.
            for_s: the time for which each has been in the world, (k,).
            kinds: their constants.
        """
        resident = self.resident_kernels(kinds)
        if resident is not None:
            return resident.charges(_selected(rows), for_s)
        staged = self._staged(rows, len(for_s), kinds)
        return np.concatenate([each.own.charges(None, for_s[each.part]) for each in staged])

    def finish(
        self,
        state: Any,
        times_s: tuple[float, float],
        before_m: FloatArray | None,
        kinds: RobotKinds,
    ) -> tuple[int, list[int], bool]:
        """End a cycle of all robots, see `Kernels.finish`.

        Args:
            state: the state whose rows these are.
            times_s: the length of the cycle, and its end.
            before_m: where the robots were, if they have moved already, (robots, 2).
            kinds: their constants.
        """
        joined_s, count = state.presence.joined_s, len(self.table)
        resident = self.resident_kernels(kinds)
        if resident is not None:
            cycle = *times_s, before_m is None, _UNKNOWN
            return resident.finish(count, cycle, joined_s, before_m)
        # What is true of all is not known to a part of them; few enough to be free are one part.
        works, is_weary = state.drive.slice.any() or state.bodies.slipping.any(), False
        found, empty = ADVANCED, list[int]()
        for staged in self._staged(ALL, count, kinds):
            part = staged.part
            before = None if before_m is None else before_m[part]
            cycle = *times_s, before is None, float(works)
            found, some, weary = staged.own.finish(staged.robots, cycle, joined_s[part], before)
            is_weary |= weary
            empty += [part.start + each for each in some]
            self._copy_back(staged)
        return found, empty, is_weary

    def _staged(self, rows: Rows, count: int, kinds: RobotKinds) -> Iterator[_StagedRows]:
        """Yield this thread's kernels with copies of some rows, as often as needed for all."""
        own = kernels()
        for some, part in parts(rows, count, ROBOTS_AT_ONCE):
            copies, numbers = self.table[some].copy(), kinds.battery[some]
            has = numbers >= 0
            copies[:, KIND] = np.arange(len(copies))
            copies[:, BATTERY] = np.where(has, np.cumsum(has) - 1, -1)
            _lay(own.kinds, kinds.table[kinds.kind[some]])
            _lay(own.robots, copies)
            _lay(own.bodies, self.bodies[: len(self.table)][some])
            _lay(own.batteries, self.batteries[numbers[has]])
            yield _StagedRows(own, some, part, numbers[has])

    def _copy_back(self, staged: _StagedRows) -> None:
        """Copy rows back after a kernel has changed them."""
        own, count, batteries = staged.own, staged.robots, len(staged.batteries)
        self.table[staged.some] = _table(own.robots, count, ROBOT_SIZE)
        self.bodies[: len(self.table)][staged.some] = _table(own.bodies, count, BODY_SIZE)
        self.batteries[staged.batteries] = _table(own.batteries, batteries, BATTERY_SIZE)


class _StagedRows(NamedTuple):
    """Copies of rows in the memory of kernels.

    Attributes:
        own: the kernels.
        some: the robots.
        part: their places among those that are asked for.
        batteries: the numbers of their batteries.
    """

    own: Kernels
    some: Rows
    part: slice
    batteries: IndexArray

    @property
    def robots(self) -> int:
        """Return the number of robots."""
        return int(self.part.stop - self.part.start)


def _table(memory: Any, count: int, size: int) -> FloatArray:
    return np.ndarray((count, size), np.float64, memory)


def _moved(state: Any, parts: _Parts, size: int, memory: Any) -> FloatArray:
    """Return the rows of some columns of a state, to which these are moved.

    Args:
        state: the state.
        parts: the columns, in order.
        size: numbers in a row.
        memory: where to lay the rows; None for memory of their own.
    """
    first = getattr(attrgetter(parts[0][0])(state), parts[0][1][0])
    content = bytearray(len(first) * size * _NUMBER) if memory is None else memory
    table, place = _table(content, len(first), size), 0
    for path, names in parts:
        part = attrgetter(path)(state) if path else state
        for name in names:
            array = getattr(part, name)
            width = int(array.itemsize) * math.prod(array.shape[1:])
            column = table.view(np.uint8)[:, place : place + width]
            view = column.view(array.dtype).reshape(array.shape)
            view[...] = array
            setattr(part, name, view)
            place += width
    return table


def _selected(rows: Rows) -> IndexArray | None:
    return None if isinstance(rows, slice) else rows


def _lay(memory: Any, rows: FloatArray) -> None:
    memory[: rows.nbytes] = rows.tobytes()
