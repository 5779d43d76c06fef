"""The table of operations: what page, shell and Python can do with a world, by the same names.

A row says what an operation acts on and what values it takes. `WorldBuilder.apply` does it, the
command line makes a subcommand of each row, and the page sends the name of a row with its values.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final, Literal, Protocol, TypeAlias

from crs_cc.builder import arrangement, changes, clips, composition
from crs_cc.builder.arrangement import SIDES, Extents
from crs_cc.builder.changes import Plan
from crs_cc.builder.document import Document
from crs_cc.builder.motion import Motion, position, quantity
from crs_cc.builder.spans import Node
from crs_cc.core.quantity import ANGLE, LENGTH, Kind
from crs_cc.core.suggest import unknown

Value: TypeAlias = str | float | None
"""A value as it is given: a text with or without a unit, or a number in SI units."""

Values: TypeAlias = dict[str, Any]
"""The values of the fields of an operation, in SI units."""


class Workspace(Protocol):
    """What operations are done in: a `WorldBuilder`."""

    document: Document

    def element(self, name: str) -> Node:
        """Return an element."""

    def extents(self) -> Extents:
        """Return what elements cover."""

    def library(self) -> list[Document]:
        """Return the included files."""


@dataclass(frozen=True, slots=True)
class Field:
    """A value that an operation takes.

    Attributes:
        name: its name.
        kind: a quantity, a whole number, a text, or the words that are allowed.
        help: what it means.
        default: its default; None if there is one that depends on the elements, or none.
        required: whether it must be given.
    """

    name: str
    kind: type[int | str] | Kind | tuple[str, ...]
    help: str
    default: float | int | str | None = None
    required: bool = False

    def value(self, given: Value) -> float | int | str | None:
        """Return a value as it is given in SI units.

        Raises:
            ValueError: it is invalid.
        """
        if given is None:
            if self.required:
                raise ValueError(f"missing value {self.name!r}: {self.help}")
            return self.default
        try:
            return self._value(given)
        except ValueError as wrong:
            raise ValueError(f"{self.name}: {wrong}") from None

    def _value(self, given: str | float) -> float | int | str:
        if isinstance(self.kind, Kind):
            if isinstance(given, str):
                return self.kind.parse(given)
            if not math.isfinite(given) or abs(given) > self.kind.limit:
                raise ValueError(f"{given!r} is not {self.kind.name}")
            return float(given)
        if self.kind is int:
            text = str(given).strip()
            if not text.isdecimal() or len(text) > 9:
                raise ValueError(f"{given!r} is not a whole number")
            return int(text)
        if isinstance(self.kind, tuple) and given not in self.kind:
            raise ValueError(unknown("word", str(given), self.kind))
        return str(given)


@dataclass(frozen=True, slots=True)
class Operation:
    """An operation.

    Attributes:
        name: its name.
        summary: what it does, in one sentence.
        things: on how many elements it acts.
        make: works out the change.
        fields: the values that it takes.
        attributes: whether it takes attributes of elements besides.
    """

    name: str
    summary: str
    things: Literal["none", "one", "some"]
    make: Callable[[Workspace, list[Node], Values, Mapping[str, str | None]], Plan]
    fields: tuple[Field, ...] = ()
    attributes: bool = False

    def values(self, given: Mapping[str, Value]) -> Values:
        """Return the values of all fields in SI units.

        Raises:
            ValueError: one is invalid, unknown or missing.
        """
        names = [field.name for field in self.fields]
        for name in given:
            if name not in names:
                raise ValueError(unknown(f"value of {self.name}", name, names))
        return {field.name: field.value(given.get(field.name)) for field in self.fields}


def _add(
    builder: Workspace, _: Sequence[Node], values: Values, attributes: Mapping[str, str | None]
) -> Plan:
    parent = builder.element(values["into"])
    given = {name: text for name, text in attributes.items() if text is not None}
    return changes.add(builder.document, parent, values["kind"], given, values["text"])


def _set(
    builder: Workspace, nodes: Sequence[Node], _: Values, attributes: Mapping[str, str | None]
) -> Plan:
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
    if len(nodes) == 1 and nodes[0].tag not in ("wall", "polygon", "map"):
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
    return changes.move(builder.document, nodes, motion)


def _array(builder: Workspace, nodes: Sequence[Node], values: Values, _: object) -> Plan:
    counts = values["columns"], values["rows"]
    return arrangement.array(builder.document, nodes, counts, (values["x"], values["y"]))


def _ring(builder: Workspace, nodes: Sequence[Node], values: Values, _: object) -> Plan:
    centre = values["x"], values["y"]
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


def _paste(builder: Workspace, _: Sequence[Node], values: Values, __: object) -> Plan:
    motion = Motion.shift(values["x"], values["y"])
    return clips.paste(builder.document, values["clip"], motion, builder.library())


_X_Y: Final = (
    Field("x", LENGTH, "By how much along x.", 0.0),
    Field("y", LENGTH, "By how much along y.", 0.0),
)
_ABOUT: Final = (
    Field("x", LENGTH, "About this x. Default: the middle."),
    Field("y", LENGTH, "About this y. Default: the middle."),
)

ROWS: Final = (
    Operation("add", "Add an element with these attributes.", "none", _add, (
        Field("kind", str, "Its tag, such as box.", required=True),
        Field("into", str, "The element around it, such as define[table]. Default: the world.", ""),
        Field("text", str, "Its own text.", ""),
    ), attributes=True),
    Operation("set", "Set attributes of elements; an empty one is removed.", "some", _set,
              attributes=True),
    Operation("text", "Set the text of an element, such as the number of a sensor.", "one", _text,
              (Field("text", str, "The text.", required=True),)),
    Operation("remove", "Remove elements.", "some", _remove),
    Operation("move", "Move elements.", "some", _move, _X_Y),
    Operation("place", "Put an element at a place.", "one", _place, (
        Field("x", LENGTH, "Its new x. Default: as it is."),
        Field("y", LENGTH, "Its new y. Default: as it is."),
        Field("heading", ANGLE, "Its new heading. Default: as it is."),
    )),
    Operation("turn", "Turn elements as one body, counter-clockwise.", "some", _turn, (
        Field("angle", ANGLE, "By how much.", required=True), *_ABOUT,
    )),
    Operation("mirror", "Mirror elements; an object of parts and a robot keep their shape.", "some",
              _mirror, (
        Field("axis", ("x", "y"), "x exchanges left and right, y up and down.", "x"),
        Field("at", LENGTH, "Where the mirror stands. Default: in the middle."),
    )),
    Operation("array", "Copy elements into columns and rows.", "some", _array, (
        Field("columns", int, "How many along x.", 1),
        Field("rows", int, "How many along y.", 1),
        Field("x", LENGTH, "From one column to the next.", 0.0),
        Field("y", LENGTH, "From one row to the next.", 0.0),
    )),
    Operation("ring", "Copy elements around a point, evenly spaced.", "some", _ring, (
        Field("count", int, "How many there will be of each.", required=True),
        Field("x", LENGTH, "The point's x.", required=True),
        Field("y", LENGTH, "The point's y.", required=True),
    )),
    Operation("align", "Bring sides or centres of elements into line.", "some", _align, (
        Field("side", SIDES, "Which.", required=True),
    )),
    Operation("distribute", "Space the centres of elements evenly.", "some", _distribute, (
        Field("axis", ("x", "y"), "Along which axis.", required=True),
    )),
    Operation("group", "Make elements an object: a definition, and one copy of it.", "some", _group,
              (
        Field("name", str, "The name of the definition.", required=True),
        Field("id", str, "The id of the object. Default: the name.", ""),
    )),
    Operation("ungroup", "Put the parts of an object in its place.", "one", _ungroup),
    Operation("paste", "Put in elements that were copied.", "none", _paste, (
        Field("clip", str, "What copy or cut has returned.", required=True), *_X_Y,
    )),
)  # fmt: skip

OPERATIONS: Final = {row.name: row for row in ROWS}
"""All operations by name."""
