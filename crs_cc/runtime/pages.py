"""Which pages of a robot's memory can hold anything but zeros.

A robot has 16 MiB, of which most programs touch a few pages. Linux tells which pages of a process
exist at all (`/proc/self/pagemap`, 8 bytes for each page, bit 63 present, bit 62 swapped out:
`admin-guide/mm/pagemap.rst` of the kernel's documentation); to look at the others would make them
exist. Where it does not tell, all are looked at.

>>> memory = np.frombuffer(mmap.mmap(-1, 8 * CHUNK), np.uint8)
>>> memory[2 * CHUNK + 5] = 1
>>> used, content = save(memory, range(0))
>>> used.tolist(), content.shape
([2], (1, 4096))
"""

from __future__ import annotations

import contextlib
import mmap
import os
from pathlib import Path
from typing import Final

import numpy as np
import numpy.typing as npt

IndexArray = npt.NDArray[np.intp]
ByteArray = npt.NDArray[np.uint8]

CHUNK: Final = 4096
"""What is kept or left out as a whole [bytes]."""

_PAGEMAP: Final = Path("/proc/self/pagemap")
_ENTRY: Final = 8
_EXISTS: Final = 0b11 << 62


def save(memory: ByteArray, initial: range) -> tuple[IndexArray, ByteArray]:
    """Gives the numbers of the chunks that are not all zero, and their content.

    Args:
        memory: the memory, whole chunks of it.
        initial: the chunks that were not all zero at the start; the system may still have them in
            a file of its own.
    """
    chunks = memory.reshape(-1, CHUNK)
    used = _used(memory, initial)
    return used, chunks[used]


def load(memory: ByteArray, initial: range, used: IndexArray, content: ByteArray) -> None:
    """Puts back what `save` gave."""
    chunks = memory.reshape(-1, CHUNK)
    chunks[np.setdiff1d(_used(memory, initial), used)] = 0
    chunks[used] = content


def _used(memory: ByteArray, initial: range) -> IndexArray:
    """Gives the numbers of the chunks that are not all zero."""
    candidates = _existing(memory)
    candidates[initial.start : initial.stop] = True
    numbers = np.flatnonzero(candidates)
    words = memory.reshape(-1, CHUNK)[numbers].view(np.uint64)
    return np.asarray(numbers[words.any(axis=1)])


def _existing(memory: ByteArray) -> npt.NDArray[np.bool_]:
    """Tells of each chunk whether the system has it in memory, or would have to fetch it."""
    count = len(memory) // CHUNK
    address = memory.__array_interface__["data"][0]
    if mmap.PAGESIZE == CHUNK and address % CHUNK == 0:
        with contextlib.suppress(OSError), _PAGEMAP.open("rb", buffering=0) as pagemap:
            entries = os.pread(pagemap.fileno(), count * _ENTRY, address // CHUNK * _ENTRY)
            if len(entries) == count * _ENTRY:
                return np.asarray(np.frombuffer(entries, np.uint64) & np.uint64(_EXISTS) != 0)
    return np.ones(count, dtype=np.bool_)
