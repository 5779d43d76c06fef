"""What changes while a world runs: arrays, one row for each robot.

Everything that a later cycle depends on is here, so a copy of it (with the history that
`physics.Physics` keeps) is a snapshot, and its SHA-256 tells whether two runs are the same.

>>> from crs_cc.sim.scene import Scene
>>> from crs_cc.sim.world_xml import empty_world
>>> state = EnvState.at_start(empty_world())
>>> state.x_m, state.sonar_in[0, :3]
(array([0.]), array([255, 255, 255], dtype=int32))
>>> state.sha256() == state.copy().sha256()
True
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import Any, Final, Self

import numpy as np
import numpy.typing as npt

from crs_cc.requests import MESSAGE
from crs_cc.sim.hardware import Wheels
from crs_cc.sim.model import WorldModel
from crs_cc.sim.physics import Bodies
from crs_cc.sim.robot_elements import MAX_SONARS
from crs_cc.sim.scene import Scene

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]
WholeArray = npt.NDArray[np.int64]
IndexArray = npt.NDArray[np.intp]

NO_ECHO: Final = 255
"""A sonar's reading in inches when it hears nothing, the largest that the byte on the line holds
(vendor source `Ndirect.c` 2.7)."""


@dataclass(slots=True)
class EnvState:
    """The state of a world at an instant; arrays have a row for each robot unless said otherwise.

    Attributes:
        cycle: number of the current cycle.
        bodies: what moves, the robots first.
        heading_rad: the robots' true headings at the start of the cycle.
        wheels: the wheels' motion, shape (robots, 2) each.
        clock_s: the instant to which each robot's wheels have been turned.
        moved_m: where the wheels took each robot in this cycle, world frame, (robots, 2).
        facing_rad: the heading that this led to.
        slice_m: the way of each wheel in this cycle, (robots, 2): the slice so far.
        odometry_x_m: where each robot believes to be, in the frame of its odometry.
        odometry_y_m: the same.
        odometry_heading_rad: the same.
        move_mps: speed of relative moves (`sp`), (robots, 2).
        ramp_mps2: acceleration (`ac`), (robots, 2).
        command: request code of the motion command that runs; 0 before the first.
        command_cycle: the cycle in which it came.
        timeout_s: the wheels stop when no command came for so long (`conf_tm`), infinite for never.
        deadline_s: when they will.
        connected: whether the program has connected.
        waiting: the wheels that a `ws` waits for, (robots, 2).
        wait_until_s: when it gives up.
        asked: the message of the `ws`, of dtype `MESSAGE`, zero for robots that do not wait.
        sonar_on: the sonars in the firing order, (robots, 16).
        sonar_in: what each measured last [in], (robots, 16).
        sonar_cycle: the cycle of these readings, -1 before the first.
        sonar_count: how many readings were taken.
        bumpers: pressed switches, bit n for switch n.
        touching: what robots touched in the last cycle: robot times names plus thing, sorted;
            shape (contacts,).
        distance_m: how far each robot has really moved.
        collisions: how many contacts began.
        commands: how many requests were served.
    """

    cycle: int
    bodies: Bodies
    heading_rad: FloatArray
    wheels: Wheels
    clock_s: FloatArray
    moved_m: FloatArray
    facing_rad: FloatArray
    slice_m: FloatArray
    odometry_x_m: FloatArray
    odometry_y_m: FloatArray
    odometry_heading_rad: FloatArray
    move_mps: FloatArray
    ramp_mps2: FloatArray
    command: WholeArray
    command_cycle: WholeArray
    timeout_s: FloatArray
    deadline_s: FloatArray
    connected: BoolArray
    waiting: BoolArray
    wait_until_s: FloatArray
    asked: npt.NDArray[np.void]
    sonar_on: BoolArray
    sonar_in: npt.NDArray[np.int32]
    sonar_cycle: WholeArray
    sonar_count: WholeArray
    bumpers: npt.NDArray[np.int32]
    touching: WholeArray
    distance_m: FloatArray
    collisions: WholeArray
    commands: WholeArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Gives the state before the first cycle: everything rests, odometry at 0."""
        count = len(world.robots)
        drives = [robot.model.drive for robot in world.robots]
        timeout_s = np.array([drive.timeout_s or np.inf for drive in drives])
        sonar_on = np.zeros((count, MAX_SONARS), dtype=np.bool_)
        for row, robot in zip(sonar_on, world.robots, strict=True):
            row[list(robot.model.sonar_order)] = True
        bodies = Bodies.at_start(Scene(world))
        heading_rad = bodies.angle_rad[:count].copy()
        return cls(
            cycle=0,
            bodies=bodies,
            heading_rad=heading_rad,
            wheels=Wheels.standing(count),
            clock_s=np.zeros(count),
            moved_m=np.zeros((count, 2)),
            facing_rad=heading_rad.copy(),
            slice_m=np.zeros((count, 2)),
            odometry_x_m=np.zeros(count),
            odometry_y_m=np.zeros(count),
            odometry_heading_rad=np.zeros(count),
            move_mps=_both([drive.speed_mps for drive in drives]),
            ramp_mps2=_both([drive.acceleration_mps2 for drive in drives]),
            command=_whole(count),
            command_cycle=_whole(count),
            timeout_s=timeout_s,
            deadline_s=np.full(count, np.inf),
            connected=np.zeros(count, dtype=np.bool_),
            waiting=np.zeros((count, 2), dtype=np.bool_),
            wait_until_s=np.full(count, np.inf),
            asked=np.zeros(count, MESSAGE),
            sonar_on=sonar_on,
            sonar_in=np.full((count, MAX_SONARS), NO_ECHO, dtype=np.int32),
            sonar_cycle=np.full(count, -1, dtype=np.int64),
            sonar_count=_whole(count),
            bumpers=np.zeros(count, dtype=np.int32),
            touching=_whole(0),
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

    def copy(self) -> Self:
        """Gives a copy that shares nothing."""
        copied = _copy(self)
        assert isinstance(copied, type(self))
        return copied

    def sha256(self) -> str:
        """Gives a digest of the whole state."""
        digest = hashlib.sha256()
        for name, value in _leaves(self, ""):
            digest.update(f"{name} {np.shape(value)}\n".encode())
            digest.update(np.ascontiguousarray(value).tobytes())
        return digest.hexdigest()


def _both(values: list[float]) -> FloatArray:
    """Gives the same value to both wheels of each robot."""
    return np.repeat(np.array(values, dtype=np.float64)[:, None], 2, axis=1)


def _whole(count: int) -> WholeArray:
    return np.zeros(count, dtype=np.int64)


def _copy(value: Any) -> Any:
    if isinstance(value, EnvState | Bodies | Wheels):
        return type(value)(*(_copy(getattr(value, field.name)) for field in fields(value)))
    return value.copy() if isinstance(value, np.ndarray) else value


def _leaves(value: Any, name: str) -> Iterator[tuple[str, Any]]:
    if isinstance(value, EnvState | Bodies | Wheels):
        for field in fields(value):
            yield from _leaves(getattr(value, field.name), f"{name}.{field.name}")
    else:
        yield name, value
