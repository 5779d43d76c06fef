"""The fleet: all robots' programs in one store, with one mailbox and one call for a round of all.

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

import contextlib
import ctypes
import errno
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np
import wasmtime

from crs_cc.core.arrays import ByteArray, IndexArray, Records
from crs_cc.core.source import Location
from crs_cc.requests import ERROR_KINDS, FAILED, MESSAGE, SLOT
from crs_cc.runtime import resident_pages
from crs_cc.runtime.driver import HEADER, SLOTS
from crs_cc.runtime.executable import Driver, Executable, compile_driver, engine
from crs_cc.runtime.layout import MEMORY_BYTES, PAGE, STACK_TOP
from crs_cc.runtime.resident_pages import CHUNK
from crs_cc.runtime.watch_ranges import WATCHED

if TYPE_CHECKING:
    from crs_cc.runtime.diagnosis.active_call import ActiveCall
    from crs_cc.runtime.diagnosis.failure import Failure
    from crs_cc.runtime.diagnosis.inspect import Stopped
    from crs_cc.runtime.diagnosis.report import ErrorReport

MEMORY_END: Final = 0xFFFFFFFF  # the largest address
_MOST_PAGES: Final = 2**16  # of the mailbox: the maximum, so that it never moves


@dataclass(frozen=True, slots=True)
class Snapshot:
    """The whole state of one program, which can be resumed in any fleet of the same program.

    Attributes:
        slot: its slot, one element of dtype `SLOT`.
        chunks: numbers of the non-zero chunks of memory.
        content: those chunks, shape (len(chunks), CHUNK).
        shadow_chunks: the same for the shadow memory; empty in unchecked builds.
        shadow_content: those chunks.
    """

    slot: Records
    chunks: IndexArray
    content: ByteArray
    shadow_chunks: IndexArray
    shadow_content: ByteArray


@dataclass(frozen=True, slots=True)
class _Sandbox:
    """An instance of a program, and its memories.

    Attributes:
        initial: chunks of its memory that hold initialised objects.
        begun: the global counting statements begun; None in builds without statements.
    """

    executable: Executable
    resume: wasmtime.Func
    memory: ByteArray
    shadow: ByteArray
    marks: ByteArray
    initial: range
    begun: wasmtime.Global | None


class Fleet:
    """Robots' programs and their slots.

    Attributes:
        slots: the slots, an array of dtype `SLOT`, one for each robot.
        marks: for each robot with a debug build, a byte for each statement: 1 to stop
            before it. A round ends at the first robot that stops.
        watched: for each robot, its watched ranges, one element of dtype `WATCHED`;
            only watching builds use them.
    """

    def __init__(self, executables: Sequence[Executable], driver: Driver | None = None) -> None:
        """Create a sandbox for each program.

        Args:
            executables: the programs.
            driver: the module that `compile_driver` returns, if it is known.

        Raises:
            OSError: there is not enough memory or address space.
        """
        with _memory_demanded(len(executables)):
            self._create(executables, driver or compile_driver())

    def _create(self, executables: Sequence[Executable], driver: Driver) -> None:
        self._store = wasmtime.Store(engine())
        limits = wasmtime.Limits(_pages(len(executables)), _MOST_PAGES)
        self._mailbox = wasmtime.Memory(self._store, wasmtime.MemoryType(limits))
        self.marks: list[ByteArray] = []
        self.watched: list[Records] = []
        self._sandboxes: list[_Sandbox] = []
        self._builds: list[list[_Sandbox]] = []  # of each program, all builds used
        self._fresh: list[Snapshot | None] = []  # of added programs
        self._made = 0
        self._start_driver(driver)
        for executable in executables:
            self._instantiate(executable)
        self._resize_slots(0, len(executables))

    def __len__(self) -> int:
        return len(self.slots)

    def add(self, executable: Executable) -> int:
        """Create a sandbox for one more program, and return its number; replaces `slots`.

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
        with _memory_demanded(1):
            self._instantiate(executable)
            self._resize_slots(number, number + 1)
        self._fresh[number] = self.snapshot(number)
        return number

    def truncate(self, count: int) -> None:
        """Remove all programs but the first `count`; the removed may be added again."""
        self._resize_slots(count, count)

    def _resize_slots(self, first: int, count: int) -> None:
        """Set `slots` for `count` programs, initialised from number `first` on."""
        more = _pages(count) - self._mailbox.size(self._store)
        if more > 0:
            self._mailbox.grow(self._store, more)
        mailbox = _view(self._store, self._mailbox)
        self._header = mailbox[: HEADER.itemsize].view(HEADER)
        self._header["count"] = count
        self.slots = mailbox[SLOTS : SLOTS + count * SLOT.itemsize].view(SLOT)
        self.slots[first:] = np.zeros((), SLOT)

    def _start_driver(self, driver: Driver) -> None:
        self._raise_instance_limit()
        exports = wasmtime.Instance(self._store, driver, [self._mailbox]).exports(self._store)
        round_, table = exports["round"], exports["robots"]
        assert isinstance(round_, wasmtime.Func)
        assert isinstance(table, wasmtime.Table)
        self._round, self._table = round_, table

    def _instantiate(self, executable: Executable) -> None:
        """Append a new program."""
        sandbox = self._sandbox(executable)
        self.marks.append(_NO_MARKS)
        self.watched.append(_NO_MARKS.view(WATCHED))
        self._sandboxes.append(sandbox)
        self._builds.append([sandbox])
        self._fresh.append(None)
        self._assign(len(self._sandboxes) - 1, sandbox)

    def _assign(self, robot: int, sandbox: _Sandbox) -> None:
        """Assign a sandbox to a robot."""
        size = self._table.size(self._store)
        if robot >= size:
            self._table.grow(self._store, max(robot + 1 - size, size), None)
        self._table.set(self._store, robot, sandbox.resume)
        self._sandboxes[robot] = sandbox
        if len(sandbox.marks):
            self.marks[robot] = sandbox.marks[WATCHED.itemsize :]
            self.watched[robot] = sandbox.marks[: WATCHED.itemsize].view(WATCHED)

    def _sandbox(self, executable: Executable) -> _Sandbox:
        self._raise_instance_limit()
        instance = wasmtime.Instance(self._store, executable.module(), [self._mailbox])
        own = instance.exports(self._store)
        resume, heap = own["resume"], own["heap"]
        assert isinstance(resume, wasmtime.Func)
        assert isinstance(heap, wasmtime.Global)
        memory = _view(self._store, own["memory"])
        shadow = _view(self._store, own["shadow"]) if "shadow" in own else _NO_SHADOW
        marks = _view(self._store, own["marks"]) if "marks" in own else _NO_MARKS
        begun = own.get("begun", None)
        assert begun is None or isinstance(begun, wasmtime.Global)
        end = -(-int(heap.value(self._store)) // CHUNK)
        initial = range(STACK_TOP // CHUNK, end)
        return _Sandbox(executable, resume, memory, shadow[:MEMORY_BYTES], marks, initial, begun)

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
            with _memory_demanded(1):
                new = self._sandbox(executable)
            builds.append(new)
        state, marks = self.snapshot(robot), self.marks[robot]
        self._assign(robot, new)
        self.restore(robot, state)
        self.marks[robot][:] = marks

    def _raise_instance_limit(self) -> None:
        """Raise the store's limit of instances by one: removed programs stay in it."""
        self._made += 1
        made = self._made
        self._store.set_limits(instances=made, memories=3 * made + 1, tables=made)

    def executable(self, robot: int) -> Executable:
        """Return a robot's program."""
        return self._sandboxes[robot].executable

    def memory(self, robot: int) -> ByteArray:
        """Return a live view of a robot's memory."""
        return self._sandboxes[robot].memory

    def shadow(self, robot: int) -> ByteArray:
        """Return a live view of a robot's shadow memory; empty in unchecked builds."""
        return self._sandboxes[robot].shadow

    def messages(self, robots: IndexArray) -> Records:
        """Return copies of the messages that robots posted, of dtype `MESSAGE`."""
        return self.slots["message"].view(_BYTES)[robots].view(MESSAGE)

    def reply(self, robots: IndexArray, messages: Records) -> None:
        """Overwrite posted messages with replies."""
        self.slots["message"].view(_BYTES)[robots] = messages.view(_BYTES)

    def run_round(self) -> int | None:
        """Resume every robot whose slot has `run` set.

        Return the first one that stops before a marked statement, which ends the round: those after
        it have not run. None if all have.
        """
        self._header["current"] = 0
        while True:
            try:
                self._round(self._store)
            except (wasmtime.Trap, wasmtime.WasmtimeError) as trap:
                robot = int(self._header["current"][0])
                self._trapped(robot, trap)
                self._header["current"] = robot + 1
                continue
            robot = int(self._header["current"][0])
            is_one = robot < len(self) and bool(self.slots["stopped"][robot])
            return robot if is_one else None

    def _trapped(self, robot: int, trap: Exception) -> None:
        """Record a trap as the robot's failure, so that the others continue."""
        slot = self.slots[robot]
        slot["status"] = FAILED
        slot["fuel"] = min(int(slot["fuel"]), 0)
        begun = self._sandboxes[robot].begun
        if begun is not None:
            slot["statements"] = begun.value(self._store)
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
        kind, stack, size, found = site.kind, stopped.stack, site.size, None
        if kind == "memory":
            kind, value, found = diagnose(stopped, value, size, site.access)
        elif kind in {"invalid free", "double free"}:
            found = find_object(stopped, value)
        elif site.variable is not None:
            found = of_variable(stopped, site.variable)
        size = size or int(slot["error_size"])
        return Failure(kind, site.location, value, stack, site.access, size, found, stopped)

    def stopped(
        self, robot: int, failed_at: Location | None = None, *, saved: bool = True
    ) -> Stopped:
        """Return a suspended program for inspection, see `Stopped`."""
        from crs_cc.runtime.diagnosis.inspect import Stopped, call_stack

        detail, memory = self.executable(robot).detail(), self.memory(robot)
        stack = tuple(call_stack(memory, detail.compiled, failed_at))
        parts = detail.program, detail.compiled, detail.lines, stack, saved
        return Stopped(memory, self.shadow(robot), *parts)

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

    def report(self, robot: int) -> ErrorReport:
        """Return the error report of a robot with status FAILED."""
        from crs_cc.runtime.diagnosis.report import report  # rarely needed

        return report(self.failure(robot))

    def snapshot(self, robot: int) -> Snapshot:
        """Return the whole state of one robot's program, breakpoints excluded."""
        slot = self.slots[robot : robot + 1].copy()
        for wish in _WISHES:
            slot[wish] = 0
        sandbox = self._sandboxes[robot]
        kept = resident_pages.save(sandbox.memory, sandbox.initial)
        return Snapshot(slot, *kept, *resident_pages.save(sandbox.shadow, _NONE))

    def restore(self, robot: int, snapshot: Snapshot) -> None:
        """Restore a snapshot of one robot's program."""
        sandbox = self._sandboxes[robot]
        resident_pages.load(sandbox.memory, sandbox.initial, snapshot.chunks, snapshot.content)
        resident_pages.load(sandbox.shadow, _NONE, snapshot.shadow_chunks, snapshot.shadow_content)
        slot = self.slots[robot : robot + 1]
        wishes = {name: slot[name].copy() for name in _WISHES}
        slot[:] = snapshot.slot
        for name, wish in wishes.items():
            slot[name] = wish


@contextlib.contextmanager
def _memory_demanded(programs: int) -> Iterator[None]:
    """Translate wasmtime's out-of-memory error."""
    try:
        yield
    except wasmtime.WasmtimeError as error:
        if f"os error {errno.ENOMEM}" not in str(error):
            raise
        text = (
            f"cannot allocate memory for {programs} program(s): each needs up to"
            " 9 GiB of address space, but little memory (see 'ulimit -v')"
        )
        raise OSError(errno.ENOMEM, text) from error


def _pages(programs: int) -> int:
    """Return the size of the mailbox for a number of programs [pages]."""
    return -(-(SLOTS + programs * SLOT.itemsize) // PAGE)


_BYTES: Final = np.dtype(("V", MESSAGE.itemsize))  # numpy copies fields one by one
_NO_SHADOW: Final = np.zeros(0, np.uint8)
_NO_MARKS: Final = np.zeros(0, np.uint8)
_NONE: Final = range(0)
_WISHES: Final = ("stop_before_all", "stop_from")
"""Fields that control where a program stops, which are not part of its state."""


def _view(store: wasmtime.Store, memory: object) -> ByteArray:
    """Return a memory as an array that keeps the store alive; our memories never move."""
    assert isinstance(memory, wasmtime.Memory)
    address = ctypes.addressof(memory.data_ptr(store).contents)
    buffer = (ctypes.c_uint8 * memory.data_len(store)).from_address(address)
    buffer.store = store  # type: ignore[attr-defined]
    return np.frombuffer(memoryview(buffer), np.uint8)
