"""Inclines: forces on bodies on sloping ground.

On ground that rises by tan a, a body of mass m is pulled down the slope by m g sin a, and presses
on the ground with m g cos a only: its friction, or the traction of its wheels, is reduced by that
factor. So an object slides if tan a is larger than its friction coefficient, and a robot with the
force F climbs up to sin a = F / (m g). Positions are projected on the horizontal plane, where a
distance along a direction in which the ground rises by tan b is shorter by the factor cos b, and so
is every acceleration. Hence, in the horizontal plane,

    pull on an object                  m g tan a cos^2 a           down the gradient
    its friction at most               mu m g cos^2 a
    pull on a robot, along its wheels  m g tan b cos^2 b           b is the slope along its wheels
    across them                        m g tan c cos^2 a           c is the slope across them
    force of its motors at most        F cos b
    grip at most                       (grip cos a) cos b along, (grip cos a) cos a / cos b across

The slope is that under the centre of a body at the start of a cycle. Ignored are tipping over,
shifting loads, and the vertical part of pushes: all pushes are horizontal. The rest is plain
mechanics; the simplifications are our choice.

>>> from crs_cc.sim.files.world_xml import parse_world
>>> world = parse_world(b'''<world version="1"><area length="9m" width="9m"/>
...   <surface><ramp x="4m" y="4m" length="4m" width="4m" to="1m"/></surface>
...   <robot x="4m" y="4m"/></world>''', "ramp")
>>> from crs_cc.sim.geometry.scene import Scene
>>> scene = Scene(world)
>>> incline = Inclines(world, scene).slope_under(scene.start[:, :2], np.zeros(1), np.array([23.0]))
>>> -incline.pull_n.round(3), round(23 * 9.80665 * 0.25 / (1 + 0.25**2), 3)
(array([[53.071,  0.   ]]), 53.071)
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.geometry.terrain import Terrain
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.mass_properties import FLOOR_FRICTION, GRAVITY_MPS2
from crs_cc.sim.model.world import WorldModel

_MARGIN_M: Final = 0.01
_MIN_FORCE_N: Final = 1e-3


@dataclass(frozen=True, slots=True)
class Incline:
    """The slope under all bodies in a cycle.

    Attributes:
        pull_n: the pull of gravity, in the horizontal plane, (bodies, 2).
        grip: the remaining factor of friction, in the horizontal plane: cos^2 a, (bodies,).
        hold: ratio of the brakes' holding force on the slope to that on level ground, in the
            horizontal plane, (robots,).
        ahead: the rolling direction of the robots' wheels, of length 1, (robots, 2).
        along: the factor on distances along the wheels, in the horizontal plane, (robots,).
        across: the same across them.
        sloping: robots on sloping ground, (robots,).
        quiet: whether no robot is on or near a patch, and no object slides.
    """

    pull_n: FloatArray
    grip: FloatArray
    hold: FloatArray
    ahead: FloatArray
    along: FloatArray
    across: FloatArray
    sloping: BoolArray
    quiet: bool

    def drawn_n(
        self, needed_n: FloatArray, along_n: FloatArray, grip_n: FloatArray, held: BoolArray
    ) -> FloatArray:
        """Return the forces of wheels, in the horizontal plane, (robots, 2).

        Args:
            needed_n: the force needed to reach the velocity of the wheels, in the horizontal plane,
                (robots, 2).
            along_n: the maximum force along the wheels, (robots,).
            grip_n: the traction limit on level ground, (robots,).
            held: robots that are held sideways by joints.
        """
        left = np.column_stack([-self.ahead[:, 1], self.ahead[:, 0]])
        robots = len(self.ahead)
        needed_n = needed_n - self.pull_n[:robots]
        most_n = grip_n * np.sqrt(self.grip[:robots])
        along_n = np.minimum(along_n, most_n)
        roll_n = np.clip((needed_n * self.ahead).sum(axis=1) / self.along, -along_n, along_n)
        rest_n = np.where(held, 0.0, np.sqrt(most_n * most_n - roll_n * roll_n))
        slip_n = np.clip((needed_n * left).sum(axis=1) / self.across, -rest_n, rest_n)
        return np.asarray(
            (roll_n * self.along)[:, None] * self.ahead + (slip_n * self.across)[:, None] * left
        )


class Inclines:
    """The slopes of a world.

    Attributes:
        terrain: its ground.
    """

    def __init__(self, world: WorldModel, scene: Scene) -> None:
        """Collect the constants of the bodies in a scene."""
        self.terrain = Terrain(world.surface)
        self._robots = scene.robots
        drives = [robot.model.drive for robot in world.robots]
        fastest_m = max((drive.wheels.speed_limit for drive in drives), default=0.0)
        radius_m = max((robot.model.radius_m for robot in world.robots), default=0.0)
        self._reach_m = radius_m + fastest_m * world.timestep_s + _MARGIN_M
        self._near = self.terrain.grid(self._reach_m)

    def slope_under(
        self, position_m: FloatArray, facing_rad: FloatArray, mass_kg: FloatArray
    ) -> Incline:
        """Return the slope under bodies.

        Args:
            position_m: the positions, (bodies, 2).
            facing_rad: the rolling directions of the robots' wheels, (robots,).
            mass_kg: the mass on the ground for each body, (bodies,).
        """
        weight_n = mass_kg * GRAVITY_MPS2
        gradient = self.terrain.gradient(position_m[:, 0], position_m[:, 1])
        grip = 1.0 / (1.0 + (gradient * gradient).sum(axis=1))
        pull_n = -(weight_n * grip)[:, None] * gradient
        ahead = np.column_stack([exact.cos(facing_rad), exact.sin(facing_rad)])
        left = np.column_stack([-ahead[:, 1], ahead[:, 0]])
        mine, robots = gradient[: self._robots], slice(self._robots)
        rise, lean = (mine * ahead).sum(axis=1), (mine * left).sum(axis=1)
        along2, grip2 = 1.0 / (1.0 + rise * rise), grip[robots]
        pull_n[robots] = (rise * along2)[:, None] * ahead + (lean * grip2)[:, None] * left
        pull_n[robots] *= -weight_n[robots, None]
        sloping = np.asarray(mine.any(axis=1))
        down_n = weight_n[robots] * np.sqrt(1.0 - grip2)
        seen_n = exact.hypot(pull_n[robots, 0], pull_n[robots, 1])
        seen = np.divide(seen_n, down_n, out=np.ones_like(down_n), where=down_n > _MIN_FORCE_N)
        hold = np.sqrt(grip2) * seen
        along, across = np.sqrt(along2), np.sqrt(grip2 / along2)
        steep = 1.0 / grip[self._robots :] - 1.0 > FLOOR_FRICTION * FLOOR_FRICTION
        quiet = not steep.any() and not self._any_near(position_m[robots])
        return Incline(pull_n, grip, hold, ahead, along, across, sloping, quiet)

    def shortened(
        self, position_m: FloatArray, x_m: FloatArray, y_m: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """Project displacements along the ground on the horizontal plane.

        Args:
            position_m: their starts, (k, 2).
            x_m: their lengths along x on level ground, (k,).
            y_m: their lengths along y on level ground, (k,).
        """
        gradient = self.terrain.gradient(position_m[:, 0], position_m[:, 1])
        way_m = exact.hypot(x_m, y_m)
        rise = x_m * gradient[:, 0] + y_m * gradient[:, 1]
        share = np.divide(
            way_m, exact.hypot(way_m, rise), out=np.ones_like(way_m), where=rise != 0.0
        )
        return x_m * share, y_m * share

    def length_ratios(self, position_m: FloatArray, direction: FloatArray) -> FloatArray:
        """Return the ratios of lengths along the ground to those in the horizontal plane.

        Args:
            position_m: the starts of the displacements, (k, 2).
            direction: their directions, of length 1, (k, 2).
        """
        gradient = self.terrain.gradient(position_m[:, 0], position_m[:, 1])
        return np.asarray(exact.hypot(1.0, (gradient * direction).sum(axis=1)))

    def _any_near(self, position_m: FloatArray) -> bool:
        terrain, place = self.terrain, position_m[:, 0] + 1j * position_m[:, 1]
        if terrain.heights is not None and terrain.heights.holds(place, self._reach_m).any():
            return True
        point, patch = self._near.near(place)
        local = terrain.local(place.take(point), patch)
        beyond_x = np.abs(local.real) - terrain.half_length_m.take(patch)
        beyond_y = np.abs(local.imag) - terrain.half_width_m.take(patch)
        return bool((np.maximum(beyond_x, beyond_y) <= self._reach_m).any())
