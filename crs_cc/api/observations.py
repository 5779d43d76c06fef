"""Observations for Python policies: what they see of the robots they control, as bounded numbers.

A name is that of a sensor, or one of `pose`, `odometry` and `speeds`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Final, Self

import numpy as np
import numpy.typing as npt

from crs_cc.api.robots import RobotView
from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.core.suggest import unknown
from crs_cc.sim.engine.environment import Environment

_TURN: Final = 2 * np.pi
_LARGEST_INFRARED: Final = 15.0

_LIMITS: Final[dict[str, Callable[[Any], tuple[float, float]]]] = {
    "bumper": lambda _model: (0.0, 1.0),
    "camera": lambda model: (0.0, model.range_m),
    "compass": lambda _model: (0.0, _TURN),
    "infrared": lambda _model: (0.0, _LARGEST_INFRARED),
    "laser": lambda model: (0.0, model.range_m),
    "sonar": lambda model: (0.0, max(each.range_m for each in model.sonars)),
}
"""The smallest and the largest value of some sensors; the others have no limits."""

_OWN: Final[dict[str, Callable[[RobotView], FloatArray]]] = {
    "pose": lambda robot: robot.pose,
    "odometry": lambda robot: robot.odometry,
    "speeds": lambda robot: robot.axis_speeds,
}
"""What is no sensor, by name."""


@dataclass(frozen=True, slots=True)
class ObservationSpec:
    """One kind of observation of a robot.

    Attributes:
        name: its name.
        shape: the shape of its arrays.
        low: the smallest value; smaller ones are clipped to it.
        high: the largest value; larger ones, such as no echo, are clipped to it.
    """

    name: str
    shape: tuple[int, ...]
    low: float
    high: float

    @classmethod
    def of(cls, name: str, robot: RobotView) -> Self:
        """Return the observation of a robot.

        Raises:
            ValueError: the name is unknown.
        """
        if name in _OWN:
            high = np.inf
            if name == "speeds":
                axes = [axis for axis in robot.model.drive.axes if axis is not None]
                high = max(axis.speed_limit for axis in axes)
            return cls(name, _OWN[name](robot).shape, -high, high)
        if name not in robot.sensors:
            raise ValueError(f"{robot.name}: {unknown('observation', name, known(robot))}")
        low, high = -np.inf, np.inf
        if name in _LIMITS:
            low, high = _LIMITS[name](robot.model.device(name))
        return cls(name, getattr(robot, name).shape, low, high)

    def value(self, robot: RobotView) -> FloatArray:
        """Return a new array with the last value, 0 for what has not been measured."""
        if self.name in _OWN:
            return np.array(_OWN[self.name](robot), dtype=np.float64)
        found: npt.NDArray[Any] = getattr(robot, self.name)
        value = found.astype(np.float64)
        return np.clip(np.nan_to_num(value, nan=0.0, posinf=self.high), self.low, self.high)


def known(robot: RobotView) -> list[str]:
    """Return the names of all that can be observed of a robot."""
    return [*robot.sensors, *_OWN]


def measure(environment: Environment, names: Sequence[str], robots: IndexArray) -> None:
    """Measure now with those sensors of robots that do not measure by themselves.

    Args:
        environment: the world.
        names: the names of observations.
        robots: the robots, in ascending order.
    """
    for name in names:
        if name not in _OWN:
            numbers = environment.device_numbers(name)[robots]
            environment.measure(name, robots[numbers >= 0])
