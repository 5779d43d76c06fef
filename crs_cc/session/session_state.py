"""The state of a run: world, programs, host computers and clocks.

A robot has a place in the world (`environment`), a sandbox (`fleet`), a host computer (`host`) and
a row in the arrays here. A robot that joins is given all of these; one that leaves keeps them.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterable, Sequence
from dataclasses import fields
from itertools import takewhile
from typing import TYPE_CHECKING, Any, Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import IndexArray
from crs_cc.core.suggest import unknown
from crs_cc.requests import FAILED, TIMING
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.session.build import build_driver
from crs_cc.session.network.service import NetworkService
from crs_cc.session.result import (
    Added,
    Outcome,
    RobotResult,
    RunResult,
    SessionSnapshot,
    robot_state,
)
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.model.world import Robot, WorldModel

if TYPE_CHECKING:
    from crs_cc.runtime.diagnosis.active_call import ActiveCall
    from crs_cc.runtime.diagnosis.lost_blocks import LostBlocks
    from crs_cc.session.host import Host

NEVER_S: Final = math.inf

_INITIAL: Final[dict[str, float]] = {
    "clock_s": 0.0,
    "fuel": 0,
    "alive": False,
    "due_s": NEVER_S,
    "ended_s": 0.0,
    "called_s": -math.inf,
    "pending": 0,
}
"""The arrays over robots, and their values for a robot whose program has not started."""

_TIMING: Final = frozenset(_INITIAL) & frozenset(TIMING.names or ())
"""Those that are views of the fleet's: the driver uses them."""


