"""A run: how programs and environment take turns, one timestep after the other.

Time is cut into cycles `[t, t + dt)`. In each cycle

1. every program that is not waiting runs on until its own clock has passed the end of the cycle.
   Its clock moves by the processor time it uses (fuel) and by the time its commands take on the
   link. When it posts a request it stops: the host's requests are answered at once, the robot's
   when they have come through the link, in this cycle or in a later one;
2. the environment executes the cycle: the hardware simulator has cut the running commands into
   one slice for it. Waits that ended in it let their programs go on in the next cycle.

All robots that can go on are resumed in one call, and all requests with the same code are served
in one call, in the order of their codes; so a run is a function of programs, world and seed alone.

>>> from crs_cc.runtime.testing import counting_program
>>> from crs_cc.sim.world_xml import empty_world
>>> session = Session(empty_world(), [counting_program(rounds=42)])
>>> session.step()
False
>>> session.result().robots[0].exit_status
42
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Protocol

import numpy as np
import numpy.typing as npt

from crs_cc.requests import FAILED, REQUESTS, SUSPENDED
from crs_cc.runtime.fleet import Fleet
from crs_cc.session.host import HOST_CODES, HOST_SPEED, SYSTEM_CALL, Host, HostRequest
from crs_cc.session.result import Pose, RobotResult, RunResult
from crs_cc.sim.environment import Environment
from crs_cc.source import Diagnostic

if TYPE_CHECKING:
    from crs_cc.runtime.executable import Executable
    from crs_cc.session.host import Input, Output
    from crs_cc.sim.model import WorldModel
    from crs_cc.sim.step import Step

ENDLESS = math.inf


def _discard(_robot: int, _stream: int, _content: bytes) -> None:
    """Takes a program's output and drops it."""


def _no_input(_robot: int, _wanted: int) -> bytes:
    """Gives the end of the standard input."""
    return b""


class Listener(Protocol):
    """Hears of every timestep: a trace, a viewer, a recording."""

    def step(self, step: Step) -> None:
        """Takes what happened in a timestep that has ended."""


