"""The antennae: the amount of pheromone at one to four places around the robot.

The ends of the antennae are on a circle around the centre of the mount, in front of it, at equal
angles, numbered counter-clockwise: of two antennae, 0 is the right one. Each smells the amount in
the field's cell under its end:

    reading = amount * (1 + noise * normal deviate), at least 0; an amount below the threshold is 0

The gradient is that of the plane that fits the readings best (least squares); along directions in
which the antennae do not differ, it is 0. Two antennae therefore only distinguish left from right;
three or four also distinguish ahead from behind.

All fields are measured at once: on request, but no more often than the rate allows, or on the
timer. Degradation (`antennae`): element 1.2 is antenna 2 in field 1; a dropped reading is 0. The
model was chosen by us.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, all_of
from crs_cc.core.quantity import AMOUNT, ANGLE, LENGTH
from crs_cc.requests import device_request
from crs_cc.requests.request import fields
from crs_cc.robot_api.row import OURS, Function
from crs_cc.sim.devices.fields import Fields
from crs_cc.sim.devices.sensor import Measurement, Readings, Sensor, last_values
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.attribute import FRACTION, Count, attribute, period, rate
from crs_cc.sim.model.degradable import Degradable, elements_of
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.fields import MAX_FIELDS
from crs_cc.sim.model.robot import devices_of
from crs_cc.sim.state.rows import ALL, simplest

if TYPE_CHECKING:
    from crs_cc.sim.devices.installed import Installed
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState

_MAX_ANTENNAE: Final = 4  # antennae; our choice
_WIDTH: Final = MAX_FIELDS * _MAX_ANTENNAE
_FLAT: Final = 1e-9  # antennae in a line, relative to their distance


@dataclass(frozen=True, slots=True)
class Antennae:
    """Antennae in front of the mount."""

    number: int = attribute(
        "number", Count(1, _MAX_ANTENNAE), "2", f"Number of antennae, 1 to {_MAX_ANTENNAE}."
    )
    reach_m: float = attribute(
        "reach", LENGTH, "25cm", "Distance of the antennae's ends from the centre of the robot."
    )
    apart_rad: float = attribute("apart", ANGLE, "40deg", "Angle between neighbouring antennae.")
    threshold: float = attribute(
        "threshold", AMOUNT, "0", "Smallest amount that is detected; smaller amounts read as 0."
    )
    noise: float = attribute(
        "noise", FRACTION, "0", "Standard deviation of a reading, as a fraction of the reading."
    )
    rate_hz: float = rate("50Hz")
    period_s: float = period()

    def ends_m(self) -> list[tuple[float, float]]:
        """Return the places of their ends, x ahead and y to the left of the mount's centre.

        >>> [(round(x_m, 3), round(y_m, 3)) for x_m, y_m in Antennae(reach_m=0.3).ends_m()]
        [(0.282, -0.103), (0.282, 0.103)]
        """
        first_rad = -0.5 * (self.number - 1) * self.apart_rad
        angles_rad = [first_rad + number * self.apart_rad for number in range(self.number)]
        return [
            (self.reach_m * exact.cos(angle_rad), self.reach_m * exact.sin(angle_rad))
            for angle_rad in angles_rad
        ]


def plane_weights(ends_m: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return the factors of readings in the gradient of the plane that fits them best [1/m].

    >>> plane_weights([(0.5, 0.0), (-0.5, 0.5), (-0.5, -0.5), (0.5, 0.0)])
    [(0.5, 0.0), (-0.5, 1.0), (-0.5, -1.0), (0.5, 0.0)]
    >>> plane_weights([(0.25, -0.125), (0.25, 0.125)])
    [(0.0, -4.0), (0.0, 4.0)]
    """
    count = len(ends_m)
    x0_m, y0_m = sum(x for x, _ in ends_m) / count, sum(y for _, y in ends_m) / count
    ends = [(x - x0_m, y - y0_m) for x, y in ends_m]
    xx, yy = sum(x * x for x, _ in ends), sum(y * y for _, y in ends)
    xy = sum(x * y for x, y in ends)
    determinant, extent = xx * yy - xy * xy, xx + yy
    if determinant > _FLAT * extent * extent:
        return [((yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant) for x, y in ends]
    return [(x / extent, y / extent) if extent > 0.0 else (0.0, 0.0) for x, y in ends]


class _AllAntennae:
    """The antennae of all robots that have any."""

    def __init__(self, row: Device, world: WorldModel, seed: int) -> None:
        self._fields = Fields(world)
        found = devices_of([robot.model for robot in world.robots], row.name)
        models: list[Antennae] = [model for model in found if model is not None]
        self._numbers = np.array([model.number for model in models], dtype=np.intp)
        most = int(self._numbers.max(initial=1))
        # Missing antennae end nowhere, where nothing is smelled.
        self._ends_m = np.full((most, 2, len(models)), np.nan)
        self._weights = np.zeros((most, 2, len(models)))
        for number, model in enumerate(models):
            ends_m = model.ends_m()
            self._ends_m[: model.number, :, number] = ends_m
            self._weights[: model.number, :, number] = plane_weights(ends_m)
        if len(set(models)) == 1:  # one for all takes less time
            self._ends_m = self._ends_m[:, :, :1]
        self._width = _MAX_ANTENNAE * max(len(self._fields.names), 1)
        self._sensor = Sensor(
            row, world, seed, self.measure, self._width, columns=self._width, missing=0.0
        )
        self._thresholds = bool(self._sensor.settings["threshold"].any())

    def installed(self) -> Installed:
        """Return the antennae with the handler of their request."""
        return self._sensor.installed({"SMELL": self.smell})

    def measure(self, now: Measurement) -> FloatArray:
        """Return the amounts at the ends of antennae, (k, 4 * fields)."""
        ends_m = self._ends_m
        if ends_m.shape[-1] > 1:
            mine = simplest(now.constants.numbers["antennae"][now.rows], len(self._numbers))
            ends_m = ends_m[:, :, mine]
        amounts = np.zeros((len(now.rows), self._width))
        fields = self._width // _MAX_ANTENNAE
        smelled = amounts.reshape(-1, fields, _MAX_ANTENNAE).transpose(1, 2, 0)[:, : len(ends_m)]
        self._fields.smell(now.state, now.constants, now.rows, ends_m, smelled)
        if self._thresholds:
            amounts[amounts < now.settings["threshold"][:, None]] = 0.0
        return amounts

    def smell(self, context: RequestContext) -> BoolArray:
        """Answer SMELL; refuse unknown fields and antennae."""
        has, mine = self._sensor.measure_on_request(context)
        where = ALL if all_of(has) else has
        asked = context.columns("field", "antenna", "gradient")[where]
        field, antenna, gradients = np.ascontiguousarray(asked.T)
        good = (field >= 0) & (field < len(self._fields.names))
        good &= (antenna >= 0) & (antenna < self._numbers[mine])
        if not all_of(good):
            has[has] = good
            where = has
            mine, field, antenna = mine[good], field[good], antenna[good]
            gradients = gradients[good]
        readings = self._sensor.readings(context.state).value.ravel()
        first = mine * _WIDTH + _MAX_ANTENNAE * field
        context.put("amount", np.maximum(readings.take(first + antenna), 0.0), where)
        wants = np.flatnonzero(gradients)
        if len(wants):
            gradient = np.zeros((2, len(mine)))
            for number, weights in enumerate(self._weights):
                smelled = np.maximum(readings[first[wants] + number], 0.0)
                gradient[:, wants] += weights[:, mine[wants]] * smelled
            context.put("ahead", gradient[0], where)
            context.put("left", gradient[1], where)
        return has


def _elements(antennae: Antennae) -> tuple[str, ...]:
    """Return the names of readings: field and antenna."""
    there = range(antennae.number)
    places = (divmod(column, _MAX_ANTENNAE) for column in range(_WIDTH))
    return tuple(f"{field}.{place}" if place in there else "" for field, place in places)


def _inspect(state: EnvState, number: int) -> str:
    readings = state.device("antennae", Readings)
    if readings.at_s[number] < 0.0:
        return "no reading"
    return " ".join(f"{value:g}" for value in readings.value[number].tolist())


DEVICE = Device(
    name="antennae",
    title="Antennae",
    element="antennae",
    summary="Antennae that detect pheromone fields; programs read them with crs_smell() and"
    " crs_smell_gradient() (crs.h).",
    model=Antennae,
    state=lambda models: Readings.never(len(models), _WIDTH),
    install=lambda row, world, seed, _log: _AllAntennae(row, world, seed).installed(),
    requests=(
        device_request(
            "SMELL", 232, "double crs_smell(int field, int antenna)", "reads the antennae",
            fields(
                ("field", "i[0]", "1", "the number of the field"),
                ("antenna", "i[1]", "1", "the antenna, from 0"),
                ("gradient", "i[2]", "1", "1 for the gradient, too"),
            ),
            results=fields(
                ("amount", "f[0]", "1", "the amount"),
                ("ahead", "f[1]", "1/m", "the gradient ahead"),
                ("left", "f[2]", "1/m", "the gradient to the left"),
            ),
        ),
    ),
    functions=(
        Function(
            "double crs_smell(int field, int antenna)",
            "returns the amount of a pheromone field at an antenna, numbered from the right; -1 if"
            " there is no such field or antenna", posts=("SMELL",), source=(OURS,),
        ),
        Function(
            "int crs_smell_gradient(int field, double *ahead, double *left)",
            "stores the gradient of a pheromone field at the antennae, in the robot's frame",
            units="-, 1/m, 1/m", posts=("SMELL",), source=(OURS,),
        ),
    ),
    degradables=(
        Degradable(
            "antennae", "amount detected by an antenna (element f.a: antenna a in field f)", AMOUNT,
            elements_of("antennae", _elements), _WIDTH,
            "the reading is 0",
        ),
    ),
    inspect=_inspect,
    reading=last_values("antennae"),
    number=10,
    source=__file__,
)  # fmt: skip
