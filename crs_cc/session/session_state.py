"""The robots of a run with their programs: who there is, what came out, and the whole state.

A robot has a place in the world (`environment`), a sandbox (`fleet`), a host computer, and a row in
the arrays here. Robots that join get all of these; those that leave keep them.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Mapping, Sequence
from dataclasses import fields
from itertools import takewhile
from typing import TYPE_CHECKING, Any, Final, Protocol

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import IndexArray
from crs_cc.core.suggest import unknown
from crs_cc.requests import FAILED
from crs_cc.runtime.fleet import Fleet
from crs_cc.session.host import Host, discard, no_input
from crs_cc.session.result import (
    Added,
    Outcome,
    RobotResult,
    RunResult,
    SessionSnapshot,
    robot_state,
)
from crs_cc.sim.engine.environment import Environment

if TYPE_CHECKING:
    from crs_cc.runtime.diagnosis.active_call import ActiveCall
    from crs_cc.runtime.executable import Executable
    from crs_cc.session.host import Client, Input, Output
    from crs_cc.sim.engine.step import Step
    from crs_cc.sim.model.world import Robot, WorldModel

ENDLESS = math.inf

_NOTHING: Final[dict[str, float]] = {
    "clock_s": 0.0,
    "fuel": 0,
    "alive": False,
    "_due_s": ENDLESS,
    "_ended_s": 0.0,
    "_called_s": -math.inf,
    "pending": 0,
}
"""The session's own state, arrays over robots, and what they hold of a robot that has not begun."""


class Listener(Protocol):
    """Hears of every timestep: a trace, a viewer, a recording."""

    def step(self, step: Step) -> None:
        """Takes what happened in a timestep that has ended."""


