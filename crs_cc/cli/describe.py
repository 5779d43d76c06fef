"""The contents of a world file, a robot definition or an included file, in a few lines."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import fields
from pathlib import Path
from typing import Final

from crs_cc.sim.devices.bumper.element import switches_of
from crs_cc.sim.devices.sonar.model import sonars_of
from crs_cc.sim.files.world_xml import Definitions
from crs_cc.sim.model.communication import PREDEFINED, Channel, Communication
from crs_cc.sim.model.degradation import Degradation, described
from crs_cc.sim.model.fields import MAX_AMOUNT, Field
from crs_cc.sim.model.foraging import Source
from crs_cc.sim.model.goals import Goal
from crs_cc.sim.model.registry import device
from crs_cc.sim.model.robot import RobotModel
from crs_cc.sim.model.world import Robot, WorldModel, is_pushable

_MAX_LISTED: Final = 10


def describe(what: WorldModel | RobotModel | Definitions) -> list[str]:
    """Return lines that describe the contents."""
    if isinstance(what, WorldModel):
        return list(_world(what))
    if isinstance(what, RobotModel):
        return [f"robot '{what.name}': {', '.join(_parts(what))}"]
    materials, objects = ", ".join(what.materials) or "none", ", ".join(what.objects) or "none"
    return [f"materials: {materials}", f"objects: {objects}"]


def counted(number: int, noun: str, plural: str = "") -> str:
    """Return a count with its noun.

    >>> counted(1, "wall"), counted(2, "box", "boxes")
    ('1 wall', '2 boxes')
    """
    return f"{number} {noun if number == 1 else plural or f'{noun}s'}"


def _world(world: WorldModel) -> Iterator[str]:
    area = world.area
    line = f"world '{world.name}': {area.length_m:g} m x {area.width_m:g} m"
    line += f", timestep {world.timestep_s * 1000:g} ms"
    if world.duration_s is not None:
        line += f", duration {world.duration_s:g} s"
    if world.seed is not None:
        line += f", seed {world.seed}"
    yield line
    yield from _objects(world)
    yield from _communication(world.communication)
    for robot in world.robots[:_MAX_LISTED]:
        yield _robot(robot)
    if len(world.robots) > _MAX_LISTED:
        yield f"... and {counted(len(world.robots) - _MAX_LISTED, 'more robot')}"
    for goal in world.goals:
        yield _goal(goal)
    for degradation in world.degradations[:_MAX_LISTED]:
        yield _degradation(degradation, world)
    if len(world.degradations) > _MAX_LISTED:
        yield f"... and {counted(len(world.degradations) - _MAX_LISTED, 'more degradation')}"


def _objects(world: WorldModel) -> Iterator[str]:
    described = [
        counted(len(found), noun, plural)
        for found, noun, plural in (
            (world.walls, "wall", ""), (world.boxes, "box", "boxes"),
            (world.cylinders, "cylinder", ""), (world.polygons, "polygon", ""),
        )
        if found
    ]  # fmt: skip
    if described:
        solids = world.solids()
        pushable = sum(map(is_pushable, solids))
        hot = sum(solid.heat > 0.0 for solid in solids)
        notes = [f"{pushable} to be pushed"] if pushable else []
        notes += [f"{hot} hot"] if hot else []
        yield ", ".join(described) + (f" ({', '.join(notes)})" if notes else "")
    if world.surface.heightmap is not None:
        yield "ground from a picture"
    if world.surface.patches:
        yield counted(len(world.surface.patches), "ramp or plateau", "ramps and plateaus")
    more = (world.lights, "light"), (world.sounds, "sound"), (world.degradations, "degradation")
    counts = [counted(len(found), noun) for found, noun in more if found]
    if counts:
        yield ", ".join(counts)
    for source in world.sources:
        yield f"source '{source.id}': {_items(source)}"
    if world.nests:
        yield counted(len(world.nests), "nest")
    for field in world.fields:
        yield f"field '{field.name}': {', '.join(_field(field))}"


def _items(source: Source) -> str:
    if source.items is None:
        return "unlimited items"
    again = f", a new one in {source.refill_s:g} s" if math.isfinite(source.refill_s) else ""
    return counted(source.items, "item") + again


def _field(field: Field) -> Iterator[str]:
    yield f"cells of {100 * field.cell_m:g} cm"
    if math.isfinite(field.evaporation_s):
        yield f"evaporates in {field.evaporation_s:g} s"
    if field.diffusion_m2ps:
        yield f"diffuses by {1e4 * field.diffusion_m2ps:g} cm2/s"
    if field.saturation < MAX_AMOUNT:
        yield f"saturated at {field.saturation:g}"


def _communication(communication: Communication) -> Iterator[str]:
    """Yield a line for each channel that the world file adds or changes, and one for outages."""
    for channel in communication.channels:
        if channel not in PREDEFINED:
            yield f"channel '{channel.name}': {', '.join(_properties(channel))}"
    if communication.shuts:
        yield counted(len(communication.shuts), "outage")


def _properties(channel: Channel) -> Iterator[str]:
    reach = "unlimited range" if math.isinf(channel.range_m) else f"range {channel.range_m:g} m"
    if channel.walls == 0.0:
        reach += " in line of sight"
    elif channel.walls < 1.0:
        reach += f" times {channel.walls:g} for each object in between"
    yield reach
    if math.isfinite(channel.bandwidth_bps):
        yield f"{channel.bandwidth_bps:g} B/s"
    if channel.delay_s or channel.jitter_s:
        varies = f" to {(channel.delay_s + channel.jitter_s) * 1000:g}" if channel.jitter_s else ""
        yield f"delay {channel.delay_s * 1000:g}{varies} ms"
    if channel.loss:
        yield f"loss {100 * channel.loss:g}%"
    if channel.burst_begin:
        yield "bursts of losses"
    if channel.corruption:
        yield f"corruption {100 * channel.corruption:g}% of bytes"


def _robot(robot: Robot) -> str:
    start = robot.start
    line = f"robot '{robot.id}': {robot.model.name} at x = {start.x_m:g} m, y = {start.y_m:g} m"
    line += f", {math.degrees(start.heading_rad):g} degrees"
    if robot.program:
        arguments = "".join(f" {argument}" for argument in robot.arguments)
        line += f", runs {Path(robot.program).name}{arguments}"
    if robot.join_s:
        line += f", joins at {robot.join_s:g} s"
    if math.isfinite(robot.leave_s):
        line += f", leaves at {robot.leave_s:g} s"
    return line


def _goal(goal: Goal) -> str:
    kind = re.sub("(?<=[a-z])(?=[A-Z])", "-", type(goal.condition).__name__).lower()
    line = (
        f"goal '{goal.title}': {kind}, {goal.points:g} {'point' if goal.points == 1 else 'points'}"
    )
    if goal.robots:
        line += f", of {', '.join(goal.robots)}"
    if goal.after:
        line += f", after '{goal.after}'"
    if goal.until:
        line += f", until '{goal.until}'"
    if math.isfinite(goal.within_s):
        line += f", within {goal.within_s:g} s"
    return line


def _degradation(degradation: Degradation, world: WorldModel) -> str:
    model = next(robot.model for robot in world.robots if robot.id == degradation.robot)
    line = f"degradation '{degradation.id}' of '{degradation.robot}': "
    line += f"{described(degradation, model)}, from {degradation.onset_s:g} s on"
    if degradation.duration_s is not None:
        line += f" for {degradation.duration_s:g} s"
    return line


def _parts(model: RobotModel) -> Iterator[str]:
    yield f"radius {model.radius_m:g} m, {model.mass_kg:g} kg"
    yield f"{'synchro' if model.drive.steering else 'differential'} drive"
    if sonars := sonars_of(model).sonars:
        yield counted(len(sonars), "sonar")
    if switches := switches_of(model):
        yield counted(len(switches), "bumper switch", "bumper switches")
    for field in fields(model):  # a device that a robot may lack is None there
        if field.default is None and getattr(model, field.name) is not None:
            yield field.name.replace("_", " ")
    for name, _ in model.devices:
        element = device(name).element
        if element and name not in {"sonar", "bumper"}:
            yield element.replace("-", " ")
