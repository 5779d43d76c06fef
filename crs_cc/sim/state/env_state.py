"""The state of a world: arrays with one row for each robot.

It contains everything that later cycles depend on, so its SHA-256 shows whether two runs are equal.
A snapshot is a packed state (`snapshot_codec`), with the history of `physics.simulation.Physics`,
and with the pending results of the current cycle: served requests, and events.

>>> from crs_cc.sim.geometry.scene import Scene
>>> from crs_cc.sim.files.world_xml import empty_world
>>> state = EnvState.at_start(empty_world())
>>> state.x_m, state.drive.clock_s
(array([0.]), array([0.]))
>>> from crs_cc.sim.state.snapshot_codec import packed
>>> state.sha256() == packed(state).state().sha256()
True
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, fields, is_dataclass
from functools import lru_cache
from typing import Any, Self, TypeVar

import numpy as np

from crs_cc.core.arrays import BoolArray, ByteArray, FloatArray, Int64Array
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.bodies import Bodies
from crs_cc.sim.state.degradation import DegradationState
from crs_cc.sim.state.devices import device_states
from crs_cc.sim.state.drawings import DrawingState
from crs_cc.sim.state.drive import DriveState
from crs_cc.sim.state.fields import FieldState
from crs_cc.sim.state.foraging import ForagingState
from crs_cc.sim.state.goals import GoalState
from crs_cc.sim.state.heat import HeatState
from crs_cc.sim.state.link import LinkState
from crs_cc.sim.state.mask import first_mask
from crs_cc.sim.state.messages import MessageState
from crs_cc.sim.state.obstacles import ObstacleState
from crs_cc.sim.state.odometry import OdometryState
from crs_cc.sim.state.pos_data import PosDataState
from crs_cc.sim.state.presence import PresenceState
from crs_cc.sim.state.robot_rows import RobotRows
from crs_cc.sim.state.timers import TimerState
from crs_cc.sim.state.waits import WaitState

S = TypeVar("S")


class _InRows:
    """The rows of a state, besides its fields."""

    __slots__ = ("_rows",)

    def __post_init__(self) -> None:
        self._rows: RobotRows | None = None

    @property
    def rows(self) -> RobotRows:
        """What kernels change, as rows: the memory of some of the arrays, once asked for."""
        if self._rows is None:
            self._rows = RobotRows(self)
        return self._rows

    def replace(self, before: _InRows) -> None:
        """Use the memory of another state, which is not used any more."""
        if before._rows is not None:
            self._rows = RobotRows(self, before._rows)


@dataclass(slots=True, kw_only=True)
class EnvState(_InRows):
    """The state of a world at one time; arrays have a row for each robot unless noted otherwise.

    The state of each device is in a dataclass of its own.

    Attributes:
        cycle: number of the current cycle.
        presence: the robots that are in the world.
        bodies: the movable bodies, the robots first.
        heading_rad: the robots' true headings at the start of the cycle: the rolling direction.
        mount_rad: direction of the mount of their sonars, infrared sensors and laser: the heading,
            or the turret, or the base of a synchro drive without a turret.
        base_rad: direction of the mount of their bumpers: the heading, or the base of a synchro
            drive, which never turns.
        drive: the motion of the axes.
        odometry: the estimated pose of each robot.
        devices: the state of each device of `registry.devices()`, by its name.
        timers: the timers of sensors.
        degradation: the degradations of these devices, and of the drive.
        mask: the parts of `State` that the program requests (`Smask`), (robots, 44).
        pos_data: positions and times of sensor readings, for programs that request them.
        heat: the heat of objects.
        link: the serial links to the robots.
        obstacles: objects that programs added to the world and removed from it.
        drawings: drawings of programs.
        connected: whether the program has connected.
        messages: messages between robots.
        waits: the robots that wait, and their requests.
        contacts_before: contacts of the last cycle: robot times number of names plus object,
            sorted; shape (contacts,).
        distance_m: true distance that each robot has moved.
        collisions: number of contacts that began.
        commands: number of requests served.
        goals: how far the goals are met; None in a world without goals.
        foraging: the items in sources and nests; None in a world without them.
        fields: the contents of the pheromone fields; last, as its size changes most.
    """

    cycle: int
    presence: PresenceState
    bodies: Bodies
    heading_rad: FloatArray
    mount_rad: FloatArray
    base_rad: FloatArray
    drive: DriveState
    odometry: OdometryState
    devices: Any
    timers: TimerState
    degradation: DegradationState
    mask: ByteArray
    pos_data: PosDataState
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
    goals: GoalState | None
    foraging: ForagingState | None
    fields: FieldState

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return the state before the first cycle: everything at rest, odometry at 0."""
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
            devices=device_states(world),
            timers=TimerState.at_start(world),
            degradation=DegradationState.at_start(world),
            mask=first_mask(count),
            pos_data=PosDataState.at_start(world),
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
            goals=GoalState.at_start(world),
            foraging=ForagingState.at_start(world),
            fields=FieldState.at_start(world),
        )

    @property
    def x_m(self) -> FloatArray:
        """The robots' x in the world frame, at the start of the cycle."""
        return self.bodies.position_m[: len(self.heading_rad), 0]

    @property
    def y_m(self) -> FloatArray:
        """The robots' y in the world frame, at the start of the cycle."""
        return self.bodies.position_m[: len(self.heading_rad), 1]

    def device(self, name: str, kind: type[S]) -> S:
        """Return the state of a device of `registry.devices()`."""
        state = getattr(self.devices, name)
        assert isinstance(state, kind)
        return state

    def renumber(self, before: Sequence[str], now: Sequence[str]) -> None:
        """Renumber objects after some were added or removed, keeping the state of the others.

        Args:
            before: the names of all objects so far, as in `Scene.names`.
            now: the new names.
        """
        places = {name: place for place, name in enumerate(now)}
        place = np.array([places.get(name, -1) for name in before], dtype=np.intp)
        left, heat = place >= 0, np.zeros(len(now))
        heat[place[left]] = self.heat.left[left]
        self.heat.left = heat
        slipping = self.bodies.slipping
        self.bodies = self.bodies.take(np.flatnonzero(left[: len(self.bodies.angle_rad)]))
        if self._rows is not None:
            self.bodies.slipping = slipping  # in the rows of robots
            self._rows.replace_bodies(self)
        robot, obj = np.divmod(self.contacts_before, len(before))
        robot, obj = robot[left[obj]], place[obj[left[obj]]]
        self.contacts_before = np.sort(robot * len(now) + obj)

    def sha256(self) -> str:
        """Return a digest of the whole state."""
        parts = list[bytes]()
        _add_leaves(parts, self, "")
        return hashlib.sha256(b"".join(parts)).hexdigest()


