"""A part of a fleet: the sandboxes of some of its programs, in one store.

A wasmtime store belongs to one thread at a time, so each shard has its own. What they share is the
mailbox, in which no two programs have a cache line in common.
"""

from __future__ import annotations

import contextlib
import ctypes
import errno
import struct
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final, NamedTuple, TypeAlias

import numpy as np
import wasmtime
from wasmtime import _bindings, _ffi

from crs_cc.core.arrays import ByteArray, Records
from crs_cc.core.errors import InternalError
from crs_cc.core.source import Location
from crs_cc.runtime.driver import HEADER, MAX_SHARDS
from crs_cc.runtime.executable import Driver, Executable, engine
from crs_cc.runtime.layout import MEMORY_BYTES, PAGE, STACK_TOP
from crs_cc.runtime.resident_pages import CHUNK
from crs_cc.runtime.site_tests import ConditionTable, SiteTests

if TYPE_CHECKING:
    from typing import Self

Trapped: TypeAlias = tuple[int, Exception]
"""A robot whose program trapped, and the trap."""

_HEADER: Final = struct.Struct("<10Id")  # faster than numpy
_CURRENT, _ROUNDS, _RAN = map(HEADER.names.index, ("current", "rounds", "ran"))  # type: ignore[union-attr]
_FUNCTIONS: Final = "round", "begin", "end"
_MAX_PAGES: Final = 2**16  # of the mailbox: the maximum, so that it never moves
_NONE: Final = np.zeros(0, np.uint8)

QUICKEST_CALL: Final = "wasmtime_func_call_unchecked", _ffi.dll
CALL_TYPES: Final = *(ctypes.c_void_p,) * 4, ctypes.c_size_t, ctypes.c_void_p
"""wasmtime's quickest call, and the types of its result and arguments."""

_call_unchecked = ctypes.CFUNCTYPE(*CALL_TYPES)(QUICKEST_CALL)
"""The call with the interpreter's lock released: programs may run for long."""


class RunResult(NamedTuple):
    """What happened when robots of a shard were run.

    Attributes:
        rounds: number of rounds that ended.
        trapped: the robots that trapped: they have not ended their turn as others do.
        stopped: the robot that stopped before a mark, if any.
    """

    rounds: int
    trapped: list[Trapped]
    stopped: int | None


