"""Composite objects: `<define>` and `<object>`.

    <define name="table">
      <box id="top" x="0" y="0" length="1m" width="60cm"/>
      <object ref="leg" id="leg0" x="-40cm" y="20cm"/>
    </define>
    <object ref="table" id="t1" x="3m" y="2m" heading="30deg"/>

A definition has its own frame, which `<object>` places; its parts are then called `t1.top` and so
on. A definition may use other definitions, also later ones, but not itself.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Final

from crs_cc.core.quantity import MASS
from crs_cc.core.suggest import unknown
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.files.object_ids import name_objects
from crs_cc.sim.files.solid_elements import SolidElements, pose
from crs_cc.sim.model.mass_properties import floor_m2
from crs_cc.sim.model.world import Pose, Solid, Wall

MAX_DEFINITIONS: Final = 400
MAX_PARTS: Final = 250
MAX_DEPTH: Final = 8


class CompositeElements:
    """The definitions of a world; errors go to the reader of `solids`."""

    def __init__(self, definitions: Iterable[Element], solids: SolidElements) -> None:
        """Read all definitions, including unused ones."""
        self._solids = solids
        self._reader: Reader = solids.reader
        self._elements: dict[str, Element] = {}
        self._parts: dict[str, tuple[Solid, ...]] = {}
        self._depth: dict[str, int] = {}
        self._open: list[str] = []
        for element in definitions:
            name = element.attributes["name"]
            first = self._elements.setdefault(name, element)
            if first is not element:
                text = f"duplicate definition {name!r} (first defined in {first.place})"
                self._reader.error(element, text)
            elif len(self._elements) == MAX_DEFINITIONS + 1:
                self._reader.error(element, f"more than {MAX_DEFINITIONS} definitions")
        for name in list(self._elements)[:MAX_DEFINITIONS]:
            self._read(name)

    def parts(self, element: Element) -> tuple[Solid, ...]:
        """Return the placed parts of an `<object>`; empty after an error."""
        name, place = element.attributes["ref"], pose(element, self._reader)
        if name not in self._elements:
            wrong = unknown("definition", name, tuple(self._elements))
            self._reader.refuse(element, f"ref: {wrong}")
            return ()
        if name in self._open:
            circle = [*self._open[self._open.index(name) :], name]
            self._reader.error(element, f"{name!r} contains itself: {' in '.join(circle[::-1])}")
            element.broken = True
            return ()
        parts = self._read(name) if len(self._open) < MAX_DEPTH else ()
        if len(self._open) + self._depth.get(name, 1) > MAX_DEPTH:
            self._reader.error(element, f"definitions are nested more than {MAX_DEPTH} deep")
            element.broken = True
            return ()
        element.broken |= self._elements[name].broken
        placed = [_placed(part, place, element.attributes["id"]) for part in parts]
        return self._with_mass(element, placed) if "mass" in element.attributes else tuple(placed)

    def _with_mass(self, element: Element, parts: Sequence[Solid]) -> tuple[Solid, ...]:
        """Return the parts of a movable object, each with its share of the mass."""
        mass_kg = self._reader.positive(element, "mass", MASS)
        objects = [part for part in parts if not isinstance(part, Wall)]
        if self._open:
            self._reader.refuse(element, "mass: not allowed on an object inside a definition")
        elif len(objects) < len(parts):
            self._reader.refuse(element, "mass: an object that contains walls cannot be movable")
        whole_m2 = sum(map(floor_m2, objects))
        name = element.attributes["id"]
        return tuple(
            replace(obj, mass_kg=mass_kg * floor_m2(obj) / whole_m2, part_of=name)
            for obj in objects
        )

    def _read(self, name: str) -> tuple[Solid, ...]:
        """Return the parts of a definition in its own frame."""
        if name in self._parts:
            return self._parts[name]
        definition = self._elements[name]
        name_objects(definition.children, self._reader)
        self._open.append(name)
        parts = [part for child in definition.children for part in self._part(child)]
        self._open.pop()
        if len(parts) > MAX_PARTS:
            self._reader.error(definition, f"{name!r} has more than {MAX_PARTS} parts")
            definition.broken, parts = True, []
        definition.broken |= any(child.broken for child in definition.children)
        inner = [child.attributes["ref"] for child in definition.all("object")]
        self._depth[name] = 1 + max((self._depth.get(each, 0) for each in inner), default=0)
        self._parts[name] = tuple(parts)
        return self._parts[name]

    def _part(self, element: Element) -> tuple[Solid, ...]:
        if element.tag == "object":
            return self.parts(element)
        if "mass" in element.attributes:
            self._reader.refuse(element, "mass: not allowed on a part of an object")
        return (self._solids.solid(element),)


def _placed(part: Solid, frame: Pose, name: str) -> Solid:
    """Return a part of an object, transformed from the object's frame to the frame around it."""
    name = f"{name}.{part.id}"
    if not isinstance(part, Wall):
        return replace(part, id=name, pose=part.pose.within(frame))
    start, end = Pose(part.x1_m, part.y1_m).within(frame), Pose(part.x2_m, part.y2_m).within(frame)
    return replace(part, id=name, x1_m=start.x_m, y1_m=start.y_m, x2_m=end.x_m, y2_m=end.y_m)
