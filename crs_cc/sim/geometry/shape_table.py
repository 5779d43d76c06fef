"""The shapes of all objects in arrays, and distances from points to them.

A shape is a rectangle with a margin around it: for a box the margin is 0, for a round object the
rectangle is a point and the margin its radius, for a wall it is a line. Polygons have corners.

>>> from crs_cc.sim.model.world import Area, Box, Cylinder, Pose, WorldModel
>>> desk, bin = Box("desk", Pose(3.0, 0.0), 2.0, 1.0), Cylinder("bin", Pose(0.0, 4.0), 0.5)
>>> area = Area(-5, -5, 10, 10, edge_m=0)
>>> things = ShapeTable.of(Scene(WorldModel("w", area, boxes=(desk,), cylinders=(bin,))))
>>> things.distance_m(things.fixed, np.array([0, 1]), np.zeros(2), np.zeros(2)).tolist()
[2.0, 3.5]
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol, Self

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.polygon import distances_m
from crs_cc.sim.model.world import Box, Cylinder, Polygon, Robot, Solid, Wall


class Placed(Protocol):
    """The poses of bodies."""

    @property
    def position_m(self) -> FloatArray:
        """Their centres in the world frame, (bodies, 2)."""

    @property
    def angle_rad(self) -> FloatArray:
        """Their headings, (bodies,)."""


@dataclass(frozen=True, slots=True)
class ShapeTable:
    """The shapes of all objects, in the order of `Scene.names`.

    Attributes:
        half_m: half the length and width of the rectangle, (things, 2).
        margin_m: the margin around it, (things,).
        corners_m: the corners of all polygons in their own frames, one after the other, (n, 2).
        first: the first corner of each object, (things,).
        corners: number of its corners, 0 if it is not a polygon, (things,).
        spread_m: the spread of its heat, infinite for everywhere, (things,).
        fixed: x, y [m] and heading [rad] of the fixed objects, the last ones, (fixed, 3).
    """

    half_m: FloatArray
    margin_m: FloatArray
    corners_m: FloatArray
    first: IndexArray
    corners: IndexArray
    spread_m: FloatArray
    fixed: FloatArray

    @classmethod
    def of(cls, scene: Scene) -> Self:
        """Create the table of the objects in a scene."""
        things = scene.things
        shapes = np.array([_shape(thing) for thing in things], dtype=np.float64).reshape(-1, 3)
        fixed = [_pose(thing) for thing in scene.fixed_solids]
        own = [thing.corners_m if isinstance(thing, Polygon) else () for thing in things]
        counts = np.array([len(corners) for corners in own], dtype=np.intp)
        return cls(
            shapes[:, :2],
            shapes[:, 2],
            np.array([corner for corners in own for corner in corners]).reshape(-1, 2),
            np.cumsum(counts) - counts,
            counts,
            np.array([thing.spread_m for thing in things], dtype=np.float64),
            np.array(fixed, dtype=np.float64).reshape(-1, 3),
        )

    @property
    def reach_m(self) -> FloatArray:
        """Maximum distance of each object's points from its centre, (things,)."""
        return np.hypot(self.half_m[:, 0], self.half_m[:, 1]) + self.margin_m

    def poses(self, bodies: Placed) -> FloatArray:
        """Return x, y [m] and heading [rad] of all objects, (things, 3)."""
        moving = np.column_stack([bodies.position_m, bodies.angle_rad])
        return np.concatenate([moving, self.fixed])

    def distance_m(
        self, poses: FloatArray, things: IndexArray, x_m: FloatArray, y_m: FloatArray
    ) -> FloatArray:
        """Return the distances from points to objects, 0 or less inside.

        Args:
            poses: of all objects, see `poses`.
            things: the object for each point, (k,).
            x_m: the points, (k,).
            y_m: the points, (k,).
        """
        pose = poses[things]
        east_m, north_m = x_m - pose[:, 0], y_m - pose[:, 1]
        cos, sin = np.cos(pose[:, 2]), np.sin(pose[:, 2])
        own_m = np.column_stack([cos * east_m + sin * north_m, cos * north_m - sin * east_m])
        beyond_m = np.maximum(np.abs(own_m) - self.half_m[things], 0.0)
        distance_m = np.hypot(beyond_m[:, 0], beyond_m[:, 1]) - self.margin_m[things]
        angular = np.flatnonzero(self.corners[things])
        if len(angular):
            distance_m[angular] = self._from_polygons_m(own_m[angular], things[angular])
        return distance_m

    def _from_polygons_m(self, own_m: FloatArray, things: IndexArray) -> FloatArray:
        """Return the distances of points, in the frames of polygons, from these."""
        counts = self.corners[things]
        ends = np.cumsum(counts)
        corner = np.arange(ends[-1]) + np.repeat(self.first[things] - (ends - counts), counts)
        return distances_m(own_m, self.corners_m[corner], counts)


def _shape(thing: Robot | Solid) -> tuple[float, float, float]:
    """Return half the length, half the width, and the margin [m]."""
    match thing:
        case Box():
            return thing.length_m / 2, thing.width_m / 2, 0.0
        case Cylinder():
            return 0.0, 0.0, thing.radius_m
        case Robot():
            return 0.0, 0.0, thing.model.radius_m
        case Wall():
            length_m = math.hypot(thing.x2_m - thing.x1_m, thing.y2_m - thing.y1_m)
            return length_m / 2, 0.0, thing.thickness_m / 2
        case Polygon():
            return 0.0, 0.0, max(math.hypot(*corner) for corner in thing.corners_m)


def _pose(thing: Solid) -> tuple[float, float, float]:
    if isinstance(thing, Wall):
        heading_rad = math.atan2(thing.y2_m - thing.y1_m, thing.x2_m - thing.x1_m)
        return (thing.x1_m + thing.x2_m) / 2, (thing.y1_m + thing.y2_m) / 2, heading_rad
    return thing.pose.x_m, thing.pose.y_m, thing.pose.heading_rad
