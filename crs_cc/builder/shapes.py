"""The shapes of a world's elements from above, as JSON for the page of the builder.

A shape is a polygon (`points`), a disc (`x`, `y`, `radius`) or a wall (`points` and `thickness`);
lengths are in metres. Those of an object made of parts have the name of their `part`. Warm ones
have their `heat` and how far it `spread`s.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, TypeAlias

from crs_cc.builder.addresses import address, ids
from crs_cc.builder.document import Document
from crs_cc.builder.extents import element_of, patches
from crs_cc.plot.goal_layer import places
from crs_cc.sim.engine.robot_colours import colour as robot_colour
from crs_cc.sim.geometry.scene import corners_m
from crs_cc.sim.model.colours import hexadecimal
from crs_cc.sim.model.goals import Goal, Visit
from crs_cc.sim.model.world import (
    PLAIN,
    Box,
    Cylinder,
    Polygon,
    Pose,
    Robot,
    Solid,
    Wall,
    WorldModel,
    is_pushable,
)

Shape: TypeAlias = dict[str, Any]


def shapes(document: Document, world: WorldModel) -> dict[str, list[Shape]]:
    """Return the shapes of all elements that have one, by their names."""
    known = ids(document.root)
    found: dict[str, list[Shape]] = {}
    found.update(_heightmap(document, world))
    for name, patch in patches(document, world):
        pose = Pose(patch.x_m, patch.y_m, patch.heading_rad)
        ground = {"kind": "ground", "points": _corners(pose, patch.length_m, patch.width_m)}
        found[name] = [ground | {"from": patch.from_m, "to": patch.to_m}]
    for solid in world.solids()[len(world.edge_walls()) :]:
        name = element_of(solid.id, known)
        shape = _solid(solid)
        if name != solid.id:
            shape["part"] = solid.id[len(name) + 1 :]
        found.setdefault(name, []).append(shape)
    for goal in world.goals:
        found[goal.id] = list(_places(goal))
    for number, robot in enumerate(world.robots):
        name = element_of(robot.id, known)
        shape = _robot(robot) | {"colour": robot_colour(number)}
        if name != robot.id:
            shape["part"] = robot.id[len(name) + 1 :]
        found.setdefault(name, []).append(shape)
    found.update(_discs(world))
    found.update(_ranges(document, world))
    return found


def _discs(world: WorldModel) -> Iterator[tuple[str, list[Shape]]]:
    """Yield the lights and sounds, which have no size, and the sources and nests."""
    for light in world.lights:
        yield light.id, [{"kind": "light", "x": light.x_m, "y": light.y_m, "radius": 0.1}]
    for sound in world.sounds:
        yield sound.id, [{"kind": "sound", "x": sound.x_m, "y": sound.y_m, "radius": 0.1}]
    for kind, discs in (("source", world.sources), ("nest", world.nests)):
        for disc in discs:
            place = {"x": disc.x_m, "y": disc.y_m, "radius": disc.radius_m}
            yield disc.id, [{"kind": kind, **place}]


def _heightmap(document: Document, world: WorldModel) -> Iterator[tuple[str, list[Shape]]]:
    """Yield the ground's map of heights, whose rows are from the top as in the file."""
    chart = world.surface.heightmap
    for node in document.root.all():
        if node.tag != "heightmap" or chart is None:
            continue
        size = chart.columns
        rows = [
            [round(value, 4) for value in chart.heights_m[start : start + size]]
            for start in range(0, len(chart.heights_m), size)
        ]
        right_m = chart.x_m + size * chart.pixel_m
        top_m = chart.y_m + len(rows) * chart.pixel_m
        shape = {"kind": "heights", "pixel": chart.pixel_m, "rows": rows[::-1]}
        corners = [[chart.x_m, chart.y_m], [right_m, chart.y_m], [right_m, top_m]]
        yield address(node), [{**shape, "points": [*corners, [chart.x_m, top_m]]}]


def _ranges(document: Document, world: WorldModel) -> Iterator[tuple[str, list[Shape]]]:
    """Yield the range of each channel of the file, around each robot."""
    known = {channel.name: channel for channel in world.communication.channels}
    for node in document.root.all():
        channel = known.get(node.attributes.get("name", "")) if node.tag == "channel" else None
        if channel is None or not math.isfinite(channel.range_m):
            continue
        discs = [
            {"kind": "range", "x": place.x_m, "y": place.y_m, "radius": channel.range_m}
            for place in (robot.start for robot in world.robots)
        ]
        yield address(node), discs


def _solid(solid: Solid) -> Shape:
    style: Shape = {"kind": "movable" if is_pushable(solid) else "solid", **_warmth(solid)}
    if solid.material.colour != PLAIN.colour:
        style["colour"] = hexadecimal(solid.material.colour)
    if isinstance(solid, Wall):
        ends = [[solid.x1_m, solid.y1_m], [solid.x2_m, solid.y2_m]]
        return {**style, "kind": "wall", "points": ends, "thickness": solid.thickness_m}
    if isinstance(solid, Cylinder):
        return {**style, "x": solid.pose.x_m, "y": solid.pose.y_m, "radius": solid.radius_m}
    if isinstance(solid, Box):
        return {**style, "points": _corners(solid.pose, solid.length_m, solid.width_m)}
    return {**style, "points": _polygon(solid)}


def _polygon(solid: Polygon) -> list[list[float]]:
    return [[float(x), float(y)] for x, y in corners_m(solid).tolist()]


def _corners(pose: Pose, length_m: float, width_m: float) -> list[list[float]]:
    cos, sin = math.cos(pose.heading_rad), math.sin(pose.heading_rad)
    return [
        [pose.x_m + cos * x - sin * y, pose.y_m + sin * x + cos * y]
        for x, y in (
            (length_m / 2, width_m / 2), (-length_m / 2, width_m / 2),
            (-length_m / 2, -width_m / 2), (length_m / 2, -width_m / 2),
        )
    ]  # fmt: skip


def _robot(robot: Robot) -> Shape:
    place = {"x": robot.start.x_m, "y": robot.start.y_m, "heading": robot.start.heading_rad}
    return {"kind": "robot", **place, "radius": robot.model.radius_m, **_warmth(robot)}


def _warmth(obj: Solid | Robot) -> Shape:
    """Return the heat of an object and its spread, if it has any."""
    if obj.heat <= 0:
        return {}
    spread_m = obj.spread_m if math.isfinite(obj.spread_m) else None
    return {"heat": obj.heat, "spread": spread_m}


def _places(goal: Goal) -> Iterator[Shape]:
    """Yield the places of a goal, each with the name of its element within the goal's."""
    found = list(places(goal))
    if isinstance(goal.condition, Visit):
        names = [f"visit/place[{number}]" for number in range(len(found))]
        names = ["visit/place"] if len(found) == 1 else names
    else:
        names = [type(goal.condition).__name__.lower()]
    for place, name in zip(found, names, strict=False):
        shape = {"kind": "goal", "x": place.x_m, "y": place.y_m, "radius": place.radius_m}
        yield {**shape, "element": name}
