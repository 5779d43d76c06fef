"""What a kind of robot is made of: constant data, as its definition file says.

A definition has a dataclass for each device. All of it is frozen, compares and hashes by content,
and pickles. Units: metres, seconds, kilograms, radians. Robot frame: x ahead, y to the left, origin
midway between the wheels.

>>> ahead = Sonar(0, x_m=0.2, y_m=0.0, direction_rad=0.0, range_m=6.477, radius_m=1.14)
>>> round(math.degrees(ahead.half_angle_rad))
10
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from crs_cc.sim.sensor_model import (
    ENDLESS,
    ENDLESS_MOTORS,
    USUAL_BOARD,
    Battery,
    MotorBattery,
    SensorBoard,
    Switch,
)


@dataclass(frozen=True, slots=True)
class Sonar:
    """One ultrasonic range sensor.

    Its beam is a cone that starts at the sensor: `range_m` is the height of the cone and
    `radius_m` the radius of its base.

    Attributes:
        id: its number, the index of its reading among the vendor's `STATE_SONAR_0` to `_15`.
        x_m: where it sits in the robot frame, ahead of the axle's middle.
        y_m: the same, to the left.
        direction_rad: where it points, counter-clockwise from ahead.
        range_m: how far it hears.
        radius_m: how wide the beam is at that distance.
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
        return math.atan2(self.radius_m, self.range_m)


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


@dataclass(frozen=True, slots=True)
class Drive:
    """A differential drive, or a synchro drive when there is a steering axis.

    A differential drive has two driven wheels on one axle, and turns with all that is on it. The
    wheels of a synchro drive all run and steer alike, and its base never turns.

    Attributes:
        wheel_base_m: distance between the wheels of a differential drive.
        wheels: each wheel, or the translation of a synchro drive [m].
        steering: the direction of a synchro drive's wheels [rad].
        turret: what turns the sensors above the base of a synchro drive [rad].
        timeout_s: the axes stop when no command came for so long, until the program sets
            another; 0 for never.
        push_n: the force with which the robot pushes against what is in its way.
    """

    wheel_base_m: float = 0.0
    wheels: Axis = Axis(1.0, 2.0, 0.3, 0.5)
    steering: Axis | None = None
    turret: Axis | None = None
    timeout_s: float = 0.0
    push_n: float = 60.0

    @property
    def axes(self) -> tuple[Axis | None, Axis | None, Axis | None]:
        """The vendor's three axes; None for one that the robot does not have."""
        if self.steering is None:
            return self.wheels, self.wheels, None
        return self.wheels, self.steering, self.turret

    @property
    def axis_names(self) -> tuple[str, ...]:
        """What the axes are called, those that the robot has."""
        if self.steering is None:
            return "right", "left"
        return ("translation", "steering", "turret")[: 2 if self.turret is None else 3]


@dataclass(frozen=True, slots=True)
class Heat:
    """What senses heat, and takes it away.

    Attributes:
        range_m: how far it senses, from the robot's middle; 0 when there is no such sensor.
        tag_range_m: how far it takes heat away.
    """

    range_m: float = 0.0
    tag_range_m: float = 0.0


@dataclass(frozen=True, slots=True)
class RobotModel:
    """What a kind of robot is made of, as its definition file says.

    Attributes:
        name: the definition's name.
        radius_m: radius of its round body.
        drive: its wheels.
        mass_kg: its mass.
        sonars: its sonars, by rising id.
        sonar_order: firing order until the program sets another.
        sonar_noise_m: standard deviation of a sonar's error.
        heat: its heat sensor.
        bumpers: the switches of its bumpers.
        computer_battery: what feeds its computers.
        motor_battery: what feeds its motors.
        board: the computer that reads its sensors.
        link_s: time that each command takes on the line between host and robot, by name.
        host_speed_hz: how many IR instructions the host computer runs in a second.
        vendor_model: number of the model, as the vendor's `connect_robot` takes it: 0 a Nomad 200,
            1 a Nomad 150, 2 a Scout.
    """

    name: str
    radius_m: float
    drive: Drive
    mass_kg: float = 20.0
    sonars: tuple[Sonar, ...] = ()
    sonar_order: tuple[int, ...] = ()
    sonar_noise_m: float = 0.0
    heat: Heat = Heat()
    bumpers: tuple[Switch, ...] = ()
    computer_battery: Battery = ENDLESS
    motor_battery: MotorBattery = ENDLESS_MOTORS
    board: SensorBoard = USUAL_BOARD
    link_s: tuple[tuple[str, float], ...] = ()
    host_speed_hz: float = 5e7
    vendor_model: int = 2
