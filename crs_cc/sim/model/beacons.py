"""What shines and sounds, and what senses it: constant data, as world and robot files say.

Brightness and level have no unit: they are what a sensor tells that is 1 m away from the only
source, and looks at it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

TONES: Final = 8
"""How many tones there are: 0 to 7. Chosen by us."""

MAX_LIGHT_SENSORS: Final = 32
"""The most light sensors of a robot; chosen by us."""


@dataclass(frozen=True, slots=True)
class Light:
    """A light that stands in the world, and is no body."""

    id: str
    x_m: float
    y_m: float
    brightness: float


@dataclass(frozen=True, slots=True)
class Sound:
    """A sound that comes from a place in the world all the time."""

    id: str
    x_m: float
    y_m: float
    level: float
    tone: int


@dataclass(frozen=True, slots=True)
class LightSensors:
    """A ring of light sensors around the mount.

    Attributes:
        number: how many there are, at equal angles, counter-clockwise.
        first_rad: where the first one looks, from ahead.
        range_m: how far away the farthest light is that they sense.
        noise: standard deviation of a reading's error, as a share of the reading.
        period_s: how often they measure by their timer; 0 for when they are asked.
    """

    number: int
    first_rad: float
    range_m: float
    noise: float
    period_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Microphones:
    """What hears tones, and from where they come.

    Attributes:
        range_m: how far away the farthest sound is that they hear.
        noise: standard deviation of a level's error, as a share of the level.
        period_s: how often they measure by their timer; 0 for when they are asked.
    """

    range_m: float
    noise: float
    period_s: float = 0.0
