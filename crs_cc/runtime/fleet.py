"""The fleet: all robots' programs, in shards, with one mailbox and one call for a round of all.

The owner of a fleet sets `run` and `fuel` in the slots of the robots to be resumed, calls
`run_round`, and finds in each slot why the program returned: a request to serve, no fuel left,
exit, or a run-time error.

>>> from crs_cc.runtime.testing import counting_program
>>> fleet = Fleet([counting_program()] * 2)
>>> fleet.slots["run"] = 1
>>> fleet.slots["fuel"] = 1000
>>> fleet.run_round()
>>> fleet.slots["code"].tolist()        # both posted EXIT
[1, 1]
"""

from __future__ import annotations

import functools
import time
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt
import wasmtime

from crs_cc.core.arrays import ByteArray, IndexArray, Records
from crs_cc.core.source import Location
from crs_cc.requests import ERROR_KINDS, FAILED, MESSAGE
from crs_cc.runtime import resident_pages
from crs_cc.runtime.driver import MAX_SHARDS, SLOTS
from crs_cc.runtime.executable import Driver, Executable, compile_driver
from crs_cc.runtime.shard import Mailbox, RunResult, Sandbox, Shard, Trapped, memory_errors
from crs_cc.runtime.site_tests import STOP, TEST, UNPASSED, SiteTests
from crs_cc.runtime.snapshot import Snapshot
from crs_cc.runtime.turns import RECORD
from crs_cc.runtime.watch_ranges import WATCHED
from crs_cc.runtime.workers import default_threads, run_all

if TYPE_CHECKING:
    from crs_cc.runtime.diagnosis.active_call import ActiveCall
    from crs_cc.runtime.diagnosis.compared_pointers import ComparedPointers
    from crs_cc.runtime.diagnosis.failure import Failure
    from crs_cc.runtime.diagnosis.inspect import CallStack, StackFrame, StoppedProgram
    from crs_cc.runtime.diagnosis.lost_blocks import LostBlocks
    from crs_cc.runtime.diagnosis.report import ErrorReport
    from crs_cc.runtime.partner import Partner
    from crs_cc.runtime.sites import Access

MEMORY_END: Final = 0xFFFFFFFF  # the largest address
PARALLEL_S: Final = 0.00015
"""Rounds that take more processor time than this on average run in several threads, which costs
some tens of microseconds."""


