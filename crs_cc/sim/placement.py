"""Who stands where nobody can stand: robots outside the world, or inside something.

Touching is allowed; an overlap of more than `TOLERANCE_M` is not.

>>> from crs_cc.sim.model import Area, Pose, Robot, Wall, WorldModel
>>> from crs_cc.sim.robot_model import Drive, RobotModel
>>> scout = RobotModel("scout", 0.2, Drive(0.345))
>>> misplaced(WorldModel("w", Area(0, 0, 4, 4), (Wall("screen", 1, 0, 1, 4),), robots=(
...     Robot("r1", scout, Pose(2.0, 2.0)), Robot("r2", scout, Pose(1.1, 2.0)))))
[(1, "robot 'r2' stands inside wall 'screen'")]
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Final

import numpy as np
import numpy.typing as npt

from crs_cc.sim.model import Box, Solid, Wall, WorldModel
from crs_cc.sim.neighbours import CellList

FloatArray = npt.NDArray[np.float64]

TOLERANCE_M: Final = 1e-6


def misplaced(world: WorldModel) -> list[tuple[int, str]]:
    """Gives the index of each robot that stands where it cannot, and what is wrong."""
    robots = world.robots
    if not robots:
        return []
    x_m = np.array([robot.start.x_m for robot in robots])
    y_m = np.array([robot.start.y_m for robot in robots])
    radius_m = np.array([robot.model.radius_m for robot in robots])
    ids = [robot.id for robot in robots]
    return [
        *_outside(world, ids, x_m, y_m, radius_m),
        *_inside(world, ids, x_m, y_m, radius_m),
        *_overlapping(ids, x_m, y_m, radius_m),
    ]


def clearance_m(solid: Solid, x_m: FloatArray, y_m: FloatArray) -> FloatArray:
    """Gives how far points lie from a solid [m]; 0 or less inside."""
    if isinstance(solid, Wall):
        return _from_wall_m(solid, x_m, y_m)
    across_x, across_y = x_m - solid.pose.x_m, y_m - solid.pose.y_m
    if isinstance(solid, Box):
        return _from_box_m(solid, across_x, across_y)
    return np.asarray(np.hypot(across_x, across_y) - solid.radius_m)


def _from_wall_m(wall: Wall, x_m: FloatArray, y_m: FloatArray) -> FloatArray:
    along_x, along_y = wall.x2_m - wall.x1_m, wall.y2_m - wall.y1_m
    length2 = along_x * along_x + along_y * along_y
    share = ((x_m - wall.x1_m) * along_x + (y_m - wall.y1_m) * along_y) / (length2 or 1.0)
    share = np.clip(share, 0.0, 1.0)
    across_x = x_m - wall.x1_m - share * along_x
    across_y = y_m - wall.y1_m - share * along_y
    return np.asarray(np.hypot(across_x, across_y) - wall.thickness_m / 2)


def _from_box_m(box: Box, across_x: FloatArray, across_y: FloatArray) -> FloatArray:
    cos, sin = math.cos(box.pose.heading_rad), math.sin(box.pose.heading_rad)
    beyond_x = np.abs(cos * across_x + sin * across_y) - box.length_m / 2
    beyond_y = np.abs(cos * across_y - sin * across_x) - box.width_m / 2
    outside = np.hypot(np.maximum(beyond_x, 0.0), np.maximum(beyond_y, 0.0))
    return np.asarray(outside + np.minimum(np.maximum(beyond_x, beyond_y), 0.0))


def _outside(
    world: WorldModel, ids: list[str], x_m: FloatArray, y_m: FloatArray, radius_m: FloatArray
) -> Iterator[tuple[int, str]]:
    area, reach_m = world.area, radius_m - TOLERANCE_M
    inside = (x_m - reach_m >= area.x_min_m) & (x_m + reach_m <= area.x_max_m)
    inside &= (y_m - reach_m >= area.y_min_m) & (y_m + reach_m <= area.y_max_m)
    for robot in np.flatnonzero(~inside):
        yield int(robot), f"robot {ids[robot]!r} stands outside the world or in its edge"


def _inside(
    world: WorldModel, ids: list[str], x_m: FloatArray, y_m: FloatArray, radius_m: FloatArray
) -> Iterator[tuple[int, str]]:
    solids: tuple[Solid, ...] = (*world.walls, *world.boxes, *world.cylinders)
    for solid in solids:
        kind = type(solid).__name__.lower()
        for robot in np.flatnonzero(clearance_m(solid, x_m, y_m) < radius_m - TOLERANCE_M):
            yield int(robot), f"robot {ids[robot]!r} stands inside {kind} {solid.id!r}"


def _overlapping(
    ids: list[str], x_m: FloatArray, y_m: FloatArray, radius_m: FloatArray
) -> Iterator[tuple[int, str]]:
    reach_m = 2 * float(radius_m.max())
    first, second = CellList(x_m, y_m, reach_m).near(x_m, y_m)
    first, second = first[first < second], second[first < second]
    distance_m = np.hypot(x_m[first] - x_m[second], y_m[first] - y_m[second])
    overlap = distance_m < radius_m[first] + radius_m[second] - TOLERANCE_M
    for robot, other in zip(second[overlap], first[overlap], strict=True):
        yield int(robot), f"robot {ids[robot]!r} stands inside robot {ids[other]!r}"
