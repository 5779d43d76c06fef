"""Moving, turning and mirroring elements: new coordinates, in the units of the old ones.

>>> from crs_cc.builder.document import Document
>>> room = Document(b"<world><wall x1='75in' y1='0' x2='150cm' y2='0'/></world>", "room.xml")
>>> moved(room, room.root.children[0], Motion.shift(0.1, 0.5))
{'x1': '78.93701in', 'y1': '19.68504in', 'x2': '160cm', 'y2': '19.68504in'}
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Final, Self

from crs_cc.builder.addresses import address
from crs_cc.builder.document import Document
from crs_cc.builder.spans import Node
from crs_cc.core.quantity import ANGLE, LENGTH, Kind

POSED: Final = frozenset({"box", "cylinder", "object", "robot", "ramp", "plateau", "map"})
"""Elements with a position and a heading."""

PLACED: Final = POSED | {"light", "sound", "source", "nest", "place", "reach", "bring", "heightmap"}
"""Elements with a position."""

_ROUND: Final = frozenset({"cylinder"})
_SYMMETRIC: Final = frozenset({"box", "plateau"})
_AT_CORNER: Final = frozenset({"map", "heightmap"})
_NUMBER: Final = re.compile(r"\s*([-+0-9.]+(?:[eE][-+]?[0-9]+)?)\s*([A-Za-z]*)\s*")
_STEP: Final = {LENGTH: 1e-6, ANGLE: 1e-7}
"""What a coordinate that is computed is rounded to [SI unit]; less than anything matters."""


@dataclass(frozen=True, slots=True)
class Motion:
    """A motion of the plane: x, y to xx x + xy y + x_m, yx x + yy y + y_m.

    Attributes:
        turn_rad: by how much headings turn; of a mirror, twice the angle of its axis.
        mirrors: whether left becomes right.
    """

    x_m: float = 0.0
    y_m: float = 0.0
    xx: float = 1.0
    xy: float = 0.0
    yx: float = 0.0
    yy: float = 1.0
    turn_rad: float = 0.0
    mirrors: bool = False

    @classmethod
    def shift(cls, x_m: float, y_m: float) -> Self:
        """Return a motion without a turn."""
        return cls(x_m, y_m)

    @classmethod
    def turn(cls, angle_rad: float, x_m: float, y_m: float) -> Self:
        """Return a turn about a point, counter-clockwise."""
        cos, sin = _exact(math.cos(angle_rad)), _exact(math.sin(angle_rad))
        shift = x_m - cos * x_m + sin * y_m, y_m - sin * x_m - cos * y_m
        return cls(*shift, cos, -sin, sin, cos, angle_rad)

    @classmethod
    def mirror(cls, axis_rad: float, x_m: float, y_m: float) -> Self:
        """Return a reflection in a line through a point."""
        cos, sin = _exact(math.cos(2 * axis_rad)), _exact(math.sin(2 * axis_rad))
        shift = x_m - cos * x_m - sin * y_m, y_m - sin * x_m + cos * y_m
        return cls(*shift, cos, sin, sin, -cos, 2 * axis_rad, mirrors=True)

    def point(self, x_m: float, y_m: float) -> tuple[float, float]:
        """Return where a point goes."""
        return (
            self.xx * x_m + self.xy * y_m + self.x_m,
            self.yx * x_m + self.yy * y_m + self.y_m,
        )

    def inverse(self) -> Motion:
        """Return the motion that takes a shift and a turn back."""
        back = Motion.turn(-self.turn_rad, 0.0, 0.0)
        x_m, y_m = back.point(self.x_m, self.y_m)
        return replace(back, x_m=-x_m, y_m=-y_m)

    def heading(self, heading_rad: float) -> float:
        """Return a transformed heading, at most a full turn."""
        if not self.mirrors:
            return math.fmod(heading_rad + self.turn_rad, math.tau)
        return math.remainder(self.turn_rad - heading_rad, math.tau)


def _exact(value: float) -> float:
    """Return -1, 0 or 1 for a value that equals one of them except for rounding."""
    return round(value) + 0.0 if abs(value - round(value)) < 1e-15 else value


def measure(kind: Kind, value: float, unit: str) -> str:
    """Return a value [SI unit] in a unit; empty for a bare number.

    >>> measure(LENGTH, 0.1 + 0.2, "m"), measure(LENGTH, 0.3, "cm"), measure(LENGTH, 1e-9, "")
    ('0.3m', '30cm', '0')
    """
    factor = dict(kind.units)[unit or kind.default]
    digits = max(0, math.ceil(-math.log10(_STEP[kind] / factor)))
    text = f"{value / factor:.{digits}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return ("0" if text in {"-0", ""} else text) + unit


def unit_of(document: Document, node: Node, kind: Kind, text: str) -> str:
    """Return the unit in which a value is written, or would be: of 0, that of its neighbours."""
    found = _NUMBER.fullmatch(text)
    if found and (found[2] or float(found[1])):
        return found[2] or ""
    if kind is ANGLE:
        return kind.default
    for other in node.attributes.values():
        near = _NUMBER.fullmatch(other)
        if near and near[2] in dict(LENGTH.units):
            return near[2]
    return document.length_unit


def like(document: Document, node: Node, kind: Kind, value: float, text: str) -> str:
    """Return a value as another one is written, which stays as it is if it is the same."""
    if text and abs(kind.parse(text) - value) <= _STEP[kind] / 2:
        return text
    return measure(kind, value, unit_of(document, node, kind, text))


def quantity(node: Node, name: str, kind: Kind, absent: float | None = None) -> float:
    """Return the value [SI unit] of an attribute.

    Raises:
        ValueError: it is missing or no such quantity.
    """
    text = node.attributes.get(name)
    if text is None and absent is not None:
        return absent
    try:
        return kind.parse(text or "")
    except ValueError as wrong:
        raise ValueError(f"{address(node)}, {name}: {wrong}") from None


def position(document: Document, node: Node) -> tuple[float, float]:
    """Return where an element is: its own point, the middle of a wall, a polygon's first corner.

    Raises:
        ValueError: it has no position, or an invalid one.
    """
    if node.tag == "wall":
        ends = [quantity(node, name, LENGTH) for name in ("x1", "y1", "x2", "y2")]
        return (ends[0] + ends[2]) / 2, (ends[1] + ends[3]) / 2
    if node.tag == "polygon" and not _has_frame(node):
        return corners(node)[0]
    if node.tag in PLACED or node.tag == "polygon":
        corner = _corner(document) if node.tag in _AT_CORNER else (None, None)
        absent = (0.0, 0.0) if node.tag == "polygon" else corner
        return quantity(node, "x", LENGTH, absent[0]), quantity(node, "y", LENGTH, absent[1])
    inner = next(movable(node), node)
    if inner is node:
        raise ValueError(f"{address(node)} has no position")
    return position(document, inner)


def _corner(document: Document) -> tuple[float, float]:
    """Return the lower left corner of the area."""
    area = next((each for each in document.root.children if each.tag == "area"), None)
    if area is None or area.attributes.get("origin") != "centre":
        return 0.0, 0.0
    return -quantity(area, "length", LENGTH) / 2, -quantity(area, "width", LENGTH) / 2


def movable(node: Node) -> Iterator[Node]:
    """Yield the elements that move with an element: itself, or the places of a goal."""
    if node.tag in PLACED or node.tag in {"wall", "polygon"}:
        yield node
    elif node.tag in {"goal", "visit", "surface"}:
        for child in node.children:
            yield from movable(child)


def moved(document: Document, node: Node, motion: Motion) -> dict[str, str | None]:
    """Return the attributes of an element that change with a motion, as they are to be written.

    Raises:
        ValueError: it has no position, or an invalid one.
    """
    if node.tag == "wall":
        return _points_moved(document, node, motion, ("x1", "y1"), ("x2", "y2"))
    if node.tag == "polygon":
        return _polygon_moved(document, node, motion)
    if node.tag not in PLACED:
        raise ValueError(f"{address(node)} has no position")
    if node.tag in _AT_CORNER and (motion.mirrors or (motion.turn_rad and node.tag != "map")):
        raise ValueError(f"{address(node)}: an image cannot be turned or mirrored like this")
    x_m, y_m = motion.point(*position(document, node))
    found: dict[str, str | None] = {
        "x": like(document, node, LENGTH, x_m, node.attributes.get("x", "")),
        "y": like(document, node, LENGTH, y_m, node.attributes.get("y", "")),
    }
    if node.tag in POSED:
        found |= _heading(document, node, motion)
    return found


def _heading(document: Document, node: Node, motion: Motion) -> dict[str, str | None]:
    if node.tag in _ROUND and "heading" not in node.attributes:
        return {}
    before_rad = quantity(node, "heading", ANGLE, 0.0)
    after_rad = motion.heading(before_rad)
    if motion.mirrors and node.tag in _SYMMETRIC:
        after_rad = math.remainder(after_rad, math.pi)
    text = node.attributes.get("heading", "")
    if not text and abs(after_rad) < _STEP[ANGLE]:
        return {}
    return {"heading": like(document, node, ANGLE, after_rad, text)}


def _points_moved(
    document: Document, node: Node, motion: Motion, *names: tuple[str, str]
) -> dict[str, str | None]:
    found: dict[str, str | None] = {}
    for pair in names:
        place = motion.point(*(quantity(node, name, LENGTH) for name in pair))
        for name, value_m in zip(pair, place, strict=True):
            found[name] = like(document, node, LENGTH, value_m, node.attributes[name])
    return found


def frame(node: Node) -> Motion:
    """Return the motion from an element's own coordinates to those around it."""
    turn = Motion.turn(quantity(node, "heading", ANGLE, 0.0), 0.0, 0.0)
    return replace(turn, x_m=quantity(node, "x", LENGTH, 0.0), y_m=quantity(node, "y", LENGTH, 0.0))


