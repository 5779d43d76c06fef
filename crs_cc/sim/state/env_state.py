"""What changes while a world runs: arrays, one row for each robot.

Everything that a later cycle depends on is here, so its SHA-256 tells whether two runs are the
same. A snapshot is this, packed (`packing`), with the history that `physics.Physics` keeps, and
with what the current cycle has to tell when it ends: requests that were served, and events.

>>> from crs_cc.sim.geometry.scene import Scene
>>> from crs_cc.sim.files.world_xml import empty_world
>>> state = EnvState.at_start(empty_world())
>>> state.x_m, state.sonar.reading_in(np.array([0]))[0, :3]
(array([0.]), array([255, 255, 255], dtype=int32))
>>> from crs_cc.sim.state.snapshot_codec import packed
>>> state.sha256() == packed(state).state().sha256()
True
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, is_dataclass
from typing import Any, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, ByteArray, FloatArray, Int64Array
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.arm import ArmState
from crs_cc.sim.state.battery import BatteryState
from crs_cc.sim.state.beacons import BeaconState
from crs_cc.sim.state.bodies import Bodies
from crs_cc.sim.state.bumper import BumperState
from crs_cc.sim.state.camera import CameraState
from crs_cc.sim.state.compass import CompassState
from crs_cc.sim.state.degradation import DegradationState
from crs_cc.sim.state.drawings import DrawingState
from crs_cc.sim.state.drive import DriveState
from crs_cc.sim.state.gripper import GripperState
from crs_cc.sim.state.heat import HeatState
from crs_cc.sim.state.heat_sensor import HeatSensorState
from crs_cc.sim.state.infrared import InfraredState
from crs_cc.sim.state.laser import LaserState
from crs_cc.sim.state.light import LightState
from crs_cc.sim.state.link import LinkState
from crs_cc.sim.state.mask import first_mask
from crs_cc.sim.state.messages import MessageState
from crs_cc.sim.state.obstacles import ObstacleState
from crs_cc.sim.state.odometry import OdometryState
from crs_cc.sim.state.pos_data import PosDataState
from crs_cc.sim.state.presence import PresenceState
from crs_cc.sim.state.sensors import sensor_states
from crs_cc.sim.state.sonar import SonarState
from crs_cc.sim.state.sound import SoundState
from crs_cc.sim.state.timers import TimerState
from crs_cc.sim.state.waits import WaitState


@dataclass(slots=True)
class EnvState:
    """The state of a world at an instant; arrays have a row for each robot unless said otherwise.

    What belongs to one device is in a dataclass of its own, see `states`.

    Attributes:
        cycle: number of the current cycle.
        presence: which robots are in the world.
        bodies: what moves, the robots first.
        heading_rad: the robots' true headings at the start of the cycle: where their wheels roll.
        mount_rad: where the mount of their sonars, infrared sensors and laser points: the heading,
            or the turret, or the base of a synchro drive without a turret.
        base_rad: where the mount of their bumpers points: the heading, or the base of a synchro
            drive, which never turns.
        drive: the motion of the axes.
        odometry: where each robot believes to be.
        sonar: the sonars' timetables and readings.
        bumpers: the switches that are pressed.
        infrared: the infrared sensors' readings.
        compass: the compasses' readings.
        laser: what the lasers saw and told.
        sensors: the `Readings` of each device of `registry.devices()`, by its name.
        camera: what cameras saw and told.
        heat_sensor: what heat sensors told.
        light: what light sensors read.
        sound: what microphones heard.
        timers: when sensors measure by themselves.
        degradation: what is wrong with all of these, and with the drive.
        gripper: where the fingers of grippers are; what they hold is in `bodies`.
        arm: where the joints of arms are; what their hands hold is in `bodies`.
        beacons: how bright robots shine and how loud they sound.
        mask: which parts of `State` the program asks for (`Smask`), (robots, 44).
        pos_data: where and when sensors were read, for those who ask.
        battery: what the motors took from theirs.
        heat: how hot things are.
        link: the serial lines to the robots.
        obstacles: what programs have put into the world, and taken out of it.
        drawings: what they have drawn.
        connected: whether the program has connected.
        messages: those that robots send each other.
        waits: which robots wait, and for what.
        contacts_before: what robots touched in the last cycle: robot times names plus thing,
            sorted; shape (contacts,).
        distance_m: how far each robot has really moved.
        collisions: how many contacts began.
        commands: how many requests were served.
    """

    cycle: int
    presence: PresenceState
    bodies: Bodies
    heading_rad: FloatArray
    mount_rad: FloatArray
    base_rad: FloatArray
    drive: DriveState
    odometry: OdometryState
    sonar: SonarState
    bumpers: BumperState
    infrared: InfraredState
    compass: CompassState
    laser: LaserState
    sensors: Any
    camera: CameraState
    heat_sensor: HeatSensorState
    light: LightState
    sound: SoundState
    timers: TimerState
    degradation: DegradationState
    gripper: GripperState
    arm: ArmState
    beacons: BeaconState
    mask: ByteArray
    pos_data: PosDataState
    battery: BatteryState
    heat: HeatState
    link: LinkState
    obstacles: ObstacleState
    drawings: DrawingState
    connected: BoolArray
    messages: MessageState
    waits: WaitState
    contacts_before: Int64Array
    distance_m: FloatArray
    collisions: Int64Array
    commands: Int64Array

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return the state before the first cycle: everything rests, odometry at 0."""
        count = len(world.robots)
        scene = Scene(world)
        bodies = Bodies.at_start(scene)
        heading_rad = bodies.angle_rad[:count].copy()
        return cls(
            cycle=0,
            presence=PresenceState.at_start(world),
            bodies=bodies,
            heading_rad=heading_rad,
            mount_rad=heading_rad.copy(),
            base_rad=heading_rad.copy(),
            drive=DriveState.at_start(world),
            odometry=OdometryState.at_start(world),
            sonar=SonarState.at_start(world),
            bumpers=BumperState.at_start(world),
            infrared=InfraredState.at_start(world),
            compass=CompassState.at_start(world),
            laser=LaserState.at_start(world),
            sensors=sensor_states(world),
            camera=CameraState.at_start(world),
            heat_sensor=HeatSensorState.at_start(world),
            light=LightState.at_start(world),
            sound=SoundState.at_start(world),
            timers=TimerState.at_start(world),
            degradation=DegradationState.at_start(world),
            gripper=GripperState.at_start(world),
            arm=ArmState.at_start(world),
            beacons=BeaconState.at_start(world),
            mask=first_mask(count),
            pos_data=PosDataState.at_start(world),
            battery=BatteryState.at_start(world),
            obstacles=ObstacleState.at_start(world),
            drawings=DrawingState.at_start(),
            heat=HeatState.at_start(world, scene),
            link=LinkState.at_start(world),
            connected=np.zeros(count, dtype=np.bool_),
            messages=MessageState.at_start(world),
            waits=WaitState.at_start(world),
            contacts_before=_whole(0),
            distance_m=np.zeros(count),
            collisions=_whole(count),
            commands=_whole(count),
        )

    @property
    def x_m(self) -> FloatArray:
        """Where the robots are, x in the world frame, at the start of the cycle."""
        return self.bodies.position_m[: len(self.heading_rad), 0]

    @property
    def y_m(self) -> FloatArray:
        """Where the robots are, y in the world frame, at the start of the cycle."""
        return self.bodies.position_m[: len(self.heading_rad), 1]

    def renumber(self, before: Sequence[str], now: Sequence[str]) -> None:
        """Takes over what belongs to things that still stand, when others have come or gone.

        Args:
            before: the names of all things, as in `Scene.names`.
            now: the same, as they are from now on.
        """
        places = {name: place for place, name in enumerate(now)}
        place = np.array([places.get(name, -1) for name in before], dtype=np.intp)
        left, heat = place >= 0, np.zeros(len(now))
        heat[place[left]] = self.heat.left[left]
        self.heat.left = heat
        self.bodies = self.bodies.take(np.flatnonzero(left[: len(self.bodies.angle_rad)]))
        robot, thing = np.divmod(self.contacts_before, len(before))
        robot, thing = robot[left[thing]], place[thing[left[thing]]]
        self.contacts_before = np.sort(robot * len(now) + thing)

    def sha256(self) -> str:
        """Return a digest of the whole state."""
        digest = hashlib.sha256()
        for name, value in _leaves(self, ""):
            digest.update(f"{name} {np.shape(value)}\n".encode())
            digest.update(np.ascontiguousarray(value).tobytes())
        return digest.hexdigest()


def _whole(count: int) -> Int64Array:
    return np.zeros(count, dtype=np.int64)


def _leaves(value: Any, name: str) -> Iterator[tuple[str, Any]]:
    if is_dataclass(value):
        for field in fields(value):
            yield from _leaves(getattr(value, field.name), f"{name}.{field.name}")
    else:
        yield name, value
