"""Sonars of a kind of robot.

Units: metres, seconds, radians. Robot frame: x ahead, y to the left, origin midway between the
wheels.

>>> ahead = Sonar(0, x_m=0.2, y_m=0.0, direction_rad=0.0, range_m=6.477, radius_m=1.14)
>>> round(math.degrees(ahead.half_angle_rad))
10
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from crs_cc.sim.kernels import exact

if TYPE_CHECKING:
    from crs_cc.sim.model.robot import RobotModel

MAX_SONARS: Final = 16
"""Number of sonars in the vendor's `State` array (vendor header `Nclient.h` 1.29)."""

SONAR_TICK_S: Final = 0.004
"""The unit of `conf_sn`'s rate (vendor header `Nclient.h` 1.29)."""


@dataclass(frozen=True, slots=True)
class Sonar:
    """One ultrasonic range sensor.

    Its beam is a cone that starts at the sensor: `range_m` is the height of the cone and
    `radius_m` the radius of its base.

    Attributes:
        id: its number, the index of its reading among the vendor's `STATE_SONAR_0` to `_15`.
        x_m: its position in the robot frame, ahead of the axle's centre.
        y_m: its position to the left of the axle's centre.
        direction_rad: its direction, counter-clockwise from ahead.
        range_m: maximum range.
        radius_m: radius of the beam at that distance.
        z_m: its height above the floor.
    """

    id: int
    x_m: float
    y_m: float
    direction_rad: float
    range_m: float
    radius_m: float
    z_m: float = 0.0

    @property
    def half_angle_rad(self) -> float:
        """The angle between the axis of the beam and its side."""
        return exact.arctan2(self.radius_m, self.range_m)


@dataclass(frozen=True, slots=True)
class SonarBoard:
    """Properties common to all sonars of a robot; see `devices.sonar` and the files it names.

    Attributes:
        order: default firing order.
        interval_s: default time from one firing to the next.
        least_interval_s: the shortest interval that a program can set.
        lobe_rad: angle off the axis at which the sound pressure falls to one half; 0 for a cone
            with uniform pressure.
        critical_rad: the largest angle of incidence at which a face returns an echo.
        blind_m: the distance below which the transducer still rings when the echo arrives.
        minimum_m: minimum reading.
        noise_m: standard deviation of a reading.
        noise_share: distance-proportional part of the standard deviation, relative to the distance.
        dropouts: probability of missing an echo.
        crosstalk: probability of taking another robot's ping for an echo, if it arrives in time.
        resolution_m: resolution of readings; 0 for unlimited.
    """

    order: tuple[int, ...] = ()
    interval_s: float = 0.06
    least_interval_s: float = 0.04
    lobe_rad: float = 0.0
    critical_rad: float = math.pi / 2
    blind_m: float = 0.0
    minimum_m: float = 0.0
    noise_m: float = 0.0
    noise_share: float = 0.0
    dropouts: float = 0.0
    crosstalk: float = 0.0
    resolution_m: float = 0.0


NO_SONARS: Final = SonarBoard()
"""Properties of a robot without sonars."""


@dataclass(frozen=True, slots=True)
class SonarMode:
    """A mode of a robot's sonars, such as far and coarse, or near and fine.

    Attributes:
        sonars: the sonars, with range and beam of the mode.
        board: their common properties; order and intervals are the same in all modes.
    """

    name: str
    sonars: tuple[Sonar, ...]
    board: SonarBoard


@dataclass(frozen=True, slots=True)
class Sonars:
    """All sonars of a robot.

    Attributes:
        sonars: the sonars, by rising id.
        board: their common properties.
        own_modes: their modes; empty if there is only one.
    """

    sonars: tuple[Sonar, ...]
    board: SonarBoard = NO_SONARS
    own_modes: tuple[SonarMode, ...] = ()

    @property
    def modes(self) -> tuple[SonarMode, ...]:
        """The modes, at least one."""
        return self.own_modes or (SonarMode("", self.sonars, self.board),)


NONE: Final = Sonars(())
"""The sonars of a robot that has none."""


def sonars_of(model: RobotModel) -> Sonars:
    """Return the sonars of a robot, maybe none."""
    found: Sonars | None = model.device("sonar")
    return NONE if found is None else found
