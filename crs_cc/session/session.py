"""A run: programs and environment alternate, timestep by timestep.

Time is divided into cycles `[t, t + dt)`. In each cycle

1. every program that is not waiting runs until its own clock has passed the end of the cycle.
   Its clock advances by the processor time it uses (fuel) and by the transmission time of its
   commands on the link. When it posts a request it is suspended: requests to the host are answered
   at once, those to the robot when they arrive over the link, in this cycle or a later one;
2. the environment executes the cycle, with one slice of each running command from the hardware
   simulator. Programs whose waits ended in it resume in the next cycle.

All runnable programs are resumed in one call, and all requests with the same code are served in one
call, in the order of the codes; so a run is a function of programs, world and seed alone.

>>> from crs_cc.runtime.testing import counting_program
>>> from crs_cc.sim.files.world_xml import empty_world
>>> session = Session(empty_world(), [counting_program(rounds=42)])
>>> session.step()
False
>>> session.result().robots[0].exit_status
42
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol, Self

import numpy as np

from crs_cc.core.arrays import IndexArray, Int32Array, all_of
from crs_cc.requests import CODES, DEVICE_CODES, REQUESTS, SUSPENDED, SYSTEM_CALL
from crs_cc.runtime.executable import Executable
from crs_cc.session.calm_programs import CalmPrograms
from crs_cc.session.hints import Hint, Hints
from crs_cc.session.host import (
    HOST_CODES,
    Client,
    Host,
    HostRequest,
    Input,
    Output,
    Waiting,
    discard,
    never_waits,
    no_input,
)
from crs_cc.session.network.service import NETWORK_CODES
from crs_cc.session.quiet_programs import QuietPrograms
from crs_cc.session.result import RunResult, SessionSnapshot
from crs_cc.session.session_state import NEVER_S, SessionState
from crs_cc.sim.engine.goals import GoalResult
from crs_cc.sim.engine.step import Step
from crs_cc.sim.kernels.calm import ASKED, DONE, REFUSED
from crs_cc.sim.model.world import Robot, WorldModel

if TYPE_CHECKING:
    from crs_cc.runtime.fleet import Fleet

_ON_LINK = np.isin(
    np.arange(DEVICE_CODES.stop + 1),
    [*(REQUESTS.keys() - HOST_CODES - NETWORK_CODES), *DEVICE_CODES],
)
"""By code, whether a request is sent over the link; the last is for all larger codes."""
_RAN, _USED_UP, _ENDED = range(3)


class Listener(Protocol):
    """Is notified of every timestep: a trace, a viewer, a recording."""

    def step(self, step: Step) -> None:
        """Process what happened in a timestep that has ended."""


class Session:
    """A run of one program in each robot of a world.

    Attributes:
        state: all that changes in the run.
        environment: the world, a part of it.
        fleet: the programs, a part of it.
        network: the network, a part of it.
        calm: its calm time.
    """

    def __init__(
        self,
        world: WorldModel,
        executables: Sequence[Executable],
        seed: int | None = None,
        *,
        arguments: Sequence[Sequence[str]] = (),
        output: Output = discard,
        read: Input = no_input,
        files: Mapping[str, bytes] | None = None,
        client: Client = "nclient",
        waiting: Waiting = never_waits,
        trace: Listener | None = None,
        threads: int | None = None,
        observer: Listener | None = None,
        fleet: Fleet | None = None,
    ) -> None:
        """Load the programs into the robots, in the world's order of robots.

        Args:
            world: the world.
            executables: one program for each robot.
            seed: the random seed; by default the world's, or 0 if it has none.
            arguments: for each robot `argv`; by default the program's name and the arguments that
                the world gives the robot.
            output: receives the programs' output.
            read: returns their input.
            files: the initial contents of every program's disk, by file name.
            client: which of the vendor's client libraries to emulate.
            waiting: returns what can be read of their input.
            trace: is notified of every timestep.
            threads: how many threads may run programs, see `Fleet`, and measure, see
                `Environment`; results do not depend on it.
            observer: is notified of those in which something can happen, without `slices` if
                there is no trace. If it has a method `passed`, that is called with calm timesteps,
                all at once, see `sim.engine.passage`.
            fleet: the programs where they are loaded already, perhaps on other machines.

        Raises:
            ValueError: there is not one program for each robot.
        """
        if len(executables) != len(world.robots):
            raise ValueError(
                f"{len(executables)} programs for {len(world.robots)} robots (expected one each)"
            )
        rows = arguments or [
            [executable.command, *robot.arguments]
            for executable, robot in zip(executables, world.robots, strict=True)
        ]
        seed = world.seed or 0 if seed is None else seed
        self._world, self._seed = world, seed
        self._host = Host(rows, output, read, files, client, waiting=waiting)
        self.state = SessionState(world, executables, seed, self._host, threads, fleet=fleet)
        self.environment = self.state.environment
        self.fleet = self.state.fleet
        self.network = self.state.network
        self._trace, self._observer = trace, observer
        self._passed = getattr(observer, "passed", None)
        self._hints = Hints(self.environment, self.fleet)
        self.calm = CalmPrograms(self.state, self._hints)
        self._quiet = QuietPrograms(self.state)

    def close(self) -> None:
        """Let go of those who are notified or give input; results can be read afterwards.

        Where they have the session, it would wait for the garbage collector.
        """
        self._host.close()
        self._trace = self._observer = self._passed = None

    # -- the state -----------------------------------------------------------------------------

    @property
    def time_s(self) -> float:
        """Start of the current cycle [s]."""
        return self.environment.time_s

    @property
    def timesteps(self) -> int:
        """Number of timesteps run."""
        return self.state.timesteps

    @property
    def hints(self) -> Sequence[Hint]:
        """What is doubtful in the programs' calls and comparisons so far."""
        return [*self._hints.found, *self._hints.comparisons()]

    def add_robot(self, robot: Robot, executable: Executable, arguments: Sequence[str] = ()) -> int:
        """Add a robot, see `SessionState.add_robot`."""
        return self.state.add_robot(robot, executable, arguments)

    def remove_robot(self, robot: int | str) -> None:
        """Remove a robot, see `SessionState.remove_robot`."""
        self.state.remove_robot(robot)

    @property
    def goals(self) -> tuple[GoalResult, ...]:
        """The current status of the world's goals."""
        return self.environment.goals

    def result(self) -> RunResult:
        """Return the result of the run so far."""
        return self.state.result()

    def exit_status(self, robot: int) -> int | None:
        """Return the exit status of a robot's program; None unless it has exited."""
        return self._host.exit_status[robot]

    def files(self, robot: int) -> dict[bytes, bytes]:
        """Return the files that a robot's program created or changed, by name."""
        return self._host.disks[robot].outputs()

    def missed_files(self, robot: int) -> list[bytes]:
        """Return the names of files that a robot's program tried to open and did not find."""
        return self._host.disks[robot].missed

    def snapshot(self) -> SessionSnapshot:
        """Return the whole state, see `SessionState.snapshot`."""
        return self.state.snapshot()

    def restore(self, snapshot: SessionSnapshot) -> None:
        """Restore a snapshot of a session of the same programs, world and seed."""
        self.state.restore(snapshot)

    def save(self, path: Path) -> None:
        """Write the whole state to a file, between two timesteps; `Session.load` reads it.

        Raises:
            ValueError: robots have been added to the session, or have been dismissed.
            OSError: it cannot be written.
        """
        from crs_cc.session.snapshot_file import identity, write_snapshot

        snapshot = self.snapshot()
        if snapshot.added or snapshot.environment.world is not self._world:
            raise ValueError("a session whose set of robots has been changed cannot be saved")
        write_snapshot(path, snapshot, identity(self._world, self._seed, self.fleet))

    @classmethod
    def load(
        cls, path: Path, world: WorldModel, executables: Sequence[Executable], **options: Any
    ) -> Self:
        """Return a session that continues from a file written by `save`.

        Args:
            path: the file.
            world: the same world.
            executables: the same programs.
            options: the same options as of the session that was saved.

        Raises:
            RecordingError: the file is no snapshot, is damaged, or of another session or version.
            OSError: it cannot be read.
        """
        from crs_cc.session.snapshot_file import identity, read_snapshot, unusable

        session = cls(world, executables, **options)
        fresh = session.snapshot()
        wanted = identity(world, session._seed, session.fleet)
        snapshot = read_snapshot(path, wanted, world, fresh)
        try:
            session.restore(snapshot)
        except (ValueError, IndexError, TypeError, KeyError, AttributeError):
            raise unusable(path) from None
        return session

    def state_hash(self) -> str:
        """Return the SHA-256 of all state, see `RunResult`."""
        return self.state.state_hash()

    # -- one timestep --------------------------------------------------------------------------

    def step(self) -> bool:
        """Run one timestep; return False when all programs have ended and no robot is to join."""
        return self.advance(1)

    def advance(self, most: int, *, calmly: bool = False) -> bool:
        """Run at least one timestep, and further ones while nothing has happened in the world.

        Args:
            most: the maximum number of timesteps, at least 1.
            calmly: run further ones also in calm time, in which robots move, see `CalmPrograms`;
                return after one that is not calm.

        Returns:
            False when all programs have ended and no robot is to join.
        """
        end = self.timesteps + most
        self._run_quietly(end)
        while self.timesteps < end:
            until = end if calmly else self.timesteps + 1
            while (ran := self._run_round(until)) == _RAN:
                pass
            if ran == _ENDED:
                if not calmly or self.timesteps >= end or not self._can_continue:
                    break
                self._run_quietly(end)
                continue
            was_quiet = self._is_quiet
            if not self.end_cycle() or not (was_quiet and self._is_quiet):
                break
            self._run_quietly(end)
        self._report_passages()
        return self._can_continue

    def _run_quietly(self, end: int) -> None:
        """Run timesteps, up to a number of them, in which nothing happens, see `QuietPrograms`."""
        if self._is_quiet and not self.fleet.has_marks and self._can_continue:
            self._quiet.run(end, self._answer)

    def run_round(self) -> bool:
        """Run programs for one round; return False when all have used up the cycle.

        Further rounds follow while no program requests anything but the time. A debug build
        that stops at a breakpoint ends the call in the middle of the round; `halted` is its robot.
        The next call continues from there.
        """
        if self.fleet.has_marks:
            if not self.begin_round():
                return False
            self.run_programs()
            if self.state.halted is None:
                self.end_round()
            return True
        return self._run_round(self.timesteps) == _RAN

    def _run_round(self, until: int) -> int:
        """Run programs for one round; in calm time end cycles, up to a number of timesteps.

        Return `_RAN`, `_USED_UP` if all have used up the cycle, or `_ENDED` if cycles have ended
        and no other is to begin.
        """
        if self.fleet.has_marks:
            return _RAN if self.run_round() else _USED_UP
        before, verdict = self.timesteps, self._run_calmly(until)
        if verdict == ASKED:
            self._answer(self.fleet.take_requesting())
            return _RAN
        if self.timesteps > before and (self.timesteps >= until or not self._can_continue):
            return _ENDED
        if verdict == DONE:
            return _USED_UP if self.timesteps == before else _RAN
        if verdict != REFUSED:
            return _RAN
        return _RAN if self._run_general_round() else _USED_UP

    def _run_calmly(self, until: int) -> int:
        """Run programs, and cycles up to a number, while it is calm; return why it ended."""
        if self._is_quiet and not (self.state.due_s < self.environment.end_s).any():
            return REFUSED
        cycles = until - self.timesteps
        if self._trace is not None or (self._observer is not None and self._passed is None):
            cycles = 0
        return self.calm.run(cycles, keeps=self._passed is not None)

    def _run_general_round(self) -> bool:
        end_s = self.environment.end_s
        self._answer_robots(end_s)
        fleet = self.fleet
        rounds = fleet.run_rounds(end_s)
        if not rounds:
            return False
        self.state.rounds += rounds
        requesting = fleet.take_requesting()
        if requesting.size:
            self._answer(requesting)
            return True
        return not fleet.is_whole

    def begin_round(self) -> bool:
        """Select the programs to run and their fuel; return False when there is none.

        In the middle of a round, they are selected already.
        """
        if self.state.pending.any():
            return True
        end_s = self.environment.end_s
        self._answer_robots(end_s)
        return self.fleet.begin_round(end_s)

    def run_programs(self) -> None:
        """Resume the programs of this round, all or up to the first that halts."""
        state = self.state
        if state.halted is not None:
            self.fleet.slots["run"][state.halted] = 1
        state.halted = self.fleet.run_round()

    def end_round(self) -> None:
        """Advance the clocks of the programs that ran, and handle their requests."""
        self.fleet.end_round()
        self.state.rounds += 1
        self._answer(self.fleet.take_requesting())

    def _answer(self, requesting: IndexArray) -> None:
        """Answer programs that have asked for anything, by a request or as they have ended."""
        if not requesting.size:
            return
        fleet = self.fleet
        posted = fleet.slots["status"][requesting] == SUSPENDED
        if not all_of(posted):
            self.state.end(requesting[~posted])
            requesting = requesting[posted]
        codes = fleet.codes[requesting]
        on_link = _ON_LINK.take(codes, mode="clip")
        if all_of(on_link):
            self._send(requesting, codes)
            return
        if on_link.any():
            self._send(requesting[on_link], codes[on_link])
        self._answer_hosts(requesting[~on_link], codes[~on_link])

    def end_cycle(self) -> bool:
        """Execute the cycle in the environment when all programs have used it up.

        Return False when all programs have ended and no robot is to join.
        """
        state = self.state
        if self._is_quiet:
            self._quiet.skip(1)
            self.network.begin_cycle(state.clock_s, state.alive)
            return self._can_continue
        self.calm.is_worthwhile = True
        self._report_passages()
        step = self.environment.step(tells_slices=self._trace is not None)
        if len(step.robots):
            state.clock_s[step.robots] = state.called_s[step.robots] = step.at_s
            self.fleet.reply(step.robots, step.messages)
        state.timesteps += 1
        state.rounds = 0
        state.update_presence()
        self.network.begin_cycle(state.clock_s, state.alive)
        if self._trace is not None:
            self._trace.step(step)
        if self._observer is not None:
            self._observer.step(step)
        return self._can_continue

    def _report_passages(self) -> None:
        """Report the passages of calm time to the observer."""
        passages, self.calm.passages = self.calm.passages, []
        if self._passed is not None:
            for passage in passages:
                self._passed(passage)

    @property
    def _is_quiet(self) -> bool:
        """Whether nothing can happen in the world in this cycle, and there are no listeners."""
        return self._trace is None and self.environment.is_quiet

    @property
    def _can_continue(self) -> bool:
        return self.state.running > 0 or self.environment.expects_robots

    def now_s(self, robot: int) -> float:
        """Return a program's clock [s], also in the middle of a round."""
        state = self.state
        burnt = 0
        if state.pending[robot]:
            burnt = int(state.pending[robot] - self.fleet.slots["fuel"][robot])
        return float(state.clock_s[robot] + burnt / state.speed_hz[robot])

    def _send(self, robots: IndexArray, codes: Int32Array) -> None:
        """Send requests over the link."""
        self.calm.is_worthwhile = True
        state = self.state
        sizes = self.fleet.sizes[robots]
        link_s = self.environment.link_s(codes, robots, sizes)
        # Endless requests that take no time would never reach the end of the cycle.
        if np.count_nonzero(link_s) < len(link_s):
            self._charge_system_call(robots[link_s == 0.0])
        state.due_s[robots] = state.clock_s[robots] + link_s

    def _charge_system_call(self, robots: IndexArray) -> None:
        """Charge programs the processor time of a request to the host."""
        state = self.state
        state.fuel[robots] += SYSTEM_CALL
        state.clock_s[robots] += SYSTEM_CALL / state.speed_hz[robots]

    def _answer_hosts(self, robots: IndexArray, codes: Int32Array) -> None:
        """Answer requests to the host computers and their network, immediately."""
        self._charge_system_call(robots)
        for robot, code in zip(robots.tolist(), codes.tolist(), strict=True):
            self._answer_host(robot, code)

    def _answer_host(self, robot: int, code: int) -> None:
        state = self.state
        if code == CODES["UNCONNECTED"]:
            state.unconnected_calls[robot] = self.fleet.library_call(robot)
        message = self.fleet.slots["message"][robot : robot + 1][0]
        request = HostRequest(robot, message, float(state.clock_s[robot]))
        if code in NETWORK_CODES:
            state.clock_s[robot] = self.network.serve(code, request)
            return
        self._host.serve(code, request)
        if self._host.exit_status[robot] is not None:
            self._hints.note_exit(robot, float(state.clock_s[robot]))
            state.end(np.array([robot]))

    def _answer_robots(self, end_s: float) -> None:
        """Serve the requests that arrive over the link before the end of the cycle."""
        state = self.state
        due = (state.due_s < end_s).nonzero()[0]
        if not due.size:
            return
        codes = self.fleet.codes[due]
        kinds = [int(codes[0])] if all_of(codes == codes[0]) else sorted(set(codes.tolist()))
        for code in kinds:
            robots = due if len(kinds) == 1 else due[codes == code]
            messages, at_s = self.fleet.messages(robots), state.due_s[robots]
            self._hints.note_requests(code, robots, messages, at_s)
            state.clock_s[robots] = self.environment.serve(code, robots, messages, at_s)
            self.fleet.reply(robots, messages)
            state.called_s[robots] = at_s
            state.due_s[robots] = NEVER_S
