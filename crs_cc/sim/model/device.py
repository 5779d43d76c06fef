"""A device in one row: everything else about it is derived from this.

A row says how the device is called, what its robot definition sets, what it measures, and which C
function reads it. From the rows come the elements and attributes of robot definitions and their
schema, the columns of the state, request codes and handlers, timers, noise streams, degradation,
the declarations of `crs.h`, and the tables of the docs.

A new device is a package in `crs_cc/sim/devices` with a `DEVICE`; a device of one's own is the same
in a package of one's own, named by an entry point of the group `crs_cc.devices`.

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
"""What devices and values may be called: they become names in C and Python."""

ELEMENT: Final = re.compile(r"[a-z][a-z0-9-]{0,31}")


@dataclass(frozen=True, slots=True)
class Attribute:
    """An attribute of a device's element in robot definitions.

    Attributes:
        name: what it is called there.
        kind: what quantity it is.
        default: its value where it is absent, as it would be written.
        meaning: what it means: whole sentences, shown in the schema and its docs.
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
    """Return a dataclass field that an attribute of the device's element sets [SI unit].

    Args:
        name: the attribute.
        kind: what quantity it is.
        default: its value where it is absent, as it would be written, such as `"20Hz"`.
        meaning: what it means, as whole sentences.
        positive: whether it must be greater than 0.
        signed: whether it may be less than 0.
    """
    row = Attribute(name, kind, default, meaning, positive, signed)
    return dataclasses.field(default=kind.parse(default), metadata={"attribute": row})


def rate(default: str) -> Any:
    """Return the field `rate_hz` that every sensor has: how often it measures at most [Hz]."""
    return attribute("rate", FREQUENCY, default, "Maximum measurement rate.", positive=True)


def period() -> Any:
    """Return the field `period_s` that every sensor has: how often it measures by itself [s]."""
    return attribute("period", TIME, "0s", "")


def attributes_of(model: type) -> tuple[Attribute, ...]:
    """Return the attributes of a model's fields, in their order."""
    fields = dataclasses.fields(model)
    return tuple(f.metadata["attribute"] for f in fields if "attribute" in f.metadata)


@dataclass(frozen=True, slots=True)
class Value:
    """One number that a sensor measures.

    Attributes:
        name: its name in C and as an element of degradations, such as `pitch`.
        meaning: what it is, and which sign means what, such as `pitch, nose up`.
    """

    name: str
    meaning: str


Measure = Callable[[Any], "FloatArray"]
"""Measures with some robots' sensors, given a `devices.sensor.Measurement`.

Returns the true values [SI unit], without noise and degradation, in an array of shape (k, values).
"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Device:
    """A sensor that measures a few numbers for its robot, on request or by a timer.

    Attributes:
        name: one word: its function is `crs_<name>`, its number `CRS_SENSOR_<NAME>`, its request
            `<NAME>`; degradations name it so.
        title: what the docs call it, such as `Inclinometer`.
        element: its element in robot definitions.
        summary: what it is, for the schema: one sentence, before what reads it.
        does: what its C function does, for the docs of `crs.h`: `measures ...`.
        model: the dataclass of its constants, whose fields are made by `attribute`, `rate` and
            `period`; it has `rate_hz` and `period_s`, and may have a standard deviation `noise`.
        values: what it measures.
        kind: what quantity its values are: `LENGTH` (0.1 inch in C) or `ANGLE` (0.1 degree).
        measure: how.
        nothing: what comes of a degradation that leaves no value.
        source: the device's file, whose docstring the docs show; it is `__file__` of the package.
        number: its number in `crs.h`; by default the next that is free.
        code: its request's code, given by the registry.
        stream: the number of its stream of noise; by default derived from its name.
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
        """The device's folder, where its own C file may be."""
        return Path(self.source).parent

    def complaint(self) -> str:
        """Return what is wrong with the row; empty if nothing is."""
        if not NAME.fullmatch(self.name) or not ELEMENT.fullmatch(self.element):
            return "its name or element is not a lower-case word"
        if not self.values or not all(NAME.fullmatch(value.name) for value in self.values):
            return "its values need names, lower-case words"
        if len(self.values) > MAX_VALUES:
            return f"it measures more than {MAX_VALUES} values"
        if self.kind.name not in UNITS:
            return "its kind is neither LENGTH nor ANGLE"
        names = {each.name for each in dataclasses.fields(self.model)}
        if not {"rate_hz", "period_s"} <= names:
            return "its model lacks rate_hz or period_s"
        return ""


MAX_VALUES: Final = 8
"""As many integers as a reply has (`requests.door`)."""

UNITS: Final = {LENGTH.name: "0.1 in", ANGLE.name: "0.1 deg"}
"""The units of values in C, by the name of their kind: the vendor's (`Nclient.h`)."""
