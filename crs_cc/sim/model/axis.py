"""One axis of a drive: a wheel, the steering, or the turret."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

AXES: Final = 3
"""Number of axes of a robot (vendor header `Nclient.h` 1.29)."""


@dataclass(frozen=True, slots=True)
class Axis:
    """Limits and defaults of one drive axis: in metres for wheels, radians for steering and turret.

    Attributes:
        speed_limit: maximum speed.
        acceleration_limit: maximum acceleration.
        speed: default speed of relative moves.
        acceleration: default acceleration.
    """

    speed_limit: float
    acceleration_limit: float
    speed: float
    acceleration: float


STILL: Final = Axis(1.0, 1.0, 1.0, 1.0)
"""Placeholder in arrays for an axis that a robot does not have; avoids division by zero."""
