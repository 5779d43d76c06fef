"""Simple polygons: validity, area, moments, distances, and triangulation.

A polygon is simple: its sides meet only where two neighbours share a corner. It is triangulated by
ear clipping (Meisters, "Polygons have ears", 1975): every simple polygon has two corners whose
neighbours see each other through the inside.

>>> hook = np.array([(0, 0), (4, 0), (4, 3), (2, 1), (0, 3)], dtype=float)
>>> area_m2(hook), validation_error(hook)
(8.0, '')
>>> triangles(hook).tolist()
[[1, 2, 3], [3, 4, 0], [0, 1, 3]]
>>> validation_error(hook[[0, 2, 1, 3, 4]])
'the side from corner 1 to 2 meets the side from corner 4 to 5'
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core import segment
from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.kernels import exact

MIN_LENGTH_M: Final = 1e-3
"""Minimum length of a side, and minimum distance between sides that are not neighbours."""

_FLAT_M2: Final = 1e-12  # twice the area of a degenerate triangle


def area_m2(corners_m: FloatArray) -> float:
    """Return the signed area, negative for clockwise corners (shoelace formula)."""
    x, y = (corners_m - corners_m[0]).T
    return float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2)


def centroid_m(corners_m: FloatArray) -> FloatArray:
    """Return the centroid, shape (2,)."""
    x, y = (corners_m - corners_m[0]).T
    next_x, next_y = np.roll(x, -1), np.roll(y, -1)
    cross = x * next_y - next_x * y
    sums = np.array([((x + next_x) * cross).sum(), ((y + next_y) * cross).sum()])
    return np.asarray(corners_m[0] + sums / (3 * cross.sum()))


def second_moment_m4(corners_m: FloatArray) -> float:
    """Return the polar second moment of the area about the origin."""
    x, y = corners_m.T
    next_x, next_y = np.roll(x, -1), np.roll(y, -1)
    cross = x * next_y - next_x * y
    squares = x * x + x * next_x + next_x * next_x + y * y + y * next_y + next_y * next_y
    return float((cross * squares).sum() / 12)


def distances_m(points_m: FloatArray, corners_m: FloatArray, counts: IndexArray) -> FloatArray:
    """Return the signed distances from points to polygons, one polygon a point; negative inside.

    A point is inside if a ray to its right meets an odd number of sides (Shimrat, "Algorithm 112:
    position of point relative to polygon", 1962).

    Args:
        points_m: the points, (k, 2).
        corners_m: the corners of all polygons, one polygon after the other, (n, 2).
        counts: number of corners of each polygon, (k,).

    Returns:
        the distances to the nearest side, (k,).
    """
    if not len(points_m):
        return np.zeros(0)
    ends = np.cumsum(counts)
    after = np.arange(1, len(corners_m) + 1)
    after[ends - 1] = ends - counts
    side = corners_m[after] - corners_m
    across = np.repeat(points_m, counts, axis=0) - corners_m
    sides_m = segment.distance(*across.T, *side.T)
    nearest_m = np.minimum.reduceat(sides_m, ends - counts)
    spans = (across[:, 1] < 0.0) != (across[:, 1] < side[:, 1])
    rise = np.where(spans, side[:, 1], 1.0)
    meets = spans & (across[:, 0] < side[:, 0] * across[:, 1] / rise)
    inside = np.logical_xor.reduceat(meets, ends - counts)
    return np.where(inside, -nearest_m, nearest_m)


def validation_error(corners_m: FloatArray) -> str:
    """Return why corners, in either order, are not a valid polygon; empty if they are."""
    count = len(corners_m)
    if count < 3:
        return "fewer than 3 corners"
    ends_m = np.roll(corners_m, -1, axis=0)
    sides_m = ends_m - corners_m
    length_m = exact.hypot(sides_m[:, 0], sides_m[:, 1])
    if length_m.min() < MIN_LENGTH_M:
        corner = int(length_m.argmin())
        return f"corners {corner + 1} and {_next(corner, count) + 1} are less than 1mm apart"
    if (pair := _meeting(corners_m, ends_m)) is not None:
        first, second = ((side + 1, _next(side, count) + 1) for side in pair)
        return "the side from corner {} to {} meets the side from corner {} to {}".format(
            *first, *second
        )
    return ""


def is_convex(corners_m: FloatArray) -> bool:
    """Return whether a polygon with counter-clockwise corners is convex."""
    before, after = np.roll(corners_m, 1, axis=0), np.roll(corners_m, -1, axis=0)
    return bool((_turn(before, corners_m, after) >= 0.0).all())


def triangles(corners_m: FloatArray) -> IndexArray:
    """Return the indices of the corners of triangles of a polygon, counter-clockwise, (n, 3)."""
    left = list(range(len(corners_m)))
    found: list[list[int]] = []
    at = 0
    while len(left) > 3:
        at = _ear(corners_m[left], at)
        _cut(corners_m, [left[at - 1], left[at], left[(at + 1) % len(left)]], found)
        del left[at]
        at %= len(left)
    _cut(corners_m, left, found)
    return np.array(found, dtype=np.intp).reshape(-1, 3)


def _next(corner: int, count: int) -> int:
    return (corner + 1) % count


def _cut(corners_m: FloatArray, ear: list[int], found: list[list[int]]) -> None:
    """Clip an ear; an ear without area (collinear corners) yields no triangle."""
    a, b, c = corners_m[ear]
    if _turn(a, b, c) > _FLAT_M2:
        found.append(ear)


def _ear(corners_m: FloatArray, start: int) -> int:
    """Return the first corner from `start` on that is an ear."""
    before, after = np.roll(corners_m, 1, axis=0), np.roll(corners_m, -1, axis=0)
    turns = _turn(before, corners_m, after)
    around = np.roll(np.arange(len(corners_m)), -start)
    dents = corners_m[turns < _FLAT_M2]
    for corner in around[turns[around] >= -_FLAT_M2].tolist():
        a, b, c = before[corner], corners_m[corner], after[corner]
        if turns[corner] <= _FLAT_M2 or not _inside(dents, a, b, c):
            return int(corner)
    return int(turns.argmax())  # reached only through rounding


def _inside(points: FloatArray, a: FloatArray, b: FloatArray, c: FloatArray) -> bool:
    """Return whether any point, other than its corners, is in or on a triangle."""
    within = (_turn(a, b, points) >= 0) & (_turn(b, c, points) >= 0) & (_turn(c, a, points) >= 0)
    for corner in (a, b, c):
        within &= (points != corner).any(axis=1)
    return bool(within.any())


def _turn(a: FloatArray, b: FloatArray, c: FloatArray) -> FloatArray:
    """Return twice the signed area of triangles, positive if a, b, c turn left."""
    ab, ac = b - a, c - a
    return np.asarray(ab[..., 0] * ac[..., 1] - ab[..., 1] * ac[..., 0])


def _meeting(starts_m: FloatArray, ends_m: FloatArray) -> tuple[int, int] | None:
    """Return two sides that meet or are too close, other than neighbours at their common corner."""
    count = len(starts_m)
    for side in range(count):
        a, b, c = starts_m[side], ends_m[side], ends_m[_next(side, count)]
        if _folds(a, b, c):
            return side, _next(side, count)
        far = slice(side + 2, count - 1 if side == 0 else count)
        near = np.flatnonzero(_apart_m(a, b, starts_m[far], ends_m[far]) < MIN_LENGTH_M)
        if len(near):
            return side, side + 2 + int(near[0])
    return None


def _folds(a: FloatArray, b: FloatArray, c: FloatArray) -> bool:
    """Return whether the sides from a to b and from b to c fold back on each other."""
    if ((a - b) * (c - b)).sum() <= 0:
        return False
    ends = (a, c) if exact.hypot(*(a - b)) < exact.hypot(*(c - b)) else (c, a)
    return float(_to_segment_m(ends[0], b, ends[1])) < MIN_LENGTH_M


def _apart_m(a: FloatArray, b: FloatArray, c: FloatArray, d: FloatArray) -> FloatArray:
    """Return the distances between the segments from a to b and those from c to d."""
    crossing = (_turn(a, b, c) * _turn(a, b, d) < 0) & (_turn(c, d, a) * _turn(c, d, b) < 0)
    ends = [_to_segment_m(a, c, d), _to_segment_m(b, c, d)]
    ends += [_to_segment_m(c, a, b), _to_segment_m(d, a, b)]
    return np.where(crossing, 0.0, np.minimum.reduce(ends))


def _to_segment_m(point: FloatArray, start: FloatArray, end: FloatArray) -> FloatArray:
    along, across = end - start, point - start
    return segment.distance(across[..., 0], across[..., 1], along[..., 0], along[..., 1])
