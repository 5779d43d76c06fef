"""Attributes of a device's element in robot definitions: fields of the dataclass of its constants.

>>> @dataclass(frozen=True, slots=True)
... class Feeler:
...     range_m: float = attribute("range", LENGTH, "1m", "How far it measures.")
>>> [(each.name, each.default) for each in attributes_of(Feeler)]
[('range', '1m')]
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from decimal import Decimal
from typing import Any, Final, TypeAlias

from crs_cc.core.quantity import FREQUENCY, LENGTH, TIME, Kind
from crs_cc.sim.model.colours import hexadecimal, rgb

__all__ = [
    "COLOUR",
    "FRACTION",
    "LENGTH",
    "SHARE",
    "Attribute",
    "Choice",
    "Colour",
    "Count",
    "Numbers",
    "Voltages",
    "attribute",
    "attributes_of",
    "period",
    "rate",
]


@dataclass(frozen=True, slots=True)
class Count:
    """Integers in a range, both ends included."""

    least: int
    most: int

    def parse(self, text: str) -> int:
        """Return the value of a text that the schema allows."""
        return int(text)

    def exact(self, value: int) -> str:
        """Return the text of a value."""
        return str(value)


@dataclass(frozen=True, slots=True)
class Choice:
    """One of several words.

    Attributes:
        values: each word and its value.
    """

    values: tuple[tuple[str, Any], ...]

    def parse(self, text: str) -> Any:
        """Return the value of a word that the schema allows."""
        return dict(self.values)[text]

    def exact(self, value: Any) -> str:
        """Return the word of a value; raise ValueError if it has none."""
        for word, each in self.values:
            if each == value:
                return word
        known = ", ".join(repr(each) for _, each in self.values)
        raise ValueError(f"{value!r} is not one of {known}")


@dataclass(frozen=True, slots=True)
class Fraction:
    """Numbers from 0 to 1.

    Attributes:
        positive: whether 0 is invalid.
    """

    positive: bool = False

    def parse(self, text: str) -> float:
        """Return the value of a text that the schema allows."""
        return float(text)

    def exact(self, value: float) -> str:
        """Return the text of a value; the schema allows nine decimals.

        >>> FRACTION.exact(0.25), FRACTION.exact(1e-7), FRACTION.exact(1.0)
        ('0.25', '0.0000001', '1.0')
        """
        return _decimal(value)


FRACTION: Final = Fraction()
SHARE: Final = Fraction(positive=True)


@dataclass(frozen=True, slots=True)
class Numbers:
    """Lists of sensor numbers.

    Attributes:
        most: maximum length.
    """

    most: int

    def parse(self, text: str) -> tuple[int, ...]:
        """Return the value of a text that the schema allows."""
        return tuple(int(number) for number in text.split())

    def exact(self, value: Sequence[int]) -> str:
        """Return the text of a value."""
        return " ".join(map(str, value))


@dataclass(frozen=True, slots=True)
class Voltages:
    """Lists of at least one voltage, bare numbers.

    Attributes:
        most: maximum length.
    """

    most: int

    def parse(self, text: str) -> tuple[float, ...]:
        """Return the value of a text that the schema allows."""
        return tuple(float(volts) for volts in text.split())

    def exact(self, value: Sequence[float]) -> str:
        """Return the text of a value."""
        return " ".join(map(_decimal, value))


@dataclass(frozen=True, slots=True)
class Colour:
    """Colours: names, or #rrggbb."""

    def parse(self, text: str) -> tuple[int, int, int]:
        """Return red, green and blue, 0 to 255; raise ValueError if the text is not a colour."""
        return rgb(text)

    def exact(self, value: tuple[int, int, int]) -> str:
        """Return the text of a value."""
        return hexadecimal(value)


COLOUR: Final = Colour()


def _decimal(value: float) -> str:
    """Return the exact text of a number without an exponent, as of `xs:decimal`."""
    return f"{Decimal(repr(float(value))):f}"


Values: TypeAlias = Kind | Count | Choice | Fraction | Numbers | Voltages | Colour
"""Which values an attribute can have."""


@dataclass(frozen=True, slots=True)
class Attribute:
    """An attribute of a device's element in robot definitions.

    Attributes:
        name: its name there.
        values: its quantity, or its possible values.
        default: default value, as written in the file; None if it is required, empty if the
            device has a `read` that knows it.
        meaning: description in whole sentences, shown in the schema and its docs.
        positive: whether a quantity must be greater than 0.
        signed: whether a quantity may be less than 0.
        most: largest value of a quantity, as written in the file; empty for no limit.
    """

    name: str
    values: Values
    default: str | None
    meaning: str
    positive: bool = False
    signed: bool = False
    most: str = ""


def attribute(
    name: str,
    values: Values,
    default: str | None,
    meaning: str,
    *,
    positive: bool = False,
    signed: bool = False,
    most: str = "",
) -> Any:
    """Return a dataclass field that is set by an attribute of the device's element [SI unit].

    Args:
        name: the attribute's name.
        values: its quantity, or its possible values.
        default: default value, as written in the file, such as `"20Hz"`; None if it is required,
            empty if the device has a `read` that knows it.
        meaning: description in whole sentences.
        positive: whether a quantity must be greater than 0.
        signed: whether a quantity may be less than 0.
        most: largest value of a quantity, as written in the file; empty for no limit.
    """
    metadata = {"attribute": Attribute(name, values, default, meaning, positive, signed, most)}
    if not default:
        return dataclasses.field(metadata=metadata)
    return dataclasses.field(default=values.parse(default), metadata=metadata)


def rate(default: str | None) -> Any:
    """Return the field `rate_hz` of a sensor: its maximum measuring rate [Hz]."""
    return attribute("rate", FREQUENCY, default, "Maximum measurement rate.", positive=True)


def period() -> Any:
    """Return the field `period_s` of a sensor: its measuring period by timer [s]."""
    return attribute("period", TIME, "0s", "")


def attributes_of(model: type) -> tuple[Attribute, ...]:
    """Return the attributes of a model's fields, in order."""
    fields = dataclasses.fields(model)
    return tuple(f.metadata["attribute"] for f in fields if "attribute" in f.metadata)
