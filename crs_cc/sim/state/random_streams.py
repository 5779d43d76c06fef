"""Random streams with random access: each number is a function of seed, stream key and index.

Each robot's sensor has a stream of its own, so that readings of one robot never change the noise of
another. A stream consists of blocks: block b of the stream with key k comes from a generator seeded
with `SeedSequence(seed, spawn_key=(*k, b))`. There is no generator state to save: any row can be
generated again from its index.

Normal deviates are made of uniform ones by the transformation of Box and Muller ("A note on the
generation of random normal deviates", 1958). numpy's own depend on the host's C library.

>>> noise = Noise(seed=1, sensor=SONAR, width=2, robots=3)
>>> rows = noise.rows(np.array([0, 2]), np.array([0, 500]))
>>> again = Noise(seed=1, sensor=SONAR, width=2, robots=3)
>>> bool((again.rows(np.array([2]), np.array([500]))[0] == rows[1]).all())
True
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray, Int64Array
from crs_cc.sim.kernels import exact

SONAR: Final = 0
ROLLING: Final = 4
MESSAGES: Final = 20
DEGRADATION: Final = 100
"""Keys of the sensors."""

_BLOCK_ROWS: Final = 64  # few enough to be generated quickly, many enough to be so rarely
_MAX_BLOCK_SIZE: Final = 4096  # deviates; one block is held for each stream


class _BlockCache:
    """The rows of several streams, of each of which one block is held."""

    def __init__(
        self,
        seed: int,
        keys: Sequence[tuple[int, ...]],
        row_shape: tuple[int, ...],
        fill: Callable[[np.random.Generator, FloatArray], None],
    ) -> None:
        """Set up the streams; blocks are generated when they are asked for.

        Args:
            seed: the random seed.
            keys: the key of each stream.
            row_shape: shape of a row; its last dimension bounds the number of rows in a block.
            fill: fills a block, of shape (rows, *row_shape), from a generator.
        """
        self._seed, self._keys, self._fill = seed, tuple(keys), fill
        self._rows = min(_BLOCK_ROWS, max(1, _MAX_BLOCK_SIZE // row_shape[-1]))
        self._blocks = np.zeros((len(self._keys), self._rows, *row_shape))
        self._held = np.full(len(self._keys), -1, dtype=np.int64)  # the block of each stream

    def rows(self, streams: Int64Array, numbers: Int64Array) -> FloatArray:
        """Return row `numbers[i]` of stream `streams[i]`, shape (k, *row_shape)."""
        blocks, places = numbers // self._rows, numbers % self._rows
        found = self._blocks[streams, places]
        for miss in np.flatnonzero(self._held[streams] != blocks):
            stream, block = int(streams[miss]), int(blocks[miss])
            if self._held[stream] != block:  # else an earlier row of this call needed it
                self._generate(stream, block)
            found[miss] = self._blocks[stream, places[miss]]
        return np.asarray(found)

    def _generate(self, stream: int, block: int) -> None:
        seeds = np.random.SeedSequence(self._seed, spawn_key=(*self._keys[stream], block))
        self._fill(np.random.Generator(np.random.PCG64(seeds)), self._blocks[stream])
        self._held[stream] = block


class Noise:
    """Standard normal deviates for one sensor of all robots, in rows of `width`."""

    def __init__(self, seed: int, sensor: int, width: int, robots: int) -> None:
        keys = [(robot, sensor) for robot in range(robots)]
        self._cache = _BlockCache(seed, keys, (width,), _fill_normal)

    def rows(self, robots: Int64Array, numbers: Int64Array) -> FloatArray:
        """Return row `numbers[i]` of the stream of robot `robots[i]`, shape (k, width)."""
        return self._cache.rows(robots, numbers)


class NormalUniformStreams:
    """Standard normal and uniform deviates, in rows of `width` of each.

    >>> streams = NormalUniformStreams(seed=1, keys=[(0, DEGRADATION, 0)], width=2)
    >>> normal, uniform = streams.rows(np.array([0]), np.array([7]))
    >>> normal.shape, bool(((uniform >= 0) & (uniform < 1)).all())
    ((1, 2), True)
    """

    def __init__(
        self, seed: int, keys: Sequence[tuple[int, ...]], width: int, *, draws: bool = True
    ) -> None:
        """Set up the streams.

        Args:
            seed: the random seed.
            keys: the key of each stream.
            width: number of deviates of each kind in a row.
            draws: whether any are needed; otherwise all are 0 and 1.
        """
        self._width = width
        self._cache = _BlockCache(seed, keys, (2, width), _fill_both) if draws else None

    def rows(self, streams: Int64Array, numbers: Int64Array) -> tuple[FloatArray, FloatArray]:
        """Return row `numbers[i]` of stream `streams[i]`, normal and uniform, each (k, width)."""
        if self._cache is None:
            return np.zeros((len(streams), self._width)), np.ones((len(streams), self._width))
        rows = self._cache.rows(streams, numbers)
        return rows[:, 0], rows[:, 1]


def _fill_normal(generator: np.random.Generator, block: FloatArray) -> None:
    block[...] = _normal(generator, block.shape)


def _fill_both(generator: np.random.Generator, block: FloatArray) -> None:
    rows, _, width = block.shape
    block[:, 0] = _normal(generator, (rows, width))
    block[:, 1] = generator.random((rows, width))


def _normal(generator: np.random.Generator, shape: tuple[int, ...]) -> FloatArray:
    """Return standard normal deviates."""
    count = math.prod(shape)
    uniform = generator.random((2, (count + 1) // 2))
    away = np.sqrt(-2.0 * exact.log(1.0 - uniform[0]))  # 1 - u is never 0
    turns = exact.turn(2 * math.pi * uniform[1])
    return np.concatenate([away * turns.real, away * turns.imag])[:count].reshape(shape)
