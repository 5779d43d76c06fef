"""The distances that beams measure, computed with numpy from all pairs: the kernel's oracle."""

from __future__ import annotations

import numpy as np

from crs_cc.core.arrays import ComplexArray, FloatArray, IndexArray
from crs_cc.sim.geometry.outline_query import ObstacleQuery
from crs_cc.sim.geometry.rays import NO_THING, Fan
from crs_cc.sim.kernels import exact

_HEAD = 6  # numbers before the rows of beams


def nearest(
    fan: Fan, poses: FloatArray, obstacles: ObstacleQuery, own: IndexArray
) -> tuple[FloatArray, IndexArray]:
    """Return the measured distance of each beam of each robot, and the object that it hits."""
    count, place = len(fan), poses[:, 0] + 1j * poses[:, 1]
    beams = fan.table[_HEAD : _HEAD + 8 * count].reshape(count, 8)
    facing = exact.turn(poses[:, 2].copy())[:, None]
    start = exact.product(facing, beams[:, 0] + 1j * beams[:, 1])
    backturn = np.conjugate(exact.product(facing, beams[:, 2] + 1j * beams[:, 3]))
    side_cos, side_sin = beams[:, 4], beams[:, 5]
    found = np.full((len(poses), count), np.inf)
    hit = np.full(found.shape, NO_THING, dtype=np.intp)

    def take(viewers: IndexArray, distance_m: FloatArray, objects: IndexArray) -> None:
        for viewer, row_m, obj in zip(viewers, distance_m, objects, strict=True):
            nearer = row_m <= np.minimum(found[viewer], beams[:, 6])
            found[viewer, nearer], hit[viewer, nearer] = row_m[nearer], obj

    viewers, a, b, length_m = obstacles.segments_near(place)
    a, b = a - place.take(viewers), b - place.take(viewers)
    cross = a.real * b.imag - a.imag * b.real
    faces = cross <= fan.start_m * length_m
    ends = (exact.product(end[:, None] - start[viewers], backturn[viewers]) for end in (a, b))
    distance_m = _to_segment(side_cos, side_sin, *ends)
    take(viewers[faces], distance_m[faces], obstacles.segment_objects(place)[faces])
    viewers, middle, radius_m = obstacles.circles_near(place, own)
    away = exact.product((middle - place[viewers])[:, None] - start[viewers], backturn[viewers])
    distance_m = _to_circle(side_cos, side_sin, away, radius_m[:, None])
    take(viewers, distance_m, obstacles.circle_objects(place, own))
    given, objects = np.empty_like(found), np.empty_like(hit)
    given[:, fan.order], objects[:, fan.order] = found, hit
    return given, objects


def _to_segment(
    side_cos: FloatArray, side_sin: FloatArray, a: ComplexArray, b: ComplexArray
) -> FloatArray:
    """Return the distance from each beam's start to the part of a segment inside the beam.

    Args:
        side_cos: cosine of the half angle of each beam.
        side_sin: sine of it.
        a: one end of the segment in the frame of the beam, whose axis is x.
        b: the other end.
    """
    ax, ay, bx, by = a.real, a.imag, b.real, b.imag
    first, last = np.zeros_like(ax), np.ones_like(ax)
    for side in (side_cos, -side_cos):  # the cone: where the distances outside of both sides
        outside_a = side * ay - side_sin * ax  # are negative
        outside_b = side * by - side_sin * bx
        with np.errstate(divide="ignore", invalid="ignore"):
            crossing = outside_a / (outside_a - outside_b)
        first = np.maximum(first, np.where(outside_a > 0.0, crossing, 0.0))
        last = np.minimum(last, np.where(outside_b > 0.0, crossing, 1.0))
    along_x, along_y = bx - ax, by - ay
    foot = -(ax * along_x + ay * along_y) / (along_x * along_x + along_y * along_y)
    share = np.minimum(np.maximum(foot, first), last)
    x, y = ax + share * along_x, ay + share * along_y
    return np.where(first > last, np.inf, np.sqrt(x * x + y * y))


def _to_circle(
    side_cos: FloatArray, side_sin: FloatArray, middle: ComplexArray, radius: FloatArray
) -> FloatArray:
    """Return the distance from each beam's start to the part of a circle inside the beam."""
    x, y = middle.real, np.abs(middle.imag)  # the nearer side is the upper one
    along, aside = side_cos * x + side_sin * y, side_cos * y - side_sin * x
    away = np.sqrt(x * x + y * y)
    squared = radius * radius - aside * aside
    on_side = along - np.sqrt(np.maximum(squared, 0.0))
    missed = (squared < 0.0) | (along < 0.0)
    distance = np.where(aside <= 0.0, away - radius, np.where(missed, np.inf, on_side))
    return np.where(away <= radius, 0.0, distance)
