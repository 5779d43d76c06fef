"""A robot definition from above, as JSON for the page of the builder.

Shapes are as in `shapes`, in the robot's frame: its body, its wheels, and each sensor with the
beginning of its beam.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Final

from crs_cc.builder.addresses import address
from crs_cc.builder.document import Document
from crs_cc.builder.motion import quantity
from crs_cc.builder.mounting import MOUNTED, mount
from crs_cc.builder.shapes import Shape
from crs_cc.builder.spans import Node
from crs_cc.core.quantity import ANGLE, LENGTH
from crs_cc.sim.model.world import Pose

_USUAL_M: Final = 0.2
"""The radius of a body that has no valid one."""

_SHOWN: Final = 3.5
"""How far beams are drawn, in radii of the body."""

_USUAL_VIEW: Final = {"camera": "60deg", "laser": "60deg"}


def robot_area(document: Document) -> dict[str, float]:
    """Return the square around a robot that is shown [m]."""
    side_m = 2 * (_SHOWN + 1) * _radius_m(document)
    return {"x": -side_m / 2, "y": -side_m / 2, "length": side_m, "width": side_m, "edge": 0.0}


def _radius_m(document: Document) -> float:
    body = next((each for each in document.root.children if each.tag == "body"), None)
    try:
        radius_m = _USUAL_M if body is None else quantity(body, "radius", LENGTH)
    except ValueError:
        return _USUAL_M
    return radius_m if 0.001 <= radius_m <= 100 else _USUAL_M


def robot_shapes(document: Document) -> dict[str, list[Shape]]:
    """Return the shapes of a robot's parts, by their names; those that are wrong are missing."""
    radius_m = _radius_m(document)
    found: dict[str, list[Shape]] = {}
    for node in document.root.children:
        try:
            shapes = list(_shapes(node, radius_m))
        except ValueError:
            continue  # the loader reports the error
        if shapes:
            found[address(node)] = shapes
    return found


def _shapes(node: Node, radius_m: float) -> Iterator[Shape]:
    if node.tag == "body":
        yield {"kind": "body", "x": 0.0, "y": 0.0, "radius": radius_m}
    elif node.tag == "drive" and "wheel-base" in node.attributes:
        half_m = quantity(node, "wheel-base", LENGTH) / 2
        yield from (_wheel(side * half_m, radius_m) for side in (1, -1))
    elif node.tag in MOUNTED:
        place = mount(node)
        beam = _beam(node, place, _SHOWN * radius_m)
        if beam:
            yield {"kind": "beam", "points": beam}
        disc = {"x": place.x_m, "y": place.y_m, "radius": radius_m / 16}
        yield {"kind": "sensor", "heading": place.heading_rad, **disc}


def _wheel(y_m: float, radius_m: float) -> Shape:
    length_m, width_m = radius_m / 3, radius_m / 20
    corners = [[x * length_m, y_m + y * width_m] for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
    return {"kind": "wheel", "points": corners}


def _beam(node: Node, place: Pose, most_m: float) -> list[list[float]]:
    """Return the corners of a beam from above; empty if it has none."""
    if node.tag == "sensor":
        texts = {each.tag: each.text.strip() for each in node.all()}
        range_m, wide_m = (LENGTH.parse(texts.get(name, "")) for name in ("range", "radius"))
        half_rad = math.atan2(wide_m, range_m)
    elif node.tag in _USUAL_VIEW:
        range_m = quantity(node, "range", LENGTH, most_m)
        view = node.attributes.get("field-of-view", _USUAL_VIEW[node.tag])
        half_rad = ANGLE.parse(view) / 2
    else:
        return []
    length_m = min(range_m, most_m)
    corners = [[place.x_m, place.y_m]]
    for step in range(-4, 5):
        angle_rad = place.heading_rad + half_rad * step / 4
        end = place.x_m + length_m * math.cos(angle_rad), place.y_m + length_m * math.sin(angle_rad)
        corners.append(list(end))
    return corners
