"""An instance of a kernel program for the simulation, with its own memory.

Such a program has the same form as a robot's: it posts a request when it waits for work, and its
whole state is in its memory, which numpy sees. A call is one C call into wasmtime, without the
conversions of its Python interface, which cost ten times as much.
"""

from __future__ import annotations

import ctypes
import struct
from collections.abc import Callable
from typing import Final

import numpy as np
import wasmtime
from wasmtime import _bindings

from crs_cc.core.errors import InternalError
from crs_cc.core.source import Location
from crs_cc.requests import MESSAGE, SLOT, SUSPENDED, slot_offset
from crs_cc.runtime.executable import Executable, engine
from crs_cc.runtime.shard import CALL_TYPES, QUICKEST_CALL, Mailbox, memory_errors, view

_FUEL: Final = 1 << 60  # more than all calls can use; twice as much would say that it stops
_RESUME: Final = struct.Struct("<iiiiIIq")
"""The slot's fields from `run` to `fuel`."""
_STATE: Final = struct.Struct("<ii")
"""Status and code."""

_call = ctypes.PYFUNCTYPE(*CALL_TYPES)(QUICKEST_CALL)
"""The call with the interpreter's lock held: to release it takes longer than the work."""

_call_without_gil = ctypes.CFUNCTYPE(*CALL_TYPES)(QUICKEST_CALL)
"""The call with the lock released."""


class KernelInstance:
    """An instance of a program that computes whenever it is resumed.

    Attributes:
        memory: its memory; it never moves.
        message: the integers of the request that it has posted.
        exports: its functions and memories.
    """

    def __init__(self, executable: Executable, store: wasmtime.Store | None = None) -> None:
        """Start the program, and run it up to its first request.

        Args:
            executable: the program.
            store: the store; by default one of its own.

        Raises:
            InternalError: it stops with an error.
        """
        self._name = executable.name
        self._store = wasmtime.Store(engine()) if store is None else store
        with memory_errors(1):
            mailbox = Mailbox.of_size(SLOT.itemsize)
            instance = wasmtime.Instance(self._store, executable.module(), [mailbox])
        exports = self.exports = instance.exports(self._store)
        resume = exports["resume"]
        assert isinstance(resume, wasmtime.Func)
        self.memory = view(self._store, exports["memory"])
        self._slot = mailbox.view()[: SLOT.itemsize].data
        self._function = resume._func
        self._values = (_bindings.wasmtime_val_raw * 1)()
        self._trap = ctypes.c_void_p()
        self._arguments = (
            ctypes.cast(self._store._context(), ctypes.c_void_p).value,
            ctypes.addressof(self._function),
            ctypes.addressof(self._values),
            1,
            ctypes.addressof(self._trap),
        )
        self.resume()
        first = slot_offset("message")
        self.message = np.frombuffer(self._slot, MESSAGE, 1, first)["i"][0]

    def resume(self) -> None:
        """Run the program up to its next request; raise InternalError if it stops with an error."""
        self._resume(_call)

    def resume_without_gil(self) -> None:
        """Resume it with the interpreter lock released, for long computations."""
        self._resume(_call_without_gil)

    def _resume(self, call: Callable[..., int | None]) -> None:
        slot = self._slot
        _RESUME.pack_into(slot, 0, 0, 0, 0, 0, 0, 0, _FUEL)
        self._values[0].i32 = 0
        failed = call(*self._arguments)
        _, code = _STATE.unpack_from(slot, 4)
        if failed or self._trap.value or self._values[0].i32 != SUSPENDED or not code:
            self._fail()

    def _fail(self) -> None:
        raise InternalError.at(Location(self._name), "it has stopped with an error")
