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
import functools
import mmap
import os
from typing import Final

import numpy as np

from crs_cc.core.arrays import BoolArray, ByteArray, IndexArray

CHUNK: Final = 4096
"""What is kept or left out as a whole [bytes]."""

_PAGEMAP: Final = "/proc/self/pagemap"
_ENTRY: Final = 8
_EXISTS: Final = 0b11 << 62


def save(memory: ByteArray, initial: range) -> tuple[IndexArray, ByteArray]:
    """Return the numbers of the chunks that are not all zero, and their content.

    Args:
        memory: the memory, whole chunks of it.
        initial: the chunks that were not all zero at the start; the system may still have them in
            a file of its own.
    """
    chunks = memory.reshape(-1, CHUNK)
    used = _not_zero(chunks, _candidates(memory, initial))
    return used, chunks[used]


def load(memory: ByteArray, initial: range, used: IndexArray, content: ByteArray) -> None:
    """Put back what `save` gave."""
    chunks, candidates = memory.reshape(-1, CHUNK), _candidates(memory, initial)
    candidates[used] = False
    chunks[_not_zero(chunks, candidates)] = 0
    chunks[used] = content


def _candidates(memory: ByteArray, initial: range) -> BoolArray:
    """Tells of each chunk whether it may be not all zero."""
    candidates = _existing(memory)
    candidates[initial.start : initial.stop] = True
    return candidates


def _not_zero(chunks: ByteArray, candidates: BoolArray) -> IndexArray:
    """Return the numbers of those of some chunks that are not all zero."""
    numbers = np.flatnonzero(candidates)
    words = chunks[numbers].view(np.uint64)
    return np.asarray(numbers[words.any(axis=1)])


def _existing(memory: ByteArray) -> BoolArray:
    """Tells of each chunk whether the system has it in memory, or would have to fetch it."""
    count = len(memory) // CHUNK
    address = memory.__array_interface__["data"][0]
    pagemap = _pagemap(os.getpid())
    if pagemap is not None and mmap.PAGESIZE == CHUNK and address % CHUNK == 0:
        with contextlib.suppress(OSError):
            entries = os.pread(pagemap, count * _ENTRY, address // CHUNK * _ENTRY)
            if len(entries) == count * _ENTRY:
                return np.asarray(np.frombuffer(entries, np.uint64) & np.uint64(_EXISTS) != 0)
    return np.ones(count, dtype=np.bool_)


@functools.cache
def _pagemap(_process: int) -> int | None:
    """Open the page map of this process, not of a child of it; None where there is none."""
    with contextlib.suppress(OSError):
        return os.open(_PAGEMAP, os.O_RDONLY)
    return None
