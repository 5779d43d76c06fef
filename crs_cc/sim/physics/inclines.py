"""Inclines: what the slope under bodies does to them.

On ground that rises by tan a, a body of mass m is pulled down the slope by m g sin a, and presses
on the ground with m g cos a only: its friction, or the grip of its wheels, is that much less. So a
thing slides where tan a is larger than its friction, and a robot with the force F climbs up to
sin a = F / (m g). Places are kept as seen from above, where a way along a direction in which the
ground rises by tan b is shorter by cos b, and so is every acceleration. Hence, seen from above,

    pull of a thing                    m g tan a cos^2 a           down the gradient
    its friction at most               mu m g cos^2 a
    pull of a robot, along its wheels  m g tan b cos^2 b           b is the slope along its wheels
    across them                        m g tan c cos^2 a           c is the slope across them
    force of its motors at most        F cos b
    grip at most                       (grip cos a) cos b along, (grip cos a) cos a / cos b across

The slope is that under the middle of a body at the start of a cycle. That a body tips over, that
its load shifts, and that pushes have an upward part, is left out: all pushes are level. Plain
mechanics; what is left out was chosen by us.

>>> from crs_cc.sim.files.world_xml import parse_world
>>> world = parse_world(b'''<world version="1"><area length="9m" width="9m"/>
...   <surface><ramp x="4m" y="4m" length="4m" width="4m" to="1m"/></surface>
...   <robot x="4m" y="4m"/></world>''', "ramp")
>>> from crs_cc.sim.geometry.scene import Scene
>>> scene = Scene(world)
>>> incline = Inclines(world, scene).under(scene.start[:, :2], np.zeros(1), np.array([23.0]))
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
from crs_cc.sim.model.mass_properties import FLOOR_FRICTION, GRAVITY_MPS2
from crs_cc.sim.model.world import WorldModel

_MARGIN_M: Final = 0.01
_LEAST_N: Final = 1e-3


@dataclass(frozen=True, slots=True)
class Incline:
    """The slope under all bodies in a cycle.

    Attributes:
        pull_n: what draws them down, as seen from above, (bodies, 2).
        grip: the share of friction that is left, as seen from above: cos^2 a, (bodies,).
        hold: what brakes hold on the slope over what they hold on level ground, as seen from above,
            (robots,).
        ahead: where the wheels of robots roll, of length 1, (robots, 2).
        along: the share of a way along the wheels that is left, seen from above, (robots,).
        across: the same across them.
        sloping: robots that do not stand on level ground, (robots,).
        quiet: whether no robot is on or near a patch, and no thing slides.
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
        """Return the forces of wheels, as seen from above, (robots, 2).

        Args:
            needed_n: what it takes to run as fast as the wheels turn, seen from above, (robots, 2).
            along_n: what wheels can do along them, (robots,).
            grip_n: what they can hold on level ground, (robots,).
            held: robots that are held across their wheels by something else.
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
        """Takes what it needs of the bodies in a scene."""
        self.terrain = Terrain(world.surface)
        self._robots = scene.robots
        drives = [robot.model.drive for robot in world.robots]
        fastest_m = max((drive.wheels.speed_limit for drive in drives), default=0.0)
        radius_m = max((robot.model.radius_m for robot in world.robots), default=0.0)
        self._reach_m = radius_m + fastest_m * world.timestep_s + _MARGIN_M
        self._near = self.terrain.grid(self._reach_m)

    def under(self, position_m: FloatArray, facing_rad: FloatArray, mass_kg: FloatArray) -> Incline:
        """Return the slope under bodies.

        Args:
            position_m: where they are, (bodies, 2).
            facing_rad: where the wheels of the robots roll, (robots,).
            mass_kg: what rests on the ground with each body, (bodies,).
        """
        weight_n = mass_kg * GRAVITY_MPS2
        gradient = self.terrain.gradient(position_m[:, 0], position_m[:, 1])
        grip = 1.0 / (1.0 + (gradient * gradient).sum(axis=1))
        pull_n = -(weight_n * grip)[:, None] * gradient
        ahead = np.column_stack([np.cos(facing_rad), np.sin(facing_rad)])
        left = np.column_stack([-ahead[:, 1], ahead[:, 0]])
        mine, robots = gradient[: self._robots], slice(self._robots)
        rise, lean = (mine * ahead).sum(axis=1), (mine * left).sum(axis=1)
        along2, grip2 = 1.0 / (1.0 + rise * rise), grip[robots]
        pull_n[robots] = (rise * along2)[:, None] * ahead + (lean * grip2)[:, None] * left
        pull_n[robots] *= -weight_n[robots, None]
        sloping = np.asarray(mine.any(axis=1))
        down_n = weight_n[robots] * np.sqrt(1.0 - grip2)
        seen_n = np.hypot(pull_n[robots, 0], pull_n[robots, 1])
        seen = np.divide(seen_n, down_n, out=np.ones_like(down_n), where=down_n > _LEAST_N)
        hold = np.sqrt(grip2) * seen
        along, across = np.sqrt(along2), np.sqrt(grip2 / along2)
        steep = 1.0 / grip[self._robots :] - 1.0 > FLOOR_FRICTION**2
        quiet = not steep.any() and not self._any_near(position_m[robots])
        return Incline(pull_n, grip, hold, ahead, along, across, sloping, quiet)

    def shortened(
        self, position_m: FloatArray, x_m: FloatArray, y_m: FloatArray
    ) -> tuple[FloatArray, FloatArray]:
        """Return ways along the ground as seen from above.

        Args:
            position_m: where they begin, (k, 2).
            x_m: how far they would go along x if the ground were level, (k,).
            y_m: the same along y.
        """
        gradient = self.terrain.gradient(position_m[:, 0], position_m[:, 1])
        way_m = np.hypot(x_m, y_m)
        rise = x_m * gradient[:, 0] + y_m * gradient[:, 1]
        share = np.divide(way_m, np.hypot(way_m, rise), out=np.ones_like(way_m), where=rise != 0.0)
        return x_m * share, y_m * share

    def longer(self, position_m: FloatArray, direction: FloatArray) -> FloatArray:
        """Return by how much ways are longer along the ground than they look from above.

        Args:
            position_m: where they begin, (k, 2).
            direction: where they go, of length 1, (k, 2).
        """
        gradient = self.terrain.gradient(position_m[:, 0], position_m[:, 1])
        return np.asarray(np.hypot(1.0, (gradient * direction).sum(axis=1)))

    def _any_near(self, position_m: FloatArray) -> bool:
        terrain, place = self.terrain, position_m[:, 0] + 1j * position_m[:, 1]
        if terrain.heights is not None and terrain.heights.holds(place, self._reach_m).any():
            return True
        point, patch = self._near.near(place)
        local = terrain.local(place.take(point), patch)
        beyond_x = np.abs(local.real) - terrain.half_length_m.take(patch)
        beyond_y = np.abs(local.imag) - terrain.half_width_m.take(patch)
        return bool((np.maximum(beyond_x, beyond_y) <= self._reach_m).any())
