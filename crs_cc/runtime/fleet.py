"""All robots' programs, side by side: one store, one mailbox, one call for a round of all.

Whoever owns a fleet sets `run` and `fuel` in the slots of the robots that shall go on, calls
`run_round`, and finds in each slot how the program came back: a request to serve, no fuel left,
ended, or stopped by an error.

>>> from crs_cc.runtime.testing import counting_program
>>> fleet = Fleet([counting_program()] * 2)
>>> fleet.slots["run"] = 1
>>> fleet.slots["fuel"] = 1000
>>> fleet.run_round()
2
>>> fleet.slots["code"].tolist()        # both posted EXIT
[1, 1]
"""

from __future__ import annotations

import ctypes
import errno
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt
import wasmtime

from crs_cc.requests import ERROR_KINDS, FAILED, SLOT
from crs_cc.runtime import pages
from crs_cc.runtime.driver import HEADER, SLOTS, driver
from crs_cc.runtime.executable import Executable, engine
from crs_cc.runtime.layout import MEMORY_BYTES, STACK_TOP
from crs_cc.runtime.pages import CHUNK
from crs_cc.runtime.wasm import PAGE
from crs_cc.source import Location

if TYPE_CHECKING:
    from crs_cc.runtime.diagnosis.active_call import ActiveCall
    from crs_cc.runtime.diagnosis.failure import Failure
    from crs_cc.runtime.diagnosis.inspect import Stopped
    from crs_cc.runtime.diagnosis.report import ErrorReport

MEMORY_END: Final = 0xFFFFFFFF  # the last address there could be


@dataclass(frozen=True, slots=True)
class Snapshot:
    """The whole state of one program: it can go on from here in any fleet of the same program.

    Attributes:
        slot: its slot, one element of dtype `SLOT`.
        chunks: numbers of the chunks of memory that are not all zero.
        content: those chunks, shape (len(chunks), CHUNK).
        shadow_chunks: the same of the shadow memory; none in unchecked builds.
        shadow_content: those chunks.
    """

    slot: npt.NDArray[np.void]
    chunks: npt.NDArray[np.intp]
    content: npt.NDArray[np.uint8]
    shadow_chunks: npt.NDArray[np.intp]
    shadow_content: npt.NDArray[np.uint8]


