"""The timers of sensors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int64Array
from crs_cc.sim.model.robot import RobotModel
from crs_cc.sim.model.world import WorldModel

GPS, CAMERA, HEAT, LASER, INFRARED, COMPASS, TILT, LIGHT, SOUND = range(9)
"""Numbers of the sensors that can have a timer, those of `crs.h`."""

SENSORS: Final = 9


@dataclass(slots=True)
class TimerState:
    """The timers; arrays have a row for each robot, a column for each sensor.

    Attributes:
        period_s: how often each measures; 0 for one that measures on request, (robots, 9).
        start_s: when the timer was set, (robots, 9).
        turn: how many periods have begun since then, (robots, 9).
        next_s: when each measures next, infinite without a timer, (robots, 9).
        soonest_s: the least of these, (robots,).
    """

    period_s: FloatArray
    start_s: FloatArray
    turn: Int64Array
    next_s: FloatArray
    soonest_s: FloatArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Gives timers as the robots' definitions set them."""
        periods = [_periods_s(robot.model) for robot in world.robots]
        period_s = np.array(periods, dtype=np.float64).reshape(-1, SENSORS)
        next_s = np.where(period_s > 0.0, 0.0, np.inf)
        none = np.zeros_like(period_s)
        return cls(
            period_s, none, none.astype(np.int64), next_s, next_s.min(axis=1, initial=np.inf)
        )

    def on_request(self, rows: IndexArray, sensor: int) -> BoolArray:
        """Tells which robots have no timer for a sensor."""
        return np.asarray(self.period_s[rows, sensor] == 0.0)

    def begin(self, rows: IndexArray, now_s: float) -> None:
        """Lets the timers of robots that come into the world begin."""
        self.start_s[rows] = now_s
        self.next_s[rows] = np.where(self.period_s[rows] > 0.0, now_s, np.inf)
        self.soonest_s[rows] = self.next_s[rows].min(axis=1, initial=np.inf)

    def set(self, robot: int, sensor: int, period_s: float, now_s: float) -> None:
        """Sets a timer, whose first period begins now; or takes it away, with 0."""
        self.period_s[robot, sensor] = period_s
        self.start_s[robot, sensor] = now_s
        self.turn[robot, sensor] = 0
        self.next_s[robot, sensor] = now_s if period_s > 0.0 else np.inf
        self.soonest_s[robot] = self.next_s[robot].min()

    def go_on(self, rows: IndexArray, sensor: int, now_s: float) -> None:
        """Lets timers that have gone off begin their next period, the first that ends after now."""
        begun = (now_s - self.start_s[rows, sensor]) / self.period_s[rows, sensor]
        turn = np.maximum(self.turn[rows, sensor] + 1, np.ceil(begun - _ROUNDING))
        self.turn[rows, sensor] = turn
        self.next_s[rows, sensor] = self.start_s[rows, sensor] + turn * self.period_s[rows, sensor]
        self.soonest_s[rows] = self.next_s[rows].min(axis=1)


_ROUNDING: Final = 1e-6


def _periods_s(model: RobotModel) -> list[float]:
    """Gives the periods of a robot's sensors, in the order of their numbers."""
    devices = (
        model.gps, model.camera, model.heat, model.laser, model.infrared, model.compass,
        model.inclinometer, model.light_sensors, model.microphones,
    )  # fmt: skip
    return [0.0 if device is None else device.period_s for device in devices]
