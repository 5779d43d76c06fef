"""From the elements of a world file to a `WorldModel`."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path, PurePosixPath
from typing import Final, Literal, TypeAlias, TypeVar

from crs_cc.sim.document import MAX_MESSAGES, Element, Reader
from crs_cc.sim.material_elements import Materials
from crs_cc.sim.model import Area, Robot, WorldModel
from crs_cc.sim.placement import misplaced
from crs_cc.sim.quantity import HEAT, LENGTH, TIME
from crs_cc.sim.robot_model import RobotModel
from crs_cc.sim.solid_elements import SHORTEST_M, SolidElements, pose
from crs_cc.sim.surface_elements import surface

SHORTEST_TIMESTEP_S: Final = 0.001
LONGEST_TIMESTEP_S: Final = 0.1
MAX_THINGS: Final = 100_000
MAX_SEED: Final = 999_999_999
_DIALECTS: Final[dict[str, Literal["nomad", "report"]]] = {"nomad": "nomad", "report": "report"}
_OURS: Final = ("edge-", "obstacle-")  # what programs add is named so
_THINGS: Final = frozenset({"wall", "box", "cylinder", "polygon", "robot"})
_ID: Final = re.compile(r"[A-Za-z_][A-Za-z0-9_.\-]{0,63}")

Thing = TypeVar("Thing")
FindModel: TypeAlias = Callable[[Element], RobotModel]
"""Gives the model of a robot; notes it as a mistake of the element when there is none."""


def world_model(
    root: Element, name: str, folder: Path | None, reader: Reader, find_model: FindModel
) -> WorldModel:
    """Gives the world that a world file describes; mistakes go to the reader.

    Args:
        root: the outermost element.
        name: the world's name, if the file gives none.
        folder: where programs are looked for; None when the world came from no file.
        reader: reads the values.
        find_model: finds robot definitions.
    """
    if len(root.children) > MAX_THINGS:
        reader.error(root, f"more than {MAX_THINGS} things in one world")
        root.children = root.children[:1]
    _name_things(root, reader)
    materials = Materials(root.all("material"), reader)
    solids = SolidElements(reader, materials)
    world = WorldModel(
        root.attributes.get("name", name),
        area=_area(root.first("area"), reader, materials),
        walls=tuple(map(solids.wall, root.all("wall"))),
        boxes=tuple(map(solids.box, root.all("box"))),
        cylinders=tuple(map(solids.cylinder, root.all("cylinder"))),
        polygons=tuple(map(solids.polygon, root.all("polygon"))),
        robots=tuple(
            Robot(
                element.attributes["id"],
                find_model(element),
                pose(element, reader),
                _program(element, folder, reader),
                tuple(argument.text for argument in element.all("argument")),
                reader.not_negative(element, "heat", HEAT),
                _DIALECTS.get(element.attributes.get("dialect", "")),
                materials.of(element),
            )
            for element in root.all("robot")
        ),
        timestep_s=_timestep(root, reader),
        duration_s=_duration(root, reader),
        seed=_seed(root, reader),
        surface=surface(root.first("surface"), reader),
    )
    _check(world, root, reader)
    return world


def _name_things(root: Element, reader: Reader) -> None:
    """Gives names to things that have none, and notes names that are used twice."""
    used: dict[str, int] = {}
    counts: dict[str, int] = {}
    for element in root.children[1:]:
        if element.tag not in _THINGS:
            continue
        number = counts.get(element.tag, 0)
        counts[element.tag] = number + 1
        name = element.attributes.setdefault("id", f"{element.tag}{number}")
        if name in used:
            reader.error(
                element, f"a second thing with the id {name!r}; the first is in line {used[name]}"
            )
        elif name.startswith(_OURS):
            prefix = name.partition("-")[0]
            reader.error(
                element, f"the id {name!r}: names that begin with {prefix}- are the world's"
            )
        elif not _ID.fullmatch(name):
            reader.error(
                element, f"the id {name!r}: letters, digits, _ . - only, no digit first, at most 64"
            )
        used.setdefault(name, element.line)


def _check(world: WorldModel, root: Element, reader: Reader) -> None:
    """Notes what is wrong with the whole, as far as its numbers could be read."""
    if not world.robots:
        reader.error(root, "no robot in the world", "add <robot x='1m' y='1m'/>")
    if root.first("area").broken:
        return
    readable = replace(
        world,
        walls=_readable(world.walls, root.all("wall")),
        boxes=_readable(world.boxes, root.all("box")),
        cylinders=_readable(world.cylinders, root.all("cylinder")),
        polygons=_readable(world.polygons, root.all("polygon")),
        robots=_readable(world.robots, root.all("robot")),
    )
    robots = [element for element in root.all("robot") if not element.broken]
    for robot, wrong in misplaced(readable, MAX_MESSAGES + 1):
        reader.error(robots[robot], wrong)


def _readable(things: tuple[Thing, ...], elements: Iterable[Element]) -> tuple[Thing, ...]:
    pairs = zip(things, elements, strict=True)
    return tuple(thing for thing, element in pairs if not element.broken)


def _area(element: Element, reader: Reader, materials: Materials) -> Area:
    length_m = reader.positive(element, "length", LENGTH)
    width_m = reader.positive(element, "width", LENGTH)
    edge_m = reader.not_negative(element, "edge", LENGTH, 0.1)
    if 0.0 < edge_m < SHORTEST_M:
        reader.refuse(element, "edge: walls must be 1mm thick or more, or 0 for none")
    material = materials.of(element)
    if element.attributes.get("origin") == "centre":
        return Area(-length_m / 2, -width_m / 2, length_m, width_m, edge_m, material)
    return Area(0.0, 0.0, length_m, width_m, edge_m, material)


def _timestep(root: Element, reader: Reader) -> float:
    value_s = reader.positive(root, "timestep", TIME, 0.05)
    if not SHORTEST_TIMESTEP_S <= value_s <= LONGEST_TIMESTEP_S:
        reader.refuse(root, f"timestep: {value_s:g}s must be 1ms or more and 100ms or less")
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


def _program(element: Element, folder: Path | None, reader: Reader) -> str:
    """Gives a path that can be opened; only C files, and only below the world file's folder."""
    text = element.attributes.get("program", "")
    if not text:
        return ""
    path = PurePosixPath(text)
    if path.suffix != ".c" or path.is_absolute() or "\0" in text:
        reader.error(
            element, f"program {text!r}: must be a C file (.c), by a path relative to this file"
        )
        return ""
    if folder is None:
        return str(path)
    if not _is_below(folder / path, folder):
        reader.error(element, f"program {text!r}: must lie in the folder of this file or below")
        return ""
    if not _is_file(folder / path):
        reader.error(element, f"program {text!r}: there is no such file")
    return str(folder / path)


def _is_below(path: Path, folder: Path) -> bool:
    try:
        return path.resolve().is_relative_to(folder.resolve())
    except (OSError, RuntimeError):  # links that go round in a circle
        return False


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:  # a name that no file can have
        return False