class SessionState:
    """All that changes in a run of one program in each robot of a world.

    Attributes:
        environment: the world.
        fleet: the programs.
        host: the host computers.
        network: the network between them.
        alive: which programs are running: they have started, and have not ended.
        clock_s: each program's clock [s]; infinite while it waits for an event.
        fuel: IR instructions that each program has run.
        due_s: when the request of each program arrives over the link [s]; infinite for none.
        ended_s: each program's clock when it ended [s].
        called_s: time of each program's last reply from its robot [s].
        pending: fuel that each program was given for the round in which a program with a debug
            build has stopped; 0 outside a round.
        speed_hz: the speed of each robot's host [instructions/s].
        timesteps: number of timesteps run.
        rounds: number of rounds of programs run in the current timestep.
        halted: the program that stopped in the middle of a round, if any.
        unconnected_calls: by robot, the first robot call that its program made without a
            connection while this session ran it; None if there was none.
    """

    def __init__(
        self,
        world: WorldModel,
        executables: Sequence[Executable],
        seed: int,
        host: Host,
        threads: int | None = None,
        *,
        fleet: Fleet | None = None,
    ) -> None:
        """Load the programs into the robots, in the world's order of robots.

        Args:
            world: the world.
            executables: one program for each robot.
            seed: the random seed.
            host: the robots' host computers.
            threads: how many threads may run programs, see `Fleet`, and measure, see `Environment`.
            fleet: the programs, if they are loaded already.
        """
        self.environment = Environment(world, seed, threads)
        self.fleet = fleet or Fleet(executables, build_driver(), threads)
        self.host = host
        self.network = NetworkService(self.environment)
        count = len(executables)
        self._added: list[Added] = []
        self.timesteps = 0
        self.unconnected_calls: list[ActiveCall | None] = [None] * count
        self.ended_s = np.zeros(0)
        self.called_s = np.zeros(0)
        self._add_rows(0)
        self.rounds = 0
        self.halted: int | None = None
        self._present = np.zeros(count, bool)
        self.update_presence()

    @property
    def time_s(self) -> float:
        """Start of the current cycle [s]."""
        return self.environment.time_s

    @property
    def running(self) -> int:
        """Number of programs that are running."""
        return int(np.count_nonzero(self.alive))

    def add_robot(self, robot: Robot, executable: Executable, arguments: Sequence[str] = ()) -> int:
        """Add a robot to the world, between two timesteps, and return its number.

        Args:
            robot: the robot; it joins now, or at its join time if that is later.
            executable: its program.
            arguments: its `argv`; by default the program's name and the robot's arguments.

        Raises:
            ValueError: the robot is invalid there, or its place is occupied.
            OSError: there is no memory for its program.
        """
        arguments = arguments or [executable.command, *robot.arguments]
        number = self.fleet.add(executable)
        try:
            self.environment.add_robot(robot)
        except ValueError:
            self.fleet.truncate(number)
            raise
        self._added.append(Added(executable, tuple(arguments)))
        self.host.add(arguments)
        self.unconnected_calls.append(None)
        self._present = np.append(self._present, False)
        self._add_rows(number)
        self.update_presence()
        return number

    def admit_robots(self, robots: Sequence[int]) -> None:
        """Make robots that are to join later join now, between two timesteps.

        It is as if this had been their time to join: whose place is occupied waits.

        Raises:
            ValueError: a robot does not exist, has joined, or has left.
        """
        self.environment.admit_robots(robots)
        self.update_presence()

    def delay_robots(self, robots: Sequence[int]) -> None:
        """Keep robots out of the world until they are admitted, before anything happens.

        Raises:
            ValueError: a robot does not exist, or something has happened already.
        """
        self.environment.delay_robots(robots)
        self.update_presence()

    def remove_robot(self, robot: int | str) -> None:
        """Remove a robot, by number or id, from the world, between two timesteps.

        Its program ends, its result is kept. A robot that has not joined yet never joins.

        Raises:
            ValueError: there is no such robot, or it has left already.
        """
        if isinstance(robot, str):
            ids = [each.id for each in self.environment.world.robots]
            if robot not in ids:
                raise ValueError(unknown("robot", robot, ids))
            robot = ids.index(robot)
        self.environment.remove_robot(robot)
        self.update_presence()

    def result(self) -> RunResult:
        """Return the result of the run so far."""
        robots = tuple(map(self.robot_result, range(len(self.fleet))))
        goals = self.environment.goals
        places = self.environment.sources, self.environment.nests
        return RunResult(robots, self.timesteps, self.time_s, self.state_hash(), goals, *places)

    def robot_result(self, robot: int) -> RobotResult:
        """Return the result of one robot so far."""
        outcome = self._outcome(robot)
        return RobotResult(
            id=self.environment.world.robots[robot].id,
            program=self.fleet.executable(robot).name,
            outcome=outcome,
            exit_status=self.host.exit_status[robot],
            error=self.fleet.report(robot) if outcome == "failed" else None,
            time_s=self.time_s if outcome == "running" else float(self.ended_s[robot]),
            fuel=int(self.fuel[robot]),
            robot_call_s=self._robot_call_s(robot),
            **robot_state(self.environment.state, robot),
        )

    def request_on_link(self, robot: int) -> tuple[int, float] | None:
        """Return the code of the request that is on the link, and when it arrives [s].

        None if there is none: the program is running, is waiting for an event, or has ended.
        """
        due_s = float(self.due_s[robot])
        return None if due_s == NEVER_S else (int(self.fleet.slots["code"][robot]), due_s)

    def current_call(self, robot: int) -> ActiveCall | None:
        """Return the innermost active call in the user's files of a running program.

        None for one that has not started, or has ended.
        """
        return self.fleet.current_call(robot) if self.alive[robot] else None

    def lost_blocks(self, robot: int) -> tuple[LostBlocks, ...]:
        """Return the heap blocks that nothing points to at the end of a program that has exited."""
        has_exited = self.host.exit_status[robot] is not None
        return self.fleet.lost_blocks(robot) if has_exited else ()

    def snapshot(self) -> SessionSnapshot:
        """Return the whole state, between two timesteps or wherever a program has stopped.

        The position in standard input is not part of it: `read` belongs to the caller, who must
        rewind it for a restored session.
        """
        return SessionSnapshot(
            tuple(self._added),
            self.environment.snapshot(),
            tuple(self.fleet.snapshot(robot) for robot in range(len(self.fleet))),
            tuple(array.copy() for array in self._arrays()),
            tuple(self.host.exit_status),
            tuple(disk.snapshot() for disk in self.host.disks),
            self.network.snapshot(),
            self.timesteps,
            self.rounds,
            self.halted,
        )

    def restore(self, snapshot: SessionSnapshot) -> None:
        """Restore a snapshot of a session of the same programs, world and seed.

        Robots that were added before the snapshot exist again, others are removed.
        """
        self.environment.restore(snapshot.environment)
        self._present = self.environment.present
        self._set_added(snapshot.added)
        for robot, program in enumerate(snapshot.programs):
            self.fleet.restore(robot, program)
        self._bind_timing()
        for name, saved in zip(_INITIAL, snapshot.arrays, strict=True):
            if name in _TIMING:
                getattr(self, name)[:] = saved
            else:
                setattr(self, name, saved.copy())
        self.host.exit_status[:] = snapshot.exit_status
        for disk, files in zip(self.host.disks, snapshot.disks, strict=True):
            disk.restore(files)
        self.network.restore(snapshot.network)
        self.timesteps = snapshot.timesteps
        self.rounds, self.halted = snapshot.rounds, snapshot.halted

    def restore_programs(self, snapshot: SessionSnapshot, robots: Iterable[int]) -> None:
        """Restore programs of a snapshot and their clocks, but not the world.

        That is enough for programs to run again, if they are given what they were given. Those of
        other robots stay where they are, and do not run.
        """
        self.fleet.slots["run"] = 0
        for robot in robots:
            self.fleet.restore(robot, snapshot.programs[robot])
        for name, saved in zip(_INITIAL, snapshot.arrays, strict=True):
            getattr(self, name)[: len(saved)] = saved
        self.timesteps = snapshot.timesteps
        self.rounds, self.halted = snapshot.rounds, snapshot.halted

    def state_hash(self) -> str:
        """Return the SHA-256 of all state, see `RunResult`."""
        digest = hashlib.sha256(self.environment.hash().encode())
        for robot in np.flatnonzero(np.isfinite(self.environment.state.presence.joined_s)).tolist():
            program = self.fleet.snapshot(robot)  # others have not run
            for part in fields(program):
                digest.update(getattr(program, part.name).tobytes())
        for disk in self.host.disks:
            for piece in disk.state():
                digest.update(piece)
        digest.update(self.network.hashed())
        for array in self._arrays():
            digest.update(array.tobytes())
        digest.update(repr(self.host.exit_status).encode())
        return digest.hexdigest()

    def _outcome(self, robot: int) -> Outcome:
        if self.alive[robot]:
            return "running"
        if self.fleet.slots["status"][robot] == FAILED:
            return "failed"
        if self.host.exit_status[robot] is not None:
            return "exited"
        joined_s = self.environment.state.presence.joined_s[robot]
        return "left" if math.isfinite(joined_s) else "absent"

    def _robot_call_s(self, robot: int) -> float | None:
        if self.alive[robot] and (self.due_s[robot] < NEVER_S or self.clock_s[robot] == NEVER_S):
            return self.time_s
        called_s = float(self.called_s[robot])
        return called_s if math.isfinite(called_s) else None

    def _bind_timing(self) -> None:
        """Take the arrays of the fleet's programs, which are new if there are more or fewer."""
        timing = self.fleet.timing
        self.clock_s, self.due_s = timing["clock_s"], timing["due_s"]
        self.fuel, self.pending, self.alive = timing["fuel"], timing["pending"], timing["alive"]
        self.speed_hz = timing["speed_hz"]
        robots = self.environment.world.robots
        self.speed_hz[:] = [robot.model.host_speed_hz for robot in robots]

    def _add_rows(self, first: int) -> None:
        """Add array elements for the robots from number `first` on, which are new in the fleet."""
        self._bind_timing()
        for name, initial in _INITIAL.items():
            array = getattr(self, name)
            if name not in _TIMING:
                array = np.append(array, np.zeros(len(self.fleet) - first))
                setattr(self, name, array)
            array[first:] = initial

    def update_presence(self) -> None:
        """Start the programs of robots that have joined, end those of robots that have left."""
        before, now = self._present, self.environment.present
        if now is before:
            return
        self._present = now
        joined, left = np.flatnonzero(now & ~before), np.flatnonzero(before & ~now & self.alive)
        self.alive[joined] = True
        self.clock_s[joined] = self.time_s
        self.clock_s[left] = self.time_s
        self.due_s[left] = NEVER_S
        self.end(left)

    def end(self, robots: IndexArray) -> None:
        """End programs at their current clocks."""
        self.alive[robots] = False
        self.ended_s[robots] = self.clock_s[robots]

    def _set_added(self, added: Sequence[Added]) -> None:
        """Make these the added programs, keeping those that are the same."""
        pairs = zip(self._added, added, strict=False)
        same = sum(1 for _ in takewhile(lambda pair: pair[0] is pair[1], pairs))
        first = len(self.fleet) - len(self._added)
        self.fleet.truncate(first + same)
        self.host.truncate(first + same)
        del self.unconnected_calls[first + same :]
        self._added = list(added)
        for each in added[same:]:
            self.fleet.add(each.executable)
            self.host.add(each.arguments)
            self.unconnected_calls.append(None)

    def _arrays(self) -> tuple[npt.NDArray[Any], ...]:
        """Return the arrays over robots."""
        return tuple(getattr(self, name) for name in _INITIAL)
