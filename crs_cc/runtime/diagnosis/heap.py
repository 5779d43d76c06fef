"""Read the heap of a stopped program: the chunk headers of `lib/stdlib/malloc.c`, see there.

chunk + 0    size of the chunk; flags in the lowest four bits
chunk + 4    size of the chunk before it
chunk + 8    bytes asked for
chunk + 12   numbers of the five calls that allocated it
chunk + 32   the block used by the program; if that is freed, links of 8 bytes, and then the
numbers of the calls that freed it: five, or two in the smallest chunk
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import ByteArray
from crs_cc.runtime.layout import BLOCK_HEADER as HEADER
from crs_cc.runtime.layout import MEMORY_BYTES, round_up
from crs_cc.runtime.link import ALLOCATOR, HEAP_SYMBOLS

SITES: Final = 5
IN_USE: Final = 1
FLAGS: Final = 15
_LINKS: Final = 8
_FEW: Final = 2
_ROOMY: Final = (
    HEADER + _LINKS + 4 * SITES
)  # a chunk of this size has room for all calls that freed it


@dataclass(frozen=True, slots=True)
class Block:
    """A block of the heap, in use or not.

    Attributes:
        address: its first byte.
        size: the size requested; of a free chunk, its capacity [bytes].
        room: the chunk's capacity [bytes].
        in_use: whether the program may use it.
        allocated: numbers of the calls that allocated it, the innermost first.
        freed: numbers of the calls that freed it; empty while it is in use.
    """

    address: int
    size: int
    room: int
    in_use: bool
    allocated: tuple[int, ...]
    freed: tuple[int, ...]


def blocks(memory: ByteArray, addresses: Mapping[str, int]) -> Iterator[Block]:
    """Return the blocks of the heap, sorted by address.

    An unchecked program may have corrupted its heap; the list ends at the first invalid header.
    """
    end_name = f"{ALLOCATOR}:unused"
    if end_name not in addresses:
        return
    words = memory.view("<u4")
    end = min(int(words[addresses[end_name] // 4]), MEMORY_BYTES)
    chunk = round_up(addresses[HEAP_SYMBOLS[0]] + HEADER, 16) - HEADER
    while chunk + HEADER <= end:
        size = int(words[chunk // 4]) & ~FLAGS
        if size < HEADER or chunk + size > end:
            return
        yield _block(words, chunk, size)
        chunk += size


def _block(words: npt.NDArray[np.uint32], chunk: int, size: int) -> Block:
    header = [int(each) for each in words[chunk // 4 : (chunk + HEADER) // 4]]
    address, room = chunk + HEADER, size - HEADER
    flags = header[0] & FLAGS
    freed: tuple[int, ...] = ()
    if flags != IN_USE:
        count = SITES if size >= _ROOMY else _FEW
        first = (address + _LINKS) // 4
        freed = tuple(int(each) for each in words[first : first + count] if each)
    asked = header[2] if flags and header[2] <= room else room
    return Block(address, asked, room, flags == IN_USE, tuple(filter(None, header[3:])), freed)
