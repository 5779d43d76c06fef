"""Ray casting against segments and circles, vectorised over all robots and beams of a kind.

A beam is a cone with a half angle; a ray is a cone with half angle 0. A beam measures the distance
from its start to the nearest point of any object inside the cone: exactly, where a few rays would
miss a thin pillar. The nearest point of a segment is found by clipping the segment to the cone
(Liang and Barsky, "A new concept and method for line clipping", 1984) and projecting the start on
the rest; that of a circle is towards its centre, or on the nearer side of the cone.

Most shapes are never tested: `obstacles` returns those within reach of a robot, and of a robot's
beams, sorted by direction, only those are tested that can point at the shape.

Points in the plane are complex numbers, x + i y [m], so that rotations are products.

>>> from crs_cc.sim.model.world import Area, Cylinder, Pose, WorldModel
>>> from crs_cc.sim.geometry.obstacles import Obstacles
>>> from crs_cc.sim.geometry.scene import NOTHING, Scene
>>> world = WorldModel("w", Area(0, 0, 9, 9, 0), cylinders=(Cylinder("c", Pose(3, 1), 0.5),))
>>> fan = Fan.of([(0.2, 0.0, 0.0, 0.0, 5.0), (0.2, 0.0, math.pi, 0.0, 5.0)])
>>> nearest(fan, np.array([[1.0, 1.0, 0.0]]), Obstacles(Scene(world).fixed, NOTHING, 6, 1))
array([[1.3, inf]])
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import ComplexArray, FloatArray, IndexArray
from crs_cc.sim.geometry.cell_list import blocks, expand
from crs_cc.sim.geometry.outline_query import Prospect
from crs_cc.sim.kernels import exact

NO_THING: Final = -1
"""The object of a beam that hits nothing."""

_TURN: Final = 2 * math.pi
_THIN_RAD: Final = 1e-9  # minimum half angle of a cone
_BINS: Final = 360
_NEAR_M: Final = 1e-9
_CHUNK: Final = 512  # robots in one block: their pairs stay in the processor's cache
_FEW: Final = 2_000  # fewer pairs than this are all tested: filtering would cost more


@dataclass(frozen=True, slots=True)
class Fan:
    """The beams of one kind of robot, in the robot frame, by rising direction.

    Attributes:
        start: the start of each beam.
        axis: its direction, of length 1.
        side_cos: cosine of the angle between its axis and its side.
        side_sin: sine of that angle.
        behind: number of beams before each of `_BINS` directions in a turn, for three turns.
        order: the index of each beam in the list that the fan was made from.
        widest_rad: the largest angle between an axis and a side.
        start_m: the largest distance of a beam's start from the robot's origin.
        reach_m: the largest distance from the robot's origin that can be measured.
        aside_m: the largest distance at which a line inside a beam passes the origin.
        z_m: the height of the beams above the ground.
    """

    start: ComplexArray
    axis: ComplexArray
    side_cos: FloatArray
    side_sin: FloatArray
    range_m: FloatArray
    behind: IndexArray
    order: IndexArray
    widest_rad: float
    start_m: float
    reach_m: float
    aside_m: float
    z_m: float = 0.0

    @classmethod
    def of(
        cls, beams: Iterable[tuple[float, float, float, float, float]], z_m: float = 0.0
    ) -> Self:
        """Create a fan from beams: x [m], y [m], direction, half angle [rad], range [m]."""
        table = np.array(list(beams), dtype=np.float64).reshape(-1, 5)
        table[:, 2] %= _TURN
        order = np.argsort(table[:, 2], kind="stable")
        x_m, y_m, direction, half, range_m = np.ascontiguousarray(table[order].T)
        half = np.maximum(half, _THIN_RAD)
        away_m = exact.hypot(x_m, y_m)
        tilt = (exact.arctan2(y_m, x_m) - direction) % math.pi  # of the axis relative to the origin
        tilt = np.minimum(tilt, math.pi - tilt) + half
        aside_m = away_m * exact.sin(np.minimum(tilt, math.pi / 2))
        return cls(
            x_m + 1j * y_m,
            exact.turn(direction),
            exact.cos(half),
            exact.sin(half),
            range_m,
            _beams_behind(direction),
            order,
            widest_rad=float(half.max(initial=0.0)),
            start_m=float(away_m.max(initial=0.0)),
            reach_m=float((range_m + away_m).max(initial=0.0)),
            aside_m=float(aside_m.max(initial=0.0)),
            z_m=z_m,
        )

    def __len__(self) -> int:
        return len(self.order)


def nearest(
    fan: Fan,
    poses: FloatArray,
    obstacles: Prospect,
    own: IndexArray | None = None,
    objects: IndexArray | None = None,
) -> FloatArray:
    """Return the measured distance of each beam of each robot.

    A beam that starts inside a circle measures 0. One that starts behind a segment, in its solid,
    measures a wrong distance: see `contact_mask`.

    Args:
        fan: the robots' beams.
        poses: x, y [m] and heading [rad] of each robot, shape (k, 3).
        obstacles: the outlines.
        own: the number of each robot's own body, which its beams pass through.
        objects: receives the object that each beam hits, as in `Scene.names`, -1 if there is none
            within range; shape (k, beams). None if they are not needed.

    Returns:
        distances from the beams' starts [m], infinite if there is no object within range, shape
        (k, beams), in the order of the list that the fan was made from.
    """
    found = np.full((len(poses), len(fan)), np.inf)
    hit = None if objects is None else np.full(found.shape, NO_THING, dtype=np.intp)
    if own is None:
        own = np.full(len(poses), -1, dtype=np.intp)
    for block, outlines in obstacles.blocks(poses[:, 0] + 1j * poses[:, 1]):
        for first in range(block.start, block.stop, _CHUNK):
            part = slice(first, min(first + _CHUNK, block.stop))
            robots = _Robots.at(fan, poses[part])
            hits = _Hits(found[part].reshape(-1), None if hit is None else hit[part].reshape(-1))
            _try_segments(fan, robots, outlines, hits)
            _try_circles(fan, robots, outlines, own[part], hits)
    beyond = found > fan.range_m
    found[beyond] = np.inf
    given = np.empty_like(found)
    given[:, fan.order] = found
    if objects is not None and hit is not None:
        hit[beyond] = NO_THING
        objects[:, fan.order] = hit
    return given


@dataclass(frozen=True, slots=True)
class _Hits:
    """Nearest hits of the beams of all robots, in one row: distances and, if needed, objects."""

    distance_m: FloatArray
    obj: IndexArray | None

    def take(self, beam: IndexArray, distance_m: FloatArray, obj: IndexArray | None) -> None:
        """Record hits that are nearer than those before."""
        np.minimum.at(self.distance_m, beam, distance_m)
        if self.obj is not None and obj is not None:
            nearer = np.flatnonzero(distance_m == self.distance_m.take(beam))
            self.obj[beam.take(nearer)] = obj.take(nearer)


@dataclass(frozen=True, slots=True)
class _Robots:
    """Robots, and their beams relative to their positions; the beams of all robots in one row."""

    place: ComplexArray
    heading_rad: FloatArray
    start: ComplexArray
    backturn: ComplexArray

    @classmethod
    def at(cls, fan: Fan, poses: FloatArray) -> Self:
        heading_rad = poses[:, 2].copy()
        facing = exact.turn(heading_rad)[:, None]
        start = exact.product(facing, fan.start)
        backturn = np.conjugate(exact.product(facing, fan.axis))
        return cls(poses[:, 0] + 1j * poses[:, 1], heading_rad, start.ravel(), backturn.ravel())


def _try_segments(fan: Fan, robots: _Robots, obstacles: Prospect, hits: _Hits) -> None:
    """Intersect beams with segments."""
    viewers, a, b, length = obstacles.segments_near(robots.place)
    objects = None if hits.obj is None else obstacles.segment_objects(robots.place)
    place = robots.place.take(viewers)
    a, b = a - place, b - place
    if len(viewers) * len(fan) > _FEW:
        keep, sectors = _sectors_of_segments(fan, a, b, length)
        viewers, a, b = viewers.take(keep), a.take(keep), b.take(keep)
        objects = None if objects is None else objects.take(keep)
        starts, counts = _beams_between(fan, robots.heading_rad.take(viewers), sectors)
    else:
        starts, counts = _all_beams(fan, len(viewers))
    for part in blocks(counts):
        pairs, beams = expand(starts[part], counts[part])
        pairs, beams = pairs + part.start, beams % len(fan)
        numbers = viewers.take(pairs) * len(fan) + beams
        start, backturn = robots.start.take(numbers), robots.backturn.take(numbers)
        ends = (exact.product(end.take(pairs) - start, backturn) for end in (a, b))
        distance_m = _to_segment(fan, beams, *ends)
        hits.take(numbers, distance_m, None if objects is None else objects.take(pairs))


def _try_circles(
    fan: Fan, robots: _Robots, obstacles: Prospect, own: IndexArray, hits: _Hits
) -> None:
    """Intersect beams with circles."""
    viewers, middle, radius = obstacles.circles_near(robots.place, own)
    objects = None if hits.obj is None else obstacles.circle_objects(robots.place, own)
    middle = middle - robots.place.take(viewers)
    if len(viewers) * len(fan) > _FEW:
        keep, sectors = _sectors_of_circles(fan, middle, radius)
        viewers, middle, radius = viewers.take(keep), middle.take(keep), radius.take(keep)
        objects = None if objects is None else objects.take(keep)
        starts, counts = _beams_between(fan, robots.heading_rad.take(viewers), sectors)
    else:
        starts, counts = _all_beams(fan, len(viewers))
    for part in blocks(counts):
        pairs, beams = expand(starts[part], counts[part])
        pairs, beams = pairs + part.start, beams % len(fan)
        numbers = viewers.take(pairs) * len(fan) + beams
        start, backturn = robots.start.take(numbers), robots.backturn.take(numbers)
        away = exact.product(middle.take(pairs) - start, backturn)
        distance_m = _to_circle(fan, beams, away, radius.take(pairs))
        hits.take(numbers, distance_m, None if objects is None else objects.take(pairs))


# -- candidate pairs of beam and shape -------------------------------------------------------------


def _all_beams(fan: Fan, shapes: int) -> tuple[IndexArray, IndexArray]:
    counts = np.full(shapes, len(fan), dtype=np.intp)
    return np.zeros(shapes, dtype=np.intp), counts


@dataclass(frozen=True, slots=True)
class _Sectors:
    """The angles that shapes subtend at robots.

    Attributes:
        begin: direction of the clockwise end [rad], in the world frame.
        spread: the angle that the shape covers [rad].
        distance: the distance of its nearest point [m].
    """

    begin: FloatArray
    spread: FloatArray
    distance: FloatArray


def _sectors_of_segments(
    fan: Fan, a: ComplexArray, b: ComplexArray, length: FloatArray
) -> tuple[IndexArray, _Sectors]:
    """Return which segments can be hit from robots at 0, and the angles that they subtend.

    A segment with all beams' starts to its left is the back of its solid.
    """
    dot, cross = exact.dot(a, b), a.real * b.imag - a.imag * b.real
    share = (exact.dot(a, a) - dot) / (length * length)
    foot = a + np.minimum(np.maximum(share, 0.0), 1.0) * (b - a)
    distance2 = exact.dot(foot, foot)
    near = (distance2 <= fan.reach_m * fan.reach_m) & (cross <= fan.start_m * length)
    keep = np.flatnonzero(near)
    turn = exact.arctan2(cross.take(keep), dot.take(keep))
    a = a.take(keep)
    begin = exact.arctan2(a.imag, a.real) + np.minimum(turn, 0.0)
    return keep, _Sectors(begin, np.abs(turn), np.sqrt(distance2.take(keep)))


def _sectors_of_circles(
    fan: Fan, middle: ComplexArray, radius: FloatArray
) -> tuple[IndexArray, _Sectors]:
    """Return which circles can be hit from robots at 0, and the angles that they subtend."""
    away = exact.magnitude(middle)
    keep = np.flatnonzero(away - radius <= fan.reach_m)
    away, radius, middle = away.take(keep), radius.take(keep), middle.take(keep)
    # Half of the angle that the circle covers, asin(radius / away), is less than its tangent.
    tangent_m = np.sqrt(np.maximum((away - radius) * (away + radius), _NEAR_M))
    half = np.minimum(radius / tangent_m, math.pi)
    begin = exact.arctan2(middle.imag, middle.real) - half
    return keep, _Sectors(begin, 2 * half, away - radius)


def _beams_between(
    fan: Fan, heading_rad: FloatArray, sectors: _Sectors
) -> tuple[IndexArray, IndexArray]:
    """Return the range of beams that may hit the shape in each sector.

    Returns:
        index of the first beam and their number; indices wrap around after the last beam.
    """
    # A point at a distance d on a line that passes the origin at p is seen from the origin at an
    # angle asin(p / d) from the line's direction, which is at most pi / 2 times p / d.
    aside = math.pi / 2 * fan.aside_m / np.maximum(sectors.distance, _NEAR_M)
    margin = np.minimum(aside + (fan.widest_rad + _THIN_RAD), math.pi)
    lower = (sectors.begin - heading_rad - margin) % _TURN
    upper = lower + np.minimum(sectors.spread + 2 * margin, _TURN)
    starts = fan.behind.take((lower * (_BINS / _TURN)).astype(np.intp))
    ends = fan.behind.take((upper * (_BINS / _TURN)).astype(np.intp) + 1)
    return starts, np.minimum(ends - starts, len(fan))


def _beams_behind(direction: FloatArray) -> IndexArray:
    directions = np.concatenate([direction + turn * _TURN for turn in range(3)])
    bins = np.arange(3 * _BINS) * (_TURN / _BINS)
    return np.searchsorted(directions, bins, side="left")


# -- exact intersections ---------------------------------------------------------------------------


def _to_segment(fan: Fan, beam: IndexArray, a: ComplexArray, b: ComplexArray) -> FloatArray:
    """Return the distance from each beam's start to the part of a segment inside the beam.

    Args:
        fan: the beams.
        beam: indices of the beams.
        a: one end of the segment in the frame of the beam, whose axis is x.
        b: the other end.
    """
    ax, ay, bx, by = a.real.copy(), a.imag.copy(), b.real.copy(), b.imag.copy()
    side_cos, side_sin = fan.side_cos.take(beam), fan.side_sin.take(beam)
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


def _to_circle(fan: Fan, beam: IndexArray, middle: ComplexArray, radius: FloatArray) -> FloatArray:
    """Return the distance from each beam's start to the part of a circle inside the beam.

    Args:
        fan: the beams.
        beam: indices of the beams.
        middle: the circle's centre in the frame of the beam, whose axis is x.
        radius: its radius.
    """
    side_cos, side_sin = fan.side_cos.take(beam), fan.side_sin.take(beam)
    x, y = middle.real.copy(), np.abs(middle.imag)  # the nearer side is the upper one
    along, aside = side_cos * x + side_sin * y, side_cos * y - side_sin * x
    away = np.sqrt(x * x + y * y)
    squared = radius * radius - aside * aside
    on_side = along - np.sqrt(np.maximum(squared, 0.0))
    missed = (squared < 0.0) | (along < 0.0)
    distance = np.where(aside <= 0.0, away - radius, np.where(missed, np.inf, on_side))
    return np.where(away <= radius, 0.0, distance)
