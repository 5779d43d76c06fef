"""The shapes of all objects in arrays, and distances from points to them.

A shape is a rectangle with a margin around it: for a box the margin is 0, for a round object the
rectangle is a point and the margin its radius, for a wall it is a line. Polygons have corners.

>>> from crs_cc.sim.model.world import Area, Box, Cylinder, Pose, WorldModel
>>> desk, bin = Box("desk", Pose(3.0, 0.0), 2.0, 1.0), Cylinder("bin", Pose(0.0, 4.0), 0.5)
>>> area = Area(-5, -5, 10, 10, edge_m=0)
>>> objects = ShapeTable.of(Scene(WorldModel("w", area, boxes=(desk,), cylinders=(bin,))))
>>> objects.distance_m(objects.fixed, np.array([0, 1]), np.zeros(2), np.zeros(2)).tolist()
[2.0, 3.5]
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol, Self

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.kernels import exact
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
        half_m: half the length and width of the rectangle, (objects, 2).
        margin_m: the margin around it, (objects,).
        corners_m: the corners of all polygons in their own frames, one after the other, (n, 2).
        first: the first corner of each object, (objects,).
        corners: number of its corners, 0 if it is not a polygon, (objects,).
        spread_m: the spread of its heat, infinite for everywhere, (objects,).
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
        objects = scene.objects
        shapes = np.array([_shape(obj) for obj in objects], dtype=np.float64).reshape(-1, 3)
        fixed = [_pose(obj) for obj in scene.fixed_solids]
        own = [obj.corners_m if isinstance(obj, Polygon) else () for obj in objects]
        counts = np.array([len(corners) for corners in own], dtype=np.intp)
        return cls(
            shapes[:, :2],
            shapes[:, 2],
            np.array([corner for corners in own for corner in corners]).reshape(-1, 2),
            np.cumsum(counts) - counts,
            counts,
            np.array([obj.spread_m for obj in objects], dtype=np.float64),
            np.array(fixed, dtype=np.float64).reshape(-1, 3),
        )

    @property
    def reach_m(self) -> FloatArray:
        """Maximum distance of each object's points from its centre, (objects,)."""
        return exact.hypot(self.half_m[:, 0], self.half_m[:, 1]) + self.margin_m

    def poses(self, bodies: Placed) -> FloatArray:
        """Return x, y [m] and heading [rad] of all objects, (objects, 3)."""
        moving = np.column_stack([bodies.position_m, bodies.angle_rad])
        return np.concatenate([moving, self.fixed])

    def distance_m(
        self, poses: FloatArray, objects: IndexArray, x_m: FloatArray, y_m: FloatArray
    ) -> FloatArray:
        """Return the distances from points to objects, 0 or less inside.

        Args:
            poses: of all objects, see `poses`.
            objects: the object for each point, (k,).
            x_m: the points, (k,).
            y_m: the points, (k,).
        """
        pose = poses[objects]
        east_m, north_m = x_m - pose[:, 0], y_m - pose[:, 1]
        cos, sin = exact.cos(pose[:, 2]), exact.sin(pose[:, 2])
        own_m = np.column_stack([cos * east_m + sin * north_m, cos * north_m - sin * east_m])
        beyond_m = np.maximum(np.abs(own_m) - self.half_m[objects], 0.0)
        distance_m = exact.hypot(beyond_m[:, 0], beyond_m[:, 1]) - self.margin_m[objects]
        angular = np.flatnonzero(self.corners[objects])
        if len(angular):
            distance_m[angular] = self._from_polygons_m(own_m[angular], objects[angular])
        return distance_m

    def _from_polygons_m(self, own_m: FloatArray, objects: IndexArray) -> FloatArray:
        """Return the distances of points, in the frames of polygons, from these."""
        counts = self.corners[objects]
        ends = np.cumsum(counts)
        corner = np.arange(ends[-1]) + np.repeat(self.first[objects] - (ends - counts), counts)
        return distances_m(own_m, self.corners_m[corner], counts)


def _shape(obj: Robot | Solid) -> tuple[float, float, float]:
    """Return half the length, half the width, and the margin [m]."""
    match obj:
        case Box():
            return obj.length_m / 2, obj.width_m / 2, 0.0
        case Cylinder():
            return 0.0, 0.0, obj.radius_m
        case Robot():
            return 0.0, 0.0, obj.model.radius_m
        case Wall():
            length_m = exact.hypot(obj.x2_m - obj.x1_m, obj.y2_m - obj.y1_m)
            return length_m / 2, 0.0, obj.thickness_m / 2
        case Polygon():
            return 0.0, 0.0, max(exact.hypot(*corner) for corner in obj.corners_m)


def _pose(obj: Solid) -> tuple[float, float, float]:
    if isinstance(obj, Wall):
        heading_rad = exact.arctan2(obj.y2_m - obj.y1_m, obj.x2_m - obj.x1_m)
        return (obj.x1_m + obj.x2_m) / 2, (obj.y1_m + obj.y2_m) / 2, heading_rad
    return obj.pose.x_m, obj.pose.y_m, obj.pose.heading_rad
