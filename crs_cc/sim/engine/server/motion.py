"""The first collision on a path: `motion_check`.

The robot is a disc that is moved along the path, everything else is at rest. By the vendor's header
(`Nclient.h` 1.29), lengths in 0.1 in and angles in radians:

- a segment: a1, a2 are x and y of its first point, a3, a4 of its second one;
- an arc: a1, a2 are its first point, a3 and a4 the directions from the centre to its two ends, a5
  the radius, a6 and a7 the centre. Chosen by us: the path turns left where a4 is greater than a3,
  and right where it is less; where a1, a2 lie nearer to the second end it comes back from there.

The answer is the position of the robot's centre at the first contact, and the direction from there
to the point of contact. A robot that touches something at the start collides with it at once if the
path leads further into it, and not at all if it leads along or away from it.

Everything that can be hit is the set of points within a margin of a line segment (for a circle, of
its centre). Contacts are where the path meets the offset of a segment or of one of its ends by the
robot's radius and the margin: so each is the root of a quadratic equation.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, TypeAlias

import numpy as np

from crs_cc.core import segment
from crs_cc.core.arrays import BoolArray, ComplexArray, FloatArray, IndexArray
from crs_cc.core.units import m_to_tenths_inch, tenths_inch_to_m
from crs_cc.sim.kernels import exact

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext


_SEGMENT: Final = 0
_ARC: Final = 1
_TURN: Final = 2 * math.pi
_NUMBERS: Final = 7
_FURTHEST_M: Final = 1e6  # larger coordinates are not exact
_ON_M: Final = 1e-7  # rounding
_AHEAD_M: Final = 1e-3  # distance along the path that shows whether a contact gets closer
_CLOSER_M: Final = 1e-10


def motion_check(context: RequestContext) -> BoolArray:
    """Answer with the first contact on each robot's path; reject requests without one."""
    bodies, scene = context.state.bodies, context.constants.scene
    outlines = (scene.fixed, scene.moving(bodies.position_m, bodies.angle_rad))
    segments = np.concatenate([each.segments for each in outlines])
    circles = np.concatenate([each.circles for each in outlines])
    owners = np.concatenate([each.owners for each in outlines])
    hits = np.zeros(len(context), dtype=np.bool_)
    kinds = context["path"].tolist()
    numbers = context["numbers"][:, : 8 * _NUMBERS].copy().view("<f8")
    for row, robot in enumerate(context.rows.tolist()):
        path = _path(kinds[row], numbers[row])
        if path is None:
            continue
        shapes = Shapes.of(segments, circles[owners != robot], context.constants.radius_m[robot])
        contact = first_contact(path, shapes)
        if contact is not None:
            hits[row] = True
            place, normal_rad = contact
            context.put("x", m_to_tenths_inch(place.real), row)
            context.put("y", m_to_tenths_inch(place.imag), row)
            context.put("normal_rad", normal_rad, row)
    return hits


@dataclass(frozen=True, slots=True)
class Shapes:
    """The obstacles for a robot's centre: line segments, each with a clearance.

    Attributes:
        start: one end of each, as x + i y [m].
        end: the other end.
        reach_m: the clearance: the robot's radius and the margin.
    """

    start: ComplexArray
    end: ComplexArray
    reach_m: FloatArray

    @classmethod
    def of(cls, segments: FloatArray, circles: FloatArray, radius_m: float) -> Shapes:
        """Return the shapes of outlines, see `scene.Outlines`."""
        middle = circles[:, 0] + 1j * circles[:, 1]
        start = np.concatenate([segments[:, 0] + 1j * segments[:, 1], middle])
        end = np.concatenate([segments[:, 2] + 1j * segments[:, 3], middle])
        margin_m = np.concatenate([np.zeros(len(segments)), circles[:, 2]])
        return cls(start, end, radius_m + margin_m)

    def room_m(self, place: ComplexArray | complex) -> FloatArray:
        """Return the distances of points from contact, one for each shape; negative inside."""
        return np.asarray(exact.magnitude(self.nearest(place) - place) - self.reach_m)

    def nearest(self, place: ComplexArray | complex) -> ComplexArray:
        """Return the point on each segment that is nearest to a point."""
        across, along = place - self.start, self.end - self.start
        share = segment.nearest_fraction(across.real, across.imag, along.real, along.imag)
        return np.asarray(self.start + share * along)

    def take(self, which: IndexArray) -> Shapes:
        """Return some of them."""
        return Shapes(self.start[which], self.end[which], self.reach_m[which])


@dataclass(frozen=True, slots=True)
class Straight:
    """A line segment, given by its start and a direction of length 1."""

    start: complex
    direction: complex
    length_m: float

    def at(self, path_m: FloatArray) -> ComplexArray:
        """Return the points at distances along the path."""
        return np.asarray(self.start + path_m * self.direction)

    def around(self) -> tuple[complex, float]:
        """Return the centre and the radius of a disc that contains the path."""
        return self.start + self.direction * self.length_m / 2, self.length_m / 2

    def at_distance(self, point: ComplexArray, distance_m: FloatArray) -> list[FloatArray]:
        """Return the distances at which the line is so far from points; NaN for never."""
        away = self.start - point
        along = exact.dot(away, self.direction)
        root = np.sqrt(np.square(distance_m) - exact.dot(away, away) + np.square(along))
        return [-along - root, -along + root]

    def beside(
        self, point: ComplexArray, normal: ComplexArray, distance_m: FloatArray
    ) -> list[FloatArray]:
        """Return the distance at which the line is so far along a normal from points."""
        before = exact.dot(self.start - point, normal)
        return [(distance_m - before) / exact.dot(normal, self.direction)]


