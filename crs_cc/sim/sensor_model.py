"""What the sensors of a kind of robot are made of: constant data, as its definition file says.

Sonars are in `robot_model`. Units: metres, seconds, radians; directions count counter-clockwise
from ahead.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Switch:
    """One switch of a bumper.

    Attributes:
        bit: which bit of the vendor's `State[33]` it sets.
        bearing_rad: where its middle is.
        span_rad: the angle that it covers, half of it to each side.
    """

    bit: int
    bearing_rad: float
    span_rad: float
