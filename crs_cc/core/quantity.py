"""Numbers with units, as written in world and robot files.

>>> LENGTH.parse("150cm"), LENGTH.parse("1.5"), round(LENGTH.parse("60 in"), 6)
(1.5, 1.5, 1.524)
>>> round(ANGLE.parse("90"), 6), ANGLE.parse("1.57rad")
(1.570796, 1.57)
>>> LENGTH.parse("2 lb")
Traceback (most recent call last):
ValueError: '2 lb' is not a length (expected a number and one of m, cm, mm, in, ft, such as 1.5m)
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import Final

from crs_cc.core.units import INCH_M, inch_to_m

_QUANTITY: Final = re.compile(
    r"\s*([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?)\s*([A-Za-z][A-Za-z0-9/]*)?\s*"
)
_MAX_TEXT: Final = 64


@dataclass(frozen=True, slots=True)
class Kind:
    """A kind of quantity.

    Attributes:
        name: its name in messages, with an article.
        units: the value of each unit in the SI unit.
        default: the unit of a bare number.
        example: an example value for messages.
        limit: the largest magnitude accepted [SI unit].
    """

    name: str
    units: tuple[tuple[str, float], ...]
    default: str
    example: str
    limit: float

    def parse(self, text: str, default: str = "") -> float:
        """Parse a text to a value [SI unit].

        Args:
            text: a number, with or without a unit.
            default: the unit of a bare number; by default the kind's.

        Raises:
            ValueError: the text is not such a quantity, or is out of range.
        """
        match = _QUANTITY.fullmatch(text) if len(text) <= _MAX_TEXT else None
        factor = dict(self.units).get(match[2] or default or self.default) if match else None
        if match is None or factor is None:
            shown = text if len(text) <= _MAX_TEXT else text[:_MAX_TEXT] + "..."
            names = ", ".join(name for name, _ in self.units)
            unit = f" and one of {names}" if names else ""
            raise ValueError(
                f"{shown!r} is not {self.name} (expected a number{unit}, such as {self.example})"
            )
        value = float(match[1]) * factor
        if abs(value) > self.limit:
            raise ValueError(f"{text!r} is too large for {self.name} here")
        return value

    def show(self, value: float) -> str:
        """Format a value [SI unit] in the unit of a bare number.

        >>> ANGLE.show(math.pi / 2), RATIO.show(0.5)
        ('90deg', '0.5')
        """
        return f"{value / dict(self.units)[self.default]:g}{self.default}"

    def exact(self, value: float) -> str:
        """Return a short text that `parse` turns into exactly this value [SI unit].

        >>> LENGTH.exact(0.3), ANGLE.exact(math.pi / 2), ANGLE.exact(1.2), TIME.exact(1 / 3)
        ('0.3m', '90deg', '1.2rad', '0.3333333333333333s')
        """
        value = float(value) + 0.0  # no negative zero
        for unit, factor in sorted(self.units, key=lambda each: each[0] != self.default):
            text = f"{value / factor:.12g}"
            if float(text) * factor == value:
                return text + unit
        unit = next(unit for unit, factor in self.units if factor == 1.0)
        return f"{value!r}{unit}"


LENGTH: Final = Kind(
    "a length",
    (("m", 1.0), ("cm", 0.01), ("mm", 0.001), ("in", INCH_M), ("ft", inch_to_m(12.0))),
    "m", "1.5m", 1e4,
)  # fmt: skip
ANGLE: Final = Kind("an angle", (("deg", math.pi / 180), ("rad", 1.0)), "deg", "90deg", 1e4)
TIME: Final = Kind("a time", (("s", 1.0), ("ms", 0.001)), "s", "0.05s", 1e7)
MASS: Final = Kind("a mass", (("kg", 1.0), ("g", 0.001), ("lb", 0.45359237)), "kg", "2.5kg", 1e6)
SPEED: Final = Kind(
    "a speed", (("m/s", 1.0), ("cm/s", 0.01), ("in/s", INCH_M)), "m/s", "0.3m/s", 100.0
)
ACCELERATION: Final = Kind(
    "an acceleration",
    (("m/s2", 1.0), ("cm/s2", 0.01), ("in/s2", INCH_M)),
    "m/s2", "0.5m/s2", 1e3,
)  # fmt: skip
TURN_RATE: Final = Kind(
    "an angular speed", (("deg/s", math.pi / 180), ("rad/s", 1.0)), "deg/s", "45deg/s", 1e3
)
TURN_ACCELERATION: Final = Kind(
    "an angular acceleration",
    (("deg/s2", math.pi / 180), ("rad/s2", 1.0)),
    "deg/s2", "50deg/s2", 1e4,
)  # fmt: skip
FORCE: Final = Kind("a force", (("N", 1.0),), "N", "60N", 1e6)
POWER: Final = Kind("a power", (("W", 1.0), ("kW", 1e3)), "W", "25W", 1e6)
ENERGY: Final = Kind("an energy", (("J", 1.0), ("Wh", 3600.0)), "J", "200Wh", 1e12)
VOLTAGE: Final = Kind("a voltage", (("V", 1.0),), "V", "12.5V", 1e3)
FREQUENCY: Final = Kind(
    "a frequency", (("Hz", 1.0), ("kHz", 1e3), ("MHz", 1e6), ("GHz", 1e9)), "Hz", "50MHz", 1e12
)
DATA_RATE: Final = Kind(
    "a data rate",
    (("B/s", 1.0), ("kB/s", 1e3), ("MB/s", 1e6), ("bit/s", 0.125), ("kbit/s", 125.0),
     ("Mbit/s", 125e3)),
    "B/s", "1200B/s", 1e12,
)  # fmt: skip
"""In bytes per second."""

RATIO: Final = Kind("a ratio", (("", 1.0),), "", "1.002", 1e3)
HEAT: Final = Kind("a heat", (("", 1.0),), "", "1", 1e6)
"""Heat of an object, dimensionless."""
BRIGHTNESS: Final = Kind("a brightness", (("", 1.0),), "", "100", 1e6)
LOUDNESS: Final = Kind("a level", (("", 1.0),), "", "100", 1e6)
"""Brightness and loudness of sources at a distance of 1 m, dimensionless."""
AMOUNT: Final = Kind("an amount", (("", 1.0),), "", "100", 1e6)
"""Amount of pheromone in a cell of a field, dimensionless."""
DIFFUSIVITY: Final = Kind(
    "a diffusion coefficient", (("m2/s", 1.0), ("cm2/s", 1e-4)), "m2/s", "2cm2/s", 1e3
)


def round_length(length_m: float) -> float:
    """Return the largest of 1, 2 and 5 times a power of ten that is not longer.

    >>> [round_length(length) for length in (0.9, 3.0, 77.0)]
    [0.5, 2.0, 50.0]
    """
    power = 10.0 ** math.floor(math.log10(length_m))
    return next(step * power for step in (5.0, 2.0, 1.0) if step * power <= length_m * (1 + 1e-9))
