"""Floor plans in SVG: lines, polylines, rectangles, polygons, circles and straight paths.

What is filled is an object, what has only a stroke is walls. Layers become materials, with the
colour of the first shape in them. Nothing that the file refers to is read.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Final

from crs_cc.builder.importing.drawn import PlanElements, Point
from crs_cc.builder.importing.svg_path import MAX_POINTS, chains
from crs_cc.builder.importing.svg_transform import IDENTITY, Matrix, apply, compose, matrix
from crs_cc.builder.spans import Node, parse
from crs_cc.plot.x11_colours import HEX
from crs_cc.sim.model.colours import rgb

_UNITS_M: Final = {
    "mm": 1e-3, "cm": 1e-2, "m": 1.0, "in": 0.0254, "pt": 0.0254 / 72, "pc": 0.0254 / 6,
}  # fmt: skip
_SIZE: Final = re.compile(r"\s*([0-9.]+(?:[eE][-+]?[0-9]{1,3})?)\s*([a-z]*)\s*")
_IGNORED: Final = frozenset({"title", "desc", "defs", "metadata", "style", "namedview"})
_NAMED: Final = {name.lower(): value for name, value in HEX.items()}
_NAME: Final = re.compile(r"[^A-Za-z0-9_.-]+")
_NUMBERS: Final = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]{1,3})?")


@dataclass(frozen=True, slots=True)
class _Style:
    """The style of an element, which its children inherit.

    Attributes:
        by: from its coordinates to the page's.
        fill: its colour inside; `none` for nothing.
        stroke: the colour of its outline.
        layer: the name of its layer.
    """

    by: Matrix = IDENTITY
    fill: str = "black"
    stroke: str = "none"
    layer: str = ""


def read_svg(text: bytes, file: str, scale_m: float | None, thickness_m: float) -> PlanElements:
    """Return the shapes in an SVG file.

    Args:
        text: the file.
        file: its name in messages.
        scale_m: the size of one of its units; by default from its physical size.
        thickness_m: the thickness of walls.

    Raises:
        WorldError: it is not well-formed, or has a document type.
        ValueError: it has no physical size and no scale, or is too large.
    """
    root = parse(text, file).root
    if _tag(root) != "svg":
        raise ValueError(f"the root element must be <svg>, not <{root.tag}>")
    reader = _Reader(root, scale_m, thickness_m)
    reader.read(root)
    return reader.drawn


class _Reader:
    def __init__(self, root: Node, scale_m: float | None, thickness_m: float) -> None:
        self.drawn = PlanElements()
        self._thickness_m = thickness_m
        self._count = 0
        box = _numbers(root.attributes.get("viewBox", ""))
        width, unit = _size(root.attributes.get("width", ""))
        height, _ = _size(root.attributes.get("height", ""))
        box = box if len(box) == 4 and box[2] > 0 and box[3] > 0 else [0.0, 0.0, width, height]
        if scale_m is None:
            if unit not in _UNITS_M or width * box[2] <= 0.0:
                raise ValueError("the drawing has no physical size: give the scale")
            scale_m = width * _UNITS_M[unit] / box[2]
        if not 0.0 < scale_m < math.inf:
            raise ValueError("the scale must be greater than 0")
        top = box[1] + box[3]
        self._page: Matrix = (scale_m, 0.0, 0.0, -scale_m, -box[0] * scale_m, top * scale_m)

    def read(self, root: Node) -> None:
        """Read all elements."""
        work = [(root, _Style(by=self._page))]
        while work:
            node, around = work.pop()
            tag = _tag(node)
            if tag in _IGNORED:
                continue
            try:
                style = _styled(node, around)
            except ValueError as wrong:
                self.drawn.omit(tag, str(wrong))
                continue
            if tag in ("svg", "g", "a"):
                work += [(child, style) for child in reversed(node.children)]
            elif style.stroke == "none" and (style.fill == "none" or tag == "line"):
                self.drawn.omit(tag, "it cannot be seen")
            else:
                self._shape(tag, node, style)

    def _shape(self, tag: str, node: Node, style: _Style) -> None:
        try:
            match tag:
                case "line":
                    x1, y1, x2, y2 = (_number(node, name) for name in ("x1", "y1", "x2", "y2"))
                    self._chain([(x1, y1), (x2, y2)], style, filled=False)
                case "rect":
                    self._rectangle(node, style)
                case "circle":
                    self._circle(node, style)
                case "polyline" | "polygon":
                    numbers = _numbers(node.attributes.get("points", ""))
                    points = list(zip(numbers[::2], numbers[1::2], strict=False))
                    closed = [*points, *points[:1]] if tag == "polygon" else points
                    self._chain(closed, style, filled=style.fill != "none")
                case "path":
                    self._path(node, style)
                case _:
                    self.drawn.omit(tag)
        except _Unreadable as wrong:
            self.drawn.omit(tag, str(wrong))

    def _path(self, node: Node, style: _Style) -> None:
        try:
            parts = chains(node.attributes.get("d", ""))
        except ValueError as wrong:
            raise _Unreadable(str(wrong)) from None
        for points, closed in parts:
            filled = style.fill != "none" and (closed or style.stroke == "none")
            self._chain(points, style, filled=filled)

    def _chain(self, points: list[Point], style: _Style, *, filled: bool) -> None:
        self._count += len(points)
        if self._count > MAX_POINTS:
            raise ValueError(f"the drawing has more than {MAX_POINTS} points")
        placed = [apply(style.by, point) for point in points]
        more = self._material(style)
        if filled and len(points) > 3:
            self.drawn.polygon(placed, more)
        else:
            self.drawn.walls(placed, self._thickness_m, more)

    def _rectangle(self, node: Node, style: _Style) -> None:
        x, y, width, height = (_number(node, name) for name in ("x", "y", "width", "height"))
        corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y)]
        placed = [apply(style.by, corner) for corner in corners]
        sides = math.dist(placed[0], placed[1]), math.dist(placed[1], placed[2])
        square = abs(math.dist(placed[0], placed[2]) - math.hypot(*sides)) < 1e-9 * (1 + sides[0])
        if style.fill == "none" or not square:
            self._chain(corners, style, filled=style.fill != "none")
            return
        self._count += len(corners)
        centre = (placed[0][0] + placed[2][0]) / 2, (placed[0][1] + placed[2][1]) / 2
        across = placed[1][0] - placed[0][0], placed[1][1] - placed[0][1]
        turn_rad = math.atan2(across[1], across[0])
        self.drawn.box(centre, sides, turn_rad, self._material(style))

    def _circle(self, node: Node, style: _Style) -> None:
        centre = apply(style.by, (_number(node, "cx"), _number(node, "cy")))
        a, b, c, d, *_ = style.by
        if abs(math.hypot(a, b) - math.hypot(c, d)) > 1e-9 * math.hypot(a, b):
            raise _Unreadable("it is an ellipse")
        radius_m = _number(node, "r") * math.hypot(a, b)
        self.drawn.cylinder(centre, radius_m, self._material(style))

    def _material(self, style: _Style) -> dict[str, str]:
        colour = style.stroke if style.fill == "none" else style.fill
        if style.layer:
            return {"material": self.drawn.material(style.layer, _colour(colour))}
        found = _colour(colour)
        return {"colour": found} if found and found != "#000000" else {}


class _Unreadable(Exception):  # noqa: N818 - the reason why something is omitted
    """Something that is left out."""


def _tag(node: Node) -> str:
    return node.tag.rpartition(":")[2]


def _styled(node: Node, around: _Style) -> _Style:
    """Return the style of an element: presentation attributes, and those in `style`."""
    own = dict(_declarations(node.attributes.get("style", "")))
    if own.get("display", node.attributes.get("display")) == "none":
        raise ValueError("it cannot be seen")
    found = replace(
        around,
        fill=own.get("fill", node.attributes.get("fill", around.fill)),
        stroke=own.get("stroke", node.attributes.get("stroke", around.stroke)),
    )
    if "transform" in node.attributes:
        found = replace(found, by=compose(around.by, matrix(node.attributes["transform"])))
    if _tag(node) == "g":
        label = node.attributes.get("inkscape:label") or node.attributes.get("id", "")
        layer = node.attributes.get("inkscape:groupmode") == "layer" or not around.layer
        name = _NAME.sub("-", label).strip("-.")[:64]
        found = replace(found, layer=name if layer and name else around.layer)
    return found


def _declarations(text: str) -> Iterator[tuple[str, str]]:
    for each in text[:10_000].split(";"):
        name, colon, value = each.partition(":")
        if colon:
            yield name.strip(), value.strip()


def _colour(text: str) -> str | None:
    """Return a colour in the notation of worlds; None if it is invalid."""
    try:
        red, green, blue = rgb(text)
    except ValueError:
        return _NAMED.get(text.lower())
    return f"#{red:02x}{green:02x}{blue:02x}"


def _size(text: str) -> tuple[float, str]:
    found = _SIZE.fullmatch(text)
    try:
        return (float(found[1]), found[2]) if found else (0.0, "")
    except ValueError:
        return 0.0, ""


def _numbers(text: str) -> list[float]:
    numbers: list[float] = []
    for found in _NUMBERS.finditer(text):
        if len(numbers) > 2 * MAX_POINTS:
            raise ValueError(f"the drawing has more than {MAX_POINTS} points")
        numbers.append(float(found[0]))
    return numbers


def _number(node: Node, name: str) -> float:
    value, unit = _size(node.attributes.get(name, "0").removeprefix("-"))
    if unit not in ("", "px"):
        raise _Unreadable(f"{name} is in {unit}")
    return -value if node.attributes.get(name, "").startswith("-") else value
