"""The errors of sonars: the reported instead of the true distance.

In this order, each with its parameter in the robot definition:

- the board is deaf while the transducer still rings (`blind`). An echo from a nearer object goes
  back and forth, and is heard when it arrives in time: a distance d is reported as the smallest
  multiple of it that is not below `blind`, which users of the robot saw as twice the distance
  below 3 in;
- no reading is below `minimum`;
- a normal deviate is added, with the standard deviation hypot(`noise`, `noise-share` * d);
- an echo is missed altogether with the probability `dropouts`;
- the reading is a multiple of `resolution`.

Then the distance is rounded to whole inches. In the definitions' ideal setup all of this is 0.

Each robot draws from a stream of its own (`noise`), three deviates for each firing, independent of
other robots; an event of probability p is a deviate below the p-quantile of the normal
distribution.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray, Int64Array
from crs_cc.sim.devices.sonar.model import SonarBoard
from crs_cc.sim.kernels.program import ROBOTS_AT_ONCE, kernels
from crs_cc.sim.kernels.tables import ERRORS
from crs_cc.sim.state.random_streams import Noise
from crs_cc.sim.state.rows import parts

_CROSSTALK: Final = 2  # after the error's and the dropout's
_DEVIATES: Final = 3
_LIMITS: Final = 6
_ROUNDING: Final = [0, 1, 5]  # the limits without those of random errors

_NOBODY: Final = np.zeros(0, dtype=np.intp)


class SonarErrors:
    """The errors of all robots' sonars.

    Attributes:
        limits: those of each mode, see `kernels/sonars.c`, (modes, 6).
    """

    def __init__(
        self, boards: Sequence[SonarBoard], first: IndexArray, seed: int, stream: int
    ) -> None:
        """Set up the errors.

        Args:
            boards: the board of each mode.
            first: the first mode of each robot, (robots,).
            seed: the random seed.
            stream: the key of the sonars' streams.
        """
        self._first = first
        self._mistakes = np.array([_quantile(board.crosstalk) for board in boards])
        self.limits = np.array([_limits(board) for board in boards]).reshape(-1, _LIMITS)
        self._exact = not self.limits[:, _ROUNDING].any()
        random = any(
            board.noise_m or board.noise_share or board.dropouts or board.crosstalk
            for board in boards
        )
        self._noise = Noise(seed, stream, _DEVIATES, len(first)) if random else None

    @property
    def are_random(self) -> bool:
        """Whether any robot draws deviates."""
        return self._noise is not None

    @property
    def mistakes(self) -> FloatArray:
        """By mode, the deviate below which a ping is mistaken for an echo."""
        return self._mistakes

    def draw(self, rows: IndexArray, numbers: Int64Array) -> FloatArray:
        """Return the deviates of one firing of each robot, shape (k, 3)."""
        if self._noise is None:
            return np.zeros((len(rows), _DEVIATES))
        return np.asarray(self._noise.rows(rows, numbers))

    def affected_by_crosstalk(
        self, rows: IndexArray, mode: IndexArray, deviates: FloatArray
    ) -> IndexArray:
        """Return which of some robots mistake others' pings for their own in this firing."""
        if self._noise is None:
            return _NOBODY
        mistakes = self._mistakes[self._first[rows] + mode]
        return np.flatnonzero(deviates[:, _CROSSTALK] < mistakes)

    def reported_m(
        self, rows: IndexArray, mode: IndexArray, distance_m: FloatArray, deviates: FloatArray
    ) -> FloatArray:
        """Return the reported range for true distances, infinite for no echo; shape (k,)."""
        if self._exact and self._noise is None:
            return distance_m
        reported_m = np.empty(len(rows))
        limits = self.limits[self._first[rows] + mode]
        for _, part in parts(rows, len(rows), ROBOTS_AT_ONCE):
            columns = distance_m[part], limits[part], deviates[part]
            found = kernels().columns(ERRORS, len(columns[0]), columns)
            reported_m[part] = found[: len(columns[0])]
        return reported_m


def _limits(board: SonarBoard) -> tuple[float, ...]:
    """Return the errors of a board as `kernels/sonars.c` reads them."""
    return (
        board.blind_m,
        board.minimum_m,
        board.noise_m,
        board.noise_share,
        _quantile(board.dropouts),
        board.resolution_m,
    )


def _quantile(probability: float) -> float:
    """Return the quantile of the normal distribution."""
    if probability <= 0.0:
        return -np.inf
    from statistics import NormalDist  # slow to import

    return np.inf if probability >= 1.0 else NormalDist().inv_cdf(probability)
