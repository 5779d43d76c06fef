"""Materials of objects: `<material>` elements, and attributes of the objects.

An object has the material that its attribute `material` names, with the properties that it sets
itself:

    <material name="curtain" colour="maroon" sonar="0.2"/>
    <wall material="curtain" colour="navy" .../>
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from crs_cc.core.suggest import unknown
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.colours import rgb
from crs_cc.sim.model.world import PLAIN, Material


class Materials:
    """The materials of a world, by name."""

    def __init__(self, elements: Iterable[Element], reader: Reader) -> None:
        """Read `<material>` elements; each may be based on those before it."""
        self._reader = reader
        self._known: dict[str, Material] = {}
        self._where: dict[str, str] = {}
        for element in elements:
            name = element.attributes["name"]
            if name in self._known:
                before = self._where[name]
                reader.error(element, f"duplicate material {name!r} (first defined {before})")
                continue
            self._known[name] = self.of(element)
            self._where[name] = f"in {element.place}"

    def of(self, element: Element) -> Material:
        """Return the material that an element's attributes describe; errors go to the reader."""
        reader = self._reader
        name = element.attributes.get("material", "")
        base = self._known.get(name, PLAIN)
        if name and name not in self._known:
            reader.refuse(element, f"material: {unknown('material', name, tuple(self._known))}")
        infrared = base.infrared
        if "infrared" in element.attributes:
            infrared = reader.fraction(element, "infrared", 1.0)
        sonar = reader.fraction(element, "sonar", base.sonar)
        return replace(base, colour=_colour(element, base, reader), sonar=sonar, infrared=infrared)


def _colour(element: Element, base: Material, reader: Reader) -> tuple[int, int, int]:
    if "colour" not in element.attributes:
        return base.colour
    try:
        return rgb(element.attributes["colour"])
    except ValueError as wrong:
        reader.refuse(element, f"colour: {wrong}")
        return base.colour
