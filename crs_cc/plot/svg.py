"""A small SVG writer: world coordinates in metres, y up, on a page of pixels.

>>> view = View(left_m=0.0, top_m=2.0, scale=100.0, margin_px=10.0)
>>> view.point(1.0, 0.5)
(110.0, 160.0)
>>> page = Page(300, 220, "a <test>")
>>> page.circle((110.0, 160.0), 5.0, fill="red")
>>> print(page.render().decode().split("?>")[1].strip()[:72])
<svg xmlns="http://www.w3.org/2000/svg" width="300" height="220" viewBox
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from typing import Final

from lxml import etree

from crs_cc.core.file_names import displayed

Element = etree._Element
Point = tuple[float, float]
Points = Sequence[Point]
Attributes = Mapping[str, str | float]

_NAMESPACE: Final = "http://www.w3.org/2000/svg"
_FORBIDDEN: Final = re.compile("[^\t\n\r\x20-\x7e\xa0-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


@dataclass(frozen=True, slots=True)
class View:
    """The mapping of the world to the page.

    Attributes:
        left_m: world x at the left edge of the drawing.
        top_m: world y at its top edge.
        scale: pixels per metre.
        margin_px: distance of the drawing from the page's left edge.
        head_px: its distance from the page's top edge; by default `margin_px`.
    """

    left_m: float
    top_m: float
    scale: float
    margin_px: float
    head_px: float | None = None

    def point(self, x_m: float, y_m: float) -> Point:
        """Return the point on the page [px] of a point in the world."""
        head_px = self.margin_px if self.head_px is None else self.head_px
        x_px = self.margin_px + (x_m - self.left_m) * self.scale
        return x_px, head_px + (self.top_m - y_m) * self.scale

    def length(self, length_m: float) -> float:
        """Return a length on the page [px]."""
        return length_m * self.scale


class Page:
    """An SVG document; later shapes cover earlier ones.

    Keyword arguments of the shapes are SVG attributes, with `_` for `-`.

    Attributes:
        root: the `svg` element.
    """

    def __init__(self, width_px: float, height_px: float, title: str) -> None:
        size = {"width": _number(width_px), "height": _number(height_px)}
        self.root = etree.Element(
            f"{{{_NAMESPACE}}}svg",
            {**size, "viewBox": f"0 0 {size['width']} {size['height']}", "role": "img"},
            nsmap={None: _NAMESPACE},
        )
        self._parents = [self.root]
        self._add("title", {}, title)

    @contextmanager
    def group(self, **attributes: str | float) -> Iterator[None]:
        """Put the shapes drawn inside the `with` block into a group of their own."""
        self._parents.append(self._add("g", attributes))
        yield
        self._parents.pop()

    def clipped(self, corner: Point, size: Point) -> AbstractContextManager[None]:
        """Put the shapes drawn inside the `with` block into a group clipped to a rectangle."""
        name = f"clip{len(self.root)}"
        self._parents.append(self._add("clipPath", {"id": name}))
        self.rectangle(corner, size)
        self._parents.pop()
        return self.group(clip_path=f"url(#{name})")

    def line(self, start: Point, end: Point, **attributes: str | float) -> None:
        """Draw a straight line."""
        place = {"x1": start[0], "y1": start[1], "x2": end[0], "y2": end[1]}
        self._add("line", place | attributes)

    def rectangle(self, corner: Point, size: Point, **attributes: str | float) -> None:
        """Draw a rectangle from its upper left corner."""
        place = {"x": corner[0], "y": corner[1], "width": size[0], "height": size[1]}
        self._add("rect", place | attributes)

    def circle(self, centre: Point, radius_px: float, **attributes: str | float) -> None:
        """Draw a circle."""
        self._add("circle", {"cx": centre[0], "cy": centre[1], "r": radius_px} | attributes)

    def polygon(self, points: Points, **attributes: str | float) -> None:
        """Draw a closed shape."""
        self._add("polygon", {"points": _points(points)} | attributes)

    def polyline(self, points: Points, **attributes: str | float) -> None:
        """Draw an open line through points."""
        self._add("polyline", {"points": _points(points)} | attributes)

    def text(self, place: Point, text: str, **attributes: str | float) -> None:
        """Write a text whose baseline starts at `place`, unless `text_anchor` is given."""
        if text:
            self._add("text", {"x": place[0], "y": place[1]} | attributes, text)

    def render(self) -> bytes:
        """Return the document as UTF-8."""
        etree.indent(self.root)
        done: bytes = etree.tostring(self.root, encoding="utf-8", xml_declaration=True)
        return done + b"\n"

    def _add(self, tag: str, attributes: Attributes, text: str = "") -> etree._Element:
        values = {name.replace("_", "-"): _value(value) for name, value in attributes.items()}
        element = etree.SubElement(self._parents[-1], f"{{{_NAMESPACE}}}{tag}", values)
        if text:
            element.text = _legal(text)
        return element


def _value(value: str | float) -> str:
    return _legal(value) if isinstance(value, str) else _number(value)


def _number(value: float) -> str:
    """Format a number to a tenth of a pixel."""
    return f"{value:.1f}".removesuffix(".0")


def _points(points: Points) -> str:
    return " ".join(f"{_number(x)},{_number(y)}" for x, y in points)


def _legal(text: str) -> str:
    """Replace the characters that are not allowed in XML."""
    return _FORBIDDEN.sub("\ufffd", displayed(text))
