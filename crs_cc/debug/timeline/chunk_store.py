"""Snapshots that share unchanged data.

Large arrays and byte strings are cut into chunks, and equal chunks are stored once: a timestep
changes a few chunks of a program's memory, and robots with the same program share most of theirs.
Objects that snapshots share stay shared. The size of everything stored is counted, so that `size`
is the memory that dropping everything would free.

>>> store = ChunkStore()
>>> first = store.add((np.zeros(5 * CHUNK, np.uint8), "a name"))
>>> second = store.add((np.arange(5 * CHUNK) // CHUNK == 4, "a name"))
>>> store.size < 3 * CHUNK, store.get(second)[0].sum()
(True, np.int64(4096))
>>> store.remove(first)
>>> store.remove(second)
>>> store.size
0
"""

from __future__ import annotations

import sys
from collections.abc import Hashable
from dataclasses import dataclass, fields, is_dataclass
from functools import cache
from typing import Any, Final, cast

import numpy as np

from crs_cc.runtime.executable import Executable
from crs_cc.runtime.resident_pages import CHUNK
from crs_cc.sim.model.world import WorldModel

_HELD: Final = 112
"""What it takes to hold something once, about, besides the thing itself [bytes]; measured."""
_SMALL: Final = 32
"""What something takes that is not looked into, about [bytes]."""

_NO_STATE: Final = (WorldModel, Executable)
"""What the run has anyway: snapshots only say which."""


@dataclass(frozen=True, slots=True)
class _Chunked:
    """A large array, or a large byte string (of no type), in chunks."""

    dtype: np.dtype[Any] | None
    shape: tuple[int, ...]
    chunks: tuple[bytes, ...]


@dataclass(slots=True)
class _Held:
    """An object that is stored once.

    Attributes:
        value: the object, so that its `id` is not reused.
        size: its own size [bytes].
        uses: its reference count.
        is_whole: whether neither it nor any part of it is `_Chunked`.
    """

    value: Any
    size: int
    uses: int
    is_whole: bool = True


class ChunkStore:
    """A store of snapshots that share equal data.

    A snapshot is made of dataclasses, tuples, dictionaries, arrays and byte strings, and is never
    changed. Anything else in it counts as a small object.

    Attributes:
        size: the memory in use [bytes].
        most_bytes: the limit that its users observe [bytes].
    """

    def __init__(self, most_bytes: int = 0) -> None:
        self.size = 0
        self.most_bytes = most_bytes
        self._chunks: dict[bytes, _Held] = {}
        self._objects: dict[int, _Held] = {}

    def add(self, value: Any) -> Any:
        """Store a snapshot; return its key."""
        held = self._objects.get(id(value))
        if held is not None:
            held.uses += 1
            return value
        if isinstance(value, np.ndarray):
            small = value.nbytes < CHUNK
            return (
                self._hold(value) if small else self._cut(value.tobytes(), value.dtype, value.shape)
            )
        if isinstance(value, bytes):
            return self._hold(value) if len(value) < CHUNK else self._cut(value, None, ())
        parts = _parts(value)
        if parts is None:
            self.size += _SMALL
            return value
        taken = [self.add(part) for part in parts]
        if any(one is not other for one, other in zip(taken, parts, strict=True)):
            value = _made_of(value, taken)
        return self._hold(value, is_whole=all(map(self._is_whole, taken)))

    def get(self, taken: Any) -> Any:
        """Return the snapshot of a key; it stays stored."""
        if self._is_whole(taken):
            return taken
        if isinstance(taken, _Chunked):
            content = b"".join(taken.chunks)
            if taken.dtype is None:
                return content
            return np.frombuffer(content, taken.dtype).reshape(taken.shape)
        return _made_of(taken, [self.get(part) for part in _parts(taken) or ()])

    def remove(self, taken: Any) -> None:
        """Drop a snapshot, except for data that others share."""
        held = self._objects.get(id(taken))
        if held is None:
            self.size -= _SMALL
            return
        held.uses -= 1
        if held.uses:
            return
        del self._objects[id(taken)]
        self.size -= held.size
        for chunk in taken.chunks if isinstance(taken, _Chunked) else ():
            self._drop_chunk(chunk)
        for part in () if isinstance(taken, _Chunked) else _parts(taken) or ():
            self.remove(part)

    def _is_whole(self, taken: Any) -> bool:
        held = self._objects.get(id(taken))
        return held is None or held.is_whole

    def _hold(self, value: Any, *, is_whole: bool = True) -> Any:
        size = sys.getsizeof(value) + _HELD
        self.size += size
        self._objects[id(value)] = _Held(value, size, 1, is_whole)
        return value

    def _cut(self, content: bytes, dtype: np.dtype[Any] | None, shape: tuple[int, ...]) -> Any:
        cuts = range(0, len(content), CHUNK)
        chunks = tuple(self._take_chunk(content[cut : cut + CHUNK]) for cut in cuts)
        return self._hold(_Chunked(dtype, shape, chunks), is_whole=False)

    def _take_chunk(self, chunk: bytes) -> bytes:
        held = self._chunks.get(chunk)
        if held is None:
            held = self._chunks[chunk] = _Held(chunk, sys.getsizeof(chunk) + _HELD, 0)
            self.size += held.size
        held.uses += 1
        return held.value  # type: ignore[no-any-return]

    def _drop_chunk(self, chunk: bytes) -> None:
        held = self._chunks[chunk]
        held.uses -= 1
        if not held.uses:
            del self._chunks[chunk]
            self.size -= held.size


@cache
def _names(kind: Hashable) -> tuple[str, ...] | None:
    """Return the names of the fields of a dataclass, None for any other type."""
    return tuple(each.name for each in fields(kind)) if is_dataclass(kind) else None


def _parts(value: Any) -> list[Any] | None:
    """Return the parts of a value; None for an atomic one."""
    if isinstance(value, tuple):
        return list(value)
    if isinstance(value, dict):
        return list(value.values())
    names = None if isinstance(value, _NO_STATE) else _names(cast("Hashable", type(value)))
    return None if names is None else [getattr(value, name) for name in names]


def _made_of(value: Any, parts: list[Any]) -> Any:
    """Return a copy of a value with other parts."""
    if isinstance(value, tuple):
        return tuple(parts)
    if isinstance(value, dict):
        return dict(zip(value, parts, strict=True))
    return type(value)(*parts)
