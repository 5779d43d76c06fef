"""The table of operations: those of the page, the shell and Python, by the same names.

A row states what an operation acts on and its values. `operations` works out what it
changes, `WorldBuilder.apply` does it; the command line makes a subcommand of each row, and the page
sends the name of a row with its values.

>>> OPERATIONS["move"].values({"x": "50cm"})
{'x': 0.5, 'y': 0.0}
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final, Literal, TypeAlias

from crs_cc.core.quantity import ANGLE, LENGTH, Kind
from crs_cc.core.suggest import unknown

SIDES: Final = ("left", "right", "bottom", "top", "centre-x", "centre-y")
"""What can be brought into line."""

Value: TypeAlias = str | float | None
"""A value as it is given: a text with or without a unit, or a number in SI units."""

Values: TypeAlias = dict[str, Any]
"""The values of the fields of an operation, in SI units."""


@dataclass(frozen=True, slots=True)
class Field:
    """A value that an operation takes.

    Attributes:
        name: its name.
        kind: a quantity, a number, a whole number, a text, or the words that are allowed.
        help: what it means.
        default: its default; None if there is one that depends on the elements, or none.
        required: whether it must be given.
    """

    name: str
    kind: type[int | float | str] | Kind | tuple[str, ...]
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
        if self.kind is float:
            return _number(given)
        if isinstance(self.kind, tuple) and given not in self.kind:
            raise ValueError(unknown("word", str(given), self.kind))
        return str(given)


def _number(given: str | float) -> float:
    try:
        value = float(given)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise ValueError(f"{given!r} is not a number")
    return value


@dataclass(frozen=True, slots=True)
class Operation:
    """An operation.

    Attributes:
        name: its name.
        summary: what it does, in one sentence.
        elements: on how many elements it acts.
        fields: the values that it takes.
        attributes: whether it takes attributes of elements besides.
    """

    name: str
    summary: str
    elements: Literal["none", "one", "some"]
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


_X_Y: Final = (
    Field("x", LENGTH, "Distance along x.", 0.0),
    Field("y", LENGTH, "Distance along y.", 0.0),
)
_ABOUT: Final = (
    Field("x", LENGTH, "The centre's x. Default: the middle."),
    Field("y", LENGTH, "The centre's y. Default: the middle."),
)

ROWS: Final = (
    Operation("add", "Add an element with these attributes.", "none", (
        Field("kind", str, "The tag, such as box.", required=True),
        Field("into", str, "The parent element, such as define[table]. Default: the world.", ""),
        Field("text", str, "The text content.", ""),
    ), attributes=True),
    Operation("set", "Set attributes of elements; an empty value removes one.", "some",
              attributes=True),
    Operation("text", "Set the text of an element, such as the number of a sensor.", "one",
              (Field("text", str, "The text.", required=True),)),
    Operation("remove", "Remove elements.", "some"),
    Operation("move", "Move elements.", "some", _X_Y),
    Operation("place", "Move an element to a position.", "one", (
        Field("x", LENGTH, "The new x. Default: unchanged."),
        Field("y", LENGTH, "The new y. Default: unchanged."),
        Field("heading", ANGLE, "The new heading. Default: unchanged."),
    )),
    Operation("turn", "Rotate elements together, counter-clockwise.", "some", (
        Field("angle", ANGLE, "The angle.", required=True), *_ABOUT,
    )),
    Operation("mirror", "Mirror elements; objects get mirrored definitions.", "some", (
        Field("axis", ("x", "y"), "x exchanges left and right, y up and down.", "x"),
        Field("at", LENGTH, "Position of the mirror axis. Default: the middle."),
    )),
    Operation("scale", "Scale elements in x and y; heights are unchanged.", "some", (
        Field("factor", float, "The factor, such as 2 for twice as large.", required=True), *_ABOUT,
    )),
    Operation("array", "Copy elements into columns and rows.", "some", (
        Field("columns", int, "Number of columns, along x.", 1),
        Field("rows", int, "Number of rows, along y.", 1),
        Field("x", LENGTH, "Distance between columns.", 0.0),
        Field("y", LENGTH, "Distance between rows.", 0.0),
    )),
    Operation("ring", "Copy elements around a point, evenly spaced.", "some", (
        Field("count", int, "Number of copies of each, including the original.", required=True),
        Field("x", LENGTH, "The point's x. Default for sonars: the robot's centre."),
        Field("y", LENGTH, "The point's y. Default for sonars: the robot's centre."),
    )),
    Operation("align", "Align sides or centres of elements.", "some", (
        Field("side", SIDES, "The side.", required=True),
    )),
    Operation("distribute", "Space the centres of elements evenly.", "some", (
        Field("axis", ("x", "y"), "The axis.", required=True),
    )),
    Operation("group", "Combine elements into an object: a definition, and one copy of it.", "some",
              (
        Field("name", str, "The name of the definition.", required=True),
        Field("id", str, "The id of the object. Default: the name.", ""),
    )),
    Operation("ungroup", "Replace an object by its parts.", "one"),
    Operation("raise", "Raise the ground along a brush stroke.", "none", (
        Field("path", str, "The points of the stroke, such as 1m,2m 1.5m,2m.", required=True),
        Field("radius", LENGTH, "Radius of the brush.", 0.5),
        Field("rise", LENGTH, "Change of height in the middle; negative to lower it.", 0.05),
    )),
    Operation("paste", "Insert elements that were copied.", "none", (
        Field("clip", str, "The output of copy or cut.", required=True), *_X_Y,
    )),
)  # fmt: skip

OPERATIONS: Final = {row.name: row for row in ROWS}
"""All operations by name."""
