"""Beams at a height: objects that are high enough to be hit, and the ground where it rises.

The beams of a sensor are in a plane. It is z above the ground at its robot's centre, and tilts as
the robot does there:

    beam(p) = ground(robot) + z + gradient(robot) . (p - robot)

An object stands on the ground at its centre. It is hit if its top is above the beam at the nearest
point of its side, otherwise the beam passes over it. The ground is hit where it is above the beam:
each patch, clipped by the plane of the beam, is one more object with straight sides, whose cut is
where the beam meets the slope; pixels of a height map count as level.

Sound spreads: the lower side of a sonar's cone falls by the tangent of its half angle with each
metre, and an object or patch is hit if it is above that at its nearest point, but not below the
extended plane of the ground on which the robot stands: smooth ground reflects sound away. Other
beams are thin. Overhanging objects, and objects behind the top of a lower one, are ignored. All of
this is our choice.

>>> from crs_cc.sim.model.world import Area, Box, Pose, WorldModel
>>> from crs_cc.sim.geometry.rays import Fan, nearest
>>> from crs_cc.sim.geometry.scene import NOTHING
>>> low, high = Box("low", Pose(3, 1), 1, 1, height_m=0.2), Box("high", Pose(6, 1), 1, 1)
>>> scene = Scene(WorldModel("w", Area(0, 0, 9, 9, 0), boxes=(low, high)))
>>> outlook = Outlook(scene, Obstacles(scene.fixed, NOTHING, 6.0, 1.0), 6.0)
>>> outlook.place(np.zeros((0, 2)))
>>> ahead, pose = Fan.of([(0.0, 0.0, 0.0, 0.0, 5.0)]), np.array([[1.0, 1.0, 0.0]])
>>> [nearest(ahead, pose, outlook.at(z_m)).item() for z_m in (0.1, 0.3)]
[1.5, 4.5]
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final, TypeAlias

import numpy as np

from crs_cc.core import segment
from crs_cc.core.arrays import BoolArray, ComplexArray, FloatArray, IndexArray
from crs_cc.sim.geometry.obstacles import Obstacles
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.geometry.shape_table import ShapeTable
from crs_cc.sim.geometry.terrain import Terrain
from crs_cc.sim.kernels import exact
from crs_cc.sim.kernels.program import pairs
from crs_cc.sim.model.ground import Ground, Patch
from crs_cc.sim.model.world import TALL_M

Segments: TypeAlias = "tuple[IndexArray, ComplexArray, ComplexArray, FloatArray]"
Circles: TypeAlias = "tuple[IndexArray, ComplexArray, FloatArray]"

_MIN_LENGTH_M: Final = 1e-6  # shorter sides of a clipped patch are dropped
_ON_M: Final = 1e-9
_BEYOND_M: Final = 100.0  # extent of the floor beyond the world's area


class Outlook:
    """The objects and the ground of a world with heights.

    Attributes:
        obstacles: the outlines of all objects.
        terrain: the ground.
        patches: its patches, followed by the floor.
        corners: their corners, x + i y [m], counter-clockwise, (patches, 4).
        corner_heights_m: the heights of the corners.
        grid: the patches without the floor, by the places from which they are within reach.
        reach_m: the maximum distance from its centre at which a robot measures.
        ground: the number of the ground in `Scene.names`.
        tops_m: the heights of the tops of all objects, (names,).
    """

    def __init__(self, scene: Scene, obstacles: Obstacles, reach_m: float) -> None:
        """Sort the fixed objects and patches.

        Args:
            scene: the scene.
            obstacles: the outlines of all objects, updated by the caller.
            reach_m: the maximum distance from its centre at which a robot measures.
        """
        area = scene.world.area
        length_m, width_m = area.length_m + 2 * _BEYOND_M, area.width_m + 2 * _BEYOND_M
        middle = area.x_min_m + area.length_m / 2, area.y_min_m + area.width_m / 2
        floor = Patch(*middle, 0.0, length_m, width_m, 0.0, 0.0)
        self.obstacles = obstacles
        self.terrain = Terrain(scene.world.surface)
        self.patches = Terrain(Ground((*scene.world.surface.patches, floor)))
        corners_m = self.patches.corners_m()
        self.corners = corners_m[:, :, 0] + 1j * corners_m[:, :, 1]
        away = self.corners - self.patches.middle[:, None]
        ahead_m = exact.dot(away, self.patches.along[:, None])
        self.corner_heights_m = (
            self.patches.middle_m[:, None] + self.patches.slope[:, None] * ahead_m
        )
        self.grid = self.terrain.grid(reach_m)
        self.reach_m = reach_m
        self.ground = len(scene.names) - 1
        self._moving = len(scene.start)
        self._heights_m = np.array([obj.height_m for obj in scene.objects])
        self.tops_m = np.append(self._heights_m, np.inf)
        x_m, y_m = ShapeTable.of(scene).fixed[:, :2].T
        self.tops_m[self._moving : -1] += self.terrain.height_m(x_m, y_m)

    def place(self, position_m: FloatArray) -> None:
        """Update the positions of the movable bodies, (bodies, 2)."""
        ground_m = self.terrain.height_m(position_m[:, 0], position_m[:, 1])
        self.tops_m[: self._moving] = self._heights_m[: self._moving] + ground_m

    def at(self, z_m: FloatArray | float, spread: FloatArray | float = 0.0) -> Level:
        """Return the outlines for beams that start at a height above the ground under their robots.

        Args:
            z_m: the height, one for all or one for each query point.
            spread: the fall of the lower sides of their cones with each metre; likewise.
        """
        return Level(self, z_m, spread)

    def under_ground(
        self, z_m: float, poses: FloatArray, start: ComplexArray, order: IndexArray
    ) -> BoolArray:
        """Return which beams start below the ground, (k, beams).

        Args:
            z_m: their height.
            poses: x, y [m] and heading [rad] of each robot, (k, 3).
            start: their starts in the robot frame, (beams,).
            order: the index of each of these in the result.
        """
        place = poses[:, 0] + 1j * poses[:, 1]
        away = exact.product(exact.turn(poses[:, 2])[:, None], start)
        plane_m, rise = self.plane(place)
        beam_m = (plane_m + z_m)[:, None] + exact.dot(rise[:, None], away)
        ends = (place[:, None] + away).ravel()
        ground_m = self.terrain.height_m(ends.real, ends.imag).reshape(away.shape)
        given = np.empty(away.shape, dtype=np.bool_)
        given[:, order] = ground_m > beam_m + _ON_M
        return given

    def plane(self, place: ComplexArray) -> tuple[FloatArray, ComplexArray]:
        """Return the height and the gradient of the ground at points."""
        x_m, y_m = place.real, place.imag
        rise = self.terrain.gradient(x_m, y_m)
        return self.terrain.height_m(x_m, y_m), rise[:, 0] + 1j * rise[:, 1]


@dataclass(frozen=True, slots=True)
class Level:
    """The outlines for beams at a height; queried like `Obstacles`.

    Attributes:
        outlook: the objects and the ground.
        z_m: the height of the beams above the ground under their robots.
        spread: the fall of the lower sides of their cones with each metre.
    """

    outlook: Outlook
    z_m: FloatArray | float
    spread: FloatArray | float

    def blocks(self, place: ComplexArray) -> Iterator[tuple[slice, Level]]:
        """Yield parts of the robots as `Obstacles.blocks` does, each with the outlines for it."""
        outlook = self.outlook
        more = 4 * outlook.grid.counts(place) + 1
        if outlook.terrain.heights is not None:
            more = more + 2 * outlook.terrain.heights.nodes_m.size  # a side for each of two pixels
        for part, _ in outlook.obstacles.blocks(place, more):
            values = (np.asarray(value) for value in (self.z_m, self.spread))
            z_m, spread = (value[part] if value.ndim else value for value in values)
            yield part, Level(outlook, z_m, spread)

    def segment_rows(self, place: ComplexArray) -> FloatArray:
        """Return what `segments_near` returns, with objects, as `kernels/rays.c` reads it."""
        (viewers, start, end, length_m), objects = self.segments_and_objects(place)
        return np.column_stack([viewers, objects, pairs(start), pairs(end), length_m])

    def circle_rows(self, place: ComplexArray, own: IndexArray) -> FloatArray:
        """Return what `circles_near` returns, with objects, as `kernels/rays.c` reads it."""
        (viewers, middle, radius_m), objects = self.circles_and_objects(place, own)
        return np.column_stack([viewers, objects, pairs(middle), radius_m])

    def segments_near(self, place: ComplexArray) -> Segments:
        """Return `Obstacles.segments_near` without objects below the beams, and with ground."""
        return self.segments_and_objects(place)[0]

    def segments_and_objects(self, place: ComplexArray) -> tuple[Segments, IndexArray]:
        """Return `segments_near`, and the object of each pair, as in `Scene.names`."""
        found, objects, ground = self._segments(place)
        viewers, start, end, length_m = (
            np.concatenate(pair) for pair in zip(found, ground, strict=True)
        )
        grounds = np.full(len(ground[0]), self.outlook.ground, np.intp)
        return (viewers, start, end, length_m), np.concatenate([objects, grounds])

    def segment_objects(self, place: ComplexArray) -> IndexArray:
        """Return the object, as in `Scene.names`, of each pair of `segments_near`."""
        return self.segments_and_objects(place)[1]

    def circles_near(self, place: ComplexArray, own: IndexArray) -> Circles:
        """Return `Obstacles.circles_near` without objects below the beams."""
        return self.circles_and_objects(place, own)[0]

    def circles_and_objects(
        self, place: ComplexArray, own: IndexArray
    ) -> tuple[Circles, IndexArray]:
        """Return `circles_near`, and the object of each pair, as in `Scene.names`."""
        obstacles, plane = self.outlook.obstacles, self.outlook.plane(place)
        viewers, middle, radius_m = obstacles.circles_near(place, own)
        away = middle - place.take(viewers)
        away_m = np.maximum(exact.magnitude(away), _ON_M)
        front = away * np.maximum(1.0 - radius_m / away_m, 0.0)
        objects = obstacles.circle_objects(place, own)
        keep = self._is_high(plane, viewers, front, objects)
        return (viewers[keep], middle[keep], radius_m[keep]), objects[keep]

    def circle_objects(self, place: ComplexArray, own: IndexArray) -> IndexArray:
        """Return the object, as in `Scene.names`, of each pair of `circles_near`."""
        return self.circles_and_objects(place, own)[1]

    def tops_above(self, poses: FloatArray, objects: IndexArray) -> BoolArray:
        """Return which objects, one for each pose and beam, reach the beams that start there."""
        plane_m, _ = self.outlook.plane(poses[:, 0] + 1j * poses[:, 1])
        return np.asarray(self.outlook.tops_m[objects] > (plane_m + self.z_m)[:, None])

    def _segments(self, place: ComplexArray) -> tuple[Segments, IndexArray, Segments]:
        """Return the segments of objects, these objects, and the segments of the ground."""
        obstacles, plane = self.outlook.obstacles, self.outlook.plane(place)
        viewers, start, end, length_m = obstacles.segments_near(place)
        away, along = start - place.take(viewers), end - start
        share = segment.nearest_fraction(-away.real, -away.imag, along.real, along.imag)
        foot = away + share * along
        objects = obstacles.segment_objects(place)
        keep = self._is_high(plane, viewers, foot, objects)
        found = viewers[keep], start[keep], end[keep], length_m[keep]
        return found, objects[keep], self._ground(place, plane)

    def _is_high(
        self, plane: tuple[FloatArray, ComplexArray], viewers: IndexArray, near: ComplexArray,
        objects: IndexArray,
    ) -> BoolArray:  # fmt: skip
        """Return which objects are above the lower sides of beams at their nearest points."""
        ground_m, rise = plane
        beam_m = ground_m.take(viewers) + exact.dot(rise.take(viewers), near)
        beam_m += self._above(viewers, exact.magnitude(near))
        return np.asarray(self.outlook.tops_m.take(objects) > beam_m)

    def _above(self, viewers: IndexArray, away_m: FloatArray) -> FloatArray:
        """Return the height of the lower sides of beams above the viewers' ground."""
        z_m, spread = (np.asarray(value, dtype=np.float64) for value in (self.z_m, self.spread))
        z_m = z_m.take(viewers) if z_m.ndim else z_m
        spread = spread.take(viewers) if spread.ndim else spread
        return np.asarray(np.maximum(z_m - spread * away_m, 0.0))

    def _ground(self, place: ComplexArray, plane: tuple[FloatArray, ComplexArray]) -> Segments:
        """Return the sides of patches and of the floor, clipped by the beams' planes."""
        patches, corners = self.outlook.patches, self.outlook.corners
        viewers, patch = self.outlook.grid.near(place)
        tilted = np.flatnonzero(plane[1])
        viewers = np.concatenate([viewers, tilted])
        patch = np.concatenate([patch, np.full(len(tilted), len(patches.middle) - 1)])
        local = patches.local(place.take(viewers), patch)
        beyond_x = np.maximum(np.abs(local.real) - patches.half_length_m.take(patch), 0.0)
        beyond_y = np.maximum(np.abs(local.imag) - patches.half_width_m.take(patch), 0.0)
        above_m = self._above(viewers, exact.hypot(beyond_x, beyond_y))
        ends = corners[patch]
        away = ends - place.take(viewers)[:, None]
        beam_m = (plane[0].take(viewers) + above_m)[:, None]
        beam_m = beam_m + exact.dot(plane[1].take(viewers)[:, None], away)
        sides = _cut(viewers, ends, self.outlook.corner_heights_m[patch] - beam_m)
        heights = self.outlook.terrain.heights
        if heights is None:
            return sides
        z_m = np.broadcast_to(np.asarray(self.z_m, dtype=np.float64), place.shape)
        spread = np.broadcast_to(np.asarray(self.spread, dtype=np.float64), place.shape)
        more = heights.outlines(place, plane, z_m, spread, self.outlook.reach_m)
        viewers, start, end, length_m = (
            np.concatenate(pair) for pair in zip(sides, more, strict=True)
        )
        return viewers, start, end, length_m


