"""Sensors that measure by a timer of their own, independently of requests.

The CRS report (4.2) has periodic sensors, each with an event timer, and others that measure when
the program requests it. Here the definition (`period`) or the program (`crs_period`) selects one
of these. With a timer a sensor measures at

    start + n * period

at the exact multiple, anywhere in a timestep, from the robot's pose at that time; `start` is the
time at which the run started, the robot joined, or `crs_period` was called. Requests return the
last measurement; `crs_age` returns its age. The sensor's rate limits the period.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, IndexArray, all_of
from crs_cc.requests import LARGEST
from crs_cc.sim.model.registry import sensor_count

if TYPE_CHECKING:
    from crs_cc.sim.devices.installed import Read, Timed
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


_MS: Final = 0.001
_MAX_PERIOD_MS: Final = 3_600_000
_NEVER: Final = -1


class Timers:
    """The timers of all robots."""

    def __init__(self, sensors: Mapping[int, tuple[str, Timed]]) -> None:
        """Create the timers.

        Args:
            sensors: the kinds of sensors and their names, by their numbers in `crs.h`.
        """
        self._sensors = sensors

    def fire(
        self, state: EnvState, constants: RobotConstants, rays: RayCaster, rows: IndexArray
    ) -> None:
        """Measure with the sensors whose timers expire first.

        Args:
            state: changed in place; axes were turned to the timers' times.
            constants: the robots' constants.
            rays: casts rays.
            rows: robots with a timer, k of them.
        """
        timers = state.timers
        soonest_s = timers.soonest_s[rows]
        begin_s = state.cycle * constants.timestep_s
        for sensor in range(sensor_count()):
            due = timers.next_s[rows, sensor] == soonest_s
            if due.any():
                mine, at_s = rows[due], soonest_s[due]
                self._sensors[sensor][1].read(state, constants, rays, mine, at_s)
                timers.restart(mine, sensor, begin_s)

    def set_period(self, context: RequestContext) -> BoolArray:
        """Answer PERIOD; refuse missing sensors and times below 0."""
        good = self._has(context)
        periods_ms = context["period_ms"].tolist()
        for place in np.flatnonzero(good).tolist():
            robot, period_ms = context.rows[place], periods_ms[place]
            sensor = int(context["sensor"][place])
            name, timed = self._sensors[sensor]
            if period_ms < 0:
                good[place] = False
                continue
            least_s = float(timed.interval_s[context.constants.numbers[name][robot]])
            period_s = max(min(period_ms, _MAX_PERIOD_MS) * _MS, least_s) if period_ms else 0.0
            context.state.timers.set(robot, sensor, period_s, float(context.at_s[place]))
        return good

    def get_age(self, context: RequestContext) -> BoolArray:
        """Answer AGE with the time since a sensor measured [ms], -1 for never."""
        good = self._has(context)
        for place in np.flatnonzero(good).tolist():
            name, timed = self._sensors[int(context["sensor"][place])]
            number = context.constants.numbers[name][context.rows[place]]
            measured_s = float(timed.measured_s(context.state)[number])
            age_s = float(context.at_s[place]) - measured_s  # infinite for never
            age_ms = round(min(age_s / _MS, LARGEST))
            context.put("age_ms", _NEVER if measured_s < 0.0 else age_ms, place)
        return good

    def _has(self, context: RequestContext) -> BoolArray:
        """Return which requests name a sensor that the robot has."""
        sensor = context["sensor"]
        has = np.zeros(len(sensor), dtype=np.bool_)
        for number, (name, _) in self._sensors.items():
            has |= (sensor == number) & (context.constants.numbers[name][context.rows] >= 0)
        return has


def read_on_request(
    context: RequestContext, read: Read, sensor: int | None, which: BoolArray
) -> None:
    """Measure with the sensors that have no timer, for a request.

    Args:
        context: the requests.
        read: measures with sensors.
        sensor: their number in `crs.h`; None if they cannot have a timer.
        which: the requests that the robot does not refuse, (k,).
    """
    requested = which
    if sensor is not None:
        requested = which & context.state.timers.on_request(context.rows, sensor)
    rows, at_s = context.rows, context.at_s
    if not all_of(requested):
        rows, at_s = rows[requested], at_s[requested]
    read(context.state, context.constants, context.rays, rows, at_s)
