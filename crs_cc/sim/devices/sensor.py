"""Sensors that measure some numbers for their robot, on request or by a timer.

A sensor measures when the program asks, at most at its rate, or by its timer; between two
measurements it replies with the last one. Normal deviates with the standard deviation of its
definition are added to what it measures, or, where the definition has a relative one, multiplied by
the value and added; then come degradations.

The row of a sensor whose reading is a few numbers is made by `number_sensor`.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final, Self, TypeAlias

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int64Array, all_of
from crs_cc.core.time_grid import is_due
from crs_cc.sim.devices.installed import Installed, Timed
from crs_cc.sim.devices.measured import measured
from crs_cc.sim.devices.timers import read_on_request
from crs_cc.sim.model.robot import devices_of
from crs_cc.sim.state.random_streams import Noise
from crs_cc.sim.state.rows import simplest

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import Handler, RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.geometry.rays import Fan
    from crs_cc.sim.model.device import Device
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.paged_reply import PagedReply

_NOISE: Final = ("noise_m", "noise_rad", "noise")


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
    settings: Mapping[str, FloatArray]


class _Settings(Mapping[str, FloatArray]):
    """The constants of some sensors, selected when they are needed."""

    def __init__(self, columns: Mapping[str, FloatArray], rows: IndexArray) -> None:
        self._columns, self._rows = columns, rows

    def __getitem__(self, name: str) -> FloatArray:
        return self._columns[name][self._rows]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)


Measure: TypeAlias = Callable[[Measurement], FloatArray]
"""Measures with the sensors of some robots.

Returns the true values [SI unit], without noise and degradation, in an array of shape (k, values).
"""

Errors: TypeAlias = Callable[[Measurement, FloatArray, FloatArray], FloatArray]
"""Returns values with errors from the true ones and standard normal deviates, each (k, values)."""


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

    def last(self, number: int, width: int | None = None) -> FloatArray:
        """Return the first values of one sensor's last measurement, NaN if it has not measured."""
        values = self.value[number, :width]
        return values if self.at_s[number] >= 0.0 else np.full_like(values, np.nan)


_SHORT: Final = 16  # values in rows that are copied column by column


class Sensor:
    """One kind of sensor, of all robots that have it.

    Attributes:
        row: the device.
        settings: the fields of the row's model, by name, (n,) each.
        readings: returns the last measurements in a state.
    """

    def __init__(
        self,
        row: Device,
        world: WorldModel,
        seed: int,
        measure: Measure,
        width: int,
        *,
        missing: float = np.nan,
        columns: int | None = None,
        errors: Errors | None = None,
        is_on: Callable[[EnvState], BoolArray] | None = None,
        readings: Callable[[EnvState], Readings] | None = None,
    ) -> None:
        """Make the sensors of a world's robots.

        Args:
            row: the device.
            world: the world.
            seed: decides their noise.
            measure: the measuring function.
            width: number of values with noise and degradations; what else it measures follows them.
            missing: the reading for a missing value.
            columns: number of values that are measured, the first ones; by default all readings.
            errors: adds the errors; by default they have the definition's standard deviation.
            is_on: returns which sensors are on, (n,); by default all are.
            readings: returns the readings in a state; by default all of the device's state.
        """
        self.row = row
        self._measure, self._width, self._missing = measure, width, missing
        self._columns = columns
        self._errors, self._is_on = errors, is_on
        self.readings = readings or (lambda state: state.device(row.name, Readings))
        models = devices_of([robot.model for robot in world.robots], row.name)
        found = [model for model in models if model is not None]
        self.settings = {
            field.name: np.array([getattr(model, field.name) for model in found], np.float64)
            for field in dataclasses.fields(row.model)
        }
        rates_hz = self.settings.get("rate_hz")
        self._interval_s = np.zeros(len(found)) if rates_hz is None else 1.0 / rates_hz
        name = next((name for name in _NOISE if name in self.settings), "")
        sigma = self.settings.get(name)
        self._sigma = sigma if sigma is not None and sigma.any() else None
        self._is_relative = name == "noise"
        robots = len(models) if self._sigma is not None else 0
        self._noise = Noise(seed, row.stream, width, robots)

    def installed(
        self,
        handlers: Mapping[str, Handler],
        fans: Sequence[Fan] = (),
        announced: Callable[[EnvState], PagedReply] | None = None,
    ) -> Installed:
        """Return the sensors with the handlers of their requests and the beams that they cast.

        Args:
            handlers: the handlers, by the names of the requests.
            fans: the beams.
            announced: the readings for READINGS, see `Installed`.
        """
        timed = Timed(self.read, lambda state: self.readings(state).at_s, self._interval_s)
        return Installed(
            handlers=handlers, timed=timed, fans=fans, announced=announced, device=self
        )

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
        readings, mine = self.readings(state), constants.numbers[self.row.name][rows]
        which = simplest(mine, len(readings.at_s))
        due = is_due(readings.at_s[which], at_s, self._interval_s[which])
        if self._is_on is not None:
            due &= self._is_on(state)[which]
        if not all_of(due):
            rows, mine, at_s = rows[due], mine[due], at_s[due]
            which = mine
        if not len(rows):
            return
        now = Measurement(state, constants, rays, rows, at_s, _Settings(self.settings, mine))
        columns = self._columns or readings.value.shape[1]
        value = measured(self.row, self._measure, now, (len(rows), columns))
        value, extra = value[:, : self._width], value[:, self._width :]
        if self._sigma is not None:
            deviates = self._noise.rows(rows, readings.count[mine])
            if self._errors is not None:
                value = self._errors(now, value, deviates)
            else:
                error = deviates * self._sigma[which, None]
                value = value * (1.0 + error) if self._is_relative else value + error
        value = constants.degradations.alter(state, self.row.name, rows, value, at_s)
        lost = np.isnan(value)
        if lost.any():
            value = np.where(lost, self._missing, value)
        if isinstance(which, slice) and self._width <= min(_SHORT, len(rows)):
            for column in range(self._width):  # numpy goes along rows, which are short
                readings.value[:, column] = value[:, column]
        else:
            readings.value[which, : self._width] = value
        if extra.size:
            readings.value[which, self._width :] = extra
        readings.at_s[which] = at_s
        readings.count[which] += 1

    def measure_on_request(self, context: RequestContext) -> tuple[BoolArray, IndexArray]:
        """Measure for requests with the sensors that have no timer.

        Returns:
            which robots have the sensor, (k,), and the numbers of those among all that have it.
        """
        numbers = context.constants.numbers[self.row.name][context.rows]
        has = np.asarray(numbers >= 0)
        read_on_request(context, self.read, self.row.number, has)
        return has, numbers if all_of(has) else numbers[has]


def last_values(device: str) -> Callable[[EnvState, Any, int], FloatArray]:
    """Return the `reading` of a device whose state is `Readings`."""
    return lambda state, _model, number: state.device(device, Readings).last(number)


def listed(device: str, width: int) -> Callable[[EnvState, int], str]:
    """Return the function that shows the first `width` values of a sensor's last reading."""

    def inspect(state: EnvState, number: int) -> str:
        readings = state.device(device, Readings)
        if readings.at_s[number] < 0.0:
            return "no reading"
        return " ".join(f"{value:.0f}" for value in readings.value[number, :width].tolist())

    return inspect
