"""Random numbers that depend on the seed, the robot, the sensor and their number, and nothing else.

Each robot's sensor has a stream of its own, so that what one robot reads never changes the noise
of another. A stream is made of blocks: block b of robot r and sensor s comes from a generator
seeded with `SeedSequence(seed, spawn_key=(r, s, b))`. So there is no generator to save: a row can
be made again from its number at any time.

>>> noise = Noise(seed=1, sensor=SONAR, width=2, robots=3)
>>> rows = noise.rows(np.array([0, 2]), np.array([0, 500]))
>>> again = Noise(seed=1, sensor=SONAR, width=2, robots=3)
>>> bool((again.rows(np.array([2]), np.array([500]))[0] == rows[1]).all())
True
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray, Int64Array

SONAR: Final = 0
INFRARED: Final = 1
COMPASS: Final = 2
LASER: Final = 3
ROLLING: Final = 4
CAMERA: Final = 6
MESSAGES: Final = 20
LIGHT: Final = 22
SOUND: Final = 23
DEGRADATION: Final = 100
"""Numbers of the sensors."""

_BLOCK: Final = 64  # rows in a block: few enough to make quickly, many enough to make rarely
_LARGEST_BLOCK: Final = 4096  # numbers in a block: every robot has room for one


class Noise:
    """Standard normal deviates for one sensor of all robots, in rows of `width`."""

    def __init__(self, seed: int, sensor: int, width: int, robots: int) -> None:
        self._seed = seed
        self._sensor = sensor
        self._size = min(_BLOCK, max(1, _LARGEST_BLOCK // width))
        self._blocks = np.zeros((robots, self._size, width))
        self._numbers = np.full(robots, -1, dtype=np.int64)

    def rows(self, robots: Int64Array, numbers: Int64Array) -> FloatArray:
        """Gives row number `numbers[i]` of the stream of robot `robots[i]`, shape (k, width)."""
        blocks = numbers // self._size
        for place in np.flatnonzero(self._numbers[robots] != blocks):
            self._make(int(robots[place]), int(blocks[place]))
        return np.asarray(self._blocks[robots, numbers % self._size])

    def _make(self, robot: int, block: int) -> None:
        seeds = np.random.SeedSequence(self._seed, spawn_key=(robot, self._sensor, block))
        generator = np.random.Generator(np.random.PCG64(seeds))
        generator.standard_normal(out=self._blocks[robot])
        self._numbers[robot] = block


class Draws:
    """Normal and uniform deviates for things of robots, each with a stream of its own.

    >>> draws = Draws(seed=1, keys=[(0, DEGRADATION, 0)], width=2)
    >>> normal, uniform = draws.rows(np.array([0]), np.array([7]))
    >>> normal.shape, bool(((uniform >= 0) & (uniform < 1)).all())
    ((1, 2), True)
    """

    def __init__(
        self, seed: int, keys: Sequence[tuple[int, ...]], width: int, *, draws: bool = True
    ) -> None:
        """Makes the streams.

        Args:
            seed: the seed of the run.
            keys: what tells each stream from all others.
            width: how many deviates of each kind are in a row.
            draws: whether any are needed; otherwise all are 0 and 1.
        """
        self._seed, self._keys, self._draws, self._width = seed, tuple(keys), draws, width
        self._size = min(_BLOCK, max(1, _LARGEST_BLOCK // width))
        rows = len(self._keys) if draws else 0
        self._blocks = np.zeros((rows, self._size, 2, width))
        self._numbers = np.full(rows, -1, dtype=np.int64)

    def rows(self, streams: Int64Array, numbers: Int64Array) -> tuple[FloatArray, FloatArray]:
        """Gives row number `numbers[i]` of stream `streams[i]`, normal and uniform, (k, width)."""
        if not self._draws:
            return np.zeros((len(streams), self._width)), np.ones((len(streams), self._width))
        blocks = numbers // self._size
        for place in np.flatnonzero(self._numbers[streams] != blocks):
            self._make(int(streams[place]), int(blocks[place]))
        rows = self._blocks[streams, numbers % self._size]
        return rows[:, 0], rows[:, 1]

    def _make(self, stream: int, block: int) -> None:
        seeds = np.random.SeedSequence(self._seed, spawn_key=(*self._keys[stream], block))
        generator = np.random.Generator(np.random.PCG64(seeds))
        self._blocks[stream, :, 0] = generator.standard_normal((self._size, self._width))
        self._blocks[stream, :, 1] = generator.random((self._size, self._width))
        self._numbers[stream] = block
