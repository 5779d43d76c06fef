"""Elements `<scatter>` of a world file: equal robots or objects at random places.

A scatter represents copies of an element `<robot>` or `<object>`, which follow all others of the
file. Once their places are drawn they are read as if they stood in the file.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from crs_cc.core.keyed_random import KeyedUniform
from crs_cc.core.quantity import ANGLE, LENGTH
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.geometry.scatter import STREAM, Region, Taken, headings_rad
from crs_cc.sim.model.world import Area

_OWN: Final = frozenset(
    {"id", "robot", "object", "count", "in", "x", "y", "radius", "deviation", "gap", "heading"}
)
"""Attributes that the copies do not have, or have with other values."""

_KINDS: Final = {"robot": "definition", "object": "ref"}
_CORNERS_FORM: Final = "expected x,y of two opposite corners, or of each corner: 1m,0 2m,50cm"
_MAX_CORNERS: Final = 100


@dataclass(slots=True)
class Scatter:
    """A scatter and its copies, which have no places yet.

    Attributes:
        element: its element.
        number: its number among those of the file.
        copies: the elements that it represents.
        example: one of them, also if there are none; None after an error.
    """

    element: Element
    number: int
    copies: list[Element]
    example: Element | None

    def place(self, radius_m: float, area: Area, taken: Taken, seed: int, reader: Reader) -> None:
        """Set the places of the copies; report an error if they do not fit.

        Args:
            radius_m: radius of a disc around the origin of a copy that covers it.
            area: the area of the world.
            taken: the space that is taken, and is taken then.
            seed: the random seed.
            reader: receives the errors.
        """
        gap_m = reader.not_negative(self.element, "gap", LENGTH)
        region = _region(self.element, area, reader)
        uniform, count = KeyedUniform(seed, STREAM), len(self.copies)
        if self.element.broken:
            return
        needed_m = radius_m + gap_m / 2
        places_m = taken.place(count, needed_m, region, uniform, self.number).tolist()
        if len(places_m) < count:
            shown = LENGTH.show(needed_m)
            reader.error(
                self.element,
                f"only {len(places_m)} of {count} found a place (each needs a radius of {shown})",
                "scatter fewer, or in a larger region; a regular arrangement holds more",
            )
            return
        headings = [ANGLE.exact(each) for each in headings_rad(count, uniform, self.number)]
        if "heading" in self.element.attributes:
            headings = [self.element.attributes["heading"]] * count
        for copy, (x_m, y_m), heading in zip(self.copies, places_m, headings, strict=True):
            copy.attributes |= {
                "x": LENGTH.exact(x_m), "y": LENGTH.exact(y_m), "heading": heading
            }  # fmt: skip


def extract_scatters(root: Element, most: int, reader: Reader) -> list[Scatter]:
    """Take the scatters out of a world, and return them; errors go to the reader.

    Args:
        root: the root element, changed in place.
        most: largest number of copies in all.
        reader: receives the errors.
    """
    elements = list(root.all("scatter"))
    root.children = [child for child in root.children if child.tag != "scatter"]
    found: list[Scatter] = []
    for number, element in enumerate(elements):
        left = most - sum(len(each.copies) for each in found)
        found.append(_scatter(element, number, left, reader))
    return found


def _scatter(element: Element, number: int, most: int, reader: Reader) -> Scatter:
    """Return a scatter of at most `most` copies. None are valid: a sweep may begin at 0."""
    kinds = [kind for kind in _KINDS if kind in element.attributes]
    if len(kinds) != 1:
        reader.refuse(element, "expected one of the attributes robot and object")
        return Scatter(element, number, [], None)
    kind = kinds[0]
    count = reader.whole(element, "count", 0, most)
    if kind == "object" and element.children:
        reader.refuse(element, "only robots have arguments")
        return Scatter(element, number, [], None)
    shared = {name: each for name, each in element.attributes.items() if name not in _OWN}
    shared[_KINDS[kind]] = element.attributes[kind]
    name = element.attributes["id"]
    copies = [
        Element(kind, element.line, {**shared, "id": f"{name}.{each}"}, children=element.children)
        for each in range(max(count, 1))
    ]
    return Scatter(element, number, copies[:count], copies[0])


def _region(element: Element, area: Area, reader: Reader) -> Region:
    """Return where the centres may be."""
    corners_m = _corners_m(element, area, reader)
    given = {"x", "y", "radius", "deviation"} & element.attributes.keys()
    if not given:
        return Region(corners_m)
    if given not in ({"x", "y", "radius"}, {"x", "y", "deviation"}):
        reader.refuse(element, "x, y: expected with one of radius and deviation")
        return Region(corners_m)
    centre_m = (reader.quantity(element, "x", LENGTH), reader.quantity(element, "y", LENGTH))
    size_m = {name: reader.positive(element, name, LENGTH) for name in given - {"x", "y"}}
    return Region(corners_m, centre_m, size_m.get("radius", 0.0), size_m.get("deviation", 0.0))


def _corners_m(element: Element, area: Area, reader: Reader) -> tuple[tuple[float, float], ...]:
    """Return the corners of the polygon `in`; by default those of the area."""
    x_m, y_m = (area.x_min_m, area.x_max_m), (area.y_min_m, area.y_max_m)
    if "in" in element.attributes:
        pairs = [word.split(",") for word in element.attributes["in"].split()]
        if not 2 <= len(pairs) <= _MAX_CORNERS or any(len(pair) != 2 for pair in pairs):
            reader.refuse(element, f"in: {_CORNERS_FORM}")
            return ()
        try:
            corners_m = [(LENGTH.parse(x), LENGTH.parse(y)) for x, y in pairs]
        except ValueError as wrong:
            reader.refuse(element, f"in: {wrong}")
            return ()
        if len(corners_m) > 2:
            return tuple(corners_m)
        (x_m, y_m) = zip(*corners_m, strict=True)
    return ((x_m[0], y_m[0]), (x_m[1], y_m[0]), (x_m[1], y_m[1]), (x_m[0], y_m[1]))
