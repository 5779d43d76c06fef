"""Robot models: the constants of a kind of robot.

A model has a dataclass for each device. All of it is frozen, compares and hashes by content, and
pickles. Units: metres, seconds, kilograms, radians. Robot frame: x ahead, y to the left, origin
midway between the wheels.

>>> RobotModel("scout", radius_m=0.2, drive=Drive(wheel_base_m=0.345)).drive.axis_names
('right', 'left')
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Final, Self

from crs_cc.core.distinct import map_distinct
from crs_cc.sim.model.axis import Axis
from crs_cc.sim.model.sensors import (
    USUAL_BOARD,
    SensorBoard,
)

USUAL_WHEELS: Final = Axis(speed_limit=1.0, acceleration_limit=2.0, speed=0.3, acceleration=0.5)


@dataclass(frozen=True, slots=True)
class Drive:
    """A differential drive, or a synchro drive if there is a steering axis.

    A differential drive has two driven wheels on one axle, and turns with the whole robot. The
    wheels of a synchro drive all run and steer alike, and its base never turns.

    Attributes:
        wheel_base_m: distance between the wheels of a differential drive.
        wheels: each wheel, or the translation of a synchro drive [m].
        steering: the steering of a synchro drive [rad].
        turret: the turret of a synchro drive, which carries the sensors [rad].
        timeout_s: default command timeout, after which the axes stop; 0 for none.
        force_n: maximum force of the motors.
        grip_n: traction limit: the force at which the wheels slip.
        roll_out_mps2: deceleration of limp wheels.
        climb_rad: maximum slope; steeper ramps block the robot from below, see `ledges`.
        step_m: the highest step that its wheels climb.
        give_up_s: time after which stalled motors stop; infinite for never.
        waits_forever: whether `ws` with a timeout of 0 waits without end instead of not at all.
    """

    wheel_base_m: float = 0.0
    wheels: Axis = USUAL_WHEELS
    steering: Axis | None = None
    turret: Axis | None = None
    timeout_s: float = 0.0
    force_n: float = 60.0
    grip_n: float = 90.0
    roll_out_mps2: float = 0.3
    climb_rad: float = math.radians(30.0)
    step_m: float = 0.02
    give_up_s: float = math.inf
    waits_forever: bool = False

    @property
    def axes(self) -> tuple[Axis | None, Axis | None, Axis | None]:
        """The vendor's three axes; None for a missing one."""
        if self.steering is None:
            return self.wheels, self.wheels, None
        return self.wheels, self.steering, self.turret

    @property
    def axis_names(self) -> tuple[str, ...]:
        """The names of the axes that the robot has."""
        if self.steering is None:
            return "right", "left"
        return ("translation", "steering", "turret")[: 2 if self.turret is None else 3]


@dataclass(frozen=True, slots=True)
class Odometry:
    """Wheel encoders and systematic and random errors of the odometry.

    Attributes:
        resolution_m: distance for one count of a wheel's encoder; 0 for unlimited resolution.
        resolution_rad: the same for steering and turret.
        scale: ratio of true to assumed distance.
        diameters: ratio of the right wheel's diameter to that of the left one.
        wheel_base: ratio of true to assumed wheel base.
        drift_radpm: rotation of a synchro drive for each metre.
        way_noise_m: standard deviation of the distance after one metre.
        turn_noise_rad: standard deviation of the heading after one metre.
        spin_noise_rad: standard deviation of the heading after a full turn.
    """

    resolution_m: float = 0.0
    resolution_rad: float = 0.0
    scale: float = 1.0
    diameters: float = 1.0
    wheel_base: float = 1.0
    drift_radpm: float = 0.0
    way_noise_m: float = 0.0
    turn_noise_rad: float = 0.0
    spin_noise_rad: float = 0.0


@dataclass(frozen=True, slots=True)
class Link:
    """The serial link between the host and the robot, and the network to the simulator.

    Attributes:
        baud: its default speed [bit/s].
        byte_counts: size of each command with its reply, by name; empty for a robot that is on the
            network itself.
        network_s: time that a request to the simulator and its reply take on the network.
    """

    baud: int
    byte_counts: tuple[tuple[str, int], ...] = ()
    network_s: float = 0.0


IDEAL_LINK: Final = Link(1)
"""A link without delay."""


@dataclass(frozen=True, slots=True)
class RobotModel:
    """All constants of a kind of robot.

    Attributes:
        name: the definition's name.
        radius_m: radius of its round body.
        odometry: its encoders and odometry errors.
        board: the computer that reads its sensors.
        link: the link between host and robot.
        host_speed_hz: IR instructions that the host computer executes per second.
        vendor_model: number of the model in the vendor's `connect_robot`: 0 for a Nomad 200, 1 for
            a Nomad 150, 2 for a Scout.
        height_m: its height; infinite for one that is visible at any height.
        devices: names and models of its devices of `registry.devices()`, kept by rising name.
        definition: where it is from: the name of a built-in definition, or the path of a file;
            empty for a model made in Python. It does not count when models are compared.
        setup: the setup of the definition; empty for none. It does not count either.
    """

    name: str
    radius_m: float
    drive: Drive
    odometry: Odometry = Odometry()
    mass_kg: float = 20.0
    board: SensorBoard = USUAL_BOARD
    link: Link = IDEAL_LINK
    host_speed_hz: float = 5e7
    vendor_model: int = 2
    height_m: float = math.inf
    devices: tuple[tuple[str, Any], ...] = ()
    definition: str = field(default="", compare=False, repr=False)
    setup: str = field(default="", compare=False, repr=False)

    def __post_init__(self) -> None:
        there = (device for device in self.devices if device[1] is not None)
        in_order = tuple(sorted(there, key=lambda device: device[0]))
        object.__setattr__(self, "devices", in_order)  # the class is frozen

    def __hash__(self) -> int:
        return hash(self.name)  # for speed: models are dictionary keys in inner loops

    def with_device(self, name: str, model: Any) -> Self:
        """Return a robot that differs in one device; None removes it."""
        others = tuple(each for each in self.devices if each[0] != name)
        return replace(self, devices=(*others, (name, model)))

    def device(self, name: str) -> Any | None:
        """Return the model of a device of `registry.devices()`, None if the robot lacks it."""
        return next((model for each, model in self.devices if each == name), None)


def devices_of(models: Sequence[RobotModel], name: str) -> list[Any | None]:
    """Return a device of each robot, None for those that lack it."""
    return map_distinct(models, lambda model: model.device(name))
