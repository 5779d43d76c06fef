"""The outlines of a world: line segments and circles that block beams.

A wall is two parallel segments with a circle at each end, a box or polygon its sides, a cylinder
or a robot a circle. Segments have their solid to their left: seen from outside, only those with
the viewer to their right are in front.

Movable bodies are numbered in one order everywhere: the robots, then the movable objects.

>>> from crs_cc.sim.model.world import Area, Box, Pose, WorldModel
>>> world = WorldModel("w", Area(0, 0, 4, 4, edge_m=0), boxes=(Box("b", Pose(1, 1), 2, 1),))
>>> Scene(world).fixed.segments[:, :4].tolist()[0]
[0.0, 0.5, 2.0, 0.5]
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.polygon import is_convex, triangles
from crs_cc.sim.model.world import (
    Box,
    Cylinder,
    Polygon,
    Solid,
    Wall,
    WorldModel,
    WorldObject,
    is_pushable,
)


@dataclass(frozen=True, slots=True)
class Outlines:
    """Segments and circles.

    Attributes:
        segments: x1, y1, x2, y2, length [m], shape (s, 5).
        circles: x, y, radius [m], shape (c, 3).
        owners: the object of each circle, as in `Scene.names`, shape (c,).
        segment_owners: the object of each segment, shape (s,).
    """

    segments: FloatArray
    circles: FloatArray
    owners: IndexArray
    segment_owners: IndexArray


GROUND: Final = "(ground)"
"""Name of the ground where it blocks bodies."""

_NONE: Final = np.zeros(0, dtype=np.intp)
_NO_SEGMENTS: Final = np.zeros((0, 5))
NOTHING: Final = Outlines(_NO_SEGMENTS, np.zeros((0, 3)), _NONE, _NONE)
"""Empty outlines."""


class Scene:
    """The outlines of a world: fixed ones, and those of movable bodies at any poses.

    Attributes:
        robots: number of robots: the first bodies.
        pushables: the movable objects, in the order of the bodies.
        objects: all of them: the robots, movable objects, fixed solids.
        present: the robots that are in the world; the others are invisible, (robots,).
        names: the id of each object, then `GROUND` if it is not flat.
        start: the initial poses of all bodies, shape (bodies, 3): x, y [m], heading [rad].
    """

    def __init__(self, world: WorldModel, present: BoolArray | None = None) -> None:
        """Build the outlines of a world.

        Args:
            world: the world.
            present: which of its robots are in it; by default all.
        """
        solids = world.solids()
        self.world = world
        self.robots = len(world.robots)
        self.present = np.ones(self.robots, dtype=np.bool_) if present is None else present
        self.pushables: tuple[WorldObject, ...] = tuple(
            solid for solid in solids if not isinstance(solid, Wall) and is_pushable(solid)
        )
        self.fixed_solids = tuple(solid for solid in solids if not is_pushable(solid))
        self.objects = (*world.robots, *self.pushables, *self.fixed_solids)
        ids = [obj.id for obj in self.objects]
        self.names = (*ids,) if world.surface.is_flat else (*ids, GROUND)
        poses = [robot.start for robot in world.robots] + [obj.pose for obj in self.pushables]
        rows = [(pose.x_m, pose.y_m, pose.heading_rad) for pose in poses]
        self.start = np.array(rows, dtype=np.float64).reshape(-1, 3)
        self._sides = _Sides(enumerate(self.pushables, len(world.robots)))
        round_bodies = np.flatnonzero(self.present).tolist()
        radii = [world.robots[robot].model.radius_m for robot in round_bodies]
        for body, obj in enumerate(self.pushables, self.robots):
            if isinstance(obj, Cylinder):
                radii.append(obj.radius_m)
                round_bodies.append(body)
        self._radii_m = np.array(radii, dtype=np.float64)
        self._round_bodies = np.array(round_bodies, dtype=np.intp)

    @cached_property
    def fixed(self) -> Outlines:
        """The outlines of fixed solids."""
        return _fixed_outlines(self.fixed_solids, self.robots + len(self.pushables))

    def moving(self, position_m: FloatArray, angle_rad: FloatArray) -> Outlines:
        """Return the outlines of the bodies.

        Args:
            position_m: their positions, shape (bodies, 2).
            angle_rad: their headings, shape (bodies,).
        """
        circles = np.empty((len(self._radii_m), 3))
        circles[:, :2], circles[:, 2] = position_m[self._round_bodies], self._radii_m
        segments = self._sides.segments(position_m, angle_rad)
        return Outlines(segments, circles, self._round_bodies, self._sides.bodies)


class _Sides:
    """The sides of boxes and polygons, in the frames of their bodies.

    Attributes:
        bodies: the body of each side.
    """

    def __init__(self, bodies: Iterable[tuple[int, WorldObject]]) -> None:
        pairs = [(body, obj) for body, obj in bodies if not isinstance(obj, Cylinder)]
        corners = [own_corners_m(obj) for _, obj in pairs]
        counts = np.array([len(rows) for rows in corners], dtype=np.intp)
        self.bodies = np.repeat(np.array([body for body, _ in pairs], dtype=np.intp), counts)
        self._starts_m = np.concatenate([np.zeros((0, 2)), *corners])
        # Each side ends where the next one starts, the last one of a body where the first one does.
        after = np.arange(1, len(self.bodies) + 1)
        last = np.cumsum(counts) - 1
        after[last] = last - counts + 1
        self._ends_m = self._starts_m[after]
        self._places = b""  # for which the segments were made
        self._segments = _NO_SEGMENTS

    def segments(self, position_m: FloatArray, angle_rad: FloatArray) -> FloatArray:
        """Return the sides, read-only: the same array until their bodies move."""
        if not len(self.bodies):
            return _NO_SEGMENTS
        places = position_m[self.bodies].tobytes() + angle_rad[self.bodies].tobytes()
        if places != self._places:
            self._places, self._segments = places, self._turned(position_m, angle_rad)
        return self._segments

    def _turned(self, position_m: FloatArray, angle_rad: FloatArray) -> FloatArray:
        cos, sin = exact.cos(angle_rad[self.bodies]), exact.sin(angle_rad[self.bodies])
        columns = []
        for ends_m in (self._starts_m, self._ends_m):
            x, y = ends_m.T
            turned = np.column_stack([cos * x - sin * y, sin * x + cos * y])
            columns.append(turned + position_m[self.bodies])
        return _with_length(np.concatenate(columns, axis=1))


def own_corners_m(obj: Box | Polygon) -> FloatArray:
    """Return the corners of an object in its own frame, counter-clockwise, shape (corners, 2)."""
    if isinstance(obj, Polygon):
        return np.array(obj.corners_m)
    x, y = obj.length_m / 2, obj.width_m / 2
    return np.array([(-x, -y), (x, -y), (x, y), (-x, y)])


@lru_cache(maxsize=4096)  # a scene is rebuilt whenever an obstacle is added or removed
def corners_m(obj: Box | Polygon) -> FloatArray:
    """Return the corners of an object in the world frame, counter-clockwise, shape (corners, 2)."""
    corners = _sides_of([obj])[0][:, :2]
    corners.flags.writeable = False
    return corners


@lru_cache(maxsize=4096)
def triangles_of(polygon: Polygon) -> IndexArray:
    """Return the triangles of a polygon: indices of three corners each, (n, 3)."""
    return triangles(own_corners_m(polygon))


@lru_cache(maxsize=4096)
def convex_parts_of(polygon: Polygon) -> IndexArray:
    """Return the convex parts of a polygon: itself, or triangles; indices of corners, (n, m)."""
    corners = own_corners_m(polygon)
    return np.arange(len(corners))[None] if is_convex(corners) else triangles_of(polygon)


def _fixed_outlines(solids: Sequence[Solid], first: int) -> Outlines:
    """Return the outlines of fixed solids; the number of the first one is `first`."""
    segments: list[FloatArray] = [np.zeros((0, 5))]
    circles: list[tuple[float, float, float]] = []
    owners: list[int] = []
    segment_owners: list[int] = []
    objects: list[tuple[int, Box | Polygon]] = []
    for number, solid in enumerate(solids, first):
        if isinstance(solid, Wall):
            segments.append(_wall_segments(solid))
            segment_owners += [number, number]
            circles.append((solid.x1_m, solid.y1_m, solid.thickness_m / 2))
            circles.append((solid.x2_m, solid.y2_m, solid.thickness_m / 2))
            owners += [number, number]
        elif isinstance(solid, Cylinder):
            circles.append((solid.pose.x_m, solid.pose.y_m, solid.radius_m))
            owners.append(number)
        else:
            objects.append((number, solid))
    numbers = np.array([number for number, _ in objects], dtype=np.intp)
    sides, rows = _sides_of([obj for _, obj in objects])
    return Outlines(
        np.concatenate([*segments, sides]),
        np.array(circles).reshape(-1, 3),
        np.array(owners, dtype=np.intp),
        np.concatenate([np.array(segment_owners, dtype=np.intp), numbers[rows]]),
    )


def _wall_segments(wall: Wall) -> FloatArray:
    start, end = np.array([wall.x1_m, wall.y1_m]), np.array([wall.x2_m, wall.y2_m])
    along = (end - start) / exact.hypot(*(end - start))
    left = np.array([-along[1], along[0]]) * wall.thickness_m / 2
    sides = [np.concatenate([start - left, end - left]), np.concatenate([end + left, start + left])]
    return _with_length(np.array(sides))


def _sides_of(objects: Sequence[Box | Polygon]) -> tuple[FloatArray, IndexArray]:
    """Return the sides of objects in the world frame, and the index of the object of each."""
    rows = [(obj.pose.x_m, obj.pose.y_m, obj.pose.heading_rad) for obj in objects]
    poses = np.array(rows).reshape(-1, 3)
    sides = _Sides(enumerate(objects))
    return sides.segments(poses[:, :2], poses[:, 2]), sides.bodies


def _with_length(ends_m: FloatArray) -> FloatArray:
    length_m = exact.hypot(ends_m[:, 2] - ends_m[:, 0], ends_m[:, 3] - ends_m[:, 1])
    return np.column_stack([ends_m, length_m])
