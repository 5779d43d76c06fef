"""Ledges: steps and slopes of the ground that block bodies.

A patch of ground blocks a body like a wall, from below, where its top is more than a step above the
ground under the body. Robots climb a step of the height `step` of their definition; movable objects
climb `STEP_M`, and a slope of `CLIMB`. A ramp that is steeper than the limit `climb` of a robot
blocks it as if all of the ramp were as high as its highest end; so does a square between four
pixels of a height map, as high as the highest one.

From above nothing blocks: a body falls off, and continues at the lower height. It rests on the
highest ground under it, except under a rim of `RIM_M`, so it has left a plateau only when it has
left it completely. While its centre is on a patch, or it moves away from it, that patch never
blocks it, so a body can always leave what it got onto. All of this is our choice.

>>> from crs_cc.sim.files.world_xml import parse_world
>>> world = parse_world(b'''<world version="1"><area length="9m" width="9m"/>
...   <surface><plateau x="4m" y="4m" length="2m" width="2m" height="10cm"/></surface>
...   <robot x="2.8m" y="4m"/><robot x="5.15m" y="4m"/></world>''', "plateau")
>>> from crs_cc.sim.geometry.scene import Scene
>>> scene = Scene(world)
>>> ledges = Ledges(Terrain(world.surface), scene)
>>> ledges.place(scene.start[:, :2], scene.start[:, 2])
>>> ledges.blocks(0, 0, [(3.0, 4.0)]), ledges.blocks(1, 0, [(5.0, 4.0)])
(True, False)
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np

from crs_cc.core.arrays import ComplexArray, FloatArray
from crs_cc.sim.geometry.scene import Scene, own_corners_m
from crs_cc.sim.geometry.terrain import Terrain, corners_m
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.world import Cylinder, WorldObject

STEP_M: Final = 0.02
"""The highest step over which objects can be pushed."""

CLIMB: Final = 1.0
"""The steepest slope that objects can be pushed up: 45 degrees."""

RIM_M: Final = 0.02
"""Width of a body's rim that may overhang; more than a body penetrates a wall."""

_CORNERS: Final = 16
"""Points on the edge of a round body."""


class Ledges:
    """The parts of the ground that can block bodies.

    Attributes:
        patches: number of ramps and plateaus among these parts; they are the first ones.
    """

    def __init__(self, terrain: Terrain, scene: Scene) -> None:
        models = [robot.model for robot in scene.world.robots]
        self._terrain = terrain
        self._feet = [_round_feet(model.radius_m) for model in models]
        self._feet += [_feet(obj) for obj in scene.pushables]
        self._step_m = [model.drive.step_m for model in models] + [STEP_M] * len(scene.pushables)
        self._climb = [exact.tan(model.drive.climb_rad) for model in models]
        self._climb += [CLIMB] * len(scene.pushables)
        middle, highest_m, steep = _steep_squares(terrain, min([*self._climb, 1.0]))
        half_m = np.full(len(middle), terrain.heights.pixel_m / 2 if terrain.heights else 0.0)
        self.patches = len(terrain.middle)
        self._middle = np.concatenate([terrain.middle, middle])
        self._along = np.concatenate([terrain.along, np.ones(len(middle), np.complex128)])
        self._half_length_m = np.concatenate([terrain.half_length_m, half_m])
        self._half_width_m = np.concatenate([terrain.half_width_m, half_m])
        self._middle_m = np.concatenate([terrain.middle_m, highest_m])
        self._slope = np.concatenate([terrain.slope, np.zeros(len(middle))])
        self._steep = np.concatenate([np.abs(terrain.slope), steep])
        self._highest_m = self._middle_m + np.abs(self._slope) * self._half_length_m

    def corners_m(self) -> FloatArray:
        """Return the corners of all parts that can block, counter-clockwise, (n, 4, 2)."""
        return corners_m(self._middle, self._along, self._half_length_m, self._half_width_m)

    def place(self, position_m: FloatArray, angle_rad: FloatArray) -> None:
        """Set the poses of the bodies at the start of a cycle."""
        self._place = position_m[:, 0] + 1j * position_m[:, 1]
        self._turn = exact.turn(angle_rad)
        self._ground_m: dict[int, float] = {}

    def blocks(self, body: int, patch: int, touches_m: Sequence[tuple[float, float]]) -> bool:
        """Return whether a patch blocks a body that touches it at the given points."""
        middle, along, half_m = self._middle[patch], self._along[patch], self._half_length_m[patch]
        local = exact.product(self._place[body] - middle, along.conjugate())
        if abs(local.real) <= half_m and abs(local.imag) <= self._half_width_m[patch]:
            return False
        if self._steep[patch] > self._climb[body]:
            top_m = float(self._highest_m[patch])
        elif patch >= self.patches:
            return False
        else:
            ahead_m = [exact.dot(complex(x, y) - middle, along) for x, y in touches_m]
            rises_m = np.clip(ahead_m, -half_m, half_m) * self._slope[patch]
            top_m = float(self._middle_m[patch] + rises_m.max())
        return top_m > self._stands_m(body) + self._step_m[body]

    def _stands_m(self, body: int) -> float:
        """Return the height of the highest ground under a body."""
        if body not in self._ground_m:
            feet = self._place[body] + exact.product(self._turn[body], self._feet[body])
            self._ground_m[body] = float(self._terrain.height_m(feet.real, feet.imag).max())
        return self._ground_m[body]


def _steep_squares(terrain: Terrain, slope: float) -> tuple[ComplexArray, FloatArray, FloatArray]:
    """Return the parts of a height map steeper than a slope: centres, tops, slopes."""
    if terrain.heights is not None:
        return terrain.heights.steep(slope)
    return np.zeros(0, np.complex128), np.zeros(0), np.zeros(0)


def _round_feet(radius_m: float) -> ComplexArray:
    circle = exact.turn(np.linspace(0.0, 2 * math.pi, _CORNERS, endpoint=False))
    return np.append(circle * max(radius_m - RIM_M, 0.0), 0.0)


def _feet(obj: WorldObject) -> ComplexArray:
    """Return the centre and the corners of an object, moved inwards by the rim."""
    if isinstance(obj, Cylinder):
        return _round_feet(obj.radius_m)
    corners = own_corners_m(obj)
    feet = corners[:, 0] + 1j * corners[:, 1]
    feet *= np.maximum(1.0 - math.sqrt(2.0) * RIM_M / np.maximum(exact.magnitude(feet), 1e-9), 0.0)
    return np.append(feet, 0.0)
