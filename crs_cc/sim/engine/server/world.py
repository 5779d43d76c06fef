"""Obstacles that programs add and remove: `add_obstacle` and related functions.

Every program may change the world that all robots share. Such a request returns at the end of the
timestep: so the world is rebuilt a few times in a timestep at most.

Chosen by us, as the vendor's header is silent: a polygon is refused whose sides meet, or that would
lie on a robot, or that would be one too many (`MAX_OWN`, `MAX_ALL`). Programs may also
remove and move fixed boxes and polygons of the world file, which they identify by their corners,
starting with any of them. `new_world` removes everything but the edge of the world and the robots.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, Int64Array
from crs_cc.core.quantity import LENGTH
from crs_cc.core.units import m_to_tenths_inch, tenths_inch_to_m
from crs_cc.sim.geometry.placement import TOLERANCE_M, distance_from_m
from crs_cc.sim.geometry.scene import corners_m
from crs_cc.sim.model.polygon import area_m2, validation_error
from crs_cc.sim.model.world import Box, Polygon, Solid, is_pushable
from crs_cc.sim.state.obstacles import (
    MAX_VERTICES,
    Corners,
    ObstacleState,
    polygon_of,
    world_objects,
)

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


MAX_OWN: Final = 100
"""Maximum number of polygons of one robot's program in the world."""

MAX_ALL: Final = 500
"""Maximum number of polygons of all programs together."""

_FURTHEST: Final = int(m_to_tenths_inch(LENGTH.limit))


def add_obstacle(context: RequestContext) -> BoolArray:
    """Answer ADD_OBSTACLE: add a polygon."""
    good = [
        _add(context.state, context.constants, robot, corners)
        for robot, corners in zip(context.rows.tolist(), _polygons(context), strict=True)
    ]
    return np.array(good, dtype=np.bool_)


def delete_obstacle(context: RequestContext) -> BoolArray:
    """Answer DELETE_OBSTACLE: remove the polygon with these corners."""
    state = context.state
    good = np.zeros(len(context), dtype=np.bool_)
    for row, corners in enumerate(_polygons(context)):
        place = _find(state.obstacles, context.constants, corners)
        if place is not None:
            state.obstacles, good[row] = _without(state.obstacles, place), True
    return good


def move_obstacle(context: RequestContext) -> BoolArray:
    """Answer MOVE_OBSTACLE with the new corners of the polygon with these corners.

    A polygon added by another program still belongs to it; one of the world file becomes
    the mover's.
    """
    state, constants = context.state, context.constants
    good = np.zeros(len(context), dtype=np.bool_)
    offsets = context.columns("dx", "dy").astype(np.int64)
    for row, corners in enumerate(_polygons(context)):
        before = state.obstacles
        place = _find(before, constants, corners)
        if corners is None or place is None:
            continue
        owner = int(before.owners[place]) if place >= 0 else int(context.rows[row])
        state.obstacles = _without(before, place)
        moved = corners + offsets[row]
        good[row] = _add(state, constants, owner, moved)
        if good[row]:
            content = moved.astype("<i4").reshape(-1).view(np.uint8)
            context.messages["data"][row, : len(content)] = content
        else:
            state.obstacles = before
    return good


def new_world(context: RequestContext) -> None:
    """Answer NEW_WORLD: remove everything but the edge of the world and the robots."""
    nothing = np.zeros(0, dtype=np.intp)
    left = context.state.obstacles.take(nothing)
    context.state.obstacles = replace(left, standing=np.zeros_like(left.standing))


def _polygons(context: RequestContext) -> list[Int64Array | None]:
    """Return the corners of each request, (corners, 2); None where their number is invalid."""
    content = context["vertices"]
    return [
        content[row, : 8 * count].view("<i4").reshape(-1, 2).astype(np.int64)
        if 3 <= count <= MAX_VERTICES
        else None
        for row, count in enumerate(context["count"].tolist())
    ]


def _add(
    state: EnvState, constants: RobotConstants, robot: int, corners: Int64Array | None
) -> bool:
    """Add a polygon if it is valid and its place is free."""
    obstacles = state.obstacles
    if corners is None or np.abs(corners).max() > _FURTHEST:
        return False
    if len(obstacles.sizes) >= MAX_ALL or (obstacles.owners == robot).sum() >= MAX_OWN:
        return False
    places_m = tenths_inch_to_m(corners.astype(np.float64))
    if validation_error(places_m):
        return False
    if area_m2(places_m) < 0.0:
        corners = corners[::-1]
    room_m = distance_from_m(
        polygon_of(obstacles.made, corners.astype(np.int32)), state.x_m, state.y_m
    )
    if (state.presence.present & (room_m < constants.radius_m - TOLERANCE_M)).any():
        return False
    row = np.zeros((1, MAX_VERTICES, 2), dtype=np.int32)
    row[0, : len(corners)] = corners
    state.obstacles = replace(
        obstacles,
        corners=np.concatenate([obstacles.corners, row]),
        sizes=np.append(obstacles.sizes, len(corners)),
        numbers=np.append(obstacles.numbers, obstacles.made),
        owners=np.append(obstacles.owners, robot),
        made=obstacles.made + 1,
    )
    return True


def _find(
    obstacles: ObstacleState, constants: RobotConstants, corners: Int64Array | None
) -> int | None:
    """Return the first polygon with some corners; None if there is none.

    Returns:
        the row of an added one; the inverted number (~) of one of the world file.
    """
    if corners is None:
        return None
    wanted = _in_order(corners)
    for added in np.flatnonzero(obstacles.sizes == len(corners)).tolist():
        if _in_order(obstacles.of(added)) == wanted:
            return int(added)
    objects = world_objects(constants.world)
    for number in np.flatnonzero(obstacles.standing).tolist():
        if _in_order(_tenths_inch(objects[number])) == wanted:
            return ~int(number)
    return None


def _without(obstacles: ObstacleState, place: int) -> ObstacleState:
    """Return the obstacles without the one found by `_find`."""
    if place >= 0:
        return obstacles.take(np.delete(np.arange(len(obstacles.sizes)), place))
    standing = obstacles.standing.copy()
    standing[~place] = False
    return replace(obstacles, standing=standing)


def _tenths_inch(solid: Solid) -> Corners:
    """Return the corners of a fixed box or polygon [0.1 in], none for other objects."""
    if not isinstance(solid, Box | Polygon) or is_pushable(solid):
        return np.zeros((0, 2), dtype=np.int32)
    return np.rint(m_to_tenths_inch(corners_m(solid))).astype(np.int32)


def _in_order(corners: npt.NDArray[np.integer]) -> list[tuple[int, int]]:
    """Return corners counter-clockwise, the lowest of the leftmost ones first."""
    pairs: list[tuple[int, int]] = [(int(x), int(y)) for x, y in corners]
    if not pairs:
        return pairs
    if area_m2(np.array(pairs, dtype=np.float64)) < 0.0:
        pairs.reverse()
    first = pairs.index(min(pairs))
    return pairs[first:] + pairs[:first]
