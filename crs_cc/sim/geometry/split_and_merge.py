"""Line segments from points: split and merge.

The points, in the order of measurement, are split where two neighbours are further apart than the
gap. A run of points is one segment if the mean square of its points' distances from their line is
at most the threshold; else it is split at the point that is furthest from the chord between its
ends (U. Ramer, "An iterative procedure for the polygonal approximation of plane curves", 1972),
recursively. Neighbours that fit on one line are merged (T. Pavlidis, S. L. Horowitz, "Segmentation
of plane curves", 1974). The line is fitted by least squares; a segment's ends are the projections
of its first and last point on it. Segments of too few points are dropped.

>>> corner = np.array([[0, 0], [10, 0], [20, 0], [20, 10], [20, 20]], dtype=np.float64)
>>> segments(corner, threshold=1.0, min_points=2, gap=15.0).tolist()
[[0.0, 0.0, 20.0, 0.0], [20.0, 0.0, 20.0, 20.0]]
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.kernels import exact

Run = tuple[int, int]
"""Indices of the first and the last point of a segment."""

_MIN_POINTS: Final = 2  # points on a line
_NEAR: Final = 1e-12


def segments(points: FloatArray, threshold: float, min_points: int, gap: float) -> FloatArray:
    """Return the segments through points.

    Args:
        points: x and y of each, in the order of measurement, shape (n, 2).
        threshold: the largest mean square of the points' distances from their line.
        min_points: minimum number of points of a segment, at least 2.
        gap: the largest distance between neighbours of a segment.

    Returns:
        both ends of each, x1, y1, x2, y2, shape (m, 4).
    """
    found: list[Run] = []
    for run in _runs(points, gap):
        found += _merged(points, _split(points, run, threshold), threshold)
    least = max(min_points, _MIN_POINTS)
    long = [run for run in found if run[1] - run[0] + 1 >= least]
    return np.array([_ends(points, run) for run in long], dtype=np.float64).reshape(-1, 4)


def _runs(points: FloatArray, gap: float) -> list[Run]:
    """Split points where neighbours are too far apart."""
    if not len(points):
        return []
    steps = exact.hypot(*np.diff(points, axis=0).T)
    cuts = np.flatnonzero(steps > gap).tolist()
    return list(zip([0, *(cut + 1 for cut in cuts)], [*cuts, len(points) - 1], strict=True))


def _split(points: FloatArray, run: Run, threshold: float) -> list[Run]:
    """Split a run at corners; neighbours share the point at the corner."""
    done: list[Run] = []
    waiting = [run]
    while waiting:
        first, last = waiting.pop()
        if last - first < _MIN_POINTS or _error(points, (first, last)) <= threshold:
            done.append((first, last))
            continue
        corner = first + 1 + int(np.argmax(_from_chord(points, (first, last))))
        waiting += [(corner, last), (first, corner)]
    return done


def _merged(points: FloatArray, runs: list[Run], threshold: float) -> list[Run]:
    """Join neighbours that are on one line."""
    merged = runs[:1]
    for run in runs[1:]:
        together = (merged[-1][0], run[1])
        if _error(points, together) <= threshold:
            merged[-1] = together
        else:
            merged.append(run)
    return merged


def _from_chord(points: FloatArray, run: Run) -> FloatArray:
    """Return the distances between the points inside a run and its chord."""
    start, end = points[run[0]], points[run[1]]
    along, inner = end - start, points[run[0] + 1 : run[1]] - start
    length = float(exact.hypot(*along))
    if length < _NEAR:
        return np.asarray(exact.hypot(*inner.T))
    return np.asarray(np.abs(along[0] * inner[:, 1] - along[1] * inner[:, 0]) / length)


def _line(points: FloatArray, run: Run) -> tuple[FloatArray, FloatArray, float]:
    """Return the centroid, the direction, and the mean square error of the line through a run."""
    part = points[run[0] : run[1] + 1]
    middle = part.mean(axis=0)
    x, y = (part - middle).T
    xx, yy, xy = (float((a * b).sum()) for a, b in ((x, x), (y, y), (x, y)))
    angle = exact.arctan2(2 * xy, xx - yy) / 2
    direction = np.array([exact.cos(angle), exact.sin(angle)])
    across = direction[0] * y - direction[1] * x
    return middle, direction, float((across * across).sum()) / len(part)


def _error(points: FloatArray, run: Run) -> float:
    return _line(points, run)[2]


def _ends(points: FloatArray, run: Run) -> FloatArray:
    middle, direction, _ = _line(points, run)
    along = ((points[[run[0], run[1]]] - middle) * direction).sum(axis=1)
    return np.concatenate([middle + share * direction for share in along])