@dataclass(frozen=True, slots=True)
class Arc:
    """A part of a circle.

    Attributes:
        centre: the circle's.
        radius_m: the circle's.
        begin_rad: the direction of the first point from the centre.
        sense: 1 to the left, -1 to the right.
    """

    centre: complex
    radius_m: float
    begin_rad: float
    sense: int
    length_m: float

    def at(self, path_m: FloatArray) -> ComplexArray:
        """Return the points at distances along the path."""
        angle = self.begin_rad + self.sense * path_m / self.radius_m
        return np.asarray(self.centre + self.radius_m * exact.turn(angle))

    def around(self) -> tuple[complex, float]:
        """Return the centre and the radius of a disc that contains the path."""
        return self.centre, self.radius_m

    def at_distance(self, point: ComplexArray, distance_m: FloatArray) -> list[FloatArray]:
        """Return the distances at which the circle is so far from points; NaN for never."""
        away = self.centre - point
        apart = exact.magnitude(away)
        more_m2 = np.square(distance_m) - np.square(apart) - np.square(self.radius_m)
        return self._path_lengths(exact.angle(away), more_m2 / (2 * self.radius_m * apart))

    def beside(
        self, point: ComplexArray, normal: ComplexArray, distance_m: FloatArray
    ) -> list[FloatArray]:
        """Return the distances at which the circle is so far along a normal from points."""
        before = exact.dot(self.centre - point, normal)
        return self._path_lengths(exact.angle(normal), (distance_m - before) / self.radius_m)

    def _path_lengths(self, middle_rad: FloatArray, cos: FloatArray) -> list[FloatArray]:
        half_rad = exact.arccos(cos)
        ends_rad = (middle_rad + half_rad, middle_rad - half_rad)
        return [self.sense * (end - self.begin_rad) % _TURN * self.radius_m for end in ends_rad]


Path: TypeAlias = Straight | Arc


def first_contact(path: Path, shapes: Shapes) -> tuple[complex, float] | None:
    """Return a robot's centre at its first contact, and the normal [rad]."""
    middle, radius_m = path.around()
    shapes = shapes.take(np.flatnonzero(shapes.room_m(middle) <= radius_m + _AHEAD_M))
    paths_m = np.stack([np.zeros(len(shapes.reach_m)), *_candidates(path, shapes)])
    paths_m[(paths_m < 0.0) | (paths_m > path.length_m)] = np.nan
    room_m = shapes.room_m(path.at(paths_m))
    ahead_m = shapes.room_m(path.at(np.minimum(paths_m + _AHEAD_M, path.length_m)))
    touches = np.abs(room_m) <= _ON_M
    touches[0] = room_m[0] <= _ON_M
    paths_m[~touches | ~(ahead_m < room_m - _CLOSER_M)] = np.inf
    if not paths_m.size or not math.isfinite(float(paths_m.min())):
        return None
    shape = int(paths_m.min(axis=0).argmin())
    place = complex(path.at(paths_m[:, shape].min()))
    return place, float(exact.angle(shapes.nearest(place)[shape] - place))


def _candidates(path: Path, shapes: Shapes) -> list[FloatArray]:
    """Return candidate distances that include those of all contacts."""
    along = shapes.end - shapes.start
    with np.errstate(divide="ignore", invalid="ignore"):
        normal = 1j * along / exact.magnitude(along)
        return [
            *path.at_distance(shapes.start, shapes.reach_m),
            *path.at_distance(shapes.end, shapes.reach_m),
            *path.beside(shapes.start, normal, shapes.reach_m),
            *path.beside(shapes.start, normal, -shapes.reach_m),
        ]


def _path(kind: int, numbers: FloatArray) -> Path | None:
    """Return a path; None if the numbers define none."""
    if not (np.abs(numbers) <= m_to_tenths_inch(_FURTHEST_M)).all() or kind not in (_SEGMENT, _ARC):
        return None
    lengths_m = tenths_inch_to_m(numbers)
    start = complex(*lengths_m[0:2])
    if kind == _SEGMENT:
        delta = complex(*lengths_m[2:4]) - start
        length_m = exact.magnitude(delta)
        return Straight(start, delta / length_m, length_m) if delta else None
    radius_m, centre = float(lengths_m[4]), complex(*lengths_m[5:7])
    first_rad, second_rad = numbers[2:4].tolist()
    sweep_rad = min(max(second_rad - first_rad, -_TURN), _TURN)
    if radius_m <= 0.0 or sweep_rad == 0.0:
        return None
    ends = [centre + radius_m * exact.turn(angle) for angle in (first_rad, second_rad)]
    if exact.magnitude(start - ends[1]) < exact.magnitude(start - ends[0]):
        first_rad, sweep_rad = second_rad, -sweep_rad
    length_m = abs(sweep_rad) * radius_m
    return Arc(centre, radius_m, first_rad, 1 if sweep_rad > 0.0 else -1, length_m)
