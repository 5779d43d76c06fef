"""Writes worlds as XML: what `world_xml` reads, with equal values.

>>> from crs_cc.sim.files.world_xml import empty_world, parse_world
>>> world = empty_world()
>>> parse_world(world_text(world), "empty") == world
True
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Iterator
from dataclasses import fields
from pathlib import Path
from typing import Final

from crs_cc.core.quantity import BRIGHTNESS, DATA_RATE, LENGTH, LOUDNESS, RATIO, TIME
from crs_cc.sim.files.document import Element
from crs_cc.sim.files.field_elements import field_element
from crs_cc.sim.files.foraging_elements import place_element
from crs_cc.sim.files.goal_writer import goal_element
from crs_cc.sim.files.known_robots import SCOUT, known_robots
from crs_cc.sim.files.solid_writer import hot, pose, solid_elements, surface
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.files.xml_document import document_of
from crs_cc.sim.model.beacons import Light, Sound
from crs_cc.sim.model.communication import (
    PLAIN_COMMUNICATION,
    PREDEFINED,
    Channel,
    Communication,
)
from crs_cc.sim.model.degradation import HOLD, Degradation, degradables
from crs_cc.sim.model.ground import Ground, HeightMap, Patch
from crs_cc.sim.model.robot import RobotModel
from crs_cc.sim.model.world import Area, Robot, WorldModel

_HINT: Final = "write_robot writes it to a definition file"


def world_text(world: WorldModel, folder: Path | None = None) -> bytes:
    """Return a world as the text of a world file.

    Args:
        world: the world.
        folder: the folder where the file will be: programs and robot definitions must be there
            or below. None for a text without files of its own.

    Raises:
        ValueError: something in the world cannot be written.
        WorldError: the world is invalid; all errors are reported at once.
    """
    text = document_of(world_element(world, folder))
    again = parse_world(text, world.name, folder=folder)
    if again != world:
        raise ValueError(f"the world cannot be written: {_difference(world, again)}")
    return text


def world_element(world: WorldModel, folder: Path | None = None) -> Element:
    """Return the element of a world, see `world_text`; it is not checked.

    Raises:
        ValueError: something in the world cannot be written.
    """
    attributes = {"version": "1", "name": world.name, "timestep": TIME.exact(world.timestep_s)}
    if world.duration_s is not None:
        attributes["duration"] = TIME.exact(world.duration_s)
    if world.seed is not None:
        attributes["seed"] = str(world.seed)
    children = [
        _area(world.area),
        *_ground(world.surface),
        *solid_elements(world),
        *(robot_element(robot, folder) for robot in world.robots),
        *map(beacon_element, world.lights),
        *map(beacon_element, world.sounds),
        *(_degradation(each, world) for each in world.degradations),
        *_communication(world),
        *map(goal_element, world.goals),
        *map(field_element, world.fields),
        *map(place_element, world.sources),
        *map(place_element, world.nests),
    ]
    return Element("world", 0, attributes, children=children)


def beacon_element(beacon: Light | Sound) -> Element:
    """Return the element of a light or a sound."""
    place = {"id": beacon.id, "x": LENGTH.exact(beacon.x_m), "y": LENGTH.exact(beacon.y_m)}
    if isinstance(beacon, Light):
        return Element("light", 0, {**place, "brightness": BRIGHTNESS.exact(beacon.brightness)})
    own = {"level": LOUDNESS.exact(beacon.level), "tone": str(beacon.tone)}
    return Element("sound", 0, {**place, **own})


def _difference(world: WorldModel, again: WorldModel) -> str:
    """Return the parts that would not be read back unchanged."""
    for robot, other in zip(world.robots, again.robots, strict=False):
        if robot.model != other.model:
            name = robot.model.definition or SCOUT
            return f"the model of {robot.id!r} is not that of its definition {name!r} ({_HINT})"
    for field in fields(WorldModel):
        if getattr(world, field.name) != getattr(again, field.name):
            return f"its {field.name} would be read differently"
    return ""


# -- area and ground -------------------------------------------------------------------------------


def _area(area: Area) -> Element:
    attributes = {"length": LENGTH.exact(area.length_m), "width": LENGTH.exact(area.width_m)}
    if area.x_min_m or area.y_min_m:
        attributes["origin"] = "centre"
    attributes["edge"] = LENGTH.exact(area.edge_m)
    return Element("area", 0, attributes | surface(area.material))


def _ground(ground: Ground) -> Iterator[Element]:
    if ground.is_flat:
        return
    maps = [] if ground.heightmap is None else [_heightmap(ground.heightmap)]
    yield Element("surface", 0, children=[*maps, *map(_patch, ground.patches)])


def _patch(patch: Patch) -> Element:
    names = ("x", "y", "length", "width")
    attributes = {name: LENGTH.exact(getattr(patch, f"{name}_m")) for name in names}
    if patch.heading_rad:
        attributes["heading"] = f"{float(patch.heading_rad)!r}rad"
    if patch.from_m == patch.to_m:
        return Element("plateau", 0, {**attributes, "height": LENGTH.exact(patch.to_m)})
    ends = {"from": LENGTH.exact(patch.from_m), "to": LENGTH.exact(patch.to_m)}
    return Element("ramp", 0, attributes | ends)


def _heightmap(table: HeightMap) -> Element:
    rows = [
        table.heights_m[first : first + table.columns]
        for first in range(0, len(table.heights_m), table.columns)
    ]
    heights = " ".join(f"{float(height)!r}" for row in reversed(rows) for height in row)
    place = {"x": LENGTH.exact(table.x_m), "y": LENGTH.exact(table.y_m)}
    size = {"resolution": LENGTH.exact(table.pixel_m), "columns": str(table.columns)}
    return Element("heightmap", 0, {**place, **size, "heights": heights})


# -- robots ----------------------------------------------------------------------------------------


def robot_element(robot: Robot, folder: Path | None) -> Element:
    """Return the element of a robot, see `world_text`.

    Raises:
        ValueError: its definition or its program is not in the folder.
    """
    attributes = {"id": robot.id, **_model(robot.model, folder), **pose(robot.start), **hot(robot)}
    attributes |= surface(robot.material)
    if robot.join_s:
        attributes["join"] = TIME.exact(robot.join_s)
    if math.isfinite(robot.leave_s):
        attributes["leave"] = TIME.exact(robot.leave_s)
    if robot.program:
        attributes["program"] = _relative(robot.program, folder)
    if robot.dialect is not None:
        attributes["dialect"] = robot.dialect
    arguments = [Element("argument", 0, text=text) for text in robot.arguments]
    return Element("robot", 0, attributes, children=arguments)


def _model(model: RobotModel, folder: Path | None) -> dict[str, str]:
    definition = model.definition or model.name
    if definition not in known_robots():
        if not model.definition:
            names = ", ".join(known_robots())
            raise ValueError(
                f"the robot model {model.name!r} is from no definition: {_HINT} (built in: {names})"
            )
        definition = _relative(definition, folder)
    found = {} if definition == SCOUT else {"definition": definition}
    return {**found, "setup": model.setup} if model.setup else found


def _relative(name: str, folder: Path | None) -> str:
    """Return the path of a file from the folder of the world file."""
    if folder is None:
        return name
    path = os.path.relpath(Path(name).resolve(), folder.resolve())
    if path.startswith(os.pardir):
        raise ValueError(f"{name!r} is not in the folder of the world file ({folder}) or below")
    return Path(path).as_posix()


# -- faults and communication ----------------------------------------------------------------------


def _degradation(each: Degradation, world: WorldModel) -> Element:
    device = degradables()[each.device]
    model = next(robot.model for robot in world.robots if robot.id == each.robot)
    kind = device.kind_of((device.elements(model) or ("",))[each.element or 0])
    usual = Degradation(each.robot, each.device)
    attributes = {"id": each.id, "robot": each.robot, "device": each.device}
    if each.element is not None:
        attributes["element"] = str(each.element)
    units = {
        "bias": kind, "gain": RATIO, "noise": kind, "step": kind, "stuck": kind, "delay_s": TIME,
        "dropouts": RATIO, "onset_s": TIME, "duration_s": TIME, "recovery_s": TIME,
    }  # fmt: skip
    for name, unit in units.items():
        value = getattr(each, name)
        if value != getattr(usual, name):
            text = HOLD if value == HOLD else unit.exact(value)
            attributes[name.removesuffix("_s")] = text
    if each.dead:
        attributes["dead"] = "yes"
    return Element("degradation", 0, attributes)


def fault_elements(
    world: WorldModel,
    degradations: Iterable[Degradation],
    outages: Iterable[tuple[float, float, str, str, str]],
) -> list[Element]:
    """Return degradations and outages as the elements of a world file.

    Args:
        world: has the robots.
        degradations: faults of its devices.
        outages: begin and end [s], channel, sender and receiver, as of `CommunicationControl`.
    """
    shuts = [_shut(*each) for each in outages]
    communication = [Element("communication", 0, children=shuts)] if shuts else []
    return [*(_degradation(each, world) for each in degradations), *communication]


def _communication(world: WorldModel) -> Iterator[Element]:
    own: Communication = world.communication
    usual = {channel.name: channel for channel in PREDEFINED}
    children = [
        _channel(channel, usual.get(channel.name, Channel(channel.name)))
        for channel in own.channels
        if usual.get(channel.name) != channel
    ]
    robots = [robot.id for robot in world.robots]
    channels = [channel.name for channel in own.channels]
    names, robot_names = (*channels, ""), (*robots, "")  # the last is `ANY`
    for each in own.shuts:
        link = names[each.channel], robot_names[each.sender], robot_names[each.receiver]
        children.append(_shut(each.at_s, each.until_s, *link))
    attributes = {}
    if own.network_latency_s != PLAIN_COMMUNICATION.network_latency_s:
        attributes["network-latency"] = TIME.exact(own.network_latency_s)
    if children or attributes:
        yield Element("communication", 0, attributes, children=children)


def _shut(at_s: float, until_s: float, channel: str, sender: str, receiver: str) -> Element:
    attributes = {"at": TIME.exact(at_s)}
    if math.isfinite(until_s):
        attributes["until"] = TIME.exact(until_s)
    link = {"channel": channel, "from": sender, "to": receiver}
    return Element("shut", 0, attributes | {name: text for name, text in link.items() if text})


_CHANNEL_UNITS: Final = {
    "range_m": LENGTH, "walls": RATIO, "delay_s": TIME, "jitter_s": TIME,
    "bandwidth_bps": DATA_RATE, "loss": RATIO, "burst_begin": RATIO, "burst_end": RATIO,
    "burst_loss": RATIO, "corruption": RATIO,
}  # fmt: skip


def _channel(channel: Channel, usual: Channel) -> Element:
    attributes = {"name": channel.name}
    for name, unit in _CHANNEL_UNITS.items():
        value = getattr(channel, name)
        if value != getattr(usual, name) and math.isfinite(value):
            word = name.removesuffix("_m").removesuffix("_bps").removesuffix("_s")
            attributes[word.replace("_", "-")] = unit.exact(value)
    if channel.queue != usual.queue:
        attributes["queue"] = str(channel.queue)
    if channel.drops_oldest != usual.drops_oldest:
        attributes["drop"] = "oldest" if channel.drops_oldest else "newest"
    return Element("channel", 0, attributes)
