"""The result of reading a plan: elements in metres, and what was omitted.

>>> drawn = PlanElements()
>>> drawn.wall((0, 0), (2, 0), thickness_m=0.1)
>>> drawn.omit("image")
>>> drawn.omit("image")
>>> print(drawn.clip())
<clip>
  <wall x1="0m" y1="0m" x2="2m" y2="0m" thickness="0.1m"/>
</clip>
>>> drawn.omissions()
['2 of <image>']
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Final, TypeAlias

from crs_cc.builder import markup
from crs_cc.builder.motion import measure
from crs_cc.core.quantity import ANGLE, LENGTH
from crs_cc.sim.files.solid_elements import MAX_CORNERS

Point: TypeAlias = tuple[float, float]

MAX_ELEMENTS: Final = 10_000
"""Maximum number of elements of a plan."""

MIN_LENGTH_M: Final = 0.002
"""Walls and boxes that are smaller are left out."""

_SHOWN: Final = 40


@dataclass(slots=True)
class PlanElements:
    """The elements read from a plan.

    Attributes:
        elements: tag and attributes of each element.
        materials: the attributes of materials by names.
        omitted: what was left out, and how often.
        points: the points that elements have, for their extent.
    """

    elements: list[tuple[str, dict[str, str]]] = field(default_factory=list)
    materials: dict[str, dict[str, str]] = field(default_factory=dict)
    omitted: Counter[str] = field(default_factory=Counter)
    points: list[Point] = field(default_factory=list)

    def omit(self, what: str, why: str = "") -> None:
        """Record something that is omitted."""
        if len(self.omitted) < 1000:
            self.omitted[f"<{what[:_SHOWN]}>{f': {why}' if why else ''}"] += 1

    def omissions(self) -> list[str]:
        """Return a description of what was omitted."""
        return [f"{count} of {what}" for what, count in sorted(self.omitted.items())]

    def material(self, name: str, colour: str | None) -> str:
        """Return the name of a material, which is made if it is new; empty if it has none."""
        if not name:
            return ""
        self.materials.setdefault(name, {"colour": colour} if colour else {})
        return name

    def wall(
        self, start: Point, end: Point, thickness_m: float, more: Mapping[str, str] | None = None
    ) -> None:
        """Add a wall [m]."""
        if math.dist(start, end) < MIN_LENGTH_M:
            self.omit("wall", "too short")
            return
        names = zip(("x1", "y1", "x2", "y2"), (*start, *end), strict=True)
        values = {name: length(value) for name, value in names}
        self._add("wall", {**values, "thickness": length(thickness_m), **(more or {})}, start, end)

    def walls(
        self, points: Sequence[Point], thickness_m: float, more: Mapping[str, str] | None = None
    ) -> None:
        """Add a chain of walls [m]."""
        for start, end in pairwise(points):
            self.wall(start, end, thickness_m, more)

    def box(
        self, centre: Point, size: Point, heading_rad: float = 0.0,
        more: Mapping[str, str] | None = None,
    ) -> None:  # fmt: skip
        """Add a box [m]."""
        if min(size) < MIN_LENGTH_M:
            self.omit("box", "too small")
            return
        values = {**pose(centre, heading_rad), "length": length(size[0]), "width": length(size[1])}
        reach_m = math.hypot(*size) / 2
        self._add("box", {**values, **(more or {})}, *_around(centre, reach_m))

    def cylinder(
        self, centre: Point, radius_m: float, more: Mapping[str, str] | None = None
    ) -> None:
        """Add a cylinder [m]."""
        if radius_m < MIN_LENGTH_M:
            self.omit("cylinder", "too small")
            return
        values = {**pose(centre, 0.0), "radius": length(radius_m)}
        self._add("cylinder", {**values, **(more or {})}, *_around(centre, radius_m))

    def polygon(self, points: Sequence[Point], more: Mapping[str, str] | None = None) -> None:
        """Add a polygon [m]; as walls if it has too many corners."""
        if points and points[0] == points[-1]:
            points = points[:-1]
        if len(points) > MAX_CORNERS or len(points) < 3:
            self.walls([*points, *points[:1]], 0.01, more)
            return
        text = " ".join(f"{length(x)},{length(y)}" for x, y in points)
        self._add("polygon", {"points": text, **(more or {})}, *points)

    def robot(self, centre: Point, heading_rad: float) -> None:
        """Add a robot [m]."""
        self._add("robot", pose(centre, heading_rad), *_around(centre, 0.3))

    def _add(self, tag: str, attributes: dict[str, str], *points: Point) -> None:
        if len(self.elements) >= MAX_ELEMENTS:
            raise ValueError(f"the plan has more than {MAX_ELEMENTS} elements")
        for x_m, y_m in points:
            if not max(abs(x_m), abs(y_m)) <= LENGTH.limit:
                raise ValueError(f"the plan is larger than {LENGTH.limit:g} m")
        self.elements.append((tag, attributes))
        self.points += points

    @property
    def extent(self) -> tuple[Point, Point]:
        """The lower left and the upper right corner of what has been read [m]."""
        xs, ys = [x for x, _ in self.points] or [0.0], [y for _, y in self.points] or [0.0]
        return (min(xs), min(ys)), (max(xs), max(ys))

    def clip(self) -> str:
        """Return the elements as a clip, which can be pasted into a world."""
        return markup.element("clip", {}, "", *self._texts())

    def _texts(self) -> Iterator[str]:
        for name, own in self.materials.items():
            yield markup.element("material", {"name": name, **own})
        for tag, attributes in self.elements:
            yield markup.element(tag, attributes)


def length(value_m: float) -> str:
    """Return a length as it is written."""
    return measure(LENGTH, value_m, "m")


def pose(centre: Point, heading_rad: float) -> dict[str, str]:
    """Return the attributes of a pose."""
    found = {"x": length(centre[0]), "y": length(centre[1])}
    turn = math.remainder(heading_rad, math.tau)
    return found if abs(turn) < 1e-9 else {**found, "heading": measure(ANGLE, turn, "deg")}


def _around(centre: Point, reach_m: float) -> tuple[Point, Point]:
    x_m, y_m = centre
    return (x_m - reach_m, y_m - reach_m), (x_m + reach_m, y_m + reach_m)