class Session:
    """A run of one program in each robot of a world.

    Attributes:
        environment: the world as it is.
        fleet: the programs.
        clock_s: each program's clock [s]; infinite while it waits for something to happen.
        fuel: IR instructions that each program has run.
        timesteps: how many timesteps have been run.
    """

    def __init__(
        self,
        world: WorldModel,
        executables: Sequence[Executable],
        seed: int = 0,
        *,
        arguments: Sequence[Sequence[str]] = (),
        output: Output = _discard,
        read: Input = _no_input,
        trace: Listener | None = None,
    ) -> None:
        """Puts the programs into the robots, in the world's order of robots.

        Args:
            world: the world.
            executables: one program for each robot.
            seed: decides all that is random.
            arguments: for each robot `argv`; by default just the program's name.
            output: takes what the programs write.
            read: gives what they read.
            trace: hears of every timestep.
        """
        assert len(executables) == len(world.robots)
        self._world = world
        self._executables = tuple(executables)
        self.environment = Environment(world, seed)
        self.fleet = Fleet(executables)
        rows = arguments or [[executable.name] for executable in executables]
        self._host = Host(rows, output, read)
        self._trace = trace
        count = len(executables)
        self.clock_s = np.zeros(count)
        self.fuel = np.zeros(count, np.int64)
        self.timesteps = 0
        self._alive = np.ones(count, bool)
        self._due_s = np.full(count, ENDLESS)  # when a request has come through the link
        self._ended_s = np.zeros(count)

    @property
    def time_s(self) -> float:
        """Gives the start of the current cycle [s]."""
        return self.environment.time_s

    @property
    def running(self) -> int:
        """Gives the number of programs that have not ended."""
        return int(self._alive.sum())

    def step(self) -> bool:
        """Runs one timestep; gives False when all programs have ended."""
        end_s = self.environment.time_s + self.environment.timestep_s
        while True:
            self._answer_robots(end_s)
            ready = np.flatnonzero(self._alive & (self.clock_s < end_s) & (self._due_s == ENDLESS))
            if not ready.size:
                break
            self._resume(ready, end_s)
        step = self.environment.step()
        self.clock_s[step.robots] = step.at_s
        self.fleet.slots["message"][step.robots] = step.messages
        self.timesteps += 1
        if self._trace is not None:
            self._trace.step(step)
        return self.running > 0

    def _resume(self, ready: npt.NDArray[np.intp], end_s: float) -> None:
        """Lets programs run until each has posted a request or used up the cycle."""
        slots = self.fleet.slots
        budget = np.ceil((end_s - self.clock_s[ready]) * HOST_SPEED).astype(np.int64)
        slots["run"][ready] = 1
        slots["fuel"][ready] = budget
        self.fleet.run_round()
        self._charge(ready, budget - slots["fuel"][ready])
        stopped = ready[slots["status"][ready] != SUSPENDED]
        self._end(stopped)
        codes = slots["code"][ready]
        asked = ready[(slots["status"][ready] == SUSPENDED) & (codes != 0)]
        for robot in asked.tolist():
            code = int(slots["code"][robot])
            if REQUESTS.get(code) is None or code in HOST_CODES:
                self._answer_host(robot, code)
            else:
                self._due_s[robot] = self.clock_s[robot] + self.environment.link_s(code)

    def _charge(self, robots: npt.NDArray[np.intp], fuel: npt.NDArray[np.int64]) -> None:
        self.fuel[robots] += fuel
        self.clock_s[robots] += fuel / HOST_SPEED

    def _answer_host(self, robot: int, code: int) -> None:
        self._charge(np.array([robot]), np.array([SYSTEM_CALL]))
        message = self.fleet.slots["message"][robot : robot + 1][0]
        used_s = float(self.fuel[robot]) / HOST_SPEED
        request = HostRequest(robot, message, float(self.clock_s[robot]), used_s)
        self.clock_s[robot] = self._host.serve(code, request)
        if self._host.exit_status[robot] is not None:
            self._end(np.array([robot]))

    def _answer_robots(self, end_s: float) -> None:
        """Serves the requests that come through the link before the end of the cycle."""
        due = np.flatnonzero(self._due_s < end_s)
        codes = self.fleet.slots["code"][due]
        for code in np.unique(codes).tolist():
            robots = due[codes == code]
            messages = self.fleet.slots["message"][robots]
            self.clock_s[robots] = self.environment.serve(
                code, robots, messages, self._due_s[robots]
            )
            self.fleet.slots["message"][robots] = messages
            self._due_s[robots] = ENDLESS

    def _end(self, robots: npt.NDArray[np.intp]) -> None:
        self._alive[robots] = False
        self._ended_s[robots] = self.clock_s[robots]

    # -- what came out ---------------------------------------------------------------------------

    def result(self) -> RunResult:
        """Gives the run so far."""
        robots = tuple(self._robot_result(robot) for robot in range(len(self.fleet)))
        return RunResult(robots, self.timesteps, self.time_s, self.state_hash())

    def state_hash(self) -> str:
        """Gives the SHA-256 of all state: environment, programs' memories and slots, clocks."""
        digest = hashlib.sha256(self.environment.hash().encode())
        for robot in range(len(self.fleet)):
            snapshot = self.fleet.snapshot(robot)
            for part in (snapshot.slot, snapshot.chunks, snapshot.content):
                digest.update(part.tobytes())
        for array in (self.clock_s, self.fuel, self._alive, self._due_s):
            digest.update(array.tobytes())
        return digest.hexdigest()

    def _robot_result(self, robot: int) -> RobotResult:
        state = self.environment.state
        failed = bool(self.fleet.slots["status"][robot] == FAILED)
        status = self._host.exit_status[robot]
        running = bool(self._alive[robot])
        return RobotResult(
            id=self._world.robots[robot].id,
            program=self._executables[robot].name,
            outcome="running" if running else "failed" if failed else "exited",
            exit_status=status,
            error=self._error(robot) if failed else None,
            time_s=self.time_s if running else float(self._ended_s[robot]),
            odometry=_pose(
                state.odometry_x_m, state.odometry_y_m, state.odometry_heading_rad, robot
            ),
            pose=_pose(state.x_m, state.y_m, state.heading_rad, robot),
            distance_m=float(state.distance_m[robot]),
            collisions=int(state.collisions[robot]),
            commands=int(state.commands[robot]),
            fuel=int(self.fuel[robot]),
        )

    def _error(self, robot: int) -> Diagnostic:
        failure = self.fleet.failure(robot)
        where = f" (address {failure.value:#010x})" if "pointer" in failure.kind else ""
        return Diagnostic("error", failure.location, failure.kind + where)


def _pose(
    x_m: npt.NDArray[np.float64],
    y_m: npt.NDArray[np.float64],
    heading_rad: npt.NDArray[np.float64],
    robot: int,
) -> Pose:
    return float(x_m[robot]), float(y_m[robot]), float(heading_rad[robot])