def _whole(count: int) -> Int64Array:
    return np.zeros(count, dtype=np.int64)


def _add_leaves(parts: list[bytes], value: Any, name: str) -> None:
    """Add the bytes of the arrays and numbers in a dataclass, each after its name and shape."""
    for field, own in _fields(type(value), name) or ():
        part = getattr(value, field)
        if isinstance(part, np.ndarray):
            parts += _head(own, part.shape), part.tobytes()
        elif _fields(type(part), own) is not None:
            _add_leaves(parts, part, own)
        elif part is not None:
            array = np.asarray(part)
            parts += _head(own, array.shape), array.tobytes()


@lru_cache(maxsize=1024)
def _head(name: str, shape: tuple[int, ...]) -> bytes:
    return f"{name} {shape}\n".encode()


def _fields(kind: type, name: str) -> tuple[tuple[str, str], ...] | None:
    """Return the fields of a dataclass that has a name, each with its whole name; else None."""
    key = kind, name
    if key not in _FIELDS:
        own = [each.name for each in fields(kind)] if is_dataclass(kind) else None
        _FIELDS[key] = None if own is None else tuple((each, f"{name}.{each}") for each in own)
    return _FIELDS[key]


_FIELDS: dict[tuple[type, str], tuple[tuple[str, str], ...] | None] = {}
