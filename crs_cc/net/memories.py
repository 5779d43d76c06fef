"""The memories of programs as bytes: the pages that are not zero, each with its number.

>>> pages = np.array([3]), np.ones((1, CHUNK), np.uint8)
>>> memory = Memory(*pages, *pages)
>>> [found] = unpack(pack([memory]), 1)
>>> found.chunks.tolist(), bool((found.content == 1).all()), found.shadow_chunks.tolist()
([3], True, [3])
"""

from __future__ import annotations

import struct
from collections.abc import Iterable
from typing import Final, NamedTuple

import numpy as np

from crs_cc.core.arrays import ByteArray, IndexArray
from crs_cc.runtime.layout import MEMORY_BYTES
from crs_cc.runtime.resident_pages import CHUNK


class Memory(NamedTuple):
    """The memory and the shadow memory of a program, as in `runtime.fleet.Snapshot`."""

    chunks: IndexArray
    content: ByteArray
    shadow_chunks: IndexArray
    shadow_content: ByteArray


_COUNT: Final = struct.Struct("<I")
_NUMBER: Final = np.dtype("<u2")
_CHUNKS: Final = MEMORY_BYTES // CHUNK


def pack(memories: Iterable[Memory]) -> bytes:
    """Return memories as bytes."""
    parts: list[bytes] = []
    for each in memories:
        for chunks, content in (each[:2], each[2:]):
            parts += _COUNT.pack(len(chunks)), chunks.astype(_NUMBER).tobytes(), content.tobytes()
    return b"".join(parts)


def unpack(content: bytes, count: int) -> list[Memory]:
    """Return a number of memories.

    Raises:
        ValueError: the content is something else.
    """
    at, memories = 0, []
    for _ in range(count):
        at, chunks, pages = _half(content, at)
        at, shadow_chunks, shadow_pages = _half(content, at)
        memories.append(Memory(chunks, pages, shadow_chunks, shadow_pages))
    if at != len(content):
        raise ValueError("unexpected data after memories")
    return memories


def _half(content: bytes, at: int) -> tuple[int, IndexArray, ByteArray]:
    if at + _COUNT.size > len(content):
        raise ValueError("memories end early")
    (count,) = _COUNT.unpack_from(content, at)
    pages_at = at + _COUNT.size + count * _NUMBER.itemsize
    end = pages_at + count * CHUNK
    if count > _CHUNKS or end > len(content):
        raise ValueError("memories end early")
    chunks = np.frombuffer(content, _NUMBER, count, at + _COUNT.size).astype(np.intp)
    if count and (chunks[-1] >= _CHUNKS or (chunks[1:] <= chunks[:-1]).any()):
        raise ValueError("memories refer to missing pages")
    pages = np.frombuffer(content, np.uint8, count * CHUNK, pages_at)
    return end, chunks, pages.reshape(count, CHUNK)
