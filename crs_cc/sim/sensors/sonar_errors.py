"""What a sonar tells instead of the true distance.

In this order, each with its parameter in the robot definition:

- the board is deaf while the transducer still rings (`blind`). An echo from nearer than that goes
  to and fro between robot and thing, and is heard when it comes in time: a distance d is told as
  the smallest multiple of it that is not below `blind`, which users of the robot saw as twice the
  distance below 3 in;
- nothing is told as nearer than `minimum`;
- a normal deviate is added, with the standard deviation hypot(`noise`, `noise-share` * d);
- an echo is missed altogether with the probability `dropouts`.

Then the distance is rounded to whole inches. In the definitions' ideal setup all of this is 0.

Each robot draws from a stream of its own (`noise`), three deviates for each firing, so that what
others do changes nothing; an event of probability p is a deviate below the p-quantile of the
normal distribution.
"""

from __future__ import annotations

from statistics import NormalDist
from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from crs_cc.sim.noise import SONAR, Noise

if TYPE_CHECKING:
    from crs_cc.sim.model import WorldModel

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]
IndexArray = npt.NDArray[np.intp]
WholeArray = npt.NDArray[np.int64]

_ERROR, _DROPOUT, _CROSSTALK = range(3)
_DEVIATES: Final = 3


class SonarErrors:
    """The errors of all robots' sonars."""

    def __init__(self, world: WorldModel, seed: int) -> None:
        boards = [robot.model.sonar_board for robot in world.robots]
        self._blind_m = np.array([board.blind_m for board in boards])
        self._minimum_m = np.array([board.minimum_m for board in boards])
        self._noise_m = np.array([board.noise_m for board in boards])
        self._noise_share = np.array([board.noise_share for board in boards])
        self._misses = np.array([_quantile(board.dropouts) for board in boards])
        self._mistakes = np.array([_quantile(board.crosstalk) for board in boards])
        self._exact = all(board.blind_m == board.minimum_m == 0.0 for board in boards)
        random = any(
            board.noise_m or board.noise_share or board.dropouts or board.crosstalk
            for board in boards
        )
        self._noise = Noise(seed, SONAR, _DEVIATES, len(boards)) if random else None

    def draw(self, rows: IndexArray, numbers: WholeArray) -> FloatArray:
        """Gives the deviates of one firing of each robot, shape (k, 3).

        Args:
            rows: which robots, none twice, k of them.
            numbers: the number of each robot's firing.
        """
        if self._noise is None:
            return np.zeros((len(rows), _DEVIATES))
        return np.asarray(self._noise.rows(rows, numbers))

    def mistakes(self, rows: IndexArray, deviates: FloatArray) -> BoolArray:
        """Tells which robots cannot tell other robots' pings from their own this time."""
        return np.asarray(deviates[:, _CROSSTALK] < self._mistakes[rows])

    def told_m(self, rows: IndexArray, distance_m: FloatArray, deviates: FloatArray) -> FloatArray:
        """Gives what is told for true distances, infinite for no echo; shape (k,)."""
        if self._exact and self._noise is None:
            return distance_m
        beyond_m = _beyond(self._blind_m[rows], distance_m)
        told_m: FloatArray = np.maximum(beyond_m, self._minimum_m[rows])
        if self._noise is None:
            return told_m
        heard = np.isfinite(told_m) & (deviates[:, _DROPOUT] >= self._misses[rows])
        size_m = np.where(heard, told_m, 0.0)
        error_m = deviates[:, _ERROR] * np.hypot(
            self._noise_m[rows], self._noise_share[rows] * size_m
        )
        return np.where(heard, np.maximum(size_m + error_m, 0.0), np.inf)


def _beyond(blind_m: FloatArray, distance_m: FloatArray) -> FloatArray:
    """Gives the smallest multiple of distances that is not nearer than a robot can hear."""
    near = distance_m < blind_m
    if not near.any():
        return distance_m
    apart = near & (distance_m > 0.0)
    times = np.ceil(np.divide(blind_m, distance_m, out=np.ones_like(distance_m), where=apart))
    return np.where(near, np.where(apart, times * distance_m, blind_m), distance_m)


def _quantile(probability: float) -> float:
    """Gives what a normal deviate is below with a probability."""
    if probability <= 0.0:
        return -np.inf
    return np.inf if probability >= 1.0 else NormalDist().inv_cdf(probability)