def _cut(viewers: IndexArray, corners: ComplexArray, over_m: FloatArray) -> Segments:
    """Return the sides of the parts of rectangles that are above beams.

    Args:
        viewers: the viewer of each rectangle, (n,).
        corners: its corners, counter-clockwise, (n, 4).
        over_m: the heights of the corners above the beams, (n, 4); linear in between.
    """
    up = over_m > _ON_M
    some = np.flatnonzero(up.any(axis=1))
    viewers, corners, over_m, up = viewers[some], corners[some], over_m[some], up[some]
    ends, ends_m = np.roll(corners, -1, axis=1), np.roll(over_m, -1, axis=1)
    ends_up = np.roll(up, -1, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        share = over_m / (over_m - ends_m)
    crossing = corners + np.where(up ^ ends_up, share, 0.0) * (ends - corners)
    start, end = np.where(up, corners, crossing), np.where(ends_up, ends, crossing)
    side, which = np.nonzero(up | ends_up)
    leaves, enters = up & ~ends_up, ~up & ends_up
    cut = np.flatnonzero(leaves.any(axis=1))
    start = np.concatenate([start[side, which], crossing[cut, leaves[cut].argmax(axis=1)]])
    end = np.concatenate([end[side, which], crossing[cut, enters[cut].argmax(axis=1)]])
    viewers = np.concatenate([viewers[side], viewers[cut]])
    length_m = exact.magnitude(end - start)
    kept = np.flatnonzero(length_m > _MIN_LENGTH_M)
    return viewers[kept], start[kept], end[kept], length_m[kept]


def is_needed(scene: Scene) -> bool:
    """Return whether heights matter: whether an object is low or the ground is not flat."""
    return not scene.world.surface.is_flat or any(obj.height_m < TALL_M for obj in scene.objects)
