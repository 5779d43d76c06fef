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
from collections.abc import Mapping, Sequence
from dataclasses import fields
from itertools import takewhile
from typing import TYPE_CHECKING, Any, Final, Protocol

import numpy as np
import numpy.typing as npt

from crs_cc.requests import CODES, FAILED, REQUESTS, SUSPENDED
from crs_cc.runtime.fleet import Fleet
from crs_cc.session.host import (
    HOST_CODES,
    SYSTEM_CALL,
    TIME_SERVERS,
    Host,
    HostRequest,
    discard,
    no_input,
)
from crs_cc.session.result import (
    Added,
    Outcome,
    RobotResult,
    RunResult,
    SessionSnapshot,
    robot_state,
)
from crs_cc.sim.environment import Environment

if TYPE_CHECKING:
    from crs_cc.runtime.diagnosis.active_call import ActiveCall
    from crs_cc.runtime.executable import Executable
    from crs_cc.session.host import Client, Input, Output, TimeServer
    from crs_cc.sim.model import Robot, WorldModel
    from crs_cc.sim.step import Step

ENDLESS = math.inf

_GOES_OUT = np.isin(np.arange(max(REQUESTS) + 2), list(REQUESTS.keys() - HOST_CODES))
"""By code, whether a request goes over the link; the last stands for all codes beyond."""
_NOTHING: Final[dict[str, float]] = {
    "clock_s": 0.0,
    "fuel": 0,
    "_alive": False,
    "_due_s": ENDLESS,
    "_ended_s": 0.0,
    "_called_s": -math.inf,
}
"""The session's own state, arrays over robots, and what they hold of a robot that has not begun."""


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
        self._alive = np.zeros(count, bool)
        self._due_s = np.full(count, ENDLESS)  # when a request has come through the link
        self._ended_s = np.zeros(count)
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
        return int(self._alive.sum())

    def step(self) -> bool:
        """Runs one timestep; gives False when all programs have ended."""
        end_s = self.environment.end_s
        while True:
            self._answer_robots(end_s)
            ready = np.flatnonzero(self._alive & (self.clock_s < end_s) & (self._due_s == ENDLESS))
            if not ready.size:
                break
            self._resume(ready, end_s)
        step = self.environment.step()
        self.clock_s[step.robots] = self._called_s[step.robots] = step.at_s
        self.fleet.reply(step.robots, step.messages)
        self.timesteps += 1
        self._meet()
        if self._trace is not None:
            self._trace.step(step)
        return self.running > 0 or self.environment.awaits

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
                raise ValueError(f"there is no robot {robot!r}")
            robot = ids.index(robot)
        self.environment.remove_robot(robot)
        self._meet()

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
        joined, left = np.flatnonzero(now & ~before), np.flatnonzero(before & ~now & self._alive)
        self._alive[joined] = True
        self.clock_s[joined] = self.time_s
        self.clock_s[left] = self.time_s
        self._due_s[left] = ENDLESS
        self._end(left)

    def _resume(self, ready: npt.NDArray[np.intp], end_s: float) -> None:
        """Lets programs run until each has posted a request or used up the cycle."""
        slots = self.fleet.slots
        budget = np.ceil((end_s - self.clock_s[ready]) * self._speed_hz[ready]).astype(np.int64)
        slots["run"][ready] = 1
        slots["fuel"][ready] = budget
        self.fleet.run_round()
        burnt = budget - slots["fuel"][ready]
        self.fuel[ready] += burnt
        self.clock_s[ready] += burnt / self._speed_hz[ready]
        self._end(ready[slots["status"][ready] != SUSPENDED])
        codes = slots["code"][ready]
        posted = (slots["status"][ready] == SUSPENDED) & (codes != 0)
        asked, codes = ready[posted], codes[posted]
        goes_out = _GOES_OUT.take(codes, mode="clip")
        if goes_out.any():
            self._send(asked[goes_out], codes[goes_out])
        if not goes_out.all():
            self._answer_hosts(asked[~goes_out], codes[~goes_out])

    def _send(self, robots: npt.NDArray[np.intp], codes: npt.NDArray[np.int32]) -> None:
        """Puts requests on the link."""
        sizes = self.fleet.slots["message"]["size"][robots]
        link_s = self.environment.link_s(codes, robots, sizes)
        if not link_s.all():  # else a program that asks without end would keep the simulator busy
            self._call_system(robots[link_s == 0.0])
        self._due_s[robots] = self.clock_s[robots] + link_s

    def _call_system(self, robots: npt.NDArray[np.intp]) -> None:
        """Lets programs pay for a request with their hosts' processor time."""
        self.fuel[robots] += SYSTEM_CALL
        self.clock_s[robots] += SYSTEM_CALL / self._speed_hz[robots]

    def _answer_hosts(self, robots: npt.NDArray[np.intp], codes: npt.NDArray[np.int32]) -> None:
        """Answers what programs ask of their hosts, at once."""
        self._call_system(robots)
        served = np.zeros(len(robots), dtype=np.bool_)
        for code, serve in TIME_SERVERS.items():
            same = codes == code
            if same.any():
                self._answer_time(serve, robots[same])
                served |= same
        left = zip(robots[~served].tolist(), codes[~served].tolist(), strict=True)
        for robot, code in left:
            self._answer_host(robot, code)

    def _answer_time(self, serve: TimeServer, robots: npt.NDArray[np.intp]) -> None:
        messages = self.fleet.messages(robots)
        used_s = self.fuel[robots] / self._speed_hz[robots]
        self.clock_s[robots] = serve(messages, self.clock_s[robots], used_s)
        self.fleet.reply(robots, messages)

    def _answer_host(self, robot: int, code: int) -> None:
        if code == CODES["UNCONNECTED"]:
            self.unconnected_calls[robot] = self.fleet.library_call(robot)
        message = self.fleet.slots["message"][robot : robot + 1][0]
        clock_s = float(self.clock_s[robot])
        used_s = float(self.fuel[robot] / self._speed_hz[robot])
        request = HostRequest(robot, message, clock_s, used_s)
        self.clock_s[robot] = self._host.serve(code, request)
        if self._host.exit_status[robot] is not None:
            self._end(np.array([robot]))

    def _answer_robots(self, end_s: float) -> None:
        """Serves the requests that come through the link before the end of the cycle."""
        due = np.flatnonzero(self._due_s < end_s)
        codes = self.fleet.slots["code"][due]
        for code in sorted(set(codes.tolist())):
            robots = due[codes == code]
            messages = self.fleet.messages(robots)
            self.clock_s[robots] = self.environment.serve(
                code, robots, messages, self._due_s[robots]
            )
            self.fleet.reply(robots, messages)
            self._called_s[robots] = self._due_s[robots]
            self._due_s[robots] = ENDLESS

    def _end(self, robots: npt.NDArray[np.intp]) -> None:
        self._alive[robots] = False
        self._ended_s[robots] = self.clock_s[robots]

    # -- what came out, and the whole state ---------------------------------------------------

    def result(self) -> RunResult:
        """Gives the run so far."""
        robots = tuple(map(self._robot_result, range(len(self.fleet))))
        return RunResult(robots, self.timesteps, self.time_s, self.state_hash())

    def _robot_result(self, robot: int) -> RobotResult:
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

    def _outcome(self, robot: int) -> Outcome:
        if self._alive[robot]:
            return "running"
        if self.fleet.slots["status"][robot] == FAILED:
            return "failed"
        if self._host.exit_status[robot] is not None:
            return "exited"
        joined_s = self.environment.state.presence.joined_s[robot]
        return "left" if math.isfinite(joined_s) else "absent"

    def _robot_call_s(self, robot: int) -> float | None:
        if self._alive[robot] and (self._due_s[robot] < ENDLESS or self.clock_s[robot] == ENDLESS):
            return self.time_s
        called_s = float(self._called_s[robot])
        return called_s if math.isfinite(called_s) else None

    def current_call(self, robot: int) -> ActiveCall | None:
        """Gives where a program stands that runs: the innermost function of the user's own files.

        None for one that has not begun, or has ended.
        """
        return self.fleet.current_call(robot) if self._alive[robot] else None

    def files(self, robot: int) -> dict[bytes, bytes]:
        """Gives the files that a robot's program made or changed, by name."""
        return self._host.disks[robot].outputs()

    def missed_files(self, robot: int) -> list[bytes]:
        """Gives the names of files that a robot's program has looked for in vain."""
        return self._host.disks[robot].missed

    def snapshot(self) -> SessionSnapshot:
        """Gives the whole state between two timesteps.

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
        return digest.hexdigest()

    def _arrays(self) -> tuple[npt.NDArray[Any], ...]:
        """Gives the session's own state, arrays over robots."""
        return tuple(getattr(self, name) for name in _NOTHING)
