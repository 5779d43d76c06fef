"""The timers of sensors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int64Array
from crs_cc.core.distinct import map_distinct
from crs_cc.sim.model.registry import devices, sensor_count
from crs_cc.sim.model.robot import RobotModel
from crs_cc.sim.model.world import WorldModel

_ROUNDING: Final = 1e-6


@dataclass(slots=True)
class TimerState:
    """The timers; arrays have a row for each robot, a column for each sensor.

    Attributes:
        period_s: measuring period; 0 for on request, (robots, sensors).
        start_s: the time at which the timer was set, (robots, sensors).
        turn: number of periods that have begun since then, (robots, sensors).
        next_s: time of the next measurement, infinite without a timer, (robots, sensors).
        soonest_s: the earliest of these, (robots,).
    """

    period_s: FloatArray
    start_s: FloatArray
    turn: Int64Array
    next_s: FloatArray
    soonest_s: FloatArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return timers as set in the robots' definitions."""
        periods = map_distinct([robot.model for robot in world.robots], _periods_s)
        period_s = np.array(periods, dtype=np.float64).reshape(-1, sensor_count())
        next_s = np.where(period_s > 0.0, 0.0, np.inf)
        none = np.zeros_like(period_s)
        return cls(
            period_s, none, none.astype(np.int64), next_s, next_s.min(axis=1, initial=np.inf)
        )

    def on_request(self, rows: IndexArray, sensor: int) -> BoolArray:
        """Return which robots have no timer for a sensor."""
        places = rows * self.period_s.shape[1] + sensor
        return np.asarray(self.period_s.take(places) == 0.0)

    def begin(self, rows: IndexArray, now_s: float) -> None:
        """Start the timers of robots that join the world."""
        self.start_s[rows] = now_s
        self.next_s[rows] = np.where(self.period_s[rows] > 0.0, now_s, np.inf)
        self.soonest_s[rows] = self.next_s[rows].min(axis=1, initial=np.inf)

    def set(self, robot: int, sensor: int, period_s: float, now_s: float) -> None:
        """Set a timer, whose first period begins now; a period of 0 removes it."""
        self.period_s[robot, sensor] = period_s
        self.start_s[robot, sensor] = now_s
        self.turn[robot, sensor] = 0
        self.next_s[robot, sensor] = now_s if period_s > 0.0 else np.inf
        self.soonest_s[robot] = self.next_s[robot].min()

    def restart(self, rows: IndexArray, sensor: int, now_s: float) -> None:
        """Start the next period of expired timers, the first one that ends after now."""
        begun = (now_s - self.start_s[rows, sensor]) / self.period_s[rows, sensor]
        turn = np.maximum(self.turn[rows, sensor] + 1, np.ceil(begun - _ROUNDING))
        self.turn[rows, sensor] = turn
        self.next_s[rows, sensor] = self.start_s[rows, sensor] + turn * self.period_s[rows, sensor]
        self.soonest_s[rows] = self.next_s[rows].min(axis=1)


def _periods_s(model: RobotModel) -> list[float]:
    """Return the periods of a robot's sensors, in the order of their numbers; 0 for none."""
    numbered = {each.number: model.device(each.name) for each in devices()}
    have = [numbered.get(number) for number in range(sensor_count())]
    return [0.0 if device is None else device.period_s for device in have]
