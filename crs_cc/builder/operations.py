"""The implementations of the operations in the table."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Final, Protocol, TypeAlias

from crs_cc.builder import arrangement, changes, clips, composition, ground
from crs_cc.builder.arrangement import Extents
from crs_cc.builder.changes import Plan
from crs_cc.builder.document import Document
from crs_cc.builder.mirroring import mirror
from crs_cc.builder.motion import Motion, position, quantity
from crs_cc.builder.mounting import is_mounted, mount
from crs_cc.builder.scaling import scale
from crs_cc.builder.sensor_copies import is_sensor
from crs_cc.builder.spans import Node
from crs_cc.builder.table import Values
from crs_cc.core.quantity import ANGLE
from crs_cc.sim.model.world import WorldModel

Attributes: TypeAlias = Mapping[str, str | None]


class Workspace(Protocol):
    """The interface of `WorldBuilder` that operations work through."""

    document: Document

    def element(self, name: str) -> Node:
        """Return an element."""

    def extents(self) -> Extents:
        """Return the extents of elements."""

    def library(self) -> list[Document]:
        """Return the included files."""

    def visible(self) -> WorldModel | None:
        """Return the world as far as it can be read; None for an invalid file."""


def _add(builder: Workspace, _: Sequence[Node], values: Values, attributes: Attributes) -> Plan:
    parent = builder.element(values["into"])
    given = {name: text for name, text in attributes.items() if text is not None}
    return changes.add(builder.document, parent, values["kind"], given, values["text"])


def _set(builder: Workspace, nodes: Sequence[Node], _: Values, attributes: Attributes) -> Plan:
    return changes.set_values(builder.document, nodes, attributes)


def _text(builder: Workspace, nodes: Sequence[Node], values: Values, _: object) -> Plan:
    return changes.set_text(builder.document, nodes[0], values["text"])


def _remove(builder: Workspace, nodes: Sequence[Node], _: Values, __: object) -> Plan:
    return changes.remove(builder.document, nodes)


def _move(builder: Workspace, nodes: Sequence[Node], values: Values, _: object) -> Plan:
    return changes.move(builder.document, nodes, Motion.shift(values["x"], values["y"]))


def _place(builder: Workspace, nodes: Sequence[Node], values: Values, _: object) -> Plan:
    node = nodes[0]
    x_m, y_m = position(builder.document, node)
    turn_rad = 0.0
    if values["heading"] is not None:
        turn_rad = values["heading"] - quantity(node, "heading", ANGLE, 0.0)
    turn = Motion.turn(turn_rad, x_m, y_m)
    to_x = x_m if values["x"] is None else values["x"]
    to_y = y_m if values["y"] is None else values["y"]
    shift = (turn.x_m + to_x - x_m, turn.y_m + to_y - y_m)
    motion = Motion(*shift, turn.xx, turn.xy, turn.yx, turn.yy, turn.turn_rad)
    return changes.move(builder.document, nodes, motion)


def _centre(
    builder: Workspace, nodes: Sequence[Node], x_m: float | None, y_m: float | None
) -> tuple[float, float]:
    """Return a point, by default the middle of elements; of one, its own position."""
    if len(nodes) == 1 and is_mounted(nodes[0]):
        place = mount(nodes[0])
        middle = place.x_m, place.y_m
    elif len(nodes) == 1 and nodes[0].tag not in ("wall", "polygon", "map"):
        middle = position(builder.document, nodes[0])
    else:
        middle = arrangement.around(builder.document, nodes, builder.extents()).centre_m
    return middle[0] if x_m is None else x_m, middle[1] if y_m is None else y_m


def _turn(builder: Workspace, nodes: Sequence[Node], values: Values, _: object) -> Plan:
    centre = _centre(builder, nodes, values["x"], values["y"])
    return changes.move(builder.document, nodes, Motion.turn(values["angle"], *centre))


def _mirror(builder: Workspace, nodes: Sequence[Node], values: Values, _: object) -> Plan:
    swaps_x = values["axis"] == "x"
    at = values["at"]
    centre = _centre(builder, nodes, at if swaps_x else None, None if swaps_x else at)
    motion = Motion.mirror(math.pi / 2 if swaps_x else 0.0, *centre)
    return mirror(builder.document, nodes, motion, builder.library())


def _scale(builder: Workspace, nodes: Sequence[Node], values: Values, _: object) -> Plan:
    centre = _centre(builder, nodes, values["x"], values["y"])
    return scale(builder.document, nodes, values["factor"], centre)


def _array(builder: Workspace, nodes: Sequence[Node], values: Values, _: object) -> Plan:
    counts = values["columns"], values["rows"]
    return arrangement.array(builder.document, nodes, counts, (values["x"], values["y"]))


def _ring(builder: Workspace, nodes: Sequence[Node], values: Values, _: object) -> Plan:
    centre = values["x"], values["y"]
    if all(map(is_sensor, nodes)):
        centre = centre[0] or 0.0, centre[1] or 0.0
    if None in centre:
        raise ValueError("a ring needs the x and y of its centre")
    return arrangement.ring(builder.document, nodes, values["count"], centre)


def _align(builder: Workspace, nodes: Sequence[Node], values: Values, _: object) -> Plan:
    return arrangement.align(builder.document, nodes, values["side"], builder.extents())


def _distribute(builder: Workspace, nodes: Sequence[Node], values: Values, _: object) -> Plan:
    return arrangement.distribute(builder.document, nodes, values["axis"], builder.extents())


def _group(builder: Workspace, nodes: Sequence[Node], values: Values, _: object) -> Plan:
    name, own_id = values["name"], values["id"]
    return composition.group(builder.document, nodes, name, own_id, builder.extents())


def _ungroup(builder: Workspace, nodes: Sequence[Node], _: Values, __: object) -> Plan:
    return composition.ungroup(builder.document, nodes[0])


def _raise(builder: Workspace, _: Sequence[Node], values: Values, __: object) -> Plan:
    world = builder.visible()
    if world is None:
        raise ValueError("there is no ground")
    path = ground.stroke(values["path"])
    return ground.raised(builder.document, world, path, values["radius"], values["rise"])


def _paste(builder: Workspace, _: Sequence[Node], values: Values, __: object) -> Plan:
    motion = Motion.shift(values["x"], values["y"])
    return clips.paste(builder.document, values["clip"], motion, builder.library())


_MAKE: Final[Mapping[str, Callable[[Workspace, list[Node], Values, Attributes], Plan]]] = {
    "add": _add,
    "set": _set,
    "text": _text,
    "remove": _remove,
    "move": _move,
    "place": _place,
    "turn": _turn,
    "mirror": _mirror,
    "scale": _scale,
    "array": _array,
    "ring": _ring,
    "align": _align,
    "distribute": _distribute,
    "group": _group,
    "ungroup": _ungroup,
    "raise": _raise,
    "paste": _paste,
}


def planned(
    builder: Workspace, name: str, nodes: list[Node], values: Values, attributes: Attributes
) -> Plan:
    """Return the changes of an operation.

    Args:
        builder: where it is done.
        name: the operation.
        nodes: the elements on which it acts.
        values: the values of its fields.
        attributes: attributes of elements, as texts; None removes one.

    Raises:
        ValueError: it cannot be done.
    """
    return _MAKE[name](builder, nodes, values, attributes)
