"""What a kind of robot is made of: constant data, as its definition file says.

A definition has a dataclass for each device. All of it is frozen, compares and hashes by content,
and pickles. Units: metres, seconds, kilograms, radians. Robot frame: x ahead, y to the left, origin
midway between the wheels.

>>> RobotModel("scout", radius_m=0.2, drive=Drive(wheel_base_m=0.345)).drive.axis_names
('right', 'left')
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

from crs_cc.sim.model.axis import Axis
from crs_cc.sim.model.beacons import LightSensors, Microphones
from crs_cc.sim.model.handling import Arm, Gripper
from crs_cc.sim.model.sensors import (
    ENDLESS,
    ENDLESS_MOTORS,
    USUAL_BOARD,
    Battery,
    Camera,
    Compass,
    Infrared,
    Laser,
    MotorBattery,
    SensorBoard,
    Switch,
)
from crs_cc.sim.model.sonar import NO_SONARS, Sonar, SonarBoard, SonarMode

USUAL_WHEELS: Final = Axis(speed_limit=1.0, acceleration_limit=2.0, speed=0.3, acceleration=0.5)


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
        force_n: the force with which the motors push at most.
        grip_n: the force that the wheels can hand over to the floor before they slip.
        roll_out_mps2: how fast limp wheels lose their speed.
        climb_rad: ramps that are steeper block the robot from below, see `ledges`.
        step_m: the highest step that its wheels climb.
        give_up_s: the motors stop when they have stalled for so long; infinite for never.
        waits_forever: whether `ws` with a timeout of 0 waits without end, not at all otherwise.
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
class Odometry:
    """The encoders, and how the wheels differ from what they are believed to be.

    Attributes:
        resolution_m: way of a wheel for one count of its encoder; 0 for any.
        resolution_rad: the same for steering and turret.
        scale: true over believed way.
        diameters: diameter of the right wheel over that of the left one.
        wheel_base: true over believed distance of the wheels.
        drift_radpm: by how much a synchro drive turns with each metre.
        way_noise_m: standard deviation of the way after a metre.
        turn_noise_rad: that of the direction after a metre.
        spin_noise_rad: that of the direction after a full turn.
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
class Heat:
    """What senses heat, and takes it away.

    Attributes:
        range_m: how far it senses, from the robot's middle; 0 when there is no such sensor.
        tag_range_m: how far it takes heat away.
        period_s: how often it measures by its timer; 0 for when it is asked.
    """

    range_m: float = 0.0
    tag_range_m: float = 0.0
    period_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Link:
    """The serial line between the host and the robot, and the network to the simulator.

    Attributes:
        baud: its speed until the program sets another [bit/s].
        byte_counts: bytes that each command and its reply take, by name; of a robot that is on the
            network itself none.
        network_s: time that a request to the simulator and its reply take on the network.
    """

    baud: int
    byte_counts: tuple[tuple[str, int], ...] = ()
    network_s: float = 0.0


IDEAL_LINK: Final = Link(1)
"""A line on which nothing takes time."""


@dataclass(frozen=True, slots=True)
class RobotModel:
    """What a kind of robot is made of, as its definition file says.

    Attributes:
        name: the definition's name.
        radius_m: radius of its round body.
        drive: its wheels.
        odometry: its encoders, and what is wrong with its wheels.
        mass_kg: its mass.
        sonars: its sonars, by rising id.
        sonar_board: what they have in common.
        own_modes: the ways in which they can work; empty when there is but one.
        heat: its heat sensor.
        bumpers: the switches of its bumpers.
        infrared: its infrared ring, None where there is none.
        compass: its compass, None where there is none.
        laser: its laser, None where there is none.
        camera: its camera, None where there is none.
        gripper: its gripper, None where there is none.
        arm: its arm, None where there is none.
        light_sensors: its light sensors, None where there are none.
        microphones: its microphones, None where there are none.
        brightest: how bright its lamp can shine, 0 where there is none.
        loudest: how loud its speaker can sound, 0 where there is none.
        computer_battery: what feeds its computers.
        motor_battery: what feeds its motors.
        board: the computer that reads its sensors.
        link: the line between host and robot.
        host_speed_hz: how many IR instructions the host computer runs in a second.
        vendor_model: number of the model, as the vendor's `connect_robot` takes it: 0 a Nomad 200,
            1 a Nomad 150, 2 a Scout.
        height_m: how high it is; infinite for as high as anything that looks at it.
        devices: the names of the devices that it has of `registry.devices()`, each with its model.
    """

    name: str
    radius_m: float
    drive: Drive
    odometry: Odometry = Odometry()
    mass_kg: float = 20.0
    sonars: tuple[Sonar, ...] = ()
    sonar_board: SonarBoard = NO_SONARS
    own_modes: tuple[SonarMode, ...] = ()
    heat: Heat = Heat()
    bumpers: tuple[Switch, ...] = ()
    infrared: Infrared | None = None
    compass: Compass | None = None
    laser: Laser | None = None
    camera: Camera | None = None
    gripper: Gripper | None = None
    arm: Arm | None = None
    light_sensors: LightSensors | None = None
    microphones: Microphones | None = None
    brightest: float = 0.0
    loudest: float = 0.0
    computer_battery: Battery = ENDLESS
    motor_battery: MotorBattery = ENDLESS_MOTORS
    board: SensorBoard = USUAL_BOARD
    link: Link = IDEAL_LINK
    host_speed_hz: float = 5e7
    vendor_model: int = 2
    height_m: float = math.inf
    devices: tuple[tuple[str, Any], ...] = ()

    def __hash__(self) -> int:
        return hash(self.name)  # robots are sorted by kind again and again

    def device(self, name: str) -> Any | None:
        """Return the model of a device of `registry.devices()`, None where it has no such one."""
        return next((model for each, model in self.devices if each == name), None)

    @property
    def sonar_modes(self) -> tuple[SonarMode, ...]:
        """The ways in which its sonars can work, at least one."""
        return self.own_modes or (SonarMode("", self.sonars, self.sonar_board),)
