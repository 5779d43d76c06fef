"""Sensors that measure by a timer of their own, whether anybody asks or not.

The CRS report (4.2) has periodic sensors, each with an event timer, and others that measure when
the program asks. Here a sensor is one or the other as its definition says (`period`), or as the
program says (`crs_period`). With a timer it measures at

    start + n * period

to the exact multiple, wherever that falls in a timestep, from the place where the robot is then;
`start` is the start of the run, the instant at which the robot joined, or that of `crs_period`.
Whoever asks is told what was measured last, and may ask how old that is (`crs_age`). The sensor's
rate is the shortest period.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, TypeAlias

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.requests import LARGEST
from crs_cc.sim.state.timers import sensor_count

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


_MS: Final = 0.001
_LONGEST_MS: Final = 3_600_000
_NEVER: Final = -1


Read: TypeAlias = "Callable[[EnvState, RobotConstants, RayCaster, IndexArray, FloatArray], None]"
"""Lets sensors measure, those whose time has come: of which robots that have one, and when."""


@dataclass(frozen=True, slots=True)
class Timed:
    """A kind of sensor that can have a timer.

    Attributes:
        read: lets it measure.
        numbers: from the constants: the number of each robot among those that have one, -1 for the
            others, (robots,).
        measured_s: from the state: when each measured last; below 0 for never, (n,).
        interval_s: the least time between two measurements of each, (n,).
    """

    read: Read
    numbers: Callable[[RobotConstants], IndexArray]
    measured_s: Callable[[EnvState], FloatArray]
    interval_s: FloatArray


class Timers:
    """The timers of all robots."""

    def __init__(self, sensors: Mapping[int, Timed]) -> None:
        """Makes them.

        Args:
            sensors: the kinds of sensors, by their numbers in `crs.h`.
        """
        self._sensors = sensors

    def fire(
        self, state: EnvState, constants: RobotConstants, rays: RayCaster, rows: IndexArray
    ) -> None:
        """Measure with those sensors of robots whose timers fire first.

        Args:
            state: changed in place; axes were turned to the timers' instants.
            constants: the robots' constants.
            rays: what there is to see.
            rows: robots that have a timer, k of them.
        """
        timers = state.timers
        soonest_s = timers.soonest_s[rows]
        begin_s = state.cycle * constants.timestep_s
        for sensor in range(sensor_count()):
            due = timers.next_s[rows, sensor] == soonest_s
            if due.any():
                mine, at_s = rows[due], soonest_s[due]
                self._sensors[sensor].read(state, constants, rays, mine, at_s)
                timers.go_on(mine, sensor, begin_s)

    def set_period(self, context: RequestContext) -> BoolArray:
        """Answer PERIOD; refuse sensors that the robot does not have, and times below 0."""
        good = self._has(context)
        periods_ms = context["period_ms"].tolist()
        for place in np.flatnonzero(good).tolist():
            robot, period_ms = context.rows[place], periods_ms[place]
            sensor = int(context["sensor"][place])
            timed = self._sensors[sensor]
            if period_ms < 0:
                good[place] = False
                continue
            least_s = float(timed.interval_s[timed.numbers(context.constants)[robot]])
            period_s = max(min(period_ms, _LONGEST_MS) * _MS, least_s) if period_ms else 0.0
            context.state.timers.set(robot, sensor, period_s, float(context.at_s[place]))
        return good

    def get_age(self, context: RequestContext) -> BoolArray:
        """Answer AGE with the time since a sensor measured [ms], -1 for never."""
        good = self._has(context)
        for place in np.flatnonzero(good).tolist():
            timed = self._sensors[int(context["sensor"][place])]
            number = timed.numbers(context.constants)[context.rows[place]]
            measured_s = float(timed.measured_s(context.state)[number])
            age_s = float(context.at_s[place]) - measured_s  # infinite for never
            age_ms = round(min(age_s / _MS, LARGEST))
            context.put("age_ms", _NEVER if measured_s < 0.0 else age_ms, place)
        return good

    def _has(self, context: RequestContext) -> BoolArray:
        """Return which requests name a sensor that the robot has."""
        sensor = context["sensor"]
        has = np.zeros(len(sensor), dtype=np.bool_)
        for number, timed in self._sensors.items():
            has |= (sensor == number) & (timed.numbers(context.constants)[context.rows] >= 0)
        return has


def read_on_request(context: RequestContext, read: Read, sensor: int, which: BoolArray) -> None:
    """Measure with those sensors that have no timer, as a request asks for a reading.

    Args:
        context: the requests.
        read: makes sensors measure.
        sensor: their number in `crs.h`.
        which: which of the robots are asked, (k,).
    """
    asked = which & context.state.timers.on_request(context.rows, sensor)
    rows, at_s = context.rows[asked], context.at_s[asked]
    read(context.state, context.constants, context.rays, rows, at_s)
