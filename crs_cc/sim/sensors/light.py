"""Light sensors: a ring of them, and how much light each gets from where it looks.

    reading = round(sum over all lights in sight of brightness / d^2 * max(0, cos a))

d is the distance of a light from the middle of the robot [m], a the angle between the direction of
the light and that in which the sensor looks: the inverse square law, and Lambert's cosine for a
flat sensor ("Photometria", 1760). Walls, things and robots cast shadows, and nothing reflects
light. A light nearer than 10 cm shines as from there. Lights stand in the world file, or are lamps
of other robots (`crs_light`).

Sensors measure whenever the program asks, with things as they are at the start of the cycle; a
normal deviate with the definition's share of the reading is added.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from crs_cc.requests import LARGEST
from crs_cc.sim.beacon_model import MAX_LIGHT_SENSORS
from crs_cc.sim.noise import LIGHT, Noise
from crs_cc.sim.sources import Sources, line_of_sight, sense

if TYPE_CHECKING:
    from crs_cc.sim.asked import Asked
    from crs_cc.sim.model import WorldModel

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]
IndexArray = npt.NDArray[np.intp]

_TURN: Final = 2 * math.pi


class LightRings:
    """The light sensors of all robots that have some.

    Attributes:
        fans: the beam by which they look for lights.
    """

    def __init__(self, world: WorldModel, seed: int) -> None:
        rings = [robot.model.light_sensors for robot in world.robots]
        lights = world.lights
        self._lights = Sources(
            np.array([(light.x_m, light.y_m) for light in lights]).reshape(-1, 2),
            np.array([light.brightness for light in lights], dtype=np.float64),
            np.full(len(lights), -1, dtype=np.intp),
        )
        self._number = np.array([ring.number if ring else 0 for ring in rings], dtype=np.intp)
        self._first_rad = np.array([ring.first_rad if ring else 0.0 for ring in rings])
        self._range_m = np.array([ring.range_m if ring else 0.0 for ring in rings])
        self._share = np.array([ring.noise if ring else 0.0 for ring in rings])
        self.fans = line_of_sight(float(self._range_m.max(initial=0.0)))
        robots = len(rings) if self._share.any() else 0
        self._noise = Noise(seed, LIGHT, MAX_LIGHT_SENSORS, robots)

    def tell(self, asked: Asked) -> BoolArray:
        """Answers GET_LIGHT: how many sensors there are, and their readings as data."""
        count = self._number[asked.rows]
        has = count > 0
        rows, replies = asked.rows[has], asked.messages[has]
        if len(rows):
            readings = self._look(asked, rows)
            altered = asked.equipment.degradations.alter(
                asked.state, "light", rows, readings, asked.at_s[has]
            )
            whole = np.clip(np.rint(np.nan_to_num(altered, nan=0.0)), 0, LARGEST).astype("<i4")
            replies["data"][:, : 4 * MAX_LIGHT_SENSORS] = whole.view(np.uint8)
            replies["size"] = 4 * MAX_LIGHT_SENSORS
            replies["i"][:, 0] = count[has]
            asked.messages[has] = replies
        return np.asarray(has)

    def _look(self, asked: Asked, rows: IndexArray) -> FloatArray:
        """Gives the readings of all sensors that there can be, (k, 32)."""
        beacons, robots = asked.state.beacons, len(asked.state.heading_rad)
        lights = self._lights.with_robots(
            asked.state.bodies.position_m[:robots], beacons.brightness
        )
        seen = sense(asked, rows, lights, self._range_m[rows], self.fans[0])
        bright = np.flatnonzero(seen.in_sight)
        robot = seen.robot[bright]
        number = np.arange(MAX_LIGHT_SENSORS)
        spacing_rad = _TURN / self._number[rows[robot]]
        axis_rad = self._first_rad[rows[robot], None] + number * spacing_rad[:, None]
        lobe = np.maximum(np.cos(seen.bearing_rad[bright, None] - axis_rad), 0.0)
        light = lights.strength[seen.source[bright]] / seen.distance_m[bright] ** 2
        readings = np.zeros((len(rows), MAX_LIGHT_SENSORS))
        np.add.at(readings, robot, light[:, None] * lobe)
        readings[number >= self._number[rows, None]] = 0.0
        if self._share.any():
            deviates = self._noise.rows(rows, beacons.looked[rows])
            readings *= 1.0 + deviates * self._share[rows, None]
        beacons.looked[rows] += 1
        return readings