class Fleet:
    """Robots' programs and their slots.

    Attributes:
        slots: the slots, an array of dtype `SLOT`, one for each robot.
        codes: the codes in them.
        timing: the programs' clocks, an array of dtype `TIMING`; of no use to `run_round`.
        marks: for each robot with a debug build, a byte for each statement: 1 to stop
            before it. A round ends at the first robot that stops.
        watched: for each robot, its watched ranges, one element of dtype `WATCHED`;
            only watching builds use them.
        has_marks: whether any program may stop before a marked statement.
    """

    def __init__(
        self,
        executables: Sequence[Executable],
        driver: Driver | None = None,
        threads: int | None = None,
    ) -> None:
        """Create a sandbox for each program.

        Args:
            executables: the programs.
            driver: the module that `compile_driver` returns, if it is known.
            threads: how many threads may run programs at the same time, `MAX_SHARDS` at most;
                by default as many as there are processors. No result depends on it.

        Raises:
            OSError: there is not enough memory or address space.
        """
        shards = default_threads(executables) if threads is None else min(threads, MAX_SHARDS)
        with memory_errors(len(executables)):
            self._create(executables, driver or compile_driver(), shards)

    def _create(self, executables: Sequence[Executable], driver: Driver, shards: int) -> None:
        self._mailbox = Mailbox.of_size(_size(len(executables)))
        self._shards = [Shard(self._mailbox, number, driver) for number in range(shards)]
        self.marks: list[ByteArray] = []
        self.watched: list[Records] = []
        self._sandboxes: list[Sandbox] = []
        self._builds: list[list[Sandbox]] = []  # of each program, all builds used
        self._fresh: list[Snapshot | None] = []  # of added programs
        self._stacks: dict[int, CallStack] = {}  # of programs that were inspected
        self._round_s = 0.0
        self.has_marks = False
        for executable in executables:
            self._instantiate(executable)
        self._resize_slots(0, len(executables))

    def _shard(self, robot: int) -> Shard:
        return self._shards[robot % len(self._shards)]

    def __len__(self) -> int:
        return len(self.slots)

    def add(self, executable: Executable) -> int:
        """Create a sandbox for one more program, and return its number.

        Replaces `slots`, `codes` and `timing`.

        Raises:
            OSError: as for a new fleet.
        """
        number = len(self)
        fresh = self._fresh[number] if number < len(self._fresh) else None
        if fresh is not None and self._builds[number][0].executable is executable:
            self._resize_slots(number, number + 1)
            self.exchange(number, executable)
            self.restore(number, fresh)
            return number
        for spare in (self._sandboxes, self._builds, self.marks, self.watched, self._fresh):
            del spare[number:]
        with memory_errors(1):
            self._instantiate(executable)
            self._resize_slots(number, number + 1)
        self._fresh[number] = self.snapshot(number)
        return number

    def truncate(self, count: int) -> None:
        """Remove all programs but the first `count`; the removed may be added again."""
        self._resize_slots(count, count)

    def _resize_slots(self, first: int, count: int) -> None:
        """Set `slots` for `count` programs, initialised from number `first` on."""
        self._mailbox.resize(_size(count))
        mailbox = self._mailbox.view()
        records = mailbox[SLOTS : SLOTS + count * RECORD.itemsize].view(RECORD)
        records[first:] = np.zeros((), RECORD)
        self._use(records)

    def _use(self, records: Records) -> None:
        """Set slots and clocks."""
        self.slots, self.timing = records["slot"], records["timing"]
        self.codes, self._requesting = self.slots["code"], self.timing["asks"]
        self._messages = self.slots["message"].view(_BYTES)
        self.sizes = self.slots["message"]["size"]

    def table(self) -> npt.NDArray[np.uint64]:
        """Return slots and clocks as 64-bit words, a row for each program."""
        words = self._mailbox.view()[SLOTS : _size(len(self))].view(np.uint64)
        return words.reshape(len(self), RECORD.itemsize // 8)

    def _instantiate(self, executable: Executable) -> None:
        """Append a new program."""
        sandbox = self._shard(len(self._sandboxes)).sandbox(executable)
        self.marks.append(_NO_MARKS)
        self.watched.append(_NO_MARKS.view(WATCHED))
        self._sandboxes.append(sandbox)
        self._builds.append([sandbox])
        self._fresh.append(None)
        self._assign(len(self._sandboxes) - 1, sandbox)

    def _assign(self, robot: int, sandbox: Sandbox) -> None:
        """Assign a sandbox to a robot."""
        self._shard(robot).assign(robot, sandbox)
        self._sandboxes[robot] = sandbox
        if len(sandbox.marks):
            self.has_marks = True
            self.marks[robot] = sandbox.marks[WATCHED.itemsize :]
            self.watched[robot] = sandbox.marks[: WATCHED.itemsize].view(WATCHED)

    def exchange(self, robot: int, executable: Executable) -> None:
        """Move a robot's program, in its current state, to another build with the same frames.

        Its marks are copied; watched ranges are not. Builds that were used once are kept, so that
        switching back and forth costs no more than a snapshot.

        Args:
            robot: the robot's number.
            executable: a debug or watching build of the robot's program.

        Raises:
            OSError: as for a new fleet.
        """
        old = self._sandboxes[robot]
        if old.executable is executable:
            return
        builds = self._builds[robot]
        new = next((each for each in builds if each.executable is executable), None)
        if new is None:
            with memory_errors(1):
                new = self._shard(robot).sandbox(executable)
            builds.append(new)
        state, marks = self.snapshot(robot), self.marks[robot]
        self._assign(robot, new)
        self.restore(robot, state)
        stops = np.minimum(marks % UNPASSED, STOP)  # its tests are those of the other build
        self.marks[robot][:] = marks - marks % UNPASSED + stops

    def executable(self, robot: int) -> Executable:
        """Return a robot's program."""
        return self._sandboxes[robot].executable

    def set_tests(self, robot: int, tests: SiteTests) -> None:
        """Make a program in a debug build test conditions at some sites, instead of stopping."""
        self._shard(robot).set_tests(self._sandboxes[robot], tests)
        sites, marks = list(tests.sites), self.marks[robot]
        marks[sites] = marks[sites] & UNPASSED | TEST

    def memory(self, robot: int) -> ByteArray:
        """Return a live view of a robot's memory."""
        return self._sandboxes[robot].memory

    def shadow(self, robot: int) -> ByteArray:
        """Return a live view of a robot's shadow memory; empty in unchecked builds."""
        return self._sandboxes[robot].shadow

    def messages(self, robots: IndexArray) -> Records:
        """Return copies of the messages that robots posted, of dtype `MESSAGE`."""
        # Quicker than views, which look at the fields.
        return np.ndarray(len(robots), MESSAGE, self._messages[robots])

    def reply(self, robots: IndexArray, messages: Records) -> None:
        """Overwrite posted messages with replies."""
        self._messages[robots] = np.ndarray(len(robots), _BYTES, messages)

    def run_round(self) -> int | None:
        """Resume every robot whose slot has `run` set.

        Return the first one that stops before a marked statement, which ends the round: those after
        it have not run. None if all have.
        """
        if len(self._shards) == 1:
            return self._run_in_order(range(len(self)))
        if self.has_marks:
            return self._run_by_robot()
        self._run_shards(None)
        return None

    @property
    def is_whole(self) -> bool:
        """Whether `run_rounds` runs rounds until a program posts a request."""
        return len(self._shards) == 1

    def run_rounds(self, end_s: float) -> int:
        """Run rounds of all robots whose clocks have not reached a time; see `turns`.

        Return the number of rounds: the last is that after which nobody has to run, or one in which
        a program has posted a request. No program may have marks.
        """
        if len(self._shards) > 1:
            return self._run_shards(end_s)
        ran = self._shards[0].run(range(len(self)), end_s, _UNLIMITED)
        self._record_traps(ran.trapped, ends_turn=True)
        return ran.rounds

    def partner(self, executable: Executable) -> Partner | None:
        """Start a program that takes turns with all others, see `Partner`.

        None if the fleet has several shards, or its programs may stop or run elsewhere.
        """
        if len(self._shards) != 1 or self.has_marks:
            return None
        from crs_cc.runtime.partner import Partner  # not needed by a run that computes only

        shard = self._shards[0]
        for _ in range(2):  # the program, and what joins it with the driver
            shard.raise_instance_limit()
        return Partner(shard, executable, self._end_turn)

    def _end_turn(self, trap: Exception) -> int:
        """Record a trap in a turn; return the rounds that the partner was not told of."""
        ran = self._shards[0].end_turn(trap, len(self))
        self._record_traps(ran.trapped, ends_turn=True)
        return ran.rounds

    def begin_round(self, end_s: float) -> bool:
        """Make all robots whose clocks have not reached a time run; return whether there are any.

        `run_round` and `end_round` are to follow.
        """
        return self._shards[0].begin(range(len(self)), end_s)

    def end_round(self) -> None:
        """Advance the clocks of the robots that have run, and answer requests about time."""
        self._shards[0].end(range(len(self)))

    def take_requesting(self) -> IndexArray:
        """Return the robots that have posted requests since the last call."""
        requesting = self._requesting.nonzero()[0]
        if requesting.size:
            self._requesting[requesting] = 0
        return requesting

    def _run_by_robot(self) -> int | None:
        """Run programs that may stop: in their order, since those after the first must not run."""
        for robot in np.flatnonzero(self.slots["run"]).tolist():
            if self._run_in_order(range(robot, robot + 1)) is not None:
                return int(robot)
        return None

    def _run_in_order(self, robots: range) -> int | None:
        """Run robots of one shard; return the first that stops before a marked statement."""
        ran = self._shard(robots.start).run(robots)
        self._record_traps(ran.trapped)
        return ran.stopped

    def _run_shards(self, end_s: float | None) -> int:
        """Run a round of all shards, in several threads if it takes long enough.

        Return 0 if nobody had to run, else 1.
        """
        count = len(self._shards)
        every: list[RunResult] = []
        times_s: list[float] = []

        def run(number: int) -> None:
            start = time.thread_time()
            robots = range(number, len(self), count)
            every.append(self._shards[number].run(robots, end_s))
            times_s.append(time.thread_time() - start)

        if self._round_s > PARALLEL_S:
            run_all([functools.partial(run, part) for part in range(count)])
        else:
            for part in range(count):
                run(part)
        self._round_s += (sum(times_s) - self._round_s) / 8
        for ran in every:
            self._record_traps(ran.trapped, ends_turn=end_s is not None)
        return max(ran.rounds for ran in every)

    def _record_traps(self, trapped: Sequence[Trapped], *, ends_turn: bool = False) -> None:
        for robot, trap in trapped:
            self._trapped(robot, trap)
            if ends_turn:
                self._shards[0].end(range(robot, robot + 1))

    def _trapped(self, robot: int, trap: Exception) -> None:
        """Record a trap as the robot's failure, so that the others continue."""
        slot = self.slots[robot]
        slot["status"] = FAILED
        slot["fuel"] = min(int(slot["fuel"]), 0)
        begun = self._sandboxes[robot].begun
        if begun is not None:
            slot["statements"] = begun.value(self._shard(robot).store)
        outside = wasmtime.TrapCode.MEMORY_OUT_OF_BOUNDS
        if isinstance(trap, wasmtime.Trap) and trap.trap_code is outside:
            if not len(self.shadow(robot)):
                # The only trap in unchecked code, which stores no site.
                slot["error_kind"] = ERROR_KINDS.index("pointer outside memory")
                return
            from crs_cc.runtime.diagnosis.trap import blamed_site  # rarely needed

            compiled = self.executable(robot).detail().compiled
            site = blamed_site(trap, self.memory(robot), compiled)
            if site is not None:
                slot["error_site"], slot["error_address"] = site, MEMORY_END
                return
        deep = "call stack exhausted" in str(trap)
        slot["error_kind"] = ERROR_KINDS.index("stack overflow" if deep else "internal trap")

    def failure(self, robot: int) -> Failure:
        """Return the failure of a robot with status FAILED."""
        slot = self.slots[robot]
        # Rarely needed.
        from crs_cc.runtime.diagnosis.diagnose import diagnose
        from crs_cc.runtime.diagnosis.failure import Failure
        from crs_cc.runtime.diagnosis.objects import find_object, of_variable

        value = int(slot["error_address"])
        if slot["error_kind"]:
            kind = ERROR_KINDS[slot["error_kind"]]
            return Failure(kind, Location(self.executable(robot).name), value)
        site = self.executable(robot).detail().compiled.sites[slot["error_site"]]
        trapped = value == MEMORY_END and site.size > 1
        stopped = self.stopped(robot, site.location, saved=not trapped)
        kind, stack, size, found = site.kind, tuple(stopped.stack), site.size, None
        if kind == "memory":
            kind, value, found = diagnose(stopped, value, size, site.access)
        elif kind in _WITH_OBJECT:
            found = find_object(stopped, value)
        elif site.variable is not None:
            found = of_variable(stopped, site.variable)
        array = None
        if site.array is not None:
            array = site.array, int(slot["error_base"])
            found = find_object(stopped, array[1])
        elif site.kind == "out of bounds":
            found = find_object(stopped, int(slot["error_base"]))
        other = None
        if kind == "unrelated pointers":
            other = find_object(stopped, int(slot["error_base"]))
        size = size or int(slot["error_size"])
        access: Access = "write" if kind == "write to read-only memory" else site.access
        found_there = found, stopped, array, other, site.ctype
        return Failure(kind, site.location, value, stack, access, size, *found_there)

    def stopped(
        self, robot: int, failed_at: Location | None = None, *, saved: bool = True
    ) -> StoppedProgram:
        """Return a suspended program for inspection, see `StoppedProgram`."""
        from crs_cc.runtime.diagnosis.inspect import StoppedProgram, call_stack, refreshed

        detail, memory = self.executable(robot).detail(), self.memory(robot)
        stack: Sequence[StackFrame]
        if failed_at is None:
            stack = refreshed(self._stacks.get(robot), memory, detail.compiled)
            self._stacks[robot] = stack
        else:
            stack = call_stack(memory, detail.compiled, failed_at)
        parts = detail.program, detail.compiled, detail.lines, stack, saved
        return StoppedProgram(memory, self.shadow(robot), *parts)

    def current_call(self, robot: int) -> ActiveCall | None:
        """Return the innermost active call in the user's files.

        None before a program has been resumed, and after it has ended.
        """
        from crs_cc.runtime.diagnosis.report import current_call  # rarely needed

        return current_call(self.stopped(robot))

    def library_call(self, robot: int) -> ActiveCall | None:
        """Return the library function called by the user's code, with the call's location."""
        from crs_cc.runtime.diagnosis.report import library_call  # rarely needed

        return library_call(self.stopped(robot))

    def lost_blocks(self, robot: int) -> tuple[LostBlocks, ...]:
        """Return the blocks of the heap that a robot's program has lost."""
        from crs_cc.runtime.diagnosis.lost_blocks import lost_blocks  # rarely needed

        return lost_blocks(self.stopped(robot))

    def compared_pointers(self, robot: int) -> ComparedPointers | None:
        """Return the first comparison of pointers to different objects, if there was one."""
        from crs_cc.runtime.diagnosis.compared_pointers import compared_pointers  # rarely needed

        timing = self.timing[robot]
        if not timing["compared_site"]:
            return None
        site = self.executable(robot).detail().compiled.sites[int(timing["compared_site"]) - 1]
        pointers = int(timing["compared_left"]), int(timing["compared_right"])
        return compared_pointers(self.stopped(robot), site.location, pointers)

    def report(self, robot: int) -> ErrorReport:
        """Return the error report of a robot with status FAILED."""
        from crs_cc.runtime.diagnosis.report import report  # rarely needed

        return report(self.failure(robot))

    def snapshot(self, robot: int) -> Snapshot:
        """Return the whole state of one robot's program, breakpoints excluded."""
        slot = self.slots[robot : robot + 1].copy()
        for name in STOP_FIELDS:
            slot[name] = 0
        sandbox = self._sandboxes[robot]
        kept = resident_pages.save(sandbox.memory, sandbox.initial)
        return Snapshot(slot, *kept, *resident_pages.save(sandbox.shadow, _NONE))

    def restore(self, robot: int, snapshot: Snapshot) -> None:
        """Restore a snapshot of one robot's program."""
        sandbox = self._sandboxes[robot]
        resident_pages.load(sandbox.memory, sandbox.initial, snapshot.chunks, snapshot.content)
        resident_pages.load(sandbox.shadow, _NONE, snapshot.shadow_chunks, snapshot.shadow_content)
        slot = self.slots[robot : robot + 1]
        stops = {name: slot[name].copy() for name in STOP_FIELDS}
        slot[:] = snapshot.slot
        for name, value in stops.items():
            slot[name] = value


def _size(programs: int) -> int:
    """Return the size of the mailbox for a number of programs [bytes]."""
    return SLOTS + programs * RECORD.itemsize


_BYTES: Final = np.dtype(("V", MESSAGE.itemsize))  # numpy copies fields one by one
_WITH_OBJECT: Final = frozenset(
    {
        "invalid free", "double free", "overlapping copy", "unrelated pointers",
        "mismatched argument",
    }
)  # fmt: skip
"""Kinds of errors whose value is the address of an object."""
_NO_MARKS: Final = np.zeros(0, np.uint8)
_NONE: Final = range(0)
_UNLIMITED: Final = 2**31
STOP_FIELDS: Final = ("stop_before_all", "stop_from")
"""Fields that control where a program stops, which are not part of its state."""