class Crew:
    """All robots of a run, each with a program.

    Attributes:
        environment: the world as it is.
        fleet: the programs.
        alive: which programs run: they have begun, and have not ended.
        clock_s: each program's clock [s]; infinite while it waits for something to happen.
        fuel: IR instructions that each program has run.
        timesteps: how many timesteps have been run.
        rounds: how many rounds of programs the current one has had.
        pending: fuel that each program has been given for the round that a program with a debug
            build has stopped in the middle of; 0 for those that are not in one.
        halted: the program that stopped, if one has.
        unconnected_calls: by robot, the first call of the robot that its program made without a
            connection, while this session ran it; None where there was none.
    """

    def __init__(
        self,
        world: WorldModel,
        executables: Sequence[Executable],
        seed: int = 0,
        *,
        arguments: Sequence[Sequence[str]] = (),
        output: Output = discard,
        read: Input = no_input,
        files: Mapping[str, bytes] | None = None,
        client: Client = "nclient",
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
            files: what every program finds on its disk, by name.
            client: which of the vendor's client libraries the programs find.
            trace: hears of every timestep.
        """
        assert len(executables) == len(world.robots)
        self.environment = Environment(world, seed)
        self.fleet = Fleet(executables)
        rows = arguments or [[executable.name] for executable in executables]
        self._host = Host(rows, output, read, files, client)
        self._trace = trace
        count = len(executables)
        self._added: list[Added] = []
        self._learn_speeds()
        self.timesteps = 0
        self.unconnected_calls: list[ActiveCall | None] = [None] * count
        self.clock_s = np.zeros(count)
        self.fuel = np.zeros(count, np.int64)
        self.alive = np.zeros(count, bool)
        self._due_s = np.full(count, ENDLESS)  # when a request has come through the link
        self._ended_s = np.zeros(count)
        self.rounds = 0
        self.pending = np.zeros(count, np.int64)
        self.halted: int | None = None
        self._called_s = np.full(count, -math.inf)  # when it last had an answer of its robot
        self._present = np.zeros(count, bool)
        self._meet()

    @property
    def time_s(self) -> float:
        """Gives the start of the current cycle [s]."""
        return self.environment.time_s

    @property
    def running(self) -> int:
        """Gives the number of programs that have not ended."""
        return int(self.alive.sum())

    def add_robot(self, robot: Robot, executable: Executable, arguments: Sequence[str] = ()) -> int:
        """Puts another robot into the world, between two timesteps; gives its number.

        Args:
            robot: the robot; it joins now, or at its time if that comes later.
            executable: its program.
            arguments: its `argv`; by default just the program's name.

        Raises:
            ValueError: it cannot be there, or something stands in its place.
            OSError: the system does not give the memory for its program.
        """
        number = self.fleet.add(executable)
        try:
            self.environment.add_robot(robot)
        except ValueError:
            self.fleet.keep(number)
            raise
        self._make_room(executable, arguments or [executable.name])
        self._meet()
        return number

    def remove_robot(self, robot: int | str) -> None:
        """Takes a robot, by its number or its id, out of the world, between two timesteps.

        Its program ends, its result stays. One that has not joined yet never will.

        Raises:
            ValueError: there is no such robot, or it has left before.
        """
        if isinstance(robot, str):
            ids = [each.id for each in self.environment.world.robots]
            if robot not in ids:
                raise ValueError(unknown("robot", robot, ids))
            robot = ids.index(robot)
        self.environment.remove_robot(robot)
        self._meet()

    def result(self) -> RunResult:
        """Gives the run so far."""
        robots = tuple(map(self.robot_result, range(len(self.fleet))))
        return RunResult(robots, self.timesteps, self.time_s, self.state_hash())

    def robot_result(self, robot: int) -> RobotResult:
        """Gives what came of one robot so far."""
        outcome = self._outcome(robot)
        return RobotResult(
            id=self.environment.world.robots[robot].id,
            program=self.fleet.executable(robot).name,
            outcome=outcome,
            exit_status=self._host.exit_status[robot],
            error=self.fleet.report(robot) if outcome == "failed" else None,
            time_s=self.time_s if outcome == "running" else float(self._ended_s[robot]),
            fuel=int(self.fuel[robot]),
            robot_call_s=self._robot_call_s(robot),
            **robot_state(self.environment.state, robot),
        )

    def request_on_link(self, robot: int) -> tuple[int, float] | None:
        """Gives the code of the request that a program has on the link, and when it gets there [s].

        None when there is none: the program runs, or waits for something to happen, or has ended.
        """
        due_s = float(self._due_s[robot])
        return None if due_s == ENDLESS else (int(self.fleet.slots["code"][robot]), due_s)

    def current_call(self, robot: int) -> ActiveCall | None:
        """Gives where a program stands that runs: the innermost function of the user's own files.

        None for one that has not begun, or has ended.
        """
        return self.fleet.current_call(robot) if self.alive[robot] else None

    def files(self, robot: int) -> dict[bytes, bytes]:
        """Gives the files that a robot's program made or changed, by name."""
        return self._host.disks[robot].outputs()

    def missed_files(self, robot: int) -> list[bytes]:
        """Gives the names of files that a robot's program has looked for in vain."""
        return self._host.disks[robot].missed

    def snapshot(self) -> SessionSnapshot:
        """Gives the whole state, between two timesteps or wherever a program has stopped.

        How far standard input has been read is not part of it: `read` belongs to the caller, who
        has to give a restored session one that goes on from there.
        """
        return SessionSnapshot(
            tuple(self._added),
            self.environment.snapshot(),
            tuple(self.fleet.snapshot(robot) for robot in range(len(self.fleet))),
            tuple(array.copy() for array in self._arrays()),
            tuple(self._host.exit_status),
            tuple(disk.snapshot() for disk in self._host.disks),
            self.timesteps,
            self.rounds,
            self.halted,
        )

    def restore(self, snapshot: SessionSnapshot) -> None:
        """Goes back, or ahead, to a snapshot of a session of the same programs, world and seed.

        Robots that had been added when it was made are there again, others are not.
        """
        self.environment.restore(snapshot.environment)
        self._present = self.environment.state.presence.present
        self._recruit(snapshot.added)
        for robot, program in enumerate(snapshot.programs):
            self.fleet.restore(robot, program)
        for name, saved in zip(_NOTHING, snapshot.arrays, strict=True):
            setattr(self, name, saved.copy())
        self._host.exit_status[:] = snapshot.exit_status
        for disk, files in zip(self._host.disks, snapshot.disks, strict=True):
            disk.restore(files)
        self.timesteps = snapshot.timesteps
        self.rounds, self.halted = snapshot.rounds, snapshot.halted

    def state_hash(self) -> str:
        """Gives the SHA-256 of all state, see `RunResult`."""
        digest = hashlib.sha256(self.environment.hash().encode())
        for robot in range(len(self.fleet)):
            program = self.fleet.snapshot(robot)
            for part in fields(program):
                digest.update(getattr(program, part.name).tobytes())
        for disk in self._host.disks:
            for piece in disk.state():
                digest.update(piece)
        for array in self._arrays():
            digest.update(array.tobytes())
        digest.update(repr(self._host.exit_status).encode())
        return digest.hexdigest()

    def _outcome(self, robot: int) -> Outcome:
        if self.alive[robot]:
            return "running"
        if self.fleet.slots["status"][robot] == FAILED:
            return "failed"
        if self._host.exit_status[robot] is not None:
            return "exited"
        joined_s = self.environment.state.presence.joined_s[robot]
        return "left" if math.isfinite(joined_s) else "absent"

    def _robot_call_s(self, robot: int) -> float | None:
        if self.alive[robot] and (self._due_s[robot] < ENDLESS or self.clock_s[robot] == ENDLESS):
            return self.time_s
        called_s = float(self._called_s[robot])
        return called_s if math.isfinite(called_s) else None

    def _learn_speeds(self) -> None:
        robots = self.environment.world.robots
        self._speed_hz = np.array([robot.model.host_speed_hz for robot in robots])

    def _make_room(self, executable: Executable, arguments: Sequence[str]) -> None:
        """Gives a robot that is new in world and fleet a host, and a place in our own state."""
        self._added.append(Added(executable, tuple(arguments)))
        self._host.add(arguments)
        self.unconnected_calls.append(None)
        self._learn_speeds()
        self._present = np.append(self._present, False)
        for name, nothing in _NOTHING.items():
            array = getattr(self, name)
            setattr(self, name, np.append(array, array.dtype.type(nothing)))

    def _meet(self) -> None:
        """Starts the programs of robots that have joined, ends those of robots that have left."""
        before, now = self._present, self.environment.state.presence.present
        if now is before:
            return
        self._present = now
        joined, left = np.flatnonzero(now & ~before), np.flatnonzero(before & ~now & self.alive)
        self.alive[joined] = True
        self.clock_s[joined] = self.time_s
        self.clock_s[left] = self.time_s
        self._due_s[left] = ENDLESS
        self._end(left)

    def _end(self, robots: IndexArray) -> None:
        self.alive[robots] = False
        self._ended_s[robots] = self.clock_s[robots]

    def _recruit(self, added: Sequence[Added]) -> None:
        """Lets these be the programs that were added, and no others."""
        pairs = zip(self._added, added, strict=False)
        same = sum(1 for _ in takewhile(lambda pair: pair[0] is pair[1], pairs))
        first = len(self.fleet) - len(self._added)
        self.fleet.keep(first + same)
        self._host.keep(first + same)
        del self.unconnected_calls[first + same :]
        self._added = list(added)
        for each in added[same:]:
            self.fleet.add(each.executable)
            self._host.add(each.arguments)
            self.unconnected_calls.append(None)
        self._learn_speeds()

    def _arrays(self) -> tuple[npt.NDArray[Any], ...]:
        """Gives the session's own state, arrays over robots."""
        return tuple(getattr(self, name) for name in _NOTHING)
