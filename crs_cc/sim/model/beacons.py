"""Light and sound sources, and the sensors for them.

Brightness and level are dimensionless: the reading of a sensor that faces the only source from a
distance of 1 m.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

TONES: Final = 8
"""Number of tones, 0 to 7; our choice."""

MAX_LIGHT_SENSORS: Final = 32
"""Maximum number of light sensors of a robot; our choice."""


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


@dataclass(frozen=True, slots=True)
class LightSensors:
    """A ring of light sensors around the mount.

    Attributes:
        number: number of sensors, at equal angles, counter-clockwise.
        first_rad: direction of the first one, relative to the mount's heading.
        range_m: maximum distance at which a light is detected.
        noise: standard deviation of a reading's error, relative to the reading.
        period_s: measuring period by timer; 0 for on request only.
    """

    number: int
    first_rad: float
    range_m: float
    noise: float
    period_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Microphones:
    """Microphones that measure the level and direction of each tone.

    Attributes:
        range_m: maximum distance at which a sound is detected.
        noise: standard deviation of a level's error, relative to the level.
        period_s: measuring period by timer; 0 for on request only.
    """

    range_m: float
    noise: float
    period_s: float = 0.0
