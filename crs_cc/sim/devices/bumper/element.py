"""The switches of bumpers, and their elements in a robot definition, read and written."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from crs_cc.core.quantity import ANGLE
from crs_cc.sim.files.document import Element

if TYPE_CHECKING:
    from crs_cc.sim.files.document import Reader
    from crs_cc.sim.model.robot import RobotModel

BUMPER_BITS: Final = 24
"""The bumpers' state is 3 bytes wide (vendor source `Ndirect.c` 2.7)."""

_TURN: Final = 2 * math.pi
_CLOCKWISE: Final = "clockwise"


@dataclass(frozen=True, slots=True)
class Switch:
    """One switch of a bumper.

    Attributes:
        bit: the bit of the vendor's `State[33]` that it sets.
        bearing_rad: direction of its centre.
        span_rad: the angle that it covers, half of it to each side.
    """

    bit: int
    bearing_rad: float
    span_rad: float


@dataclass(frozen=True, slots=True)
class Switches:
    """The switches of a robot's bumpers.

    Attributes:
        all: the switches.
    """

    all: tuple[Switch, ...]


def switches_of(model: RobotModel) -> tuple[Switch, ...]:
    """Return the switches of a robot, maybe none."""
    found: Switches | None = model.device("bumper")
    return () if found is None else found.all


def read(root: Element, reader: Reader) -> Switches | None:
    """Return the switches of all rings, None for a robot without any; errors go to the reader."""
    rings = root.first("bumpers").all("ring")
    switches = tuple(switch for ring in rings for switch in _ring(ring, reader))
    return Switches(switches) if switches else None


def _ring(ring: Element, reader: Reader) -> list[Switch]:
    count = reader.whole(ring, "switches", 1, BUMPER_BITS, absent=1)
    spacing_rad = reader.positive(ring, "spacing", ANGLE, _TURN / count)
    span_rad = reader.positive(ring, "span", ANGLE, spacing_rad)
    first_rad = reader.quantity(ring, "first", ANGLE)
    side = -1 if ring.attributes.get("direction") == _CLOCKWISE else 1
    bits = [int(bit) for bit in ring.attributes.get("bits", "").split()] or list(range(count))
    if len(bits) != count:
        reader.error(ring, f"bits: expected {count} numbers, one for each switch, not {len(bits)}")
    for bit in bits:
        if bit >= BUMPER_BITS:
            reader.error(ring, f"bits: {bit} is too large (maximum: {BUMPER_BITS - 1})")
    return [
        Switch(bit, (first_rad + side * number * spacing_rad) % _TURN, span_rad)
        for number, bit in enumerate(bits)
    ]


def write(model: RobotModel) -> list[Element]:
    """Return the element that describes the switches of a robot: a ring for each."""
    rings = [
        Element(
            "ring",
            0,
            {
                "switches": "1",
                "first": ANGLE.exact(each.bearing_rad),
                "span": ANGLE.exact(each.span_rad),
                "bits": str(each.bit),
            },
        )
        for each in switches_of(model)
    ]
    return [Element("bumpers", 0, children=rings)] if rings else []
