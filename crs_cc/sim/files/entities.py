"""The robots, walls and objects of a world file."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Final, Literal, TypeAlias

from crs_cc.core.file_names import from_text
from crs_cc.core.quantity import HEAT, TIME
from crs_cc.sim.files.composite_elements import CompositeElements
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.files.map_elements import map_boxes
from crs_cc.sim.files.material_elements import Materials
from crs_cc.sim.files.object_ids import check_parts
from crs_cc.sim.files.scatter_elements import Scatter
from crs_cc.sim.files.solid_elements import SolidElements, pose, spread
from crs_cc.sim.geometry.placement import disc_around
from crs_cc.sim.geometry.scatter import Taken
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.robot import RobotModel
from crs_cc.sim.model.world import Area, Robot, Solid

MAX_OBJECTS: Final = 100_000
_DIALECTS: Final[dict[str, Literal["nomad", "report"]]] = {"nomad": "nomad", "report": "report"}
_SIMPLE: Final = frozenset({"wall", "box", "cylinder", "polygon"})

FindModel: TypeAlias = Callable[[Element], RobotModel]
"""Returns the model of a robot; reports an error at the element if there is none."""


@dataclass(slots=True)
class Entities:
    """The robots, walls and objects that have been read; errors go to the reader of `solids`.

    Attributes:
        area: the area of the world.
        folder: the folder of programs and images; None if the file may not use any.
        materials: the known materials.
        solids: reads walls and simple objects.
        composites: reads composite objects.
        find_model: finds robot definitions.
        robots: the robots.
        objects: walls and objects, each with its element.
        scattered: the elements that scatters represent.
    """

    area: Area
    folder: Path | None
    materials: Materials
    solids: SolidElements
    composites: CompositeElements
    find_model: FindModel
    robots: list[Robot] = field(default_factory=list)
    objects: list[tuple[Element, Solid]] = field(default_factory=list)
    scattered: list[Element] = field(default_factory=list)

    def read(self, elements: Sequence[Element]) -> None:
        """Read elements; those of other kinds are ignored."""
        for element in elements:
            if element.tag == "robot":
                self.robots.append(self._robot(element))
                continue
            self.objects += [(element, part) for part in self._solids(element)]
            if len(self.objects) > MAX_OBJECTS:
                self.solids.reader.error(element, f"more than {MAX_OBJECTS} objects")
                self.objects.clear()
                return

    def scatter(self, root: Element, scatters: Sequence[Scatter], seed: int) -> None:
        """Place a scatter in the remaining space, read it, and add it to the file."""
        reader = self.solids.reader
        taken = Taken(self.area, [solid for _, solid in self.objects], self.robots)
        messages = reader.diagnostics.messages
        for each in scatters:
            if each.example is None:
                continue
            known = len(messages)
            radius_m = self._radius_m(each.example)
            if len(messages) == known:
                each.place(radius_m, self.area, taken, seed, reader)
            for copy in each.copies:
                if len(messages) > known:
                    break  # what follows would have the same fault
                self.read([copy])
                self.scattered.append(copy)
        root.children += self.scattered

    def check_ids(self, root: Element) -> None:
        """Report invalid ids of scattered objects, and of parts of objects."""
        copies = [(each, each.attributes["id"]) for each in self.scattered]
        composed = [
            (element, part.id) for element, part in self.objects if element.tag not in _SIMPLE
        ]
        fixed = root.children[: len(root.children) - len(copies)]
        used = [element.attributes.get("id", "") for element in fixed]
        check_parts([*copies, *composed], used, self.solids.reader)

    def _radius_m(self, copy: Element) -> float:
        """Return the radius of a disc around the origin of a robot or object that covers it."""
        if copy.tag == "robot":
            return self.find_model(copy).radius_m
        around = [disc_around(part) for part in self.composites.parts(copy)]
        return max((exact.hypot(x_m, y_m) + each_m for x_m, y_m, each_m in around), default=0.0)

    def _solids(self, element: Element) -> Sequence[Solid]:
        if element.tag in _SIMPLE:
            return (self.solids.solid(element),)
        if element.tag == "object":
            return self.composites.parts(element)
        if element.tag == "map":
            return map_boxes(element, self.folder, self.area, self.solids)
        return ()

    def _robot(self, element: Element) -> Robot:
        reader = self.solids.reader
        return Robot(
            element.attributes["id"],
            self.find_model(element),
            pose(element, reader),
            _program(element, self.folder, reader),
            tuple(argument.text for argument in element.all("argument")),
            reader.not_negative(element, "heat", HEAT),
            _DIALECTS.get(element.attributes.get("dialect", "")),
            self.materials.of(element),
            *_stay(element, reader),
            spread(element, reader),
        )


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
