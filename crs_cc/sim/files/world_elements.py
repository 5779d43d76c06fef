"""Elements of a world file."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from itertools import islice
from pathlib import Path, PurePosixPath
from typing import Final, Literal, TypeAlias

from crs_cc.core.file_names import from_text
from crs_cc.core.quantity import BRIGHTNESS, HEAT, LENGTH, LOUDNESS, TIME
from crs_cc.sim.files.communication_elements import communication
from crs_cc.sim.files.composite_elements import CompositeElements
from crs_cc.sim.files.degradation_elements import degradations
from crs_cc.sim.files.document import MAX_MESSAGES, Element, Reader
from crs_cc.sim.files.field_elements import fields_of
from crs_cc.sim.files.goal_elements import goals
from crs_cc.sim.files.ground_elements import ground
from crs_cc.sim.files.include import Included
from crs_cc.sim.files.map_elements import map_boxes
from crs_cc.sim.files.material_elements import Materials
from crs_cc.sim.files.object_ids import check_parts, name_objects
from crs_cc.sim.files.solid_elements import SHORTEST_M, SolidElements, pose, spread
from crs_cc.sim.geometry.placement import misplaced, overlapping_objects
from crs_cc.sim.model.beacons import TONES, Light, Sound
from crs_cc.sim.model.robot import RobotModel
from crs_cc.sim.model.world import Area, Box, Cylinder, Polygon, Robot, Solid, Wall, WorldModel


def lights(root: Element, reader: Reader) -> tuple[Light, ...]:
    """Return the lights of a world; errors go to the reader."""
    return tuple(
        Light(
            element.attributes["id"],
            reader.quantity(element, "x", LENGTH),
            reader.quantity(element, "y", LENGTH),
            reader.not_negative(element, "brightness", BRIGHTNESS),
        )
        for element in root.all("light")
    )


def sounds(root: Element, reader: Reader) -> tuple[Sound, ...]:
    """Return the sounds of a world; errors go to the reader."""
    return tuple(
        Sound(
            element.attributes["id"],
            reader.quantity(element, "x", LENGTH),
            reader.quantity(element, "y", LENGTH),
            reader.not_negative(element, "level", LOUDNESS),
            reader.whole(element, "tone", 0, TONES - 1),
        )
        for element in root.all("sound")
    )


SHORTEST_TIMESTEP_S: Final = 0.001
LONGEST_TIMESTEP_S: Final = 0.1
MAX_THINGS: Final = 100_000
MAX_SEED: Final = 999_999_999
_DIALECTS: Final[dict[str, Literal["nomad", "report"]]] = {"nomad": "nomad", "report": "report"}
_SIMPLE: Final = frozenset({"wall", "box", "cylinder", "polygon"})

FindModel: TypeAlias = Callable[[Element], RobotModel]
"""Returns the model of a robot; reports an error at the element if there is none."""


def world_model(
    root: Element, name: str, included: Included, reader: Reader, find_model: FindModel
) -> WorldModel:
    """Return the world that a world file describes; errors go to the reader.

    Args:
        root: the root element.
        name: the default name of the world.
        included: reads included files; it has the folder of programs and images.
        reader: reads the values.
        find_model: finds robot definitions.
    """
    if len(root.children) > MAX_THINGS:
        reader.error(root, f"more than {MAX_THINGS} objects")
        root.children = root.children[:1]
    name_objects(root.children, reader)
    definitions = included.definitions(root)
    materials = Materials((each for each in definitions if each.tag == "material"), reader)
    area = _area(root.first("area"), reader, materials)
    solids = SolidElements(reader, materials)
    composites = CompositeElements((e for e in definitions if e.tag == "define"), solids)
    objects = _objects(root, included.folder, area, solids, composites)
    robots = [
        Robot(
            element.attributes["id"],
            find_model(element),
            pose(element, reader),
            _program(element, included.folder, reader),
            tuple(argument.text for argument in element.all("argument")),
            reader.not_negative(element, "heat", HEAT),
            _DIALECTS.get(element.attributes.get("dialect", "")),
            materials.of(element),
            *_stay(element, reader),
            spread(element, reader),
        )
        for element in root.all("robot")
    ]
    world = WorldModel(
        root.attributes.get("name", name),
        area,
        robots=tuple(robots),
        timestep_s=_timestep(root, reader),
        duration_s=_duration(root, reader),
        seed=_seed(root, reader),
        surface=ground(root.first("surface"), area, included.folder, reader),
        lights=lights(root, reader),
        sounds=sounds(root, reader),
        degradations=degradations(
            root.all("degradation"), zip(root.all("robot"), robots, strict=True), reader
        ),
        communication=communication(root, [robot.id for robot in robots], reader),
    )
    world = replace(world, fields=fields_of(root, area, world.timestep_s, reader))
    world = _with(world, objects)
    world = replace(world, goals=goals(root, world, reader))
    _check(world, root, {solid.id: element for element, solid in objects}, reader)
    return world


def _objects(
    root: Element,
    folder: Path | None,
    area: Area,
    solids: SolidElements,
    composites: CompositeElements,
) -> list[tuple[Element, Solid]]:
    """Return all walls and objects, each with its element."""
    objects: list[tuple[Element, Solid]] = []
    for element in root.children:
        parts: Sequence[Solid] = ()
        if element.tag in _SIMPLE:
            parts = (solids.solid(element),)
        elif element.tag == "object":
            parts = composites.parts(element)
        elif element.tag == "map":
            parts = map_boxes(element, folder, area, solids)
        objects += [(element, part) for part in parts]
        if len(objects) > MAX_THINGS:
            solids.reader.error(element, f"more than {MAX_THINGS} objects")
            return []
    composed = [(element, part.id) for element, part in objects if element.tag not in _SIMPLE]
    check_parts(
        composed, [element.attributes.get("id", "") for element in root.children], solids.reader
    )
    return objects


def _with(world: WorldModel, objects: Sequence[tuple[Element, Solid]]) -> WorldModel:
    """Return a world with objects added, except those with invalid values."""
    solids = [solid for element, solid in objects if not element.broken]
    return replace(
        world,
        walls=tuple(solid for solid in solids if isinstance(solid, Wall)),
        boxes=tuple(solid for solid in solids if isinstance(solid, Box)),
        cylinders=tuple(solid for solid in solids if isinstance(solid, Cylinder)),
        polygons=tuple(solid for solid in solids if isinstance(solid, Polygon)),
    )


def _check(
    world: WorldModel, root: Element, objects: Mapping[str, Element], reader: Reader
) -> None:
    """Report errors that concern the whole world, as far as its values are valid.

    Args:
        world: the world.
        root: the root element.
        objects: the element of each object, by its id.
        reader: receives the errors.
    """
    if not world.robots:
        reader.error(root, "no robot in the world", "add <robot x='1m' y='1m'/>")
    if root.first("area").broken:
        return
    pairs = list(zip(root.all("robot"), world.robots, strict=True))
    readable = replace(world, robots=tuple(robot for element, robot in pairs if not element.broken))
    elements = [element for element, _ in pairs if not element.broken]
    for robot, wrong in misplaced(readable, MAX_MESSAGES + 1):
        reader.error(elements[robot], wrong)
    for obj, wrong in islice(overlapping_objects(world), MAX_MESSAGES + 1):
        reader.error(objects.get(obj, root), wrong)


def _area(element: Element, reader: Reader, materials: Materials) -> Area:
    length_m = reader.positive(element, "length", LENGTH)
    width_m = reader.positive(element, "width", LENGTH)
    edge_m = reader.not_negative(element, "edge", LENGTH, 0.1)
    if 0.0 < edge_m < SHORTEST_M:
        reader.refuse(element, "edge: must be 0, or 1mm or more")
    material = materials.of(element)
    if element.attributes.get("origin") == "centre":
        return Area(-length_m / 2, -width_m / 2, length_m, width_m, edge_m, material)
    return Area(0.0, 0.0, length_m, width_m, edge_m, material)


def _timestep(root: Element, reader: Reader) -> float:
    value_s = reader.positive(root, "timestep", TIME, 0.05)
    if not SHORTEST_TIMESTEP_S <= value_s <= LONGEST_TIMESTEP_S:
        reader.refuse(root, "timestep: must be 1ms or more and 100ms or less")
        return 0.05
    return value_s


def _duration(root: Element, reader: Reader) -> float | None:
    if "duration" not in root.attributes:
        return None
    return reader.positive(root, "duration", TIME)


def _seed(root: Element, reader: Reader) -> int | None:
    if "seed" not in root.attributes:
        return None
    return reader.whole(root, "seed", 0, MAX_SEED)


def _stay(element: Element, reader: Reader) -> tuple[float, float]:
    """Return when a robot joins and when it leaves [s]."""
    join_s = reader.not_negative(element, "join", TIME)
    leave_s = reader.positive(element, "leave", TIME, math.inf)
    if leave_s <= join_s:
        reader.refuse(element, "leave: must be later than join")
    return join_s, leave_s


def _program(element: Element, folder: Path | None, reader: Reader) -> str:
    """Return the path of a program: a C file in the world file's folder or below."""
    text = element.attributes.get("program", "")
    if not text:
        return ""
    path = PurePosixPath(from_text(text))
    if path.suffix != ".c" or path.is_absolute() or "\0" in text:
        reader.error(element, f"program {text!r}: must be a relative path to a C file (.c)")
        return ""
    if folder is None:
        return str(path)
    if not _is_below(folder / path, folder):
        reader.error(element, f"program {text!r}: must be in the folder of this file or below")
        return ""
    if not _is_file(folder / path):
        reader.error(element, f"program {text!r}: no such file")
    return str(folder / path)


def _is_below(path: Path, folder: Path) -> bool:
    try:
        return path.resolve().is_relative_to(folder.resolve())
    except (OSError, RuntimeError):  # circular links
        return False


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:  # an invalid file name
        return False
