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
from typing import Final, TypeAlias

import numpy as np

from crs_cc.core.arrays import FloatArray, Int64Array
from crs_cc.sim.kernels import exact

SONAR: Final = 0
ROLLING: Final = 4
MESSAGES: Final = 20
DEGRADATION: Final = 100
"""Keys of the sensors."""

_Generators: TypeAlias = "Sequence[np.random.Generator]"

_BLOCK_ROWS: Final = 64  # few enough to be generated quickly, many enough to be so rarely
_MAX_BLOCK_SIZE: Final = 4096  # deviates; one block is held for each stream


class _BlockCache:
    """The rows of several streams, of each of which one block is held."""

    def __init__(
        self,
        seed: int,
        keys: Sequence[tuple[int, ...]],
        row_shape: tuple[int, ...],
        draw: Callable[[_Generators, tuple[int, ...]], FloatArray],
    ) -> None:
        """Set up the streams; blocks are generated when they are asked for.

        Args:
            seed: the random seed.
            keys: the key of each stream.
            row_shape: shape of a row; its last dimension bounds the number of rows in a block.
            draw: returns blocks of a shape, (rows, *row_shape), one from each generator.
        """
        self._seed, self._keys, self._draw = seed, tuple(keys), draw
        self._rows = min(_BLOCK_ROWS, max(1, _MAX_BLOCK_SIZE // row_shape[-1]))
        self._blocks = np.zeros((len(self._keys), self._rows, *row_shape))
        self._held = np.full(len(self._keys), -1, dtype=np.int64)  # the block of each stream

    def rows(self, streams: Int64Array, numbers: Int64Array) -> FloatArray:
        """Return row `numbers[i]` of stream `streams[i]`, shape (k, *row_shape)."""
        blocks, places = numbers // self._rows, numbers % self._rows
        found = self._blocks[streams, places]
        missed = np.flatnonzero(self._held[streams] != blocks)
        while len(missed):
            _, first = np.unique(streams[missed], return_index=True)
            self._generate(streams[missed[first]], blocks[missed[first]])
            got = self._held[streams[missed]] == blocks[missed]
            found[missed[got]] = self._blocks[streams[missed[got]], places[missed[got]]]
            missed = missed[~got]
        return np.asarray(found)

    def _generate(self, streams: Int64Array, blocks: Int64Array) -> None:
        """Generate a block of each of some streams."""
        keys = [
            (*self._keys[stream], block)
            for stream, block in zip(streams.tolist(), blocks.tolist(), strict=True)
        ]
        seeds = (np.random.SeedSequence(self._seed, spawn_key=key) for key in keys)
        generators = [np.random.Generator(np.random.PCG64(seed)) for seed in seeds]
        self._blocks[streams] = self._draw(generators, self._blocks.shape[1:])
        self._held[streams] = blocks


class Noise:
    """Standard normal deviates for one sensor of all robots, in rows of `width`."""

    def __init__(self, seed: int, sensor: int, width: int, robots: int) -> None:
        keys = [(robot, sensor) for robot in range(robots)]
        self._cache = _BlockCache(seed, keys, (width,), _normal)

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
        self._cache = _BlockCache(seed, keys, (2, width), _both) if draws else None

    def rows(self, streams: Int64Array, numbers: Int64Array) -> tuple[FloatArray, FloatArray]:
        """Return row `numbers[i]` of stream `streams[i]`, normal and uniform, each (k, width)."""
        if self._cache is None:
            return np.zeros((len(streams), self._width)), np.ones((len(streams), self._width))
        rows = self._cache.rows(streams, numbers)
        return rows[:, 0], rows[:, 1]


def _both(generators: _Generators, shape: tuple[int, ...]) -> FloatArray:
    """Return a row of normal and one of uniform deviates, by turns."""
    rows, _, width = shape
    uniform = np.empty((len(generators), rows, width))
    normal = _normal(generators, (rows, width))
    for block, generator in zip(uniform, generators, strict=True):
        block[...] = generator.random((rows, width))
    return np.stack([normal, uniform], axis=2)


def _normal(generators: _Generators, shape: tuple[int, ...]) -> FloatArray:
    """Return standard normal deviates."""
    count = math.prod(shape)
    uniform = np.stack([each.random((2, (count + 1) // 2)) for each in generators], axis=1)
    pairs = exact.normal_pairs(uniform[0], uniform[1])
    return np.concatenate([pairs.real, pairs.imag], axis=1)[:, :count].reshape(-1, *shape)
