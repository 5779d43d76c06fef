"""The robots' paths and contacts, for the plot of a run.

Memory is bounded: when there are more than `MAX_SAMPLES` samples, every other one is dropped, and
from then on only every other timestep is sampled.

>>> import numpy as np
>>> tracks = Tracks(max_samples=6)
>>> for step in range(7):
...     tracks.add(np.array([0.1 * step]), np.array([0.0]))
>>> tracks.end(np.array([0.65]), np.array([0.0]))
>>> [round(float(x), 2) for x, _ in tracks.path(0)]
[0.0, 0.2, 0.4, 0.6, 0.65]
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core import segment
from crs_cc.core.arrays import FloatArray

MAX_SAMPLES: Final = 1_000_000
MAX_CONTACTS: Final = 5_000
_CONTACT_CELL_M: Final = 0.1


class Tracks:
    """The robots' paths, thinned evenly in time.

    Attributes:
        max_samples: maximum number of positions of all robots together.
        collisions: number of contacts that began; two robots that touch count once.
        contacts: robot and position of contacts, one for each `0.1 m` cell.
    """

    def __init__(self, max_samples: int = MAX_SAMPLES) -> None:
        self.max_samples = max_samples
        self.collisions = 0
        self.contacts: list[tuple[int, float, float]] = []
        self._cells: set[tuple[int, int, int]] = set()
        self._samples: list[FloatArray] = []
        self._last: FloatArray = np.zeros((0, 2))
        self._stride = 1
        self._timesteps = 0

    def add(self, x_m: FloatArray, y_m: FloatArray) -> None:
        """Add all robots' positions after a timestep, NaN for one that is not in the world."""
        self._last = np.column_stack([x_m, y_m])
        if self._timesteps % self._stride == 0:
            self._samples.append(self._last)
            if len(self._samples) > max(2, self.max_samples // max(1, len(x_m))):
                self._samples = self._samples[::2]
                self._stride *= 2
        self._timesteps += 1

    def repeat_last(self, timesteps: int) -> None:
        """Add the last positions again for further timesteps, in which nothing moved."""
        for _ in range(timesteps):
            if self._timesteps % self._stride:
                self._timesteps += 1
            else:
                self.add(*self._last.T)

    def add_contact(self, robot: int, x_m: float, y_m: float) -> None:
        """Add a contact."""
        cell = (robot, round(x_m / _CONTACT_CELL_M), round(y_m / _CONTACT_CELL_M))
        if cell not in self._cells and len(self.contacts) < MAX_CONTACTS:
            self._cells.add(cell)
            self.contacts.append((robot, x_m, y_m))

    def end(self, x_m: FloatArray, y_m: FloatArray) -> None:
        """Add all robots' final positions, regardless of the thinning; NaN as for `add`."""
        self._samples.append(np.column_stack([x_m, y_m]))

    def places_at(self, robot: int, every: int) -> list[tuple[int, float, float]]:
        """Return timestep, x and y [m] of a robot at multiples of a number of timesteps.

        They are those of the next sample, if there is none at the multiple itself.
        """
        found: list[tuple[int, float, float]] = []
        wanted = every
        for number, sample in enumerate(self._samples[:-1]):
            if number * self._stride >= wanted:
                x_m, y_m = sample[robot].tolist()
                if np.isfinite(x_m):
                    found.append((wanted, x_m, y_m))
                wanted += every
        return found

    def path(self, robot: int) -> FloatArray:
        """Return a robot's positions [m] while it was in the world, shape (samples, 2)."""
        path = np.array([sample[robot] for sample in self._samples]).reshape(-1, 2)
        return np.asarray(path[np.isfinite(path[:, 0])])


def simplified(path: FloatArray, tolerance: float) -> FloatArray:
    """Return a simplified line within `tolerance` of all points.

    Source: Douglas and Peucker, "Algorithms for the reduction of the number of points required to
    represent a digitized line", 1973.

    >>> line = np.array([[0.0, 0.0], [1.0, 0.01], [2.0, 0.0], [2.0, 1.0]])
    >>> simplified(line, 0.1).tolist()
    [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0]]
    """
    kept = np.zeros(len(path), dtype=bool)
    kept[[0, -1]] = True
    spans = [(0, len(path) - 1)]
    while spans:
        first, last = spans.pop()
        if last - first < 2:
            continue
        across, along = path[first + 1 : last] - path[first], path[last] - path[first]
        distances = segment.distance(*across.T, *along)
        farthest = int(np.argmax(distances))
        if distances[farthest] > tolerance:
            middle = first + 1 + farthest
            kept[middle] = True
            spans += [(first, middle), (middle, last)]
    return path[kept]