class Fleet:
    """Robots' programs and their slots.

    Attributes:
        slots: the slots, an array of dtype `SLOT`, one for each robot.
    """

    def __init__(self, executables: Sequence[Executable]) -> None:
        """Makes a sandbox for each program.

        Raises:
            OSError: the system does not give the memory, or the room for addresses.
        """
        try:
            self._make(executables)
        except wasmtime.WasmtimeError as error:
            if f"os error {errno.ENOMEM}" not in str(error):
                raise
            text = (
                f"the system gives no memory for {len(executables)} program(s): each needs up to"
                " 9 GiB of addresses, though little memory (see 'ulimit -v')"
            )
            raise OSError(errno.ENOMEM, text) from error

    def _make(self, executables: Sequence[Executable]) -> None:
        self._executables = tuple(executables)
        self._store = wasmtime.Store(engine())
        count = len(executables)
        self._store.set_limits(instances=count + 1, memories=2 * count + 1, tables=count + 1)
        pages = -(-(SLOTS + count * SLOT.itemsize) // PAGE)
        limits = wasmtime.Limits(pages, pages)
        self._mailbox = wasmtime.Memory(self._store, wasmtime.MemoryType(limits))
        mailbox = _view(self._store, self._mailbox)
        self._header = mailbox[: HEADER.itemsize].view(HEADER)
        self._header["count"] = count
        self.slots = mailbox[SLOTS : SLOTS + count * SLOT.itemsize].view(SLOT)
        self.slots["stop_at"] = -1
        self._memories: list[npt.NDArray[np.uint8]] = []
        self._shadows: list[npt.NDArray[np.uint8]] = []
        self._initial: list[range] = []  # chunks of each memory that hold objects of the program
        self._start_driver()

    def __len__(self) -> int:
        return len(self._executables)

    def _start_driver(self) -> None:
        module = wasmtime.Module(engine(), driver(len(self)).to_binary())
        exports = wasmtime.Instance(self._store, module, [self._mailbox]).exports(self._store)
        round_ = exports["round"]
        assert isinstance(round_, wasmtime.Func)
        self._round = round_
        table = exports["robots"]
        assert isinstance(table, wasmtime.Table)
        for number, executable in enumerate(self._executables):
            instance = wasmtime.Instance(self._store, executable.module(), [self._mailbox])
            own = instance.exports(self._store)
            table.set(self._store, number, own["resume"])
            self._memories.append(_view(self._store, own["memory"]))
            shadow = _view(self._store, own["shadow"]) if "shadow" in own else _NO_SHADOW
            self._shadows.append(shadow[:MEMORY_BYTES])
            heap = own["heap"]
            assert isinstance(heap, wasmtime.Global)
            end = -(-int(heap.value(self._store)) // CHUNK)
            self._initial.append(range(STACK_TOP // CHUNK, end))

    def memory(self, robot: int) -> npt.NDArray[np.uint8]:
        """Gives a robot's memory as an array of bytes that shows every change."""
        return self._memories[robot]

    def run_round(self) -> int:
        """Resumes every robot whose slot says `run`; gives how many there were."""
        resumed = int(np.count_nonzero(self.slots["run"]))
        self._header["current"] = 0
        while True:
            try:
                self._round(self._store)
            except (wasmtime.Trap, wasmtime.WasmtimeError) as trap:
                robot = int(self._header["current"][0])
                self._trapped(robot, trap)
                self._header["current"] = robot + 1
                continue
            return resumed

    def _trapped(self, robot: int, trap: Exception) -> None:
        """Notes a trap as the robot's own failure, so that the others go on."""
        slot = self.slots[robot]
        slot["status"] = FAILED
        slot["fuel"] = min(int(slot["fuel"]), 0)
        outside = wasmtime.TrapCode.MEMORY_OUT_OF_BOUNDS
        if isinstance(trap, wasmtime.Trap) and trap.trap_code is outside:
            if not len(self._shadows[robot]):
                # Nothing but this stops a program without checks, so that no place is noted.
                slot["error_kind"] = ERROR_KINDS.index("pointer outside memory")
                return
            from crs_cc.runtime.diagnosis.trapped import blamed_site  # few runs need it

            compiled = self._executables[robot].detail().compiled
            site = blamed_site(trap, self._memories[robot], compiled)
            if site is not None:
                slot["error_site"], slot["error_address"] = site, MEMORY_END
                return
        deep = "call stack exhausted" in str(trap)
        slot["error_kind"] = ERROR_KINDS.index("stack overflow" if deep else "internal trap")

    def failure(self, robot: int) -> Failure:
        """Gives why a robot with status FAILED was stopped."""
        slot = self.slots[robot]
        # Few runs need these.
        from crs_cc.runtime.diagnosis.diagnose import diagnose
        from crs_cc.runtime.diagnosis.failure import Failure
        from crs_cc.runtime.diagnosis.objects import find_object, of_variable

        value = int(slot["error_address"])
        if slot["error_kind"]:
            kind = ERROR_KINDS[slot["error_kind"]]
            return Failure(kind, Location(self._executables[robot].name), value)
        site = self._executables[robot].detail().compiled.sites[slot["error_site"]]
        trapped = value == MEMORY_END and site.size > 1
        stopped = self._stopped(robot, site.location, saved=not trapped)
        kind, stack, size, found = site.kind, stopped.stack, site.size, None
        if kind == "memory":
            kind, value, found = diagnose(stopped, value, size, site.access)
        elif kind in {"invalid free", "double free"}:
            found = find_object(stopped, value)
        elif site.variable is not None:
            found = of_variable(stopped, site.variable)
        size = size or int(slot["error_size"])
        return Failure(kind, site.location, value, stack, site.access, size, found, stopped)

    def _stopped(
        self, robot: int, failed_at: Location | None = None, *, saved: bool = True
    ) -> Stopped:
        from crs_cc.runtime.diagnosis.inspect import Stopped, call_stack

        detail, memory = self._executables[robot].detail(), self._memories[robot]
        stack = tuple(call_stack(memory, detail.compiled, failed_at))
        parts = detail.program, detail.compiled, detail.lines, stack, saved
        return Stopped(memory, self._shadows[robot], *parts)

    def current_call(self, robot: int) -> ActiveCall | None:
        """Gives the innermost active function of the user's own files, and where it stands.

        There is none before a program has been resumed, and once it has ended.
        """
        from crs_cc.runtime.diagnosis.report import current_call  # few runs need it

        return current_call(self._stopped(robot))

    def library_call(self, robot: int) -> ActiveCall | None:
        """Gives the library's function that the user's code has called, and where it did."""
        from crs_cc.runtime.diagnosis.report import library_call  # few runs need it

        return library_call(self._stopped(robot))

    def report(self, robot: int) -> ErrorReport:
        """Gives the report on a robot with status FAILED: its failure in words."""
        from crs_cc.runtime.diagnosis.report import report  # few runs need it

        return report(self.failure(robot))

    def snapshot(self, robot: int) -> Snapshot:
        """Gives the whole state of one robot's program."""
        slot = self.slots[robot : robot + 1].copy()
        kept = pages.save(self._memories[robot], self._initial[robot])
        return Snapshot(slot, *kept, *pages.save(self._shadows[robot], _NONE))

    def restore(self, robot: int, snapshot: Snapshot) -> None:
        """Puts a state that `snapshot` gave into one robot's program."""
        memory, shadow = self._memories[robot], self._shadows[robot]
        pages.load(memory, self._initial[robot], snapshot.chunks, snapshot.content)
        pages.load(shadow, _NONE, snapshot.shadow_chunks, snapshot.shadow_content)
        self.slots[robot : robot + 1] = snapshot.slot


_NO_SHADOW: Final = np.zeros(0, np.uint8)
_NONE: Final = range(0)


def _view(store: wasmtime.Store, memory: object) -> npt.NDArray[np.uint8]:
    """Gives a memory as an array, which keeps the store alive; our memories never move."""
    assert isinstance(memory, wasmtime.Memory)
    address = ctypes.addressof(memory.data_ptr(store).contents)
    buffer = (ctypes.c_uint8 * memory.data_len(store)).from_address(address)
    buffer.store = store  # type: ignore[attr-defined]
    return np.frombuffer(memoryview(buffer), np.uint8)
