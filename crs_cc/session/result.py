"""What came out of a run, and its whole state, as plain data."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

if TYPE_CHECKING:
    import numpy.typing as npt

    from crs_cc.runtime.diagnosis.report import ErrorReport
    from crs_cc.runtime.executable import Executable
    from crs_cc.runtime.fleet import Snapshot
    from crs_cc.session.files import DiskSnapshot
    from crs_cc.sim.engine.world_data import Snapshot as EnvironmentSnapshot
    from crs_cc.sim.state.env_state import EnvState

Pose = tuple[float, float, float]
"""x [m], y [m], heading [rad, counter-clockwise from x]."""

Outcome = Literal["exited", "running", "failed", "left", "absent"]
"""How a robot's program ended, or that it runs, or that its robot has not joined."""


@dataclass(frozen=True, slots=True)
class RobotResult:
    """One robot at the end of a run.

    Attributes:
        id: its name in the world.
        program: the program that it ran.
        outcome: how its program ended: it `exited`, `failed`, or its robot `left`; else that it is
            `running`, or its robot `absent`, as it has not joined.
        exit_status: what the program returned; None unless it exited.
        error: why the program was stopped; None unless it failed.
        time_s: the program's clock when it ended, or now [s]; 0 if it has not begun.
        odometry: where the robot believes to be, in the frame of its odometry.
        pose: where it is, in the world's frame.
        distance_m: how far it has driven [m].
        collisions: how many contacts began.
        commands: how many commands it was sent.
        fuel: IR instructions that the program has run.
        robot_call_s: when, by its clock, the program last called its robot, now if it waits for
            the answer [s]; None if it never did.
        joined_s: when it joined [s]: 0 for one that was there from the start; None if it has not.
        left_s: when it left the world, or was kept from joining [s]; None if it has not.
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
        timesteps: how many timesteps were run.
        simulated_s: simulated time [s].
        state_hash: SHA-256 over the arrays of the environment (`sim.state`), and of each robot
            over its slot, its memory with the states of the bytes, the names of its files and
            what it has written into them, its clock, its fuel, when its request is due,
            when it last called its robot and what it returned.
            What a program has printed is no part of it, nor is what it has been given to read.
    """

    robots: tuple[RobotResult, ...]
    timesteps: int
    simulated_s: float
    state_hash: str


@dataclass(frozen=True, slots=True)
class Added:
    """What a robot runs that was added to a session."""

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
    timesteps: int
    rounds: int
    halted: int | None


def robot_state(state: EnvState, robot: int) -> dict[str, Any]:
    """Return the part of a `RobotResult` that the environment knows."""
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