class Mailbox(wasmtime.SharedMemory):
    """The memory of the slots of a fleet, which all its shards import."""

    @classmethod
    def of_size(cls, size: int) -> Self:
        """Create a mailbox [bytes]."""
        limits = wasmtime.Limits(-(-size // PAGE), _MAX_PAGES)
        return cls(engine(), wasmtime.MemoryType(limits, shared=True))

    def resize(self, size: int) -> None:
        """Make it at least this size [bytes]; it does not move."""
        more = -(-(size - self.data_len()) // PAGE)
        if more > 0:
            self.grow(more)

    def view(self) -> ByteArray:
        """Return it as an array."""
        return _array(ctypes.addressof(self.data_ptr().contents), self.data_len(), self)

    def headers(self) -> Records:
        """Return the headers of the shards, of dtype `HEADER`."""
        return self.view()[: MAX_SHARDS * HEADER.itemsize].view(HEADER)

    def _as_extern(self) -> Any:
        # That of wasmtime 50 passes a pointer to the pointer.
        union = _ffi.wasmtime_extern_union(sharedmemory=self.ptr())
        kind = _ffi.WASMTIME_EXTERN_SHAREDMEMORY
        return _ffi.wasmtime_extern_t(kind, union)


@dataclass(frozen=True, slots=True)
class Sandbox:
    """An instance of a program; there may be many, so it is small.

    Attributes:
        executable: the program.
        store: the store that it is in.
        resume, prefetch: its functions for the driver.
        memory_address, shadow_address: where its memories are in this process; there is no shadow
            in unchecked builds, its address is 0 then.
        marks: its memory of breakpoints; empty in builds without.
        initial: chunks of its memory that hold initialised objects.
        begun: the global counting statements begun; None in builds without statements.
        tests: its table of tests; None in builds without marks.
    """

    executable: Executable
    store: wasmtime.Store
    resume: wasmtime.Func
    prefetch: wasmtime.Func
    memory_address: int
    shadow_address: int
    marks: ByteArray
    initial: range
    begun: wasmtime.Global | None
    tests: ConditionTable | None

    @property
    def memory(self) -> ByteArray:
        """A live view of its memory."""
        return _array(self.memory_address, MEMORY_BYTES, self.store)

    @property
    def shadow(self) -> ByteArray:
        """A live view of the states of its memory; empty in unchecked builds."""
        size = MEMORY_BYTES if self.shadow_address else 0
        return _array(self.shadow_address, size, self.store) if size else _NONE


class Shard:
    """A store, with the driver that runs the sandboxes in it.

    Attributes:
        round: the driver's function.
        instances: number of instances made, the driver included.
    """

    def __init__(self, mailbox: Mailbox, number: int, driver: Driver) -> None:
        """Create a shard without programs.

        Args:
            mailbox: the fleet's.
            number: that of the shard, from 0.
            driver: the module that runs a round.
        """
        self.store = wasmtime.Store(engine())
        self.mailbox = mailbox
        self.instances = 0
        self._header = mailbox.headers()[number : number + 1]
        self._raw = memoryview(self._header.view(np.uint8))  # type: ignore[arg-type]
        self.raise_instance_limit()
        exports = wasmtime.Instance(self.store, driver, [mailbox]).exports(self.store)
        header = exports["header"]
        robots, prefetches = exports["robots"], exports["prefetches"]
        assert isinstance(header, wasmtime.Global)
        assert isinstance(robots, wasmtime.Table)
        assert isinstance(prefetches, wasmtime.Table)
        header.set_value(self.store, wasmtime.Val.i32(number * HEADER.itemsize))
        functions = [_function(exports[name]) for name in _FUNCTIONS]
        self.round = functions[0]
        self._round, self._begin, self._end = map(self.prepared, functions)
        self._tables = robots, prefetches

    def raise_instance_limit(self) -> None:
        """Raise the store's limit of instances by one: removed programs stay in it."""
        self.instances += 1
        made = self.instances
        self.store.set_limits(instances=made, memories=3 * made + 1, tables=2 * made + 1)

    def sandbox(self, executable: Executable) -> Sandbox:
        """Create a sandbox."""
        self.raise_instance_limit()
        instance = wasmtime.Instance(self.store, executable.module(), [self.mailbox])
        own = instance.exports(self.store)
        heap = own["heap"]
        assert isinstance(heap, wasmtime.Global)
        marks = view(self.store, own["marks"]) if "marks" in own else _NONE
        begun = own.get("begun", None)
        assert begun is None or isinstance(begun, wasmtime.Global)
        end = -(-int(heap.value(self.store)) // CHUNK)
        return Sandbox(
            executable,
            self.store,
            _function(own["resume"]),
            _function(own["prefetch"]),
            _address(self.store, own["memory"]),
            _address(self.store, own["shadow"]) if "shadow" in own else 0,
            marks,
            range(STACK_TOP // CHUNK, end),
            begun,
            _tests(own) if "tests" in own else None,
        )

    def set_tests(self, sandbox: Sandbox, tests: SiteTests) -> None:
        """Set the tests that a debug build makes at sites marked so."""
        table = sandbox.tests
        assert table is not None
        if table.lacks(tests):
            self.raise_instance_limit()
            table.fill(self.store, tests)

    def assign(self, robot: int, sandbox: Sandbox) -> None:
        """Make the driver run a robot's program in a sandbox of this shard."""
        functions = sandbox.resume, sandbox.prefetch
        for table, function in zip(self._tables, functions, strict=True):
            size = table.size(self.store)
            if robot >= size:
                table.grow(self.store, max(robot + 1 - size, size), None)
            table.set(self.store, robot, function)

    def run(self, robots: range, end_s: float | None = None, most: int = 1) -> RunResult:
        """Run rounds of some robots, up to the first that stops before a mark.

        Args:
            robots: the robots.
            end_s: resume those whose clocks have not reached it, and advance their clocks, see
                `turns` [s]; if None, resume those whose slots have `run` set.
            most: the maximum number of rounds; after one in which a program asks for anything or
                traps, none begins.
        """
        header, robot = self._header, robots.start
        self._tell(robots, end_s, most)
        rounds, trapped = 0, list[Trapped]()
        while (trap := self._round.make()) is not None:
            robot, rounds = header["current"].item(), header["rounds"].item()
            trapped.append((robot, trap))
            header["current"], header["most"] = robot + robots.step, rounds + 1
            if robot + robots.step >= robots.stop:
                return RunResult(rounds + 1, trapped, None)
        found = _HEADER.unpack_from(self._raw)
        current = found[_CURRENT]
        stopped = current if current < robots.stop else None
        return RunResult(found[_ROUNDS], trapped, stopped)

    def end_turn(self, trap: Exception, robots: int) -> RunResult:
        """Let the others end their round after one of some robots has trapped in a turn.

        Return the rounds that its partner was not told of.
        """
        header = self._header
        robot, rounds = header["current"].item(), header["rounds"].item()
        if robot >= robots:
            raise InternalError.at(Location("kernels"), f"they have stopped with an error: {trap}")
        rest = range(robot + 1, robots)
        ran = self.run(rest, header["end_s"].item()) if rest else RunResult(0, [], None)
        return RunResult(rounds + 1, [(robot, trap), *ran.trapped], None)

    def begin(self, robots: range, end_s: float) -> bool:
        """Select those robots whose clocks have not reached a time, see `turns`.

        Return whether there are any.
        """
        self._tell(robots, end_s, 0)
        self._begin.make()
        return bool(_HEADER.unpack_from(self._raw)[_RAN])

    def end(self, robots: range) -> None:
        """Advance the clocks of those robots that were selected, see `turns`."""
        self._tell(robots, 0.0, 0)
        self._end.make()

    def _tell(self, robots: range, end_s: float | None, most: int) -> None:
        first, timed = robots.start, end_s is not None
        told = first, first, robots.stop, robots.step, timed, most, 0, 0, 0, 0, end_s or 0.0
        _HEADER.pack_into(self._raw, 0, *told)

    def prepared(self, function: wasmtime.Func, *arguments: int) -> PreparedCall:
        """Return a call of a function in this shard's store."""
        return PreparedCall(self.store, function, arguments)


class PreparedCall:
    """A call of a function whose arguments for wasmtime are converted once, to save time.

    A call of wasmtime's `Func` takes ten times as long.
    """

    def __init__(
        self, store: wasmtime.Store, function: wasmtime.Func, arguments: tuple[int, ...]
    ) -> None:
        """Convert the arguments, which are 32-bit integers."""
        self._values = (_bindings.wasmtime_val_raw * len(arguments))()
        for value, argument in zip(self._values, arguments, strict=True):
            value.i32 = argument
        self._store, self._function = store, function
        self._prepare()

    def _prepare(self) -> None:
        self._trap = ctypes.POINTER(_ffi.wasm_trap_t)()
        self._told = (
            ctypes.cast(self._store._context(), ctypes.c_void_p),
            ctypes.addressof(self._function._func),
            ctypes.addressof(self._values),
            len(self._values),
            ctypes.addressof(self._trap),
        )

    def make(self) -> Exception | None:
        """Make the call; return the trap, if any."""
        error = _call_unchecked(*self._told)
        if error:
            pointer = ctypes.POINTER(_ffi.wasmtime_error_t)
            return wasmtime.WasmtimeError._from_ptr(ctypes.cast(error, pointer))
        if not self._trap:  # type: ignore[truthy-bool]
            return None
        trap = wasmtime.Trap._from_ptr(self._trap)
        self._prepare()  # it has what this one is made of
        return trap


@contextlib.contextmanager
def memory_errors(programs: int) -> Iterator[None]:
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


def view(store: wasmtime.Store, memory: object) -> ByteArray:
    """Return a memory as an array that keeps the store alive; our memories never move."""
    assert isinstance(memory, wasmtime.Memory)
    return _array(_address(store, memory), memory.data_len(store), store)


def _function(export: object) -> wasmtime.Func:
    """Return a function apart from its export, which takes more memory."""
    assert isinstance(export, wasmtime.Func)
    return wasmtime.Func._from_raw(_ffi.wasmtime_func_t.from_buffer_copy(export._func))


def _tests(exports: Mapping[str, object]) -> ConditionTable:
    table = exports["tests"]
    assert isinstance(table, wasmtime.Table)
    memories = (exports.get(name, None) for name in ("memory", "shadow"))
    return ConditionTable(table, [each for each in memories if isinstance(each, wasmtime.Memory)])


def _address(store: wasmtime.Store, memory: object) -> int:
    assert isinstance(memory, wasmtime.Memory)
    return ctypes.addressof(memory.data_ptr(store).contents)


def _array(address: int, size: int, owner: object) -> ByteArray:
    buffer = (ctypes.c_uint8 * size).from_address(address)
    buffer.owner = owner  # type: ignore[attr-defined]
    return np.frombuffer(memoryview(buffer), np.uint8)
