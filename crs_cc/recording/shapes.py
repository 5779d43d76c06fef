"""The objects of a world as the viewer draws them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Final

from crs_cc.sim.engine.robot_colours import colour
from crs_cc.sim.model.colours import hexadecimal
from crs_cc.sim.model.world import PLAIN, Box, Cylinder, Polygon, Solid, Wall, is_pushable

if TYPE_CHECKING:
    from crs_cc.sim.model.world import WorldModel

_MAX_HEIGHT_M: Final = 0.8
"""The drawn height of objects of unlimited height."""

_EDGE_M: Final = 0.25
"""The drawn height of the edge of the world."""

_RADIUS_M: Final = 0.2
_WALL, _FIXED, _MOVABLE = "#4a5160", "#8d95a3", "#d9b88a"


def area_data(world: WorldModel) -> dict[str, float]:
    """Return the area of a world."""
    area = world.area
    return {
        "x": area.x_min_m, "y": area.y_min_m, "length": area.length_m, "width": area.width_m
    }  # fmt: skip


def robot_data(world: WorldModel, names: Sequence[str]) -> list[dict[str, Any]]:
    """Return the robots; those that the world does not know are like its first."""
    known = {robot.id: robot.model.radius_m for robot in world.robots}
    usual_m = next(iter(known.values()), _RADIUS_M)
    return [
        {"id": name, "radius": known.get(name, usual_m), "colour": colour(number)}
        for number, name in enumerate(names)
    ]


def shape_data(world: WorldModel) -> list[dict[str, Any]]:
    """Return everything else, at its start."""
    solids: tuple[Solid, ...] = (
        *world.edge_walls(), *world.walls, *world.boxes, *world.cylinders, *world.polygons
    )  # fmt: skip
    edge = len(world.edge_walls())
    shapes = [_shape(solid) for solid in solids]
    for shape in shapes[:edge]:  # so that they do not hide objects
        shape["height"] = min(shape["height"], _EDGE_M)
    return shapes


def _shape(solid: Solid) -> dict[str, Any]:
    plain = _WALL if isinstance(solid, Wall) else _MOVABLE if is_pushable(solid) else _FIXED
    paint = solid.material.colour
    data: dict[str, Any] = {
        "id": solid.id,
        "height": min(solid.height_m, _MAX_HEIGHT_M),
        "colour": plain if paint == PLAIN.colour else hexadecimal(paint),
    }
    match solid:
        case Wall():
            along_x, along_y = solid.x2_m - solid.x1_m, solid.y2_m - solid.y1_m
            data["x"], data["y"] = (solid.x1_m + solid.x2_m) / 2, (solid.y1_m + solid.y2_m) / 2
            data["angle"] = math.atan2(along_y, along_x)
            size = math.hypot(along_x, along_y) + solid.thickness_m, solid.thickness_m
            data["corners"] = _rectangle(*size)
            return data
        case Box():
            data["corners"] = _rectangle(solid.length_m, solid.width_m)
        case Cylinder():
            data["radius"] = solid.radius_m
        case Polygon():
            data["corners"] = [list(corner) for corner in solid.corners_m]
    pose = solid.pose
    data["x"], data["y"], data["angle"] = pose.x_m, pose.y_m, pose.heading_rad
    return data


def _rectangle(length_m: float, width_m: float) -> list[list[float]]:
    x_m, y_m = length_m / 2, width_m / 2
    return [[-x_m, -y_m], [x_m, -y_m], [x_m, y_m], [-x_m, y_m]]
