"""Light sensors: a ring of sensors, each with a direction.

    reading = round(sum over all visible lights of brightness / d^2 * max(0, cos a))

d is the distance of a light from the robot's centre [m], a the angle between the direction of the
light and that of the sensor: the inverse square law, and Lambert's cosine law for a flat sensor
("Photometria", 1760). Walls, objects and robots cast shadows, and nothing reflects light. d is at
least 10 cm. Lights are declared in the world file, or are lamps of other robots (`crs_light`).

Sensors measure on request, or on their timer, with objects at their positions at the start of the
timestep; a normal deviate proportional to the reading, with the definition's noise, is added.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core import random_streams
from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.requests import LARGEST
from crs_cc.sim.devices.emitters import Sources, line_of_sight, sense
from crs_cc.sim.devices.timers import read_on_request
from crs_cc.sim.model.beacons import MAX_LIGHT_SENSORS
from crs_cc.sim.state.timers import LIGHT

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


_TURN: Final = 2 * math.pi


class LightRings:
    """The light sensors of all robots that have any.

    Attributes:
        fans: the beams that test for obstructions.
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
        self._noise = random_streams.Noise(seed, random_streams.LIGHT, MAX_LIGHT_SENSORS, robots)

    def read(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> None:
        """Measure with rings.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rays: casts rays.
            rows: robots with a ring, k of them, whose axes were turned to `at_s`.
            at_s: the time of each, shape (k,).
        """
        if not len(rows):
            return
        ring, mine = state.light, constants.light[rows]
        readings = self._light(state, constants, rays, rows)
        if self._share.any():
            deviates = self._noise.rows(rows, ring.count[mine])
            readings *= 1.0 + deviates * self._share[rows, None]
        readings = constants.degradations.alter(state, "light", rows, readings, at_s)
        ring.reading[mine], ring.at_s[mine] = np.nan_to_num(readings, nan=0.0), at_s
        ring.count[mine] += 1

    def get_light(self, context: RequestContext) -> BoolArray:
        """Answer GET_LIGHT with the number of sensors, and their readings as data."""
        mine = context.constants.light[context.rows]
        has = np.asarray(mine >= 0)
        read_on_request(context, self.read, LIGHT, has)
        readings = context.state.light.reading[mine[has]]
        context.put_data(np.clip(np.rint(readings), 0, LARGEST), has)
        context.put("sensors", self._number[context.rows[has]], has)
        return has

    def _light(
        self, state: EnvState, constants: RobotConstants, rays: RayCaster, rows: IndexArray
    ) -> FloatArray:
        """Return the light on each possible sensor of the rings, (k, 32)."""
        robots = len(state.heading_rad)
        lights = self._lights.with_robots(
            state.bodies.position_m[:robots], state.beacons.brightness
        )
        seen = sense(
            state, constants, rays, rows,
            sources=lights, range_m=self._range_m[rows], fan=self.fans[0],
        )  # fmt: skip
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
        return readings
