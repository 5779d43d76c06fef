"""Copies in rows and rings, and alignment of elements: array, ring, align, distribute."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Final, Literal, NamedTuple, TypeAlias

from crs_cc.builder import markup
from crs_cc.builder.addresses import address, ids, outermost, unused_name
from crs_cc.builder.changes import Plan, path_of, pins, schema_of
from crs_cc.builder.document import Document
from crs_cc.builder.motion import Motion, moved, position
from crs_cc.builder.sensor_copies import is_sensor, sensor_copies
from crs_cc.builder.spans import Node
from crs_cc.builder.table import SIDES
from crs_cc.core.suggest import unknown
from crs_cc.sim.files.object_ids import TAGS_WITH_ID
from crs_cc.sim.files.schema_properties import properties

MAX_COPIES: Final = 10_000

Axis: TypeAlias = Literal["x", "y"]


class Extent(NamedTuple):
    """The bounding box of an element [m], in the frame of its parent."""

    left_m: float
    bottom_m: float
    right_m: float
    top_m: float

    @property
    def centre_m(self) -> tuple[float, float]:
        """Its middle."""
        return (self.left_m + self.right_m) / 2, (self.bottom_m + self.top_m) / 2


Extents: TypeAlias = Mapping[str, Extent]
"""What the elements of a world cover, by their ids, as far as it is known."""


def extent(document: Document, node: Node, known: Extents) -> Extent:
    """Return the extent of an element, or its position if the extent is unknown."""
    found = known.get(address(node))
    return found or Extent(*position(document, node) * 2)


def around(document: Document, nodes: Sequence[Node], known: Extents) -> Extent:
    """Return the joint extent of elements."""
    rows = [extent(document, node, known) for node in nodes]
    return Extent(
        min(row.left_m for row in rows),
        min(row.bottom_m for row in rows),
        max(row.right_m for row in rows),
        max(row.top_m for row in rows),
    )


def copies(document: Document, nodes: Sequence[Node], motions: Sequence[Motion]) -> Plan:
    """Copy elements, once for each motion; the copies follow the originals.

    Raises:
        ValueError: an element has no position, or there would be too many copies.
    """
    whole = outermost(nodes)
    _require_few(len(whole) * len(motions))
    if all(map(is_sensor, whole)):
        return sensor_copies(document, whole, motions)
    plan = Plan(pins(document, {node.tag for node in whole}))
    used: dict[int, set[str]] = {}
    for node in whole:
        if node.parent is None:
            raise ValueError(f"<{node.tag}> cannot be copied")
        texts = []
        names = used.setdefault(id(node.parent), set(ids(node.parent)))
        where, slash, own = address(node).rpartition("/")
        for motion in motions:
            values = moved(document, node, motion)
            if node.tag in TAGS_WITH_ID:
                name = unused_name(own, names)
                names.add(name)
                values = {"id": name, **values}
                plan.names.append(where + slash + name)
            texts.append(written(document, node, values))
        plan.splices += markup.insert(document, node.parent, node.tag, texts, node)
    return plan


def _require_few(count: int) -> None:
    """Refuse too many copies, before anything is made for them."""
    if count > MAX_COPIES:
        raise ValueError(f"{count} copies are too many (maximum: {MAX_COPIES})")


def written(document: Document, node: Node, values: Mapping[str, str | None]) -> str:
    """Return an element as text, with other attributes at their usual positions."""
    order = [row.name for row in properties(schema_of(document), path_of(node))]
    return markup.fragment(document, node, values, order)


def array(
    document: Document, nodes: Sequence[Node], counts: tuple[int, int], step_m: tuple[float, float]
) -> Plan:
    """Copy elements into columns and rows.

    Args:
        document: the document.
        nodes: the elements.
        counts: how many columns along x and rows along y, with the elements themselves.
        step_m: from one column to the next, and from one row to the next.
    """
    if min(counts) < 1 or max(counts) > MAX_COPIES:
        raise ValueError(f"columns and rows must be 1 to {MAX_COPIES}")
    _require_few(len(nodes) * counts[0] * counts[1])
    return copies(
        document,
        nodes,
        [
            Motion.shift(column * step_m[0], row * step_m[1])
            for row in range(counts[1])
            for column in range(counts[0])
            if row or column
        ],
    )


def ring(
    document: Document, nodes: Sequence[Node], count: int, centre_m: tuple[float, float]
) -> Plan:
    """Copy elements around a point, so that there are as many of each, evenly spaced."""
    if not 2 <= count <= MAX_COPIES:
        raise ValueError(f"the count must be 2 to {MAX_COPIES}")
    turns = (math.tau * number / count for number in range(1, count))
    return copies(document, nodes, [Motion.turn(turn, *centre_m) for turn in turns])


def align(document: Document, nodes: Sequence[Node], side: str, known: Extents) -> Plan:
    """Move elements so that their sides or centres are in line with those of all of them."""
    if side not in SIDES:
        raise ValueError(unknown("side", side, SIDES))
    whole = outermost(nodes)
    all_of = around(document, whole, known)
    shifts = []
    for node in whole:
        own = extent(document, node, known)
        shift = {
            "left": (all_of.left_m - own.left_m, 0.0),
            "right": (all_of.right_m - own.right_m, 0.0),
            "bottom": (0.0, all_of.bottom_m - own.bottom_m),
            "top": (0.0, all_of.top_m - own.top_m),
            "centre-x": (all_of.centre_m[0] - own.centre_m[0], 0.0),
            "centre-y": (0.0, all_of.centre_m[1] - own.centre_m[1]),
        }[side]
        shifts.append(shift)
    return _shifted(document, whole, shifts)


def distribute(document: Document, nodes: Sequence[Node], axis: Axis, known: Extents) -> Plan:
    """Move elements so that their centres are evenly spaced; the outer two stay."""
    if axis not in ("x", "y"):
        raise ValueError(unknown("axis", axis, ("x", "y")))
    along = "xy".index(axis)
    whole = outermost(nodes)
    if len(whole) < 3:
        raise ValueError("at least three elements can be distributed")
    places = [extent(document, node, known).centre_m[along] for node in whole]
    order = sorted(range(len(whole)), key=places.__getitem__)
    first, last = places[order[0]], places[order[-1]]
    shifts = [(0.0, 0.0)] * len(whole)
    for number, index in enumerate(order):
        shift = first + (last - first) * number / (len(order) - 1) - places[index]
        shifts[index] = (0.0, shift) if along else (shift, 0.0)
    return _shifted(document, whole, shifts)


def _shifted(
    document: Document, nodes: Sequence[Node], shifts_m: Sequence[tuple[float, float]]
) -> Plan:
    plan = Plan([])
    for node, shift in zip(nodes, shifts_m, strict=True):
        values = moved(document, node, Motion.shift(*shift))
        plan.splices += markup.set_attributes(document, node, values)
    return plan
