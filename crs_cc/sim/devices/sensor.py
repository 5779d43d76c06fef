"""The sensors of `registry.devices()`: when they measure, their noise, and their replies.

A sensor measures when the program asks, at most at its rate, or by its timer; between two
measurements it replies with the last one. To what its row measures it adds normal deviates with the
standard deviation of its definition, then come degradations. A value that is not there (NaN) makes
the request fail. Values go to C as integers, rounded to the nearest 0.1 inch or 0.1 degree.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.core.quantity import ANGLE, LENGTH
from crs_cc.core.random_streams import Noise
from crs_cc.core.time_grid import is_due
from crs_cc.core.units import m_to_tenths_inch, rad_to_tenths_deg
from crs_cc.requests import LARGEST
from crs_cc.sim.devices.timers import read_on_request

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.device import Device
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.sensors import Readings

_NOISE: Final = ("noise_m", "noise_rad")
_IN_C: Final[dict[str, tuple[Callable[[FloatArray], FloatArray], float]]] = {
    LENGTH.name: (m_to_tenths_inch, LARGEST),
    ANGLE.name: (rad_to_tenths_deg, 3600.0),
}
"""The unit in C, and the largest number, as a degraded sensor may measure any value."""


@dataclass(frozen=True, slots=True)
class Measurement:
    """The arguments of a device's `measure`, for some robots' sensors.

    Attributes:
        state: the state of the world; axes were turned to `at_s`.
        constants: constants of all robots, the scene and the ground.
        rays: casts rays.
        rows: robots with the sensor, k of them.
        at_s: the time of each, (k,).
        settings: the constants of their sensors: the fields of the row's model, by name, (k,) each.
    """

    state: EnvState
    constants: RobotConstants
    rays: RayCaster
    rows: IndexArray
    at_s: FloatArray
    settings: dict[str, FloatArray]


class Sensor:
    """One kind of sensor, of all robots that have it.

    Attributes:
        interval_s: minimum time between two measurements of each.
    """

    def __init__(self, row: Device, world: WorldModel, seed: int) -> None:
        """Make the sensors of a world's robots.

        Args:
            row: the device.
            world: the world.
            seed: decides their noise.
        """
        self.row = row
        models = [robot.model.device(row.name) for robot in world.robots]
        found = [model for model in models if model is not None]
        self._settings = {
            field.name: np.array([getattr(model, field.name) for model in found], np.float64)
            for field in dataclasses.fields(row.model)
        }
        self.interval_s = 1.0 / self._settings["rate_hz"]
        sigma = next((self._settings[name] for name in _NOISE if name in self._settings), None)
        self._sigma = sigma if sigma is not None and sigma.any() else None
        self._noise = Noise(
            seed, row.stream, len(row.values), len(models) if self._sigma is not None else 0
        )

    def numbers(self, constants: RobotConstants) -> IndexArray:
        """Return the number of each robot among those that have the sensor, else -1, (robots,)."""
        return constants.sensors[self.row.name]

    def readings(self, state: EnvState) -> Readings:
        """Return the last measurements."""
        readings: Readings = getattr(state.sensors, self.row.name)
        return readings

    def measured_s(self, state: EnvState) -> FloatArray:
        """Return the time of each one's last measurement; below 0 for never."""
        return self.readings(state).at_s

    def read(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> None:
        """Measure with those sensors that may measure again.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rays: casts rays.
            rows: robots with the sensor, k of them, whose axes were turned to `at_s`.
            at_s: the time of each, shape (k,).
        """
        readings, mine = self.readings(state), self.numbers(constants)[rows]
        due = is_due(readings.at_s[mine], at_s, self.interval_s[mine])
        rows, mine, at_s = rows[due], mine[due], at_s[due]
        settings = {name: column[mine] for name, column in self._settings.items()}
        value = self.row.measure(Measurement(state, constants, rays, rows, at_s, settings))
        if self._sigma is not None:
            value = value + self._noise.rows(rows, readings.count[mine]) * self._sigma[mine, None]
        value = constants.degradations.alter(state, self.row.name, rows, value, at_s)
        readings.value[mine], readings.at_s[mine] = value, at_s
        readings.count[mine] += 1

    def answer(self, context: RequestContext) -> BoolArray:
        """Answer the sensor's request; refuse robots without it, and readings without a value."""
        numbers = self.numbers(context.constants)[context.rows]
        has = np.asarray(numbers >= 0)
        read_on_request(context, self.read, self.row.number, has)
        value = self.readings(context.state).value[numbers[has]]
        there = np.isfinite(value).all(axis=1)
        has[has] = there
        convert, limit = _IN_C[self.row.kind.name]
        whole = np.clip(np.rint(convert(value[there])), -limit, limit).astype(np.int32)
        for column, each in zip(whole.T, self.row.values, strict=True):
            context.put(each.name, column, has)
        return has
