"""Random numbers by name: each is a function of the seed and of some whole numbers alone.

Where two robots meet, no stream belongs to both: a row of numbers for each pair would have to be
kept. So the number is computed of what it is for, by the mixing steps of SplitMix64 (G. L. Steele,
D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators", 2014), one for each whole
number. Whatever else happens in a world changes none of them.

>>> chances = Chances(seed=1, stream=5)
>>> few, again = chances.draw(np.arange(3), 7), chances.draw(np.array([2]), 7)
>>> bool(few[2] == again[0]), bool((few != chances.draw(np.arange(3), 8)).all())
(True, True)
"""

from __future__ import annotations

from typing import Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import FloatArray

_STEP: Final = np.uint64(0x9E3779B97F4A7C15)
_FIRST: Final = np.uint64(0xBF58476D1CE4E5B9)
_SECOND: Final = np.uint64(0x94D049BB133111EB)
_BITS: Final = np.uint64(11)  # what a double has no room for
_UNIT: Final = 2.0**-53


class Chances:
    """Numbers uniformly distributed over [0, 1)."""

    def __init__(self, seed: int, stream: int) -> None:
        """Makes them.

        Args:
            seed: decides all of them; not negative.
            stream: what they are for, a number of `noise`.
        """
        sequence = np.random.SeedSequence(seed, spawn_key=(stream,))
        self._start = sequence.generate_state(1, np.uint64)

    def draw(self, *names: npt.NDArray[np.integer] | int) -> FloatArray:
        """Gives the number that belongs to each row of whole numbers, shape (k,).

        Args:
            names: one or more, of shape (k,) or single.
        """
        state = self._start
        for name in names:
            state = _mixed((state ^ np.asarray(name).astype(np.uint64)) + _STEP)
        return np.asarray((state >> _BITS) * _UNIT)


def _mixed(state: npt.NDArray[np.uint64]) -> npt.NDArray[np.uint64]:
    state = (state ^ (state >> np.uint64(30))) * _FIRST
    state = (state ^ (state >> np.uint64(27))) * _SECOND
    return state ^ (state >> np.uint64(31))
