"""A world as JSON for the page: its objects, its ground, its types of robots."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Final

from crs_cc.plot.beacons import NEST_PAINT, SOURCE_PAINT
from crs_cc.recording.shapes import area_data, robot_data, shape_data
from crs_cc.sim.devices.bumper.element import switches_of
from crs_cc.sim.devices.infrared import FARTHEST
from crs_cc.sim.devices.sonar.model import sonars_of
from crs_cc.sim.model.world import is_pushable

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.sim.model.ground import Ground
    from crs_cc.sim.model.robot import RobotModel
    from crs_cc.sim.model.world import WorldModel

_SLENDERNESS: Final = 0.35 / (8 * 0.0254)
"""How high robots are drawn whose height is not known, relative to their radius: as a Scout."""

_MAX_HEIGHTS: Final = 300
"""Columns or rows of a height map that are sent at most; a finer one is thinned."""


def world_data(world: WorldModel, names: Sequence[str]) -> dict[str, Any]:
    """Return a world; of robots those that are named, in this order."""
    kinds: dict[str, RobotModel] = {}
    known = {robot.id: robot for robot in world.robots}
    robots = robot_data(world, names)
    for each in robots:
        robot = known.get(each["id"])
        if robot is not None:
            kinds.setdefault(robot.model.name, robot.model)
            start = robot.start
            each["kind"] = robot.model.name
            each["start"] = [start.x_m, start.y_m, start.heading_rad]
            each["heat"] = robot.heat
    shapes = shape_data(world)
    for shape, solid in zip(shapes, world.solids(), strict=True):
        shape["heat"] = solid.heat
        shape["spread"] = solid.spread_m if math.isfinite(solid.spread_m) else None
        shape["movable"] = is_pushable(solid)
    return {
        "name": world.name,
        "area": area_data(world),
        "shapes": shapes,
        "robots": robots,
        "kinds": {name: _kind(model) for name, model in kinds.items()},
        "lights": [
            {"id": each.id, "x": each.x_m, "y": each.y_m, "brightness": each.brightness}
            for each in world.lights
        ],
        "fields": [each.name for each in world.fields],
        "places": [
            {"id": each.id, "x": each.x_m, "y": each.y_m, "radius": each.radius_m, "colour": colour}
            for places, colour in ((world.sources, SOURCE_PAINT), (world.nests, NEST_PAINT))
            for each in places
        ],
        "ground": _ground(world.surface),
        "channels": [
            {"name": each.name, "range": each.range_m}
            for each in world.communication.channels
            if math.isfinite(each.range_m)
        ],
    }


def _height_m(model: RobotModel) -> float:
    """Return the drawn height of a robot."""
    is_known = math.isfinite(model.height_m)
    return model.height_m if is_known else _SLENDERNESS * model.radius_m


def _kind(model: RobotModel) -> dict[str, Any]:
    """Return a kind of robot: its body, wheels, sonars and bumpers."""
    drive = model.drive
    return {
        "radius": model.radius_m,
        "height": _height_m(model),
        "wheel_base": drive.wheel_base_m,
        "steers": drive.steering is not None,
        "turret": drive.turret is not None,
        **_limbs(model),
        "devices": [name for name, _ in model.devices],
        "sonars": [
            {
                "x": each.x_m,
                "y": each.y_m,
                "direction": each.direction_rad,
                "half_angle": each.half_angle_rad,
                "range": each.range_m,
            }
            for each in sonars_of(model).modes[0].sonars
        ],
        "bumpers": [
            {"bit": each.bit, "bearing": each.bearing_rad, "span": each.span_rad}
            for each in switches_of(model)
        ],
    }


def _limbs(model: RobotModel) -> dict[str, Any]:
    """Return gripper, arm and sensors of a kind of robot, null for those that it lacks."""
    gripper, arm, laser = (model.device(name) for name in ("gripper", "arm", "laser"))
    camera, infrared, heat = (model.device(name) for name in ("camera", "infrared", "heat"))
    return {
        "camera": camera
        and {
            "x": camera.x_m,
            "y": camera.y_m,
            "z": camera.z_m,
            "direction": camera.direction_rad,
            "fov": camera.field_of_view_rad,
            "range": camera.range_m,
        },
        "infrared": infrared and {"step": infrared.step_m, "z": infrared.z_m, "farthest": FARTHEST},
        "heat": heat and heat.range_m,
        "gripper": gripper
        and {"place": gripper.place_m, "reach": gripper.reach_m, "opening": gripper.opening_m},
        "arm": arm and {"x": arm.x_m, "y": arm.y_m, "upper": arm.upper_m, "fore": arm.fore_m},
        "laser": laser
        and {
            "forward": laser.forward_m,
            "fov": laser.field_of_view_rad,
            "range": laser.range_m,
            "z": laser.z_m,
        },
    }


def _ground(ground: Ground) -> dict[str, Any]:
    """Return the ramps and plateaus, and the height map."""
    patches = [
        {
            "x": each.x_m,
            "y": each.y_m,
            "heading": each.heading_rad,
            "length": each.length_m,
            "width": each.width_m,
            "from": each.from_m,
            "to": each.to_m,
        }
        for each in ground.patches
    ]
    chart = ground.heightmap
    if chart is None:
        return {"patches": patches, "map": None}
    columns, rows = chart.columns, len(chart.heights_m) // chart.columns
    step = max(1, -(-max(columns, rows) // _MAX_HEIGHTS))
    heights = [
        [round(chart.heights_m[row * columns + column], 4) for column in range(0, columns, step)]
        for row in range(0, rows, step)
    ]
    half_m = chart.pixel_m / 2  # heights are those of the pixels' centres
    return {
        "patches": patches,
        "map": {
            "x": chart.x_m + half_m,
            "y": chart.y_m + half_m,
            "pixel": chart.pixel_m * step,
            "heights": heights,
        },
    }
