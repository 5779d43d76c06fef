"""What the sensors of a kind of robot are made of: constant data, as its definition file says.

Sonars are in `sonar_model`, light sensors and microphones in `beacon_model`. Units: metres,
seconds, radians; directions count counter-clockwise from ahead.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

MAX_INFRARED: Final = 16
"""The vendor's `State` array has 16 places for them (vendor header `Nclient.h` 1.29)."""

NUM_LASER: Final = 482
"""The most points that a laser can tell (vendor header `Nclient.h` 1.29)."""

MAX_COLUMNS: Final = 320
"""The most columns of a camera; chosen by us."""


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


@dataclass(frozen=True, slots=True)
class Infrared:
    """Sixteen infrared sensors around the mount, on the robot's shell.

    Attributes:
        step_m: the distance of a white surface for each 1 of a reading.
        half_angle_rad: the angle between the axis of a beam and its side.
        reflectance: how much light surfaces reflect, up to 1 for all of it.
        rate_hz: how often they measure at most.
        noise_m: standard deviation of a distance's error.
        share: how much of a reading stays in the next, until the program sets another.
        order: the sensors that measure, until the program sets others.
        z_m: how high above the ground its beams run.
        period_s: how often they measure by their timer; 0 for when they are asked.
    """

    step_m: float
    half_angle_rad: float
    reflectance: float
    rate_hz: float
    noise_m: float
    share: float
    order: tuple[int, ...]
    z_m: float = 0.2
    period_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Compass:
    """A compass.

    Attributes:
        offset_rad: what it shows of the world's x axis.
        deviation_rad: the largest error that iron on the robot causes, until it is calibrated.
        calibration_s: how long it takes to turn around for that.
        rate_hz: how often it measures at most.
        noise_rad: standard deviation of a reading's error.
        is_on: whether it is switched on at the start.
        period_s: how often it measures by its timer; 0 for when it is asked.
    """

    offset_rad: float
    deviation_rad: float
    calibration_s: float
    rate_hz: float
    noise_rad: float
    is_on: bool
    period_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Laser:
    """A laser that measures distances in its plane.

    Attributes:
        points: how many there are at most.
        field_of_view_rad: the angle that they cover, half of it to each side.
        range_m: how far it sees.
        forward_m: where it sits, ahead of the middle of the mount.
        rate_hz: how often it looks at most.
        noise_m: standard deviation of a distance's error at a distance of 1 m.
        mode: the vendor's mode at the start; 0 for off.
        z_m: how high above the ground its beams run.
        period_s: how often it measures by its timer; 0 for when it is asked.
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
    """A camera that sees a row of colours and ranges, on the mount.

    Attributes:
        columns: how many pixels the row has.
        field_of_view_rad: the angle that they cover, half of it to each side.
        range_m: how far it sees.
        x_m: where it sits, ahead of the middle of the mount.
        y_m: the same, to the left.
        direction_rad: where it looks.
        rate_hz: how often it looks at most.
        noise_m: standard deviation of a range's error at a distance of 1 m.
        background: red, green and blue of a column in which there is nothing, 0 to 255.
        z_m: how high above the ground its beams run.
        period_s: how often it measures by its timer; 0 for when it is asked.
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
class Battery:
    """A battery and what it feeds.

    Attributes:
        capacity_j: the energy in it when it is full; infinite for one that lasts for ever.
        charge: the share of it that is there at the start, 0 to 1.
        power_w: what is used all the time.
        curve_v: its voltage, for charges from empty to full at equal distances.
    """

    capacity_j: float = math.inf
    charge: float = 1.0
    power_w: float = 0.0
    curve_v: tuple[float, ...] = (12.0,)


@dataclass(frozen=True, slots=True)
class MotorBattery(Battery):
    """The battery that moves the robot: a `Battery` with more.

    Attributes:
        friction_n: force that a wheel works against while it turns.
        efficiency: the share of the energy used for moving that arrives at the wheels.
        stall_w: what is used besides while something holds the robot back.
        cutoff_v: below this voltage the motors have no force.
        is_in_status: whether bits 2 and 3 of the motors' status tell its charge.
    """

    friction_n: float = 0.0
    efficiency: float = 1.0
    stall_w: float = 0.0
    cutoff_v: float = 0.0
    is_in_status: bool = False


@dataclass(frozen=True, slots=True)
class SensorBoard:
    """The computer on the robot that reads the sensors.

    Attributes:
        start_s: what its clock shows at the start.
        tick_s: the step of its clock.
    """

    start_s: float = 0.0
    tick_s: float = 0.0164


ENDLESS: Final = Battery()
ENDLESS_MOTORS: Final = MotorBattery()
USUAL_BOARD: Final = SensorBoard()
"""What a robot has whose definition does not say."""
