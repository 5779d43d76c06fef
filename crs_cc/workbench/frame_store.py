"""The frames of a run that is watched, in blocks, within bounded memory.

Blocks have numbers that are never used twice, so a page that has one knows it for good. When memory
runs out, every second frame of the older half goes.
"""

from __future__ import annotations

import copy
import threading
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, count
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.workbench.frame_blocks import packed, unpacked

MAX_BYTES: Final = 192 * 2**20
"""Memory for blocks; chosen by us: twenty hours of three robots, ten minutes of 10,000."""

_FRAMES: Final = 20
_SECOND_S: Final = 1.0
_QUICK: Final = 1  # zlib's level: a tenth of the time of 6 for an eighth more


@dataclass(frozen=True, slots=True)
class Block:
    """A block and the times of its first and last frame [s]."""

    number: int
    begin_s: float
    end_s: float
    content: bytes


class FrameStore:
    """The frames of a run; thread-safe."""

    def __init__(self, most_bytes: int = MAX_BYTES, first: int = 0) -> None:
        """Store nothing yet.

        Args:
            most_bytes: the size of all blocks; more frames are thinned.
            first: the number of the first block.
        """
        self._most_bytes = most_bytes
        self._lock = threading.Lock()
        self._blocks: list[Block] = []
        self._bytes = 0
        self._numbers = count(first)  # of all copies
        self._times_s: list[float] = []  # of the block that is being filled
        self._frames: list[FloatArray] = []

    @property
    def end_s(self) -> float:
        """The time of the last frame; -1 without any."""
        if self._times_s:
            return self._times_s[-1]
        return self._blocks[-1].end_s if self._blocks else -1.0

    def add(self, time_s: float, values: FloatArray) -> Block | None:
        """Add the frame of a later time, (columns, rows); return the block that it completes."""
        with self._lock:
            done = None
            if self._frames and (
                len(self._frames) >= _FRAMES
                or values.shape != self._frames[0].shape
                or time_s - self._times_s[0] >= _SECOND_S
            ):
                done = self._close()
            self._times_s.append(time_s)
            self._frames.append(values)
            return done

    def add_packed(self, begin_s: float, end_s: float, content: bytes) -> None:
        """Add a block of later frames as it is."""
        with self._lock:
            self._keep(begin_s, end_s, content)

    def flush(self) -> Block | None:
        """Complete the current block; return None if there is none."""
        with self._lock:
            return self._close() if self._frames else None

    def index(self) -> list[tuple[int, float, float]]:
        """Return number, first and last time [s] of each block, the unfinished one included."""
        with self._lock:
            if self._frames:
                self._close()
            return [(each.number, each.begin_s, each.end_s) for each in self._blocks]

    def content(self, number: int) -> bytes | None:
        """Return a block by its number; None if it is there no more."""
        with self._lock:
            found = (each.content for each in self._blocks if each.number == number)
            return next(found, None)

    @property
    def frames_about(self) -> int:
        """How many frames there are at most."""
        return (len(self._blocks) + 1) * _FRAMES

    def between(
        self, begin_s: float, end_s: float, stride: int = 1
    ) -> Iterator[tuple[float, FloatArray]]:
        """Yield the times [s] and frames of a span, from every `stride`th block."""
        with self._lock:
            blocks = [each for each in self._blocks if each.end_s >= begin_s][::stride]
            last = list(zip(self._times_s, self._frames, strict=True))
        stored = (
            zip(*unpacked(each.content), strict=True) for each in blocks if each.begin_s <= end_s
        )
        for time_s, frame in chain(chain.from_iterable(stored), last):
            if begin_s <= time_s <= end_s:
                yield time_s, frame

    def fork(self) -> FrameStore:
        """Return an independent copy."""
        with self._lock:
            other = copy.copy(self)
            other._lock = threading.Lock()
            other._blocks = self._blocks[:]
            other._times_s, other._frames = self._times_s[:], self._frames[:]
        return other

    def truncate(self, time_s: float) -> None:
        """Discard all frames after a time."""
        with self._lock:
            if self._frames:
                self._close()
            while self._blocks and self._blocks[-1].end_s > time_s:
                last = self._blocks.pop()
                self._bytes -= len(last.content)
                times_s, frames = unpacked(last.content)
                left = sum(each <= time_s for each in times_s)
                if left:
                    self._store(times_s[:left], frames[:left])

    def _close(self) -> Block:
        block = self._store(self._times_s, np.array(self._frames))
        self._times_s, self._frames = [], []
        return block

    def _store(self, times_s: Sequence[float], frames: FloatArray) -> Block:
        return self._keep(times_s[0], times_s[-1], packed(times_s, frames, _QUICK))

    def _keep(self, begin_s: float, end_s: float, content: bytes) -> Block:
        block = Block(next(self._numbers), begin_s, end_s, content)
        self._blocks.append(block)
        self._bytes += len(content)
        if self._bytes > self._most_bytes:
            self._thin()
        return block

    def _thin(self) -> None:
        """Drop every second frame of the older half."""
        half = len(self._blocks) // 2
        older, newer = self._blocks[:half], self._blocks[half:]
        self._blocks, self._bytes = [], sum(len(each.content) for each in newer)
        for each in older:
            times_s, frames = unpacked(each.content)
            content = packed(times_s[::2], frames[::2], _QUICK)
            block = Block(next(self._numbers), times_s[0], times_s[::2][-1], content)
            self._blocks.append(block)
            self._bytes += len(content)
        self._blocks += newer
