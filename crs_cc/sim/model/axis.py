"""One axis of a drive: a wheel, the steering, or the turret."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

AXES: Final = 3
"""How many axes a robot has (vendor header `Nclient.h` 1.29)."""


@dataclass(frozen=True, slots=True)
class Axis:
    """What one axis of a drive can do: in metres for wheels, in radians for steering and turret.

    Attributes:
        speed_limit: the fastest that it can run.
        acceleration_limit: the fastest that its speed can change.
        speed: speed of relative moves until the program sets another.
        acceleration: acceleration until the program sets another.
    """

    speed_limit: float
    acceleration_limit: float
    speed: float
    acceleration: float


STILL: Final = Axis(1.0, 1.0, 1.0, 1.0)
"""Stands in arrays for an axis that a robot does not have, where 0 would be divided by."""
