"""Elements of walls and objects in a world file."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final, TypedDict

import numpy as np

from crs_cc.core.quantity import ANGLE, HEAT, LENGTH, MASS
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.files.material_elements import Materials
from crs_cc.sim.model.polygon import area_m2, validation_error
from crs_cc.sim.model.world import (
    EVERYWHERE_M,
    FIXED_KG,
    TALL_M,
    Box,
    Cylinder,
    Material,
    Polygon,
    Pose,
    Solid,
    Wall,
)

MAX_CORNERS: Final = 250
MIN_LENGTH_M: Final = 0.001
"""Minimum size of objects."""

_FRAME: Final = frozenset({"x", "y", "heading"})
_ROUNDING_M: Final = 1e-9

_POINTS_FORM: Final = "expected x,y of each corner, separated by spaces: 1m,0 2m,0 2m,50cm"
_STAND_IN: Final = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]


class Common(TypedDict):
    """The properties common to all solids."""

    heat: float
    material: Material
    height_m: float
    spread_m: float


@dataclass(frozen=True, slots=True)
class SolidElements:
    """Reads solids; errors go to the reader.

    Attributes:
        reader: reads the values.
        materials: the known materials.
    """

    reader: Reader
    materials: Materials

    def solid(self, element: Element) -> Solid:
        """Return the solid that a `<wall>`, `<box>`, `<cylinder>` or `<polygon>` describes."""
        match element.tag:
            case "wall":
                return self._wall(element)
            case "box":
                return self._box(element)
            case "cylinder":
                return self._cylinder(element)
        return self._polygon(element)

    def _wall(self, element: Element) -> Wall:
        wall = Wall(
            element.attributes["id"],
            self.reader.quantity(element, "x1", LENGTH),
            self.reader.quantity(element, "y1", LENGTH),
            self.reader.quantity(element, "x2", LENGTH),
            self.reader.quantity(element, "y2", LENGTH),
            self.size(element, "thickness"),
            **self.common(element),
        )
        if not element.broken and (wall.x1_m, wall.y1_m) == (wall.x2_m, wall.y2_m):
            wrong = f"wall {wall.id!r} has zero length: both its ends are the same point"
            self.reader.error(element, wrong)
        return wall

    def _box(self, element: Element) -> Box:
        return Box(
            element.attributes["id"],
            pose(element, self.reader),
            self.size(element, "length"),
            self.size(element, "width"),
            self._mass(element),
            **self.common(element),
        )

    def _cylinder(self, element: Element) -> Cylinder:
        return Cylinder(
            element.attributes["id"],
            pose(element, self.reader),
            self.size(element, "radius"),
            self._mass(element),
            **self.common(element),
        )

    def _polygon(self, element: Element) -> Polygon:
        corners = self._corners(element)
        name = element.attributes["id"]
        if not element.broken and (wrong := validation_error(np.array(corners).reshape(-1, 2))):
            self.reader.error(element, f"polygon {name!r}: {wrong}")
            element.broken = True
        if element.broken:
            corners = _STAND_IN
        polygon = Polygon.of(name, corners, self._mass(element))
        if not _FRAME.isdisjoint(element.attributes):
            polygon = _placed(polygon, corners, pose(element, self.reader))
        return replace(polygon, **self.common(element))

    def _corners(self, element: Element) -> list[tuple[float, float]]:
        """Return the corners in `points`: x,y x,y ..."""
        words = element.attributes["points"].split()
        if len(words) > MAX_CORNERS:
            self.reader.refuse(element, f"points: more than {MAX_CORNERS} corners")
            return []
        pairs = [word.split(",") for word in words]
        if any(len(pair) != 2 or "" in pair for pair in pairs):
            self.reader.refuse(element, f"points: {_POINTS_FORM}")
            return []
        try:
            return [(LENGTH.parse(x), LENGTH.parse(y)) for x, y in pairs]
        except ValueError as wrong:
            self.reader.refuse(element, f"points: {wrong}")
            return []

    def common(self, element: Element) -> Common:
        """Return the properties common to all solids."""
        return {
            "heat": self.reader.not_negative(element, "heat", HEAT),
            "material": self.materials.of(element),
            "height_m": self._height(element),
            "spread_m": spread(element, self.reader),
        }

    def _height(self, element: Element) -> float:
        return self.size(element, "height") if "height" in element.attributes else TALL_M

    def _mass(self, element: Element) -> float:
        return self.reader.positive(element, "mass", MASS, FIXED_KG)

    def size(self, element: Element, name: str) -> float:
        """Return a length [m] that is valid for an object."""
        value_m = self.reader.positive(element, name, LENGTH)
        if value_m < MIN_LENGTH_M:
            self.reader.refuse(element, f"{name}: must be 1mm or more")
        return value_m


def _placed(polygon: Polygon, corners: list[tuple[float, float]], frame: Pose) -> Polygon:
    """Return a polygon in a frame; if that is at its centroid, with exactly these corners."""
    if max(abs(polygon.pose.x_m), abs(polygon.pose.y_m)) > _ROUNDING_M:
        return replace(polygon, pose=polygon.pose.within(frame))
    if area_m2(np.array(corners)) < 0.0:
        corners.reverse()
    return replace(polygon, pose=frame, corners_m=tuple(corners))


def spread(element: Element, reader: Reader) -> float:
    """Return the spread of an object's heat [m]."""
    return reader.positive(element, "spread", LENGTH, EVERYWHERE_M)


def pose(element: Element, reader: Reader) -> Pose:
    """Return the pose that the attributes `x`, `y` and `heading` describe."""
    return Pose(
        reader.quantity(element, "x", LENGTH),
        reader.quantity(element, "y", LENGTH),
        reader.quantity(element, "heading", ANGLE),
    )
