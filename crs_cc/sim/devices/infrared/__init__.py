"""The infrared ring: sixteen sensors that measure the reflection of their own light.

    seen    = distance / sqrt(reflectance)
    new     = min(seen / step, 15)
    level   = share * previous level + (1 - share) * new
    reading = round(level)

The reflected light is proportional to the surface's reflectance and to the inverse square of its
distance, so a surface that reflects a quarter appears twice as far away. 15 is the largest value of
the four bits on the line (vendor source `Ndirect.c` 2.7), and the reading if nothing is in range.
Programs interpret readings as inches (MissionLab's driver of the Nomad 200): this is the step of
the definitions. `conf_ir` sets the share of the previous level, in tenths (vendor header
`Nclient.h` 1.29), and which sensors measure; the others read 15. Sensor n of the ring points 22.5 n
degrees counter-clockwise from the front, like the sonars. A beam is a cone (`rays`), and the
nearest object in it is measured. The reflectance is that of its surface, or the default of the
definition. All other numbers were chosen by us.

The ring is on the turret. All sensors measure when a reply contains their readings, at most at the
rate of the definition, or on their timer (`timers`). A normal deviate with the definition's noise
is added to each distance. Degradation (`infrared`) applies to the distances; a dropped distance
reads as nothing in range.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array
from crs_cc.core.random_streams import INFRARED, Noise
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.sensor_order import orders
from crs_cc.sim.devices.timers import read_on_request
from crs_cc.sim.devices.vendor_state import configuration
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.model.sensors import MAX_INFRARED
from crs_cc.sim.state import timers
from crs_cc.sim.state.infrared import FARTHEST

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.sensors import Infrared
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


_TURN: Final = 2 * math.pi
_TENTHS: Final = 10


class InfraredRing:
    """The infrared rings of all robots that have one.

    Attributes:
        fans: the beams of each kind of ring.
        interval_s: minimum time between two measurements of each.
    """

    def __init__(self, world: WorldModel, seed: int) -> None:
        rings = [ring for robot in world.robots if (ring := robot.model.infrared) is not None]
        radii_m = [robot.model.radius_m for robot in world.robots if robot.model.infrared]
        kinds = list(dict.fromkeys(zip(rings, radii_m, strict=True)))
        brightest = _brightest(world)
        self.fans = [_fan(ring, radius_m, brightest) for ring, radius_m in kinds]
        pairs = zip(rings, radii_m, strict=True)
        self._kind = np.array([kinds.index(pair) for pair in pairs], dtype=np.intp)
        self.interval_s = np.array([1.0 / ring.rate_hz for ring in rings])
        self._step_m = np.array([ring.step_m for ring in rings])[:, None]
        self._reflectance = np.array([ring.reflectance for ring in rings])[:, None]
        self._noise_m = np.array([ring.noise_m for ring in rings])[:, None]
        self._noise = Noise(
            seed, INFRARED, MAX_INFRARED, len(world.robots) if self._noise_m.any() else 0
        )

    def read(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> None:
        """Measure with the rings that may measure again.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rays: casts rays.
            rows: which robots, k of them, whose axes were turned to `at_s`.
            at_s: when, for each, shape (k,).
        """
        ring = state.infrared
        mine = constants.infrared[rows]
        due = ring.measured.are_due(mine, at_s, self.interval_s)
        if not due.any():
            return
        rows, mine = rows[due], mine[due]
        poses = mount_poses(state, constants, rows)
        distance_m, step_m = self._see(state, constants, rays, rows, poses)
        if self._noise_m.any():
            distance_m += self._noise.rows(rows, ring.count[mine]) * self._noise_m[mine]
        distance_m = constants.degradations.alter(state, "infrared", rows, distance_m, at_s[due])
        distance_m = np.where(np.isnan(distance_m), np.inf, distance_m)
        new = np.clip(_steps(distance_m, step_m), 0.0, FARTHEST)
        share = ring.share[mine, None]
        level = share * ring.level[mine] + (1.0 - share) * new
        ring.level[mine] = np.where(ring.on[mine], level, FARTHEST)
        ring.count[mine] += 1
        ring.measured.note(mine, at_s[due], configuration(state, constants, rows))

    def get_ir(self, context: RequestContext) -> BoolArray:
        """Answer GET_IR: measure, for `State`; refuse robots without infrared sensors."""
        has = np.asarray(context.constants.infrared[context.rows] >= 0)
        read_on_request(context, self.read, timers.INFRARED, has)
        return has

    def look(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        poses: FloatArray,
    ) -> Int32Array:
        """Return the rings' readings without errors if their mounts were at other poses.

        Args:
            state: has the poses of all objects.
            constants: the robots' constants.
            rays: casts rays.
            rows: robots with such a ring, k of them.
            poses: x, y [m] and direction [rad] of each mount, shape (k, 3).

        Returns:
            readings, shape (k, 16).
        """
        steps = _steps(*self._see(state, constants, rays, rows, poses))
        return np.asarray(np.rint(np.clip(steps, 0.0, FARTHEST)), dtype=np.int32)

    def _see(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        poses: FloatArray,
    ) -> tuple[FloatArray, FloatArray]:
        """Return the distances that the sensors see from poses.

        Returns:
            the distances, and the distance of such a surface that changes the reading by 1, both
            of shape (k, 16).
        """
        mine = constants.infrared[rows]
        distance_m = np.empty((len(rows), MAX_INFRARED))
        shine = np.tile(self._reflectance[mine], MAX_INFRARED)
        kinds, own = self._kind[mine], rays.surfaces.infrared
        for kind, fan in enumerate(self.fans):
            some = np.flatnonzero(kinds == kind)
            if len(some):
                if own is None:
                    seen_m = rays.distances_m(state, fan, poses[some], own=rows[some])
                else:
                    seen_m, thing = rays.seen(state, fan, poses[some], own=rows[some])
                    shine[some] = np.where(np.isnan(own[thing]), shine[some], own[thing])
                distance_m[some] = seen_m
        return distance_m, self._step_m[mine] * np.sqrt(shine)


def _steps(distance_m: FloatArray, step_m: FloatArray) -> FloatArray:
    """Return readings; a black object reads as nothing, unless the sensor touches it."""
    none = np.where(distance_m > 0.0, np.inf, 0.0)
    return np.divide(distance_m, step_m, out=none, where=step_m > 0.0)


def _brightest(world: WorldModel) -> float:
    """Return the largest reflectance of any surface of a world."""
    things = (*world.solids(), *world.robots)
    return max((thing.material.infrared or 0.0 for thing in things), default=0.0)


def conf_ir(context: RequestContext) -> BoolArray:
    """Set the share of the previous level and the active sensors; refuse unknown sensors."""
    rows, ring = context.rows, context.state.infrared
    order, given, good = orders(context["count"], context["order"], MAX_INFRARED)
    mine = context.constants.infrared[rows]
    good &= mine >= 0
    on = np.zeros((len(rows), MAX_INFRARED), dtype=np.bool_)
    robot, element = np.nonzero(given & good[:, None])
    on[robot, order[robot, element]] = True
    mine = mine[good]
    ring.on[mine] = on[good]
    ring.level[mine] = np.where(on[good], ring.level[mine], FARTHEST)
    ring.share[mine] = np.clip(context["share"][good], 0, _TENTHS) / _TENTHS
    return good


def _fan(ring: Infrared, radius_m: float, brightest: float) -> Fan:
    """Return beams that start on the shell and reach as far as a reading below the largest."""
    range_m = FARTHEST * ring.step_m * math.sqrt(max(ring.reflectance, brightest))
    directions = [number * _TURN / MAX_INFRARED for number in range(MAX_INFRARED)]
    beams = (
        (
            radius_m * math.cos(direction),
            radius_m * math.sin(direction),
            direction,
            ring.half_angle_rad,
            range_m,
        )
        for direction in directions
    )
    return Fan.of(beams, ring.z_m)
