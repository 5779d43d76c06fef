"""Device descriptions: one row for each device, from which everything else is derived.

A row has the device's name, the attributes of its element in robot definitions, its measured
values, and its C function. From the rows are derived the elements and attributes of robot
definitions and their schema, the columns of the state, request codes and handlers, timers, noise
streams, degradation, the declarations of `crs.h`, and the tables of the docs.

A new device is a package in `crs_cc/sim/devices` with a `DEVICE`; a third-party device is the same
in another package, named by an entry point of the group `crs_cc.devices`.

>>> @dataclass(frozen=True, slots=True)
... class Feeler:
...     range_m: float = attribute("range", LENGTH, "1m", "How far it measures.")
>>> [(each.name, each.default) for each in attributes_of(Feeler)]
[('range', '1m')]
"""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from crs_cc.core.quantity import ANGLE, FREQUENCY, LENGTH, TIME, Kind

if TYPE_CHECKING:
    from crs_cc.core.arrays import FloatArray

NAME: Final = re.compile(r"[a-z][a-z0-9_]{0,31}")
"""Valid names of devices and values: they become names in C and Python."""

RESERVED: Final = frozenset({
    "auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else", "enum",
    "extern", "float", "for", "goto", "if", "inline", "int", "long", "register", "restrict",
    "return", "short", "signed", "sizeof", "static", "struct", "switch", "typedef", "union",
    "unsigned", "void", "volatile", "while", "message",
})  # fmt: skip
"""Names that values cannot have: C keywords (C17 6.4.1), and a variable of the C function."""

ELEMENT: Final = re.compile(r"[a-z][a-z0-9-]{0,31}")


@dataclass(frozen=True, slots=True)
class Attribute:
    """An attribute of a device's element in robot definitions.

    Attributes:
        name: its name there.
        kind: its quantity.
        default: default value, as written in the file.
        meaning: description in whole sentences, shown in the schema and its docs.
        positive: whether it must be greater than 0.
        signed: whether it may be less than 0.
    """

    name: str
    kind: Kind
    default: str
    meaning: str
    positive: bool = False
    signed: bool = False


def attribute(
    name: str,
    kind: Kind,
    default: str,
    meaning: str,
    *,
    positive: bool = False,
    signed: bool = False,
) -> Any:
    """Return a dataclass field that is set by an attribute of the device's element [SI unit].

    Args:
        name: the attribute's name.
        kind: its quantity.
        default: default value, as written in the file, such as `"20Hz"`.
        meaning: description in whole sentences.
        positive: whether it must be greater than 0.
        signed: whether it may be less than 0.
    """
    row = Attribute(name, kind, default, meaning, positive, signed)
    return dataclasses.field(default=kind.parse(default), metadata={"attribute": row})


def rate(default: str) -> Any:
    """Return the field `rate_hz` of every sensor: its maximum measuring rate [Hz]."""
    return attribute("rate", FREQUENCY, default, "Maximum measurement rate.", positive=True)


def period() -> Any:
    """Return the field `period_s` of every sensor: its measuring period by timer [s]."""
    return attribute("period", TIME, "0s", "")


def attributes_of(model: type) -> tuple[Attribute, ...]:
    """Return the attributes of a model's fields, in order."""
    fields = dataclasses.fields(model)
    return tuple(f.metadata["attribute"] for f in fields if "attribute" in f.metadata)


@dataclass(frozen=True, slots=True)
class Value:
    """One number that a sensor measures.

    Attributes:
        name: its name in C and as an element of degradations, such as `pitch`.
        meaning: description, including the sign convention, such as `pitch, nose up`.
    """

    name: str
    meaning: str


Measure = Callable[[Any], "FloatArray"]
"""Measures with the sensors of some robots, given a `devices.sensor.Measurement`.

Returns the true values [SI unit], without noise and degradation, in an array of shape (k, values).
"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Device:
    """A sensor that measures a few numbers for its robot, on request or by a timer.

    Attributes:
        name: one word: its function is `crs_<name>`, its number `CRS_SENSOR_<NAME>`, its request
            `<NAME>`; also its name in degradations.
        title: its title in the docs, such as `Inclinometer`.
        element: its element in robot definitions.
        summary: one sentence for the schema, before the C function that reads it.
        does: description of its C function, for the docs of `crs.h`: `measures ...`.
        model: the dataclass of its constants, whose fields are made by `attribute`, `rate` and
            `period`; it has `rate_hz` and `period_s`, and may have a standard deviation `noise`.
        values: its measured values.
        kind: the quantity of its values: `LENGTH` (0.1 inch in C) or `ANGLE` (0.1 degree).
        measure: the measuring function.
        nothing: effect of a degradation that leaves no value.
        source: the device's file, whose docstring the docs show; it is `__file__` of the package.
        number: its number in `crs.h`; by default the next free one.
        code: its request's code, set by the registry.
        stream: the number of its noise stream; by default derived from its name.
    """

    name: str
    title: str
    element: str
    summary: str
    does: str
    model: type
    values: tuple[Value, ...]
    kind: Kind
    measure: Measure
    nothing: str = "no reading: the request fails"
    source: str = ""
    number: int = -1
    code: int = -1
    stream: int = -1

    @property
    def function(self) -> str:
        """The C function that reads it."""
        return f"crs_{self.name}"

    @property
    def prototype(self) -> str:
        """The C function as its header declares it."""
        arguments = ", ".join(f"int *{value.name}" for value in self.values)
        return f"int {self.function}({arguments})"

    @property
    def unit(self) -> str:
        """The unit of its values in C."""
        return UNITS[self.kind.name]

    @property
    def folder(self) -> Path:
        """The device's folder, which may contain a C file of its own."""
        return Path(self.source).parent

    def complaint(self) -> str:
        """Return why the row is invalid; empty if it is valid."""
        if not NAME.fullmatch(self.name) or not ELEMENT.fullmatch(self.element):
            return "name and element must be lower-case words"
        if not self.values or not all(NAME.fullmatch(value.name) for value in self.values):
            return "the names of its values must be lower-case words"
        values = [value.name for value in self.values]
        if len(set(values)) < len(values) or not RESERVED.isdisjoint(values):
            return "the names of its values must be distinct, and not reserved in C"
        if len(self.values) > MAX_VALUES:
            return f"more than {MAX_VALUES} values"
        if self.kind.name not in UNITS:
            return "kind must be LENGTH or ANGLE"
        names = {each.name for each in dataclasses.fields(self.model)}
        if not {"rate_hz", "period_s"} <= names:
            return "the model lacks rate_hz or period_s"
        return ""


MAX_VALUES: Final = 8
"""Number of integers in a reply (`requests.door`)."""

UNITS: Final = {LENGTH.name: "0.1 in", ANGLE.name: "0.1 deg"}
"""Units of values in C, by the name of their kind: the vendor's (`Nclient.h`)."""
