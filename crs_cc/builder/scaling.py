"""Scaling of elements about a point: their positions, and their sizes in plan view.

>>> from crs_cc.builder.document import Document
>>> room = Document(b"<world><box x='1m' y='1m' length='40cm' width='20cm'/></world>", "room.xml")
>>> room.change("scale", scale(room, room.root.children, 2.0, (0.0, 1.0)).splices)
>>> room.text
b"<world><box x='2m' y='1m' length='80cm' width='40cm'/></world>"
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from crs_cc.builder import markup
from crs_cc.builder.addresses import address, outermost
from crs_cc.builder.changes import Plan, path_of, schema_of
from crs_cc.builder.document import Document
from crs_cc.builder.motion import Motion, like, movable, moved, points_moved, quantity
from crs_cc.builder.spans import Node
from crs_cc.core.quantity import LENGTH
from crs_cc.sim.files.schema_properties import properties

LARGEST: Final = 1000.0
"""The largest factor, and the least by its inverse."""

_SIZES: Final[Mapping[str, tuple[str, ...]]] = {
    "wall": (),
    "polygon": (),
    "light": (),
    "sound": (),
    **dict.fromkeys(("cylinder", "source", "nest"), ("radius",)),
    **dict.fromkeys(("box", "ramp", "plateau"), ("length", "width")),
    **dict.fromkeys(("reach", "bring", "place"), ("radius",)),
}
_REASONS: Final = {
    "object": "it has the size of its definition: open that, and scale its parts",
    "robot": "it has the size of its robot definition",
}


def scale(
    document: Document, nodes: Sequence[Node], factor: float, centre_m: tuple[float, float]
) -> Plan:
    """Scale elements about a point; heights and the thickness of walls stay.

    Raises:
        ValueError: an element cannot be scaled, or the factor is too large or too small.
    """
    if not 1 / LARGEST <= factor <= LARGEST:
        raise ValueError(f"the factor must be {1 / LARGEST:g} to {LARGEST:g}")
    rest = 1 - factor
    motion = Motion(rest * centre_m[0], rest * centre_m[1], factor, 0.0, 0.0, factor)
    plan = Plan([])
    for node in outermost(nodes):
        for part in list(movable(node)) or [node]:
            order = [row.name for row in properties(schema_of(document), path_of(part))]
            values = _scaled(document, part, motion, factor)
            plan.splices += markup.set_attributes(document, part, values, order)
    return plan


def _scaled(document: Document, node: Node, motion: Motion, factor: float) -> dict[str, str | None]:
    if node.tag not in _SIZES:
        reason = _REASONS.get(node.tag, "it has no size")
        raise ValueError(f"{address(node)} cannot be scaled: {reason}")
    values = moved(document, node, motion)
    if node.tag == "polygon" and "points" not in values:
        values["points"] = points_moved(document, node, Motion(xx=factor, yy=factor))
    for name in _SIZES[node.tag]:
        new_m = quantity(node, name, LENGTH) * factor
        values[name] = like(document, node, LENGTH, new_m, node.attributes[name])
    return values
