"""Saving and loading the non-zero pages of a robot's memory.

A robot has 16 MiB, of which most programs touch a few pages. Linux reports which pages of a process
are mapped (`/proc/self/pagemap`, 8 bytes for each page, bit 63 present, bit 62 swapped out:
`admin-guide/mm/pagemap.rst` of the kernel's documentation); reading the others would map
them. Without a page map, all are read.

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
from crs_cc.core.host_system import open_page_map

CHUNK: Final = 4096
"""The granularity of saving [bytes]."""

_ENTRY: Final = 8
_EXISTS: Final = 0b11 << 62


def save(memory: ByteArray, initial: range) -> tuple[IndexArray, ByteArray]:
    """Return the numbers of the non-zero chunks, and their content.

    Args:
        memory: the memory, a whole number of chunks.
        initial: the chunks that were non-zero at the start, which may still be backed by a file
            and so not be in the page map.
    """
    chunks = memory.reshape(-1, CHUNK)
    used = _not_zero(chunks, _candidates(memory, initial))
    return used, chunks[used]


def load(memory: ByteArray, initial: range, used: IndexArray, content: ByteArray) -> None:
    """Restore what `save` returned."""
    chunks, candidates = memory.reshape(-1, CHUNK), _candidates(memory, initial)
    candidates[used] = False
    chunks[_not_zero(chunks, candidates)] = 0
    chunks[used] = content


def _candidates(memory: ByteArray, initial: range) -> BoolArray:
    """Return whether each chunk may be non-zero."""
    candidates = _existing(memory)
    candidates[initial.start : initial.stop] = True
    return candidates


def _not_zero(chunks: ByteArray, candidates: BoolArray) -> IndexArray:
    """Return the numbers of the candidates that are non-zero."""
    numbers = np.flatnonzero(candidates)
    words = chunks[numbers].view(np.uint64)
    return np.asarray(numbers[words.any(axis=1)])


def _existing(memory: ByteArray) -> BoolArray:
    """Return whether each chunk is present or swapped out."""
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
    """Return the page map of this process (not of a forked child); None if there is none."""
    return open_page_map()
