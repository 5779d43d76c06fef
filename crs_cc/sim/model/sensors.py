"""Sensors of a kind of robot.

Sonars are in `model.sonar`, light sensors and microphones in `model.beacons`. Units: metres,
seconds, radians; directions are counter-clockwise from ahead.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

NUM_LASER: Final = 482
"""Maximum number of points of a laser (vendor header `Nclient.h` 1.29)."""

MAX_COLUMNS: Final = 320
"""Maximum number of columns of a camera; our choice."""


@dataclass(frozen=True, slots=True)
class Laser:
    """A laser that measures distances in its plane.

    Attributes:
        points: maximum number of points.
        field_of_view_rad: the angle that they cover, half of it to each side.
        range_m: maximum range.
        forward_m: its distance ahead of the mount's centre.
        rate_hz: maximum measuring rate.
        noise_m: standard deviation of a distance's error at a distance of 1 m.
        mode: the vendor's mode at the start; 0 for off.
        z_m: height of its beams above the ground.
        period_s: measuring period by timer; 0 for on request only.
    """

    points: int
    field_of_view_rad: float
    range_m: float
    forward_m: float
    rate_hz: float
    noise_m: float
    mode: int
    z_m: float = 0.3
    period_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Camera:
    """A camera on the mount that measures a row of colours and ranges.

    Attributes:
        columns: pixels in the row.
        field_of_view_rad: the angle that they cover, half of it to each side.
        range_m: maximum range.
        x_m: its position ahead of the mount's centre.
        y_m: its position to the left of the mount's centre.
        direction_rad: direction of its axis.
        rate_hz: maximum measuring rate.
        noise_m: standard deviation of a range's error at a distance of 1 m.
        background: red, green and blue of a column without an object, 0 to 255.
        z_m: height of its beams above the ground.
        period_s: measuring period by timer; 0 for on request only.
    """

    columns: int
    field_of_view_rad: float
    range_m: float
    x_m: float = 0.0
    y_m: float = 0.0
    direction_rad: float = 0.0
    rate_hz: float = 30.0
    noise_m: float = 0.0
    background: tuple[int, int, int] = (0, 0, 0)
    z_m: float = 0.3
    period_s: float = 0.0


@dataclass(frozen=True, slots=True)
class SensorBoard:
    """The computer on the robot that reads the sensors.

    Attributes:
        start_s: its clock at the start.
        tick_s: the resolution of its clock.
    """

    start_s: float = 0.0
    tick_s: float = 0.0164


USUAL_BOARD: Final = SensorBoard()
"""Defaults of a robot definition."""
