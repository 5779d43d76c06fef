"""Models of SDF (sdformat.org) for Gazebo: upright boxes and cylinders."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Final

from crs_cc.builder.importing.drawn import PlanElements, length
from crs_cc.builder.spans import Node, parse
from crs_cc.sim.model.world import Pose

_UPRIGHT_RAD: Final = 1e-6
_READ: Final = frozenset({"link", "pose", "static", "collision", "visual", "inertial"})


def read_sdf(text: bytes, file: str) -> PlanElements:
    """Return the boxes and cylinders of an SDF file.

    Raises:
        WorldError: it is not well-formed.
        ValueError: it is not an SDF file, or too large.
    """
    root = parse(text, file).root
    if root.tag != "sdf":
        raise ValueError(f"the root element must be <sdf>, not <{root.tag}>")
    drawn = PlanElements()
    work: list[tuple[Node, Pose]] = [(node, Pose()) for node in reversed(root.children)]
    while work:
        node, around = work.pop()
        if node.tag == "world":
            work += [(child, around) for child in reversed(node.children)]
        elif node.tag == "model":
            place = _pose(drawn, node, around)
            if place is not None:
                work += [
                    (child, place) for child in reversed(node.children) if child.tag == "model"
                ]
                _model(drawn, node, place)
        elif node.tag != "physics":
            drawn.omit(node.tag)
    return drawn


def _model(drawn: PlanElements, model: Node, place: Pose) -> None:
    is_static = _text(model, "static").strip() in ("true", "1")
    links = [child for child in model.children if child.tag == "link"]
    for child in model.children:
        if child.tag not in _READ | {"model"}:
            drawn.omit(child.tag)
    for link in links:
        there = _pose(drawn, link, place)
        shapes = [child for child in link.children if child.tag == "collision"]
        mass = "" if is_static or len(links) * len(shapes) > 1 else _text(link, "inertial", "mass")
        for collision in shapes if there is not None else ():
            own = _pose(drawn, collision, there)
            if own is not None:
                _shape(drawn, collision, own, {"mass": f"{mass.strip()}kg"} if mass else {})


def _shape(drawn: PlanElements, collision: Node, place: Pose, more: dict[str, str]) -> None:
    geometry = next(_children(collision, "geometry"), None)
    for shape in geometry.children if geometry else ():
        centre = place.x_m, place.y_m
        if shape.tag == "box":
            x_m, y_m, z_m = _numbers(_text(shape, "size"), 3)
            drawn.box(centre, (x_m, y_m), place.heading_rad, {**more, **_height(z_m)})
        elif shape.tag == "cylinder":
            (radius_m,) = _numbers(_text(shape, "radius"), 1)
            (height_m,) = _numbers(_text(shape, "length"), 1)
            drawn.cylinder(centre, radius_m, {**more, **_height(height_m)})
        else:
            drawn.omit(shape.tag)


def _height(value_m: float) -> dict[str, str]:
    return {"height": length(value_m)} if value_m >= 0.001 else {}


def _pose(drawn: PlanElements, node: Node, around: Pose | None) -> Pose | None:
    """Return the pose of an element; None if it is not upright."""
    own = next(_children(node, "pose"), None)
    if own is not None and own.attributes.get("relative_to"):
        drawn.omit(node.tag, "it is placed relative to something else")
        return None
    x, y, _, roll, pitch, yaw = _numbers("" if own is None else own.text, 6)
    if max(abs(math.sin(roll)), abs(math.sin(pitch))) > _UPRIGHT_RAD:
        drawn.omit(node.tag, "it does not stand upright")
        return None
    return Pose(x, y, yaw).within(around or Pose())


def _children(node: Node, tag: str) -> Iterator[Node]:
    return (child for child in node.children if child.tag == tag)


def _text(node: Node, *tags: str) -> str:
    """Return the text of an element below another one; empty if there is none."""
    found: Node | None = node
    for tag in tags:
        found = None if found is None else next(_children(found, tag), None)
    return "" if found is None else found.text


def _numbers(text: str, count: int) -> list[float]:
    """Return numbers; those that are missing are 0."""
    found = [float(word) for word in text.split()[:count]]
    if not all(map(math.isfinite, found)):
        raise ValueError("a number is not finite")
    return found + [0.0] * (count - len(found))
