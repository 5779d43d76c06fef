"""Sensors and limbs of a robot definition: their positions on the robot, and changes of them.

>>> from crs_cc.builder.document import Document
>>> rover = Document(b'''<robot-definition><sensor><position><x-relative>8in</x-relative>
... <y-relative>0in</y-relative><dir-relative>0</dir-relative></position></sensor>
... </robot-definition>''', "rover.xml")
>>> sonar = rover.root.children[0]
>>> rover.change("turn", mounted(rover, sonar, Motion.turn(math.pi / 2, 0.0, 0.0)))
>>> print(rover.text.decode().splitlines()[1])
<y-relative>8in</y-relative><dir-relative>1.5707963</dir-relative></position></sensor>
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Final, NamedTuple

from crs_cc.builder import markup
from crs_cc.builder.addresses import address
from crs_cc.builder.document import Document, Splice
from crs_cc.builder.motion import Motion, like
from crs_cc.builder.spans import Node
from crs_cc.core.quantity import ANGLE, LENGTH
from crs_cc.sim.model.world import Pose


class Names(NamedTuple):
    """What the coordinates of a part of a robot are called; empty where it has none.

    Attributes:
        x: forward of the robot's centre.
        y: to its left.
        direction: counter-clockwise from its front.
    """

    x: str
    y: str = ""
    direction: str = ""


MOUNTED: Final[Mapping[str, Names]] = {
    "sensor": Names("x-relative", "y-relative", "dir-relative"),
    "camera": Names("forward", "left", "direction"),
    "laser": Names("forward"),
    "arm": Names("x", "y"),
}
"""The parts that can be moved on a robot."""


def is_mounted(node: Node) -> bool:
    """Return whether an element is a part of a robot that can be moved on it."""
    parent = node.parent
    return node.tag in MOUNTED and parent is not None and parent.tag == "robot-definition"


def _texts(node: Node) -> dict[str, str]:
    """Return the coordinates of a part as they are written: attributes, or texts of elements."""
    if node.tag != "sensor":
        return node.attributes
    return {each.tag: each.text.strip() for each in node.all() if not each.children}


def _angle(node: Node, text: str) -> float:
    """Return an angle [rad]; of the report's sensors, a bare number is in radians."""
    try:
        return float(text) if node.tag == "sensor" else ANGLE.parse(text)
    except ValueError:
        return ANGLE.parse(text)


def mount(node: Node) -> Pose:
    """Return where a part is on its robot.

    Raises:
        ValueError: a coordinate is invalid.
    """
    names, texts = MOUNTED[node.tag], _texts(node)
    try:
        x_m, y_m = (LENGTH.parse(texts.get(name) or "0") for name in names[:2])
        return Pose(x_m, y_m, _angle(node, texts.get(names.direction) or "0"))
    except ValueError as wrong:
        raise ValueError(f"{address(node)}: {wrong}") from None


def mounted(document: Document, node: Node, motion: Motion) -> list[Splice]:
    """Return the splices that move a part on its robot.

    Raises:
        ValueError: it cannot be moved like this, or a coordinate is invalid.
    """
    names, texts, place = MOUNTED[node.tag], _texts(node), mount(node)
    x_m, y_m = motion.point(place.x_m, place.y_m)
    turned_rad = math.remainder(motion.heading(place.heading_rad), math.tau)
    values = {names.x: like(document, node, LENGTH, x_m, texts.get(names.x, ""))}
    if names.y:
        values[names.y] = like(document, node, LENGTH, y_m, texts.get(names.y, ""))
    if names.direction and abs(turned_rad - place.heading_rad) > _MIN_ANGLE_RAD:
        values[names.direction] = _turned(
            document, node, turned_rad, texts.get(names.direction, "")
        )
    if node.tag != "sensor":
        return markup.set_attributes(document, node, values)
    leaves = {each.tag: each for each in node.all() if not each.children}
    return [
        splice
        for name, text in values.items()
        if name in leaves and text != texts[name]
        for splice in markup.set_text(document, leaves[name], text)
    ]


_MIN_ANGLE_RAD: Final = 1e-7


def _turned(document: Document, node: Node, turned_rad: float, text: str) -> str:
    is_bare = node.tag == "sensor" and text.lstrip("-+.").replace(".", "", 1).isdecimal()
    return f"{turned_rad:.8g}" if is_bare else like(document, node, ANGLE, turned_rad, text)
