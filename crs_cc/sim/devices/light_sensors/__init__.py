"""Light sensors: a ring of sensors, each with a direction.

    reading = round(sum over all visible lights of brightness / d^2 * max(0, cos a))

d is the distance of a light from the robot's centre [m], a the angle between the direction of the
light and that of the sensor: the inverse square law, and Lambert's cosine law for a flat sensor
("Photometria", 1760). Walls, objects and robots cast shadows, and nothing reflects light. Smaller
values of d count as 10 cm. Lights are declared in the world file, or are lamps of other robots
(`crs_light`).

Sensors measure on request, or on their timer, with objects at their positions at the start of the
timestep; a normal deviate is added, whose standard deviation is the reading times the `noise` of
the definition.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.core.quantity import ANGLE, BRIGHTNESS, LENGTH
from crs_cc.requests import LARGEST, device_request
from crs_cc.requests.request import fields
from crs_cc.robot_api.row import OURS, Function
from crs_cc.sim.devices import lamp
from crs_cc.sim.devices.emitters import Sources, line_of_sight, sense
from crs_cc.sim.devices.sensor import Measurement, Readings, Sensor, listed
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.attribute import FRACTION, Count, attribute, period
from crs_cc.sim.model.degradable import Degradable, elements_of, numbered
from crs_cc.sim.model.device import Device

if TYPE_CHECKING:
    from crs_cc.sim.devices.installed import Installed
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.model.world import WorldModel


_MAX: Final = 32  # our choice
_TURN: Final = 2 * math.pi


@dataclass(frozen=True, slots=True)
class LightSensors:
    """A ring of light sensors around the mount."""

    number: int = attribute(
        "number", Count(1, _MAX), "8",
        f"Number of sensors, 1 to {_MAX}, equally spaced and numbered counter-clockwise.",
    )  # fmt: skip
    first_rad: float = attribute(
        "first", ANGLE, "0deg", "Direction of the first sensor, counter-clockwise from the front.",
        signed=True,
    )  # fmt: skip
    range_m: float = attribute(
        "range", LENGTH, "10m", "Maximum distance at which a light is detected.", positive=True
    )
    noise: float = attribute(
        "noise", FRACTION, "0", "Standard deviation of a reading, as a fraction of the reading."
    )
    period_s: float = period()


class _Rings:
    """The light sensors of all robots that have any, and the lights of the world."""

    def __init__(self, row: Device, world: WorldModel, seed: int) -> None:
        lights = world.lights
        self._lights = Sources.fixed(
            [(light.x_m, light.y_m) for light in lights], [light.brightness for light in lights]
        )
        self._sensor = Sensor(row, world, seed, self.measure, _MAX, missing=0.0)
        self.fans = line_of_sight(float(self._sensor.settings["range_m"].max(initial=0.0)))

    def installed(self) -> Installed:
        """Return the sensors with the handler of their request."""
        return self._sensor.installed({"GET_LIGHT": self.get_light}, self.fans)

    def measure(self, now: Measurement) -> FloatArray:
        """Return the light on each possible sensor of the rings, (k, 32)."""
        robots = len(now.state.heading_rad)
        lights = self._lights.with_robots(
            now.state.bodies.position_m[:robots], lamp.brightness(now.state, now.constants)
        )
        count, first_rad = now.settings["number"], now.settings["first_rad"]
        seen = sense(
            now.state, now.constants, now.rays, now.rows,
            sources=lights, range_m=now.settings["range_m"], fan=self.fans[0],
        )  # fmt: skip
        bright = np.flatnonzero(seen.in_sight)
        robot = seen.robot[bright]
        number = np.arange(_MAX)
        spacing_rad = _TURN / count[robot]
        axis_rad = first_rad[robot, None] + number * spacing_rad[:, None]
        lobe = np.maximum(exact.cos(seen.bearing_rad[bright, None] - axis_rad), 0.0)
        light = lights.strength[seen.source[bright]] / np.square(seen.distance_m[bright])
        readings = np.zeros((len(now.rows), _MAX))
        np.add.at(readings, robot, light[:, None] * lobe)
        readings[number >= count[:, None]] = 0.0
        return readings

    def get_light(self, context: RequestContext) -> BoolArray:
        """Answer GET_LIGHT with the number of sensors, and their readings as data."""
        has, mine = self._sensor.measure_on_request(context)
        readings = self._sensor.readings(context.state).value[mine]
        context.put_data(np.clip(np.rint(readings), 0, LARGEST), has)
        context.put("sensors", self._sensor.settings["number"][mine], has)
        return has


DEVICE = Device(
    name="light",
    title="Light sensors",
    element="light-sensors",
    summary="A ring of light sensors on the turret (or the body); programs read it with"
    " crs_get_light() (crs.h).",
    model=LightSensors,
    state=lambda models: Readings.never(len(models), _MAX),
    install=lambda row, world, seed, _log: _Rings(row, world, seed).installed(),
    requests=(
        device_request(
            "GET_LIGHT", 227, "int crs_get_light(int *readings, int most)",
            "reads the light sensors",
            results=fields(
                ("sensors", "i[0]", "1", "how many sensors there are"),
                ("readings", "data", "1", "readings", "int32"),
            ),
        ),
    ),
    functions=(
        Function(
            "int crs_get_light(int *readings, int most)",
            "copies the readings of the light sensors, counter-clockwise; returns the number of"
            " readings copied, at most `most`", posts=("GET_LIGHT",), source=(OURS,),
        ),
    ),
    degradables=(
        Degradable(
            "light", "reading of a light sensor", BRIGHTNESS,
            elements_of("light", lambda ring: numbered(ring.number)), _MAX,
            "the reading is 0",
        ),
    ),
    inspect=listed("light", _MAX),
    reading=lambda state, model, number: state.device("light", Readings).last(number, model.number),
    number=7,
    stream=22,
    source=__file__,
)  # fmt: skip
