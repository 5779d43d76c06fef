"""Light and sound sources of a world.

Brightness and level are dimensionless: the reading of a sensor that faces the only source from a
distance of 1 m.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

TONES: Final = 8
"""Number of tones, 0 to 7; our choice."""


@dataclass(frozen=True, slots=True)
class Light:
    """A light source at a fixed position; it is not a solid."""

    id: str
    x_m: float
    y_m: float
    brightness: float


@dataclass(frozen=True, slots=True)
class Sound:
    """A continuous sound source at a fixed position."""

    id: str
    x_m: float
    y_m: float
    level: float
    tone: int
