"""Elements of a world file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import islice
from typing import Final

from crs_cc.core.quantity import BRIGHTNESS, LENGTH, LOUDNESS, TIME
from crs_cc.sim.files.communication_elements import communication
from crs_cc.sim.files.composite_elements import CompositeElements
from crs_cc.sim.files.degradation_elements import degradations
from crs_cc.sim.files.document import MAX_MESSAGES, Element, Reader
from crs_cc.sim.files.entities import MAX_OBJECTS, Entities, FindModel
from crs_cc.sim.files.field_elements import fields_of
from crs_cc.sim.files.foraging_elements import nests_of, sources_of
from crs_cc.sim.files.goal_elements import goals
from crs_cc.sim.files.ground_elements import ground
from crs_cc.sim.files.include import Included
from crs_cc.sim.files.material_elements import Materials
from crs_cc.sim.files.object_ids import name_objects
from crs_cc.sim.files.scatter_elements import extract_scatters
from crs_cc.sim.files.solid_elements import MIN_LENGTH_M, SolidElements
from crs_cc.sim.geometry.placement import misplaced, overlapping_objects
from crs_cc.sim.model.beacons import TONES, Light, Sound
from crs_cc.sim.model.world import Area, Box, Cylinder, Polygon, Solid, Wall, WorldModel


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


MIN_TIMESTEP_S: Final = 0.001
MAX_TIMESTEP_S: Final = 0.1
MAX_SEED: Final = 999_999_999


def world_model(
    root: Element,
    name: str,
    included: Included,
    reader: Reader,
    find_model: FindModel,
    *,
    seed: int | None = None,
) -> WorldModel:
    """Return the world that a world file describes; errors go to the reader.

    Args:
        root: the root element.
        name: the default name of the world.
        included: reads included files; it has the folder of programs and images.
        reader: reads the values.
        find_model: finds robot definitions.
        seed: the random seed of what is scattered; by default that of the world.
    """
    name_objects(root.children, reader)
    scatters = extract_scatters(root, MAX_OBJECTS, reader)
    if len(root.children) + sum(len(each.copies) for each in scatters) > MAX_OBJECTS:
        reader.error(root, f"more than {MAX_OBJECTS} objects")
        root.children, scatters = root.children[:1], []
    definitions = included.definitions(root)
    materials = Materials((each for each in definitions if each.tag == "material"), reader)
    area = _area(root.first("area"), reader, materials)
    solids = SolidElements(reader, materials)
    composites = CompositeElements((e for e in definitions if e.tag == "define"), solids)
    entities = Entities(area, included.folder, materials, solids, composites, find_model)
    entities.read(root.children)
    world_seed = _seed(root, reader)
    if scatters:
        entities.scatter(root, scatters, seed if seed is not None else world_seed or 0)
    if not (entities.robots or (scatters and reader.diagnostics.errors)):
        reader.error(root, "no robot in the world", "add <robot x='1m' y='1m'/>")
    entities.check_ids(root)
    robots = entities.robots
    world = WorldModel(
        root.attributes.get("name", name),
        area,
        robots=tuple(robots),
        timestep_s=_timestep(root, reader),
        duration_s=_duration(root, reader),
        seed=world_seed,
        surface=ground(root.first("surface"), area, included.folder, reader),
        lights=lights(root, reader),
        sounds=sounds(root, reader),
        degradations=degradations(
            root.all("degradation"), zip(root.all("robot"), robots, strict=True), reader
        ),
        communication=communication(root, [robot.id for robot in robots], reader),
        sources=sources_of(root, reader),
        nests=nests_of(root, reader),
    )
    world = replace(world, fields=fields_of(root, area, world.timestep_s, reader))
    world = _with(world, entities.objects)
    world = replace(world, goals=goals(root, world, reader))
    _check(world, root, {solid.id: element for element, solid in entities.objects}, reader)
    return world


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
    if 0.0 < edge_m < MIN_LENGTH_M:
        reader.refuse(element, "edge: must be 0, or 1mm or more")
    material = materials.of(element)
    if element.attributes.get("origin") == "centre":
        return Area(-length_m / 2, -width_m / 2, length_m, width_m, edge_m, material)
    return Area(0.0, 0.0, length_m, width_m, edge_m, material)


def _timestep(root: Element, reader: Reader) -> float:
    value_s = reader.positive(root, "timestep", TIME, 0.05)
    if not MIN_TIMESTEP_S <= value_s <= MAX_TIMESTEP_S:
        reader.refuse(root, "timestep: must be from 1ms to 100ms")
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
