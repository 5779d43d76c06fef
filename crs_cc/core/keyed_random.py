"""Counter-based random numbers: each is a function of seed, stream and integer keys only.

What concerns a pair of robots has no stream: a row would have to be held for each pair. So the
number is a hash of its keys, by the mixing steps of SplitMix64 (G. L. Steele, D. Lea, C. H. Flood,
"Fast splittable pseudorandom number generators", 2014), one step for each key. Nothing else that
happens in a world changes it.

>>> uniform = KeyedUniform(seed=1, stream=5)
>>> few, again = uniform.draw(np.arange(3), 7), uniform.draw(np.array([2]), 7)
>>> bool(few[2] == again[0]), bool((few != uniform.draw(np.arange(3), 8)).all())
(True, True)
"""

from __future__ import annotations

from functools import cached_property
from typing import Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import FloatArray

_STEP: Final = np.uint64(0x9E3779B97F4A7C15)
_FIRST: Final = np.uint64(0xBF58476D1CE4E5B9)
_SECOND: Final = np.uint64(0x94D049BB133111EB)
_BITS: Final = np.uint64(11)  # more than the mantissa of a double holds
_UNIT: Final = 2.0**-53


class KeyedUniform:
    """Uniform deviates in [0, 1), by key."""

    def __init__(self, seed: int, stream: int) -> None:
        """Set the seed.

        Args:
            seed: the random seed, not negative.
            stream: the key of their purpose, a constant of `random_streams`.
        """
        self._seed, self._stream = seed, stream

    @cached_property
    def _start(self) -> npt.NDArray[np.uint64]:
        sequence = np.random.SeedSequence(self._seed, spawn_key=(self._stream,))
        return np.asarray(sequence.generate_state(1, np.uint64), np.uint64)

    def draw(self, *keys: npt.NDArray[np.integer] | int) -> FloatArray:
        """Return the deviate of each row of keys, shape (k,).

        Args:
            keys: one or more, each of shape (k,) or scalar.
        """
        state = self._start
        for key in keys:
            state = _mix((state ^ np.asarray(key).astype(np.uint64)) + _STEP)
        return np.asarray((state >> _BITS) * _UNIT)


def _mix(state: npt.NDArray[np.uint64]) -> npt.NDArray[np.uint64]:
    state = (state ^ (state >> np.uint64(30))) * _FIRST
    state = (state ^ (state >> np.uint64(27))) * _SECOND
    return state ^ (state >> np.uint64(31))
