"""Detection of initial overlaps between robots, movable objects and walls.

Touching is allowed; an overlap of more than `TOLERANCE_M` is not. A robot that joins later may
overlap other robots and movable objects: they may have moved by then.

>>> from crs_cc.sim.model.world import Area, Pose, Robot, Wall, WorldModel
>>> from crs_cc.sim.model.robot import Drive, RobotModel
>>> scout = RobotModel("scout", 0.2, Drive(0.345))
>>> misplaced(WorldModel("w", Area(0, 0, 4, 4), (Wall("screen", 1, 0, 1, 4),), robots=(
...     Robot("r1", scout, Pose(2.0, 2.0)), Robot("r2", scout, Pose(1.1, 2.0)))))
[(1, "robot 'r2' overlaps wall 'screen'")]
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain, islice
from typing import Final

import numpy as np

from crs_cc.core import segment
from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.sim.geometry.cell_list import Discs, overlapping
from crs_cc.sim.geometry.overlap import overlap_m
from crs_cc.sim.geometry.scene import corners_m
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.polygon import distances_m
from crs_cc.sim.model.world import Box, Cylinder, Polygon, Solid, Wall, WorldModel, is_pushable

TOLERANCE_M: Final = 1e-6


def misplaced(world: WorldModel, most: int | None = None) -> list[tuple[int, str]]:
    """Return the index of each misplaced robot, and the error message.

    Args:
        world: the world.
        most: maximum number of messages; by default unlimited.
    """
    robots = world.robots
    if not robots:
        return []
    x_m = np.array([robot.start.x_m for robot in robots])
    y_m = np.array([robot.start.y_m for robot in robots])
    places = Discs(x_m, y_m, np.array([robot.model.radius_m for robot in robots]))
    ids = [robot.id for robot in robots]
    there = np.array([robot.join_s <= 0.0 for robot in robots])
    complaints = chain(
        _outside(world, ids, places),
        _inside(world, ids, places, there),
        _overlapping(ids, places, there),
    )
    return list(islice(complaints, most))


def overlapping_objects(world: WorldModel) -> Iterator[tuple[str, str]]:
    """Yield the id of each movable object that overlaps another, and the error message."""
    solids = world.solids()
    pushable = [number for number, solid in enumerate(solids) if is_pushable(solid)]
    if not pushable:
        return
    around = Discs(*np.array([disc_around(solid) for solid in solids]).T)
    objects = around.take(np.array(pushable))
    for solid_of, object_of in overlapping(around, objects):
        for number in sorted(set(solid_of.tolist())):
            near, solid = np.sort(object_of[solid_of == number]), solids[number]
            room_m = distance_from_m(solid, objects.x_m[near], objects.y_m[near])
            for obj in near[room_m < objects.radius_m[near]].tolist():
                other = pushable[obj]
                first = number < other or not is_pushable(solid)
                first &= not _together(solid, solids[other])
                if first and overlap_m(solids[other], solid) > TOLERANCE_M:
                    yield solids[other].id, f"{_named(solids[other])} overlaps {_named(solid)}"


def distance_from_m(solid: Solid, x_m: FloatArray, y_m: FloatArray) -> FloatArray:
    """Return the distances from points to a solid [m]; 0 or less inside."""
    if isinstance(solid, Wall):
        return _from_wall_m(solid, x_m, y_m)
    if isinstance(solid, Polygon):
        return _from_polygon_m(solid, x_m, y_m)
    across_x, across_y = x_m - solid.pose.x_m, y_m - solid.pose.y_m
    if isinstance(solid, Box):
        return _from_box_m(solid, across_x, across_y)
    return np.asarray(exact.hypot(across_x, across_y) - solid.radius_m)


def _from_wall_m(wall: Wall, x_m: FloatArray, y_m: FloatArray) -> FloatArray:
    along_x, along_y = wall.x2_m - wall.x1_m, wall.y2_m - wall.y1_m
    middle_m = segment.distance(x_m - wall.x1_m, y_m - wall.y1_m, along_x, along_y)
    return np.asarray(middle_m - wall.thickness_m / 2)


def _from_box_m(box: Box, across_x: FloatArray, across_y: FloatArray) -> FloatArray:
    cos, sin = exact.cos(box.pose.heading_rad), exact.sin(box.pose.heading_rad)
    beyond_x = np.abs(cos * across_x + sin * across_y) - box.length_m / 2
    beyond_y = np.abs(cos * across_y - sin * across_x) - box.width_m / 2
    outside = exact.hypot(np.maximum(beyond_x, 0.0), np.maximum(beyond_y, 0.0))
    return np.asarray(outside + np.minimum(np.maximum(beyond_x, beyond_y), 0.0))


def _from_polygon_m(polygon: Polygon, x_m: FloatArray, y_m: FloatArray) -> FloatArray:
    corners, count = corners_m(polygon), np.size(x_m)
    points = np.column_stack([np.ravel(x_m), np.ravel(y_m)])
    counts = np.full(count, len(corners))
    return distances_m(points, np.tile(corners, (count, 1)), counts).reshape(np.shape(x_m))


def _outside(world: WorldModel, ids: list[str], robots: Discs) -> Iterator[tuple[int, str]]:
    area, reach_m = world.area, robots.radius_m - TOLERANCE_M
    x_m, y_m = robots.x_m, robots.y_m
    inside = (x_m - reach_m >= area.x_min_m) & (x_m + reach_m <= area.x_max_m)
    inside &= (y_m - reach_m >= area.y_min_m) & (y_m + reach_m <= area.y_max_m)
    for robot in np.flatnonzero(~inside):
        yield int(robot), f"robot {ids[robot]!r} is not completely inside the world"


def _inside(
    world: WorldModel, ids: list[str], robots: Discs, there: BoolArray
) -> Iterator[tuple[int, str]]:
    solids = world.solids()[len(world.edge_walls()) :]
    if not solids:
        return
    around = Discs(*np.array([disc_around(solid) for solid in solids]).T)
    for solid_of, robot_of in overlapping(around, robots):
        for number in sorted(set(solid_of.tolist())):
            near, solid = np.sort(robot_of[solid_of == number]), solids[number]
            room_m = distance_from_m(solid, robots.x_m[near], robots.y_m[near])
            inside = room_m < robots.radius_m[near] - TOLERANCE_M
            for robot in near[inside & there[near] if is_pushable(solid) else inside]:
                yield int(robot), f"robot {ids[robot]!r} overlaps {_named(solid)}"


def _together(one: Solid, other: Solid) -> bool:
    """Return whether solids are parts of the same object."""
    if isinstance(one, Wall) or isinstance(other, Wall):
        return False
    return bool(one.part_of) and one.part_of == other.part_of


def _named(solid: Solid) -> str:
    return f"{type(solid).__name__.lower()} {solid.id!r}"


def disc_around(solid: Solid) -> tuple[float, float, float]:
    """Return x, y and radius [m] of a disc that covers a solid."""
    if isinstance(solid, Wall):
        x_m, y_m = (solid.x1_m + solid.x2_m) / 2, (solid.y1_m + solid.y2_m) / 2
        length_m = exact.hypot(solid.x2_m - solid.x1_m, solid.y2_m - solid.y1_m)
        return x_m, y_m, (length_m + solid.thickness_m) / 2
    x_m, y_m = solid.pose.x_m, solid.pose.y_m
    if isinstance(solid, Cylinder):
        return x_m, y_m, solid.radius_m
    if isinstance(solid, Box):
        return x_m, y_m, exact.hypot(solid.length_m, solid.width_m) / 2
    return x_m, y_m, max(exact.hypot(*corner) for corner in solid.corners_m)


def _overlapping(ids: list[str], robots: Discs, there: BoolArray) -> Iterator[tuple[int, str]]:
    for first, second in overlapping(robots, robots):
        before = (first < second) & there[first] & there[second]
        one, other = first[before], second[before]
        distance_m = exact.hypot(
            robots.x_m[one] - robots.x_m[other], robots.y_m[one] - robots.y_m[other]
        )
        overlap = distance_m < robots.radius_m[one] + robots.radius_m[other] - TOLERANCE_M
        for inner, outer in zip(other[overlap], one[overlap], strict=True):
            yield int(inner), f"robot {ids[inner]!r} overlaps robot {ids[outer]!r}"
