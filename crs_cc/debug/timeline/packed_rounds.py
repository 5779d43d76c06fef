"""Pieces of a run's input in blocks, which are packed: an index by key that takes little memory.

A block has the contents of successive keys, so blocks never overlap, and whether all of a range
are there is seen from the ends of the blocks.

>>> packed = PackedRounds(1000)
>>> block = RoundBlock()
>>> for key in (3, 4, 7):
...     block.append(key, bytes(100))
>>> packed.add(block)
>>> packed.get(4) == bytes(100), packed.get(5), packed.last_of(4)
(True, None, 7)
"""

from __future__ import annotations

import zlib
from bisect import bisect_left, bisect_right
from dataclasses import dataclass
from typing import Final

import numpy as np

_FULL: Final = 128 * 1024
"""The size of a block before it is packed, at least [bytes]."""
_LEVEL, _STORED = 1, 0
"""Levels of zlib: the quickest, and none."""
_LARGE: Final = 2048
"""Contents that are as large on average are not packed, as that would take too long [bytes]."""
_HELD: Final = 400
"""What a block takes besides its bytes, about [bytes]; measured."""


class RoundBlock:
    """A block that is not packed."""

    def __init__(self, keys: list[int] | None = None, contents: list[bytes] | None = None) -> None:
        """Create a block of contents with their rising keys; by default an empty one."""
        self._keys = keys or []
        self._contents = contents or []
        self._size = sum(map(len, self._contents))

    def __contains__(self, key: int) -> bool:
        return not self.is_empty and self._keys[0] <= key <= self._keys[-1]

    @property
    def is_empty(self) -> bool:
        """Return whether it holds no rounds."""
        return not self._keys

    @property
    def is_full(self) -> bool:
        """Return whether it has enough rounds to be worth packing."""
        return self._size >= _FULL

    @property
    def first(self) -> int:
        """The first key."""
        return self._keys[0]

    @property
    def last(self) -> int:
        """The last key."""
        return self._keys[-1]

    def append(self, key: int, content: bytes) -> None:
        """Append the content of the next key."""
        self._keys.append(key)
        self._contents.append(content)
        self._size += len(content)

    def get(self, key: int) -> bytes | None:
        """Return the content of a key; None if it has none."""
        at = bisect_left(self._keys, key)
        is_there = at < len(self._keys) and self._keys[at] == key
        return self._contents[at] if is_there else None

    def truncate(self, key: int) -> None:
        """Discard the contents from a key on."""
        at = bisect_left(self._keys, key)
        self._size -= sum(map(len, self._contents[at:]))
        del self._keys[at:], self._contents[at:]

    def packed(self) -> _PackedBlock:
        """Return it packed."""
        rows = np.array([self._keys, list(map(len, self._contents))], np.int64)
        differences = np.diff(rows, axis=1, prepend=0)
        content = b"".join([differences.tobytes(), *self._contents])
        level = _STORED if self._size >= _LARGE * len(self._keys) else _LEVEL
        return _PackedBlock(self.last, len(self._keys), zlib.compress(content, level))


@dataclass(frozen=True, slots=True)
class _PackedBlock:
    """A packed block.

    Attributes:
        last: its last key.
        count: how many contents it has.
        packed: the differences of keys and of sizes, as int64, then all contents.
    """

    last: int
    count: int
    packed: bytes

    @property
    def size(self) -> int:
        """Return its size [bytes]."""
        return _HELD + len(self.packed)

    def opened(self) -> RoundBlock:
        """Return it as it was."""
        content = zlib.decompress(self.packed)
        rows = np.frombuffer(content, np.int64, 2 * self.count).reshape(2, self.count)
        keys, sizes = np.cumsum(rows, axis=1)
        ends = (rows.nbytes + np.cumsum(sizes)).tolist()
        cuts = zip([rows.nbytes, *ends[:-1]], ends, strict=True)
        return RoundBlock(keys.tolist(), [content[first:end] for first, end in cuts])


class PackedRounds:
    """Packed blocks by key; the oldest are dropped when there are too many bytes."""

    def __init__(self, most_bytes: int) -> None:
        """Set the limit [bytes]."""
        self._most_bytes = most_bytes
        self._bytes = 0
        self._firsts: list[int] = []  # of the blocks, rising
        self._blocks: dict[int, _PackedBlock] = {}  # by first key; the oldest is the first
        self._open: tuple[int, RoundBlock] | None = None  # the one used last

    def add(self, block: RoundBlock) -> None:
        """Add a block of keys that none of the others has."""
        packed = block.packed()
        self._firsts.insert(bisect_left(self._firsts, block.first), block.first)
        self._blocks[block.first] = packed
        self._bytes += packed.size
        while self._bytes > self._most_bytes:
            self._drop(next(iter(self._blocks)))

    def _drop(self, first: int) -> _PackedBlock:
        block = self._blocks.pop(first)
        self._bytes -= block.size
        del self._firsts[bisect_left(self._firsts, first)]
        if self._open is not None and self._open[0] == first:
            self._open = None
        return block

    def _first_of(self, key: int) -> int | None:
        """Return the first key of the block that has a key; None if none has."""
        at = bisect_right(self._firsts, key) - 1
        if at < 0 or key > self._blocks[self._firsts[at]].last:
            return None
        return self._firsts[at]

    def __contains__(self, key: int) -> bool:
        return self._first_of(key) is not None

    def last_of(self, key: int) -> int | None:
        """Return the last key of the block that has a key; None if none has."""
        first = self._first_of(key)
        return None if first is None else self._blocks[first].last

    def get(self, key: int) -> bytes | None:
        """Return the content of a key; None if it has none."""
        first = self._first_of(key)
        if first is None:
            return None
        if self._open is None or self._open[0] != first:
            self._open = first, self._blocks[first].opened()
        return self._open[1].get(key)

    def truncate(self, key: int) -> None:
        """Discard the contents from a key on."""
        cut = self._first_of(key)
        if cut is not None:
            block = self._drop(cut).opened()
            block.truncate(key)
            if not block.is_empty:
                self.add(block)
        for first in self._firsts[bisect_left(self._firsts, key) :]:
            self._drop(first)
