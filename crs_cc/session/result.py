"""The results and the state of a run, as plain data."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy.typing as npt

from crs_cc.runtime.executable import Executable
from crs_cc.runtime.snapshot import Snapshot
from crs_cc.sim.devices.foraging import NestResult, SourceResult
from crs_cc.sim.engine.goals import GoalResult
from crs_cc.sim.engine.world_data import Snapshot as EnvironmentSnapshot
from crs_cc.sim.state.env_state import EnvState

if TYPE_CHECKING:
    from crs_cc.runtime.diagnosis.report import ErrorReport
    from crs_cc.session.files import DiskSnapshot
    from crs_cc.session.network.sockets import NetworkState

Pose = tuple[float, float, float]
"""x [m], y [m], heading [rad, counter-clockwise from x]."""

Outcome = Literal["exited", "running", "failed", "left", "absent"]
"""How a robot's program ended, or its current state."""


@dataclass(frozen=True, slots=True)
class RobotResult:
    """The result of one robot.

    Attributes:
        id: its name in the world.
        program: the program that it ran.
        outcome: how its program ended: it `exited`, `failed`, or its robot `left`; otherwise it is
            `running`, or its robot is `absent`, that is, it has not joined.
        exit_status: the program's exit status; None unless it exited.
        error: the run-time error; None unless it failed.
        time_s: the program's clock when it ended, or now [s]; 0 if it has not started.
        odometry: its pose by odometry.
        pose: its pose in the world's frame.
        distance_m: the distance driven [m].
        collisions: number of contacts that began.
        commands: number of commands sent to it.
        fuel: IR instructions that the program has run.
        robot_call_s: the program's clock at its last robot call, or now if it is waiting for
            the reply [s]; None if it made none.
        joined_s: when it joined [s]: 0 if present from the start; None if it has not.
        left_s: when it left the world or failed to join [s]; None if it has not.
    """

    id: str
    program: str
    outcome: Outcome
    exit_status: int | None
    error: ErrorReport | None
    time_s: float
    odometry: Pose
    pose: Pose
    distance_m: float
    collisions: int
    commands: int
    fuel: int
    robot_call_s: float | None
    joined_s: float | None = 0.0
    left_s: float | None = None


@dataclass(frozen=True, slots=True)
class RunResult:
    """A run so far.

    Attributes:
        robots: the robots, in the world's order.
        timesteps: number of timesteps run.
        simulated_s: simulated time [s].
        state_hash: SHA-256 over the arrays of the environment (`sim.state`), and of each robot
            over its slot, its memory and shadow memory, the names of its files and
            what it wrote to them, its clock, its fuel, when its request arrives,
            its last robot call and its exit status; and of the network, if programs use it.
            Standard output and standard input are not part of it.
        goals: the status of the world's goals, in the world's order.
        sources: the status of its sources.
        nests: the status of its nests.
    """

    robots: tuple[RobotResult, ...]
    timesteps: int
    simulated_s: float
    state_hash: str
    goals: tuple[GoalResult, ...] = ()
    sources: tuple[SourceResult, ...] = ()
    nests: tuple[NestResult, ...] = ()


@dataclass(frozen=True, slots=True)
class Added:
    """The program and arguments of a robot that was added to a session."""

    executable: Executable
    arguments: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class SessionSnapshot:
    """The whole state of a run; see `Session.snapshot`."""

    added: tuple[Added, ...]
    environment: EnvironmentSnapshot
    programs: tuple[Snapshot, ...]
    arrays: tuple[npt.NDArray[Any], ...]
    exit_status: tuple[int | None, ...]
    disks: tuple[DiskSnapshot, ...]
    network: NetworkState | None
    timesteps: int
    rounds: int
    halted: int | None


def robot_state(state: EnvState, robot: int) -> dict[str, Any]:
    """Return the fields of a `RobotResult` that come from the environment."""
    odometry = (state.odometry.x_m, state.odometry.y_m, state.odometry.heading_rad)
    pose = (state.x_m, state.y_m, state.heading_rad)
    return {
        "odometry": tuple(float(array[robot]) for array in odometry),
        "pose": tuple(float(array[robot]) for array in pose),
        "distance_m": float(state.distance_m[robot]),
        "collisions": int(state.collisions[robot]),
        "commands": int(state.commands[robot]),
        "joined_s": _finite(state.presence.joined_s[robot]),
        "left_s": _finite(state.presence.left_s[robot]),
    }


def _finite(instant_s: float) -> float | None:
    return float(instant_s) if math.isfinite(instant_s) else None