def _has_frame(node: Node) -> bool:
    return not {"x", "y", "heading"}.isdisjoint(node.attributes)


def corners(node: Node) -> list[tuple[float, float]]:
    """Return the corners of a polygon, in its frame."""
    words = node.attributes.get("points", "").split()
    try:
        pairs = [tuple(map(LENGTH.parse, word.split(","))) for word in words]
    except ValueError as wrong:
        raise ValueError(f"{address(node)}, points: {wrong}") from None
    if not pairs or any(len(pair) != 2 for pair in pairs):
        raise ValueError(f"{address(node)}, points: expected x,y of each corner: 1m,0 2m,0 2m,50cm")
    return [(pair[0], pair[1]) for pair in pairs]


def _polygon_moved(document: Document, node: Node, motion: Motion) -> dict[str, str | None]:
    if not _has_frame(node):
        return {"points": points_moved(document, node, motion)}
    x_m, y_m = motion.point(*position(document, node))
    found: dict[str, str | None] = {
        "x": like(document, node, LENGTH, x_m, node.attributes.get("x", "")),
        "y": like(document, node, LENGTH, y_m, node.attributes.get("y", "")),
    }
    found |= _heading(document, node, motion)
    if motion.mirrors:
        found["points"] = points_moved(document, node, Motion(yy=-1.0))
    return found


def points_moved(document: Document, node: Node, motion: Motion) -> str:
    """Return the corners of a polygon after a motion, each in its unit."""
    words = [word.split(",") for word in node.attributes["points"].split()]
    pairs = []
    for (x, y), corner in zip(words, corners(node), strict=True):
        x_m, y_m = motion.point(*corner)
        texts = (like(document, node, LENGTH, x_m, x), like(document, node, LENGTH, y_m, y))
        pairs.append(",".join(texts))
    return " ".join(pairs)
