"""Readings of the sensors of `registry.devices()`.

>>> from crs_cc.sim.files.world_xml import empty_world
>>> [name for name in sensor_states(empty_world()).__slots__ if name == "tilt"]
['tilt']
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from functools import cache
from typing import Any, Final, Self

import numpy as np

from crs_cc.core.arrays import FloatArray, Int64Array
from crs_cc.sim.model.registry import devices
from crs_cc.sim.model.world import WorldModel

_NAME: Final = "SensorStates"


@dataclass(slots=True)
class Readings:
    """The readings of one kind of sensor; arrays have a row for each robot with it, n of them.

    Attributes:
        value: the last measurement [SI unit], NaN for none, (n, values).
        at_s: its time; negative for none, (n,).
        count: number of measurements, (n,).
    """

    value: FloatArray
    at_s: FloatArray
    count: Int64Array

    @classmethod
    def never(cls, count: int, width: int) -> Self:
        """Return the readings of `count` sensors that have not measured yet."""
        return cls(np.zeros((count, width)), np.full(count, -1.0), np.zeros(count, dtype=np.int64))


def sensor_states(world: WorldModel) -> Any:
    """Return a dataclass with the `Readings` of each device of the registry, by its name."""
    columns = {
        device.name: Readings.never(
            sum(robot.model.device(device.name) is not None for robot in world.robots),
            len(device.values),
        )
        for device in devices()
    }
    return _columns()(**columns)


@cache
def _columns() -> type:
    names = [(device.name, Readings) for device in devices()]
    columns = dataclasses.make_dataclass(_NAME, names, slots=True)
    columns.__module__ = __name__  # where pickle looks for it, see `__getattr__`
    return columns


def __getattr__(name: str) -> type:
    if name == _NAME:
        return _columns()
    raise AttributeError(name)
