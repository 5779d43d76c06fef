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

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray, Int64Array
from crs_cc.sim.devices.sonar.model import sonars_of
from crs_cc.sim.kernels import exact
from crs_cc.sim.state.random_streams import Noise

if TYPE_CHECKING:
    from crs_cc.sim.model.world import WorldModel


_ERROR, _DROPOUT, _CROSSTALK = range(3)
_DEVIATES: Final = 3


_NOBODY: Final = np.zeros(0, dtype=np.intp)


class SonarErrors:
    """The errors of all robots' sonars."""

    def __init__(self, world: WorldModel, seed: int, stream: int) -> None:
        modes = [sonars_of(robot.model).modes for robot in world.robots]
        boards = [mode.board for each in modes for mode in each]
        self._first = np.cumsum([0, *map(len, modes)])[:-1].astype(np.intp)
        self._blind_m = np.array([board.blind_m for board in boards])
        self._minimum_m = np.array([board.minimum_m for board in boards])
        self._noise_m = np.array([board.noise_m for board in boards])
        self._noise_share = np.array([board.noise_share for board in boards])
        self._misses = np.array([_quantile(board.dropouts) for board in boards])
        self._mistakes = np.array([_quantile(board.crosstalk) for board in boards])
        self._resolution_m = np.array([board.resolution_m for board in boards])
        limits = (self._blind_m, self._minimum_m, self._resolution_m)
        self._exact = not any(each.any() for each in limits)
        random = any(
            board.noise_m or board.noise_share or board.dropouts or board.crosstalk
            for board in boards
        )
        self._noise = Noise(seed, stream, _DEVIATES, len(modes)) if random else None

    def draw(self, rows: IndexArray, numbers: Int64Array) -> FloatArray:
        """Return the deviates of one firing of each robot, shape (k, 3)."""
        if self._noise is None:
            return np.zeros((len(rows), _DEVIATES))
        return np.asarray(self._noise.rows(rows, numbers))

    def confused(self, rows: IndexArray, mode: IndexArray, deviates: FloatArray) -> IndexArray:
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
        kind = self._first[rows] + mode
        beyond_m = _beyond(self._blind_m[kind], distance_m)
        reported_m: FloatArray = np.maximum(beyond_m, self._minimum_m[kind])
        if self._noise is None:
            return _rounded(reported_m, self._resolution_m[kind])
        heard = np.isfinite(reported_m) & (deviates[:, _DROPOUT] >= self._misses[kind])
        size_m = np.where(heard, reported_m, 0.0)
        error_m = deviates[:, _ERROR] * exact.hypot(
            self._noise_m[kind], self._noise_share[kind] * size_m
        )
        reported_m = np.where(heard, np.maximum(size_m + error_m, 0.0), np.inf)
        return _rounded(reported_m, self._resolution_m[kind])


def _rounded(reported_m: FloatArray, step_m: FloatArray) -> FloatArray:
    """Return values rounded to multiples of steps; a step of 0 changes nothing."""
    if not step_m.any():
        return reported_m
    steps = np.divide(reported_m, step_m, out=reported_m.copy(), where=step_m > 0.0)
    return np.where(step_m > 0.0, np.rint(steps) * step_m, reported_m)


def _beyond(blind_m: FloatArray, distance_m: FloatArray) -> FloatArray:
    """Return the smallest multiple of distances that is not below the minimum range."""
    near = distance_m < blind_m
    if not near.any():
        return distance_m
    apart = near & (distance_m > 0.0)
    times = np.ceil(np.divide(blind_m, distance_m, out=np.ones_like(distance_m), where=apart))
    return np.where(near, np.where(apart, times * distance_m, blind_m), distance_m)


def _quantile(probability: float) -> float:
    """Return the quantile of the normal distribution."""
    if probability <= 0.0:
        return -np.inf
    from statistics import NormalDist  # slow to import

    return np.inf if probability >= 1.0 else NormalDist().inv_cdf(probability)
