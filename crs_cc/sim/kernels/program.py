"""The kernels' program, and how Python calls it.

The C files of this folder are compiled by crs_cc itself, so that what they compute is the same to
the bit on every processor, as what robots' programs compute. Arrays are copied into the memory of
the program and out of it; a call costs about a microsecond. The program is loaded on the first
call, once for each thread.
"""

from __future__ import annotations

import atexit
import functools
import struct
import threading
from pathlib import Path
from typing import TYPE_CHECKING, Final

import numpy as np

if TYPE_CHECKING:
    from crs_cc.runtime.executable import Executable

BLOCK: Final = 0x20000
"""Elements of an array in the arena, as in `kernels.h`."""

_BYTES: Final = BLOCK * 16
_ARGUMENTS: Final = struct.Struct("<2i")


class Kernels:
    """One thread's instance of the kernels.

    Attributes:
        reals: two arguments and the result of a function of real arrays, `BLOCK` elements each.
        complexes: the same memory as complex numbers.
    """

    def __init__(self, *, checked: bool = False) -> None:
        """Load the program.

        Args:
            checked: check every access through a pointer, for tests.
        """
        # Not needed by a run that computes nothing.
        from crs_cc.runtime.kernel_instance import KernelInstance

        instance = KernelInstance(_executable(checked=checked))
        arguments, arena = (int(each) for each in instance.message[:2])
        self._place, self._memory = arguments, instance.memory.data
        memory = instance.memory[arena : arena + 3 * _BYTES].reshape(3, _BYTES)
        self.reals = tuple(memory.view(np.float64)[:, :BLOCK])
        self.complexes = tuple(memory.view(np.complex128))
        self._resume = instance.resume

    def apply(self, function: int, count: int) -> None:
        """Apply a function, by its number in `functions.c`, to arguments in the arena."""
        _ARGUMENTS.pack_into(self._memory, self._place, function, count)
        self._resume()

    def number(self, function: int, a: float, b: float) -> float:
        """Return a function of one or two numbers."""
        first, second, result = self.reals
        first[0], second[0] = a, b
        self.apply(function, 1)
        return float(result[0])


@functools.cache
def _executable(*, checked: bool) -> Executable:
    from crs_cc.toolchain.kernels import build_kernels

    return build_kernels(Path(__file__).parent, checked=checked)


class _Threads(threading.local):
    """The instance of each thread, made on first use."""

    kernels: Kernels | None = None


_threads: Final = _Threads()


def kernels() -> Kernels:
    """Return this thread's kernels."""
    found = _threads.kernels
    if found is None:
        found = _threads.kernels = Kernels()
    return found


@atexit.register
def _release() -> None:
    """Release the instance while wasmtime can still do so."""
    _threads.kernels = None
    _executable.cache_clear()
