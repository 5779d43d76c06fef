"""The first echoes of pings, computed with numpy for all pings at once: the kernel's oracle."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, ComplexArray, FloatArray, IndexArray
from crs_cc.sim.geometry import cell_list
from crs_cc.sim.geometry.cell_list import blocks, expand
from crs_cc.sim.geometry.outline_query import ObstacleQuery
from crs_cc.sim.geometry.pings import ANY_ANGLE, Pings, Points
from crs_cc.sim.kernels import exact

_SIDES: Final = np.array([-1.0, 1.0])
_RAYS: Final = np.linspace(-1.0, 1.0, 17)
_ON_M: Final = 1e-9  # a transducer this close to a face is on it
_BEFORE_M: Final = 1e-6  # an object closer than this to a target does not hide it
_SEAM_M: Final = 1e-3  # faces whose ends are this close touch
_MANY: Final = 1 << 10  # more items than this may be equal ones: their pairs would take too long
_STRAIGHT: Final = 1e-3  # sine of the angle below which a face continues in another


def first_echo(
    pings: Pings,
    obstacles: ObstacleQuery,
    voices: Points | None = None,
    echo_range: FloatArray | None = None,
) -> FloatArray:
    """Return the distance of each ping's first echo.

    Args:
        pings: the pings.
        obstacles: the obstacles.
        voices: further targets, heard if they are in the beam and nothing hides them.
        echo_range: the distance at which each object, as in `Scene.names`, is heard, relative to
            that of a hard one, (objects,); None if all are hard.

    Returns:
        distances from the transducers [m], infinite without an echo, shape (k,).
    """
    # Pings that are computed in different ways never share a call, so that the echo of one does not
    # depend on the others, not even in the last bit.
    falls = pings.falloff > 0.0
    shaped = falls | (pings.critical_rad < ANY_ANGLE) | (echo_range is not None)
    if voices is not None:
        shaped[voices.ping] = True
    found_m = np.empty(len(pings))
    for falling, shaping in ((False, False), (False, True), (True, True)):
        mine = np.flatnonzero((falls == falling) & (shaped == shaping))
        if len(mine) == len(pings):
            return _first_echo(pings, obstacles, voices, echo_range, falls=falling, shaped=shaping)
        if len(mine):
            some, heard = pings.part(mine), None if voices is None else _of_pings(voices, mine)
            found_m[mine] = _first_echo(
                some, obstacles, heard, echo_range, falls=falling, shaped=shaping
            )
    return found_m


def _of_pings(voices: Points, pings: IndexArray) -> Points:
    """Return the voices that some pings may hear; `pings` ascend, and are numbered anew."""
    found = voices.where(np.isin(voices.ping, pings))
    ping = np.searchsorted(pings, found.ping)
    return Points(ping, found.place, found.reported_m, found.share)


def _first_echo(
    pings: Pings,
    obstacles: ObstacleQuery,
    voices: Points | None,
    echo_range: FloatArray | None,
    *,
    falls: bool,
    shaped: bool,
) -> FloatArray:
    """Return the distance of each ping's first echo, of pings of the same kind."""
    found_m = np.empty(len(pings))
    shares = _RAYS if falls else _SIDES
    for part, outlines in obstacles.blocks(pings.place):
        heard = None if voices is None else voices.of_pings(part)
        block = _Block(pings.part(part), outlines, heard, echo_range)
        found_m[part] = block.first_echo(shares, shaped=shaped)
    return found_m


@dataclass(frozen=True, slots=True)
class _Block:
    """Pings that are computed together; see `first_echo` for the attributes."""

    pings: Pings
    obstacles: ObstacleQuery
    voices: Points | None
    echo_range: FloatArray | None

    def first_echo(self, shares: FloatArray, *, shaped: bool) -> FloatArray:
        """Return the distance of each ping's first echo.

        `shares` has the angles of rays off the axes, relative to the beams' half angles; `shaped`
        is whether it matters which targets are hidden or are no corners.
        """
        pings = self.pings
        faces, pierced = _faces(pings, self.obstacles, self.echo_range)
        rounds, covered = _rounds(pings, self.obstacles, self.echo_range)
        found_m = self._on_rays(faces, rounds, shares, shaped=shaped)
        if not shaped:
            for points in (_feet(faces, rounds), _ends(faces)):
                heard = points.where(_in_beam(pings, points))
                np.minimum.at(found_m, heard.ping, heard.reported_m)
        else:
            for points in self._targets(faces, rounds, found_m):
                _hear(points.where(_in_beam(pings, points)), faces, rounds, found_m)
        found_m[pierced] = 0.0
        found_m[covered] = 0.0
        return found_m

    def _targets(self, faces: _Faces, rounds: _Rounds, found_m: FloatArray) -> Iterator[Points]:
        """Yield blocks of targets nearer than `found_m`, which the caller updates."""
        yield _feet(faces, rounds)
        for end in (faces.start, faces.start + faces.along):
            yield _corner_ends(self.pings, faces, end, found_m)
        near = faces.where(faces.nearest_m() <= found_m[faces.ping] + _BEFORE_M)
        near = near.where(_distinct(near.ping, near.start, near.along, near.share))
        for one, other in _pairs(near.ping, near.ping):
            yield _corners(near, one, other)
        if self.voices is not None:
            yield self.voices

    def _on_rays(
        self, faces: _Faces, rounds: _Rounds, shares: FloatArray, *, shaped: bool
    ) -> FloatArray:
        """Return the first echo along rays of each beam, infinite for none."""
        pings, echo_range = self.pings, self.echo_range
        angle_rad = pings.half_rad[:, None] * shares
        rays = exact.turn(angle_rad)
        reach_m = pings.reach_m(np.arange(len(pings))[:, None], angle_rad)
        loud_m = reach_m
        face_m, round_m = _hits_m(faces, rays), _hits_m(rounds, rays)
        if shaped:
            free_m = np.full(reach_m.shape, np.inf)
            np.minimum.at(free_m, faces.ping, face_m)
            np.minimum.at(free_m, rounds.ping, round_m)
            reach_m = np.minimum(reach_m, free_m + _BEFORE_M)
        if echo_range is not None:
            face_m[face_m > loud_m[faces.ping] * faces.share[:, None]] = np.inf
            round_m[round_m > loud_m[rounds.ping] * rounds.share[:, None]] = np.inf
        glancing_m = faces.away_m / np.maximum(exact.cos(pings.critical_rad[faces.ping]), 1e-12)
        glancing_m += _ON_M  # rounding must not silence a face at exactly the critical angle
        face_m[face_m > np.minimum(reach_m[faces.ping], glancing_m[:, None])] = np.inf
        round_m[round_m > reach_m[rounds.ping]] = np.inf
        found_m = np.full(len(pings), np.inf)
        np.minimum.at(found_m, faces.ping, face_m.min(axis=1))
        np.minimum.at(found_m, rounds.ping, round_m.min(axis=1))
        return found_m


# -- faces and circles in the beams ----------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Faces:
    """Sides of objects that may be in a beam, in the frame of its transducer; by rising ping."""

    ping: IndexArray
    start: ComplexArray
    along: ComplexArray
    away_m: FloatArray
    share: FloatArray

    def hits_m(self, rays: ComplexArray, which: IndexArray | slice = slice(None)) -> FloatArray:
        """Return the distances to the faces along rays of length 1, infinite for a miss."""
        start, along = self.start[which][..., None], self.along[which][..., None]
        with np.errstate(divide="ignore", invalid="ignore"):
            across = _cross(rays, along)
            distance_m = _cross(start, along) / across
            share = _cross(start, rays) / across
        hit = (distance_m > 0.0) & (share >= 0.0) & (share <= 1.0)
        return np.where(hit, distance_m, np.inf)

    def nearest_m(self) -> FloatArray:
        """Return the distances to the nearest points of the faces."""
        share = -exact.dot(self.start, self.along) / exact.dot(self.along, self.along)
        return exact.magnitude(self.start + np.clip(share, 0.0, 1.0) * self.along)

    def where(self, kept: BoolArray | IndexArray | slice) -> Self:
        """Return a selection of the faces."""
        return type(self)(*(getattr(self, name)[kept] for name in self.__slots__))


@dataclass(frozen=True, slots=True)
class _Rounds:
    """Circles that may be in a beam, in the frame of its transducer; by rising ping."""

    ping: IndexArray
    middle: ComplexArray
    radius_m: FloatArray
    share: FloatArray

    def hits_m(self, rays: ComplexArray, which: IndexArray | slice = slice(None)) -> FloatArray:
        """Return the distances to the circles along rays of length 1, infinite for a miss."""
        turned = exact.product(self.middle[which][..., None], rays.conj())
        square = self.radius_m[which][..., None] ** 2 - turned.imag * turned.imag
        hit = (square >= 0.0) & (turned.real > 0.0)
        return np.where(hit, turned.real - np.sqrt(np.maximum(square, 0.0)), np.inf)


def _hits_m(shapes: _Faces | _Rounds, rays: ComplexArray) -> FloatArray:
    """Return the distances to all shapes along all rays of their pings, (shapes, rays)."""
    if len(shapes.ping) * rays.shape[1] <= cell_list.PAIRS_IN_BLOCK:
        return shapes.hits_m(rays[shapes.ping])
    found_m = np.empty((len(shapes.ping), rays.shape[1]))
    for part in blocks(np.full(len(found_m), rays.shape[1])):
        found_m[part] = shapes.hits_m(rays[shapes.ping[part]], part)
    return found_m


def _faces(
    pings: Pings, obstacles: ObstacleQuery, echo_range: FloatArray | None
) -> tuple[_Faces, IndexArray]:
    """Return the faces that may be in beams, and the pings whose transducers are on or in one."""
    ping, a, b, length_m = obstacles.segments_near(pings.place)
    a, b = pings.local(ping, a), pings.local(ping, b)
    behind_m = _cross(a, b) / length_m  # depth of the transducer in the solid
    inside = np.flatnonzero(behind_m >= -_ON_M)
    middle = pings.local(ping[inside], pings.place[ping[inside]])
    a_in, b_in = a[inside], b[inside]
    # The robot's centre may be in the plane of a face: rounding must not move it in front.
    before = _cross(a_in - middle, b_in - middle) < -_ON_M * length_m[inside]
    between = _cross(middle, a_in) * _cross(middle, b_in) <= 0.0
    pierced = ping[inside[before & between]]
    cos, sin = exact.cos(pings.half_rad).take(ping), exact.sin(pings.half_rad).take(ping)
    left_a, left_b = cos * a.imag - sin * a.real, cos * b.imag - sin * b.real
    right_a, right_b = -cos * a.imag - sin * a.real, -cos * b.imag - sin * b.real
    keep = (behind_m < -_ON_M) & (-behind_m <= pings.range_m.take(ping))
    keep &= (np.minimum(left_a, left_b) <= 0.0) & (np.minimum(right_a, right_b) <= 0.0)
    kept = np.flatnonzero(keep)
    kept = kept[np.argsort(ping[kept], kind="stable")]
    share = np.ones(len(kept))
    if echo_range is not None:
        share = echo_range[obstacles.segment_objects(pings.place)[kept]]
    return _Faces(ping[kept], a[kept], b[kept] - a[kept], -behind_m[kept], share), pierced


def _rounds(
    pings: Pings, obstacles: ObstacleQuery, echo_range: FloatArray | None
) -> tuple[_Rounds, IndexArray]:
    """Return the circles that may be in beams, and the pings whose transducers are in one."""
    ping, middle, radius_m = obstacles.circles_near(pings.place, pings.own)
    middle = pings.local(ping, middle)
    away_m = exact.magnitude(middle)
    inside = away_m <= radius_m + _ON_M
    cos, sin = exact.cos(pings.half_rad).take(ping), exact.sin(pings.half_rad).take(ping)
    aside_m = cos * np.abs(middle.imag) - sin * middle.real
    keep = ~inside & (aside_m <= radius_m) & (middle.real > -radius_m)
    keep &= away_m - radius_m <= pings.range_m.take(ping)
    kept = np.flatnonzero(keep)
    kept = kept[np.argsort(ping[kept], kind="stable")]
    share = np.ones(len(kept))
    if echo_range is not None:
        share = echo_range[obstacles.circle_objects(pings.place, pings.own)[kept]]
    return _Rounds(ping[kept], middle[kept], radius_m[kept], share), ping[inside]


def _feet(faces: _Faces, rounds: _Rounds) -> Points:
    """Return the feet of perpendiculars on faces, and the nearest points of circles."""
    share = -exact.dot(faces.start, faces.along) / exact.dot(faces.along, faces.along)
    foot = np.flatnonzero((share > 0.0) & (share < 1.0))
    place = faces.start[foot] + share[foot] * faces.along[foot]
    front = rounds.middle * (1.0 - rounds.radius_m / exact.magnitude(rounds.middle))
    return Points.at(
        (faces.ping[foot], place, faces.share[foot]), (rounds.ping, front, rounds.share)
    )


def _ends(faces: _Faces) -> Points:
    """Return both ends of all faces."""
    ends = (faces.start, faces.start + faces.along)
    return Points.at(*((faces.ping, end, faces.share) for end in ends))


def _corner_ends(pings: Pings, faces: _Faces, end: ComplexArray, found_m: FloatArray) -> Points:
    """Return those ends of faces in the beams that no other face continues.

    Args:
        pings: the pings.
        faces: the faces.
        end: an end of each.
        found_m: the first echo of each ping so far; ends behind it are omitted.
    """
    points = Points.at((faces.ping, end, faces.share))
    which = _in_beam(pings, points)
    which = which[points.reported_m[which] < found_m[points.ping[which]]]
    which = which[_distinct(faces.ping[which], end[which], faces.along[which], faces.share[which])]
    along, corner = faces.along, np.ones(len(which), dtype=np.bool_)
    for item, other in _pairs(faces.ping[which], faces.ping):
        one = which[item]
        length_m, apart = exact.magnitude(along[other]), end[one] - faces.start[other]
        over_m = exact.dot(apart, along[other]) / length_m
        goes_on = (one != other) & (np.abs(_cross(apart, along[other])) <= _SEAM_M * length_m)
        goes_on &= (over_m >= -_SEAM_M) & (over_m <= length_m + _SEAM_M)
        goes_on &= _parallel(along[one], along[other])
        corner[item[goes_on]] = False
    return points.where(which[corner])


def _distinct(ping: IndexArray, *columns: ComplexArray | FloatArray) -> IndexArray | slice:
    """Return the indices of the first of equal items, or of all items if they are few."""
    if len(ping) <= _MANY:
        return slice(None)
    parts = [part for column in columns for part in (column.real, column.imag)]
    return np.sort(np.unique(np.column_stack([ping, *parts]), axis=0, return_index=True)[1])


def _corners(faces: _Faces, one: IndexArray, other: IndexArray) -> Points:
    """Return the intersections of faces in the same beam, such as the corners of a room.

    Sound is reflected by both, so the softer one decides.
    """
    once = (one < other) & ~_parallel(faces.along[one], faces.along[other])
    one, other = one[once], other[once]
    apart = faces.start[other] - faces.start[one]
    across = _cross(faces.along[one], faces.along[other])
    share = _cross(apart, faces.along[other]) / across
    others = _cross(apart, faces.along[one]) / across
    meet = (share >= 0.0) & (share <= 1.0) & (others >= 0.0) & (others <= 1.0)
    one, other, share = one[meet], other[meet], share[meet]
    heard = np.minimum(faces.share[one], faces.share[other])
    return Points.at((faces.ping[one], faces.start[one] + share * faces.along[one], heard))


def _in_beam(pings: Pings, points: Points) -> IndexArray:
    """Return which targets are in the beams and within reach."""
    tan = exact.tan(pings.half_rad).take(points.ping)
    inside = np.flatnonzero(np.abs(points.place.imag) <= tan * points.place.real)
    points = points.where(inside)
    reach_m = pings.reach_m(points.ping, exact.angle(points.place)) * points.share
    return inside[exact.magnitude(points.place) <= reach_m]


def _hear(points: Points, faces: _Faces, rounds: _Rounds, found_m: FloatArray) -> None:
    """Record the echoes of targets that nothing hides, the nearest first.

    Args:
        points: the targets; those behind an echo that was already found are skipped.
        faces: faces that may hide them.
        rounds: circles that may hide them.
        found_m: the first echo of each ping so far, changed in place.
    """
    points = points.where(points.reported_m < found_m[points.ping])
    points = points.where(_distinct(points.ping, points.place, points.reported_m))
    points = points.where(np.argsort(points.reported_m, kind="stable"))
    before = np.bincount(faces.ping, minlength=len(found_m))
    before += np.bincount(rounds.ping, minlength=len(found_m))
    while len(points.ping):
        work = np.cumsum(before[points.ping])
        count = max(1, int(np.searchsorted(work, cell_list.PAIRS_IN_BLOCK, side="right")))
        near = points.where(slice(count))
        near = near.where(~_hidden(near, faces, rounds))
        np.minimum.at(found_m, near.ping, near.reported_m)
        points = points.where(slice(count, None))
        points = points.where(points.reported_m < found_m[points.ping])


def _hidden(points: Points, faces: _Faces, rounds: _Rounds) -> BoolArray:
    """Return which targets are hidden."""
    away_m = exact.magnitude(points.place)
    rays = (points.place / np.maximum(away_m, _ON_M))[:, None]
    free_m = np.full((len(points.ping), 1), np.inf)
    for shapes in (faces, rounds):
        for point, shape in _pairs(points.ping, shapes.ping):
            np.minimum.at(free_m, point, shapes.hits_m(rays[point], shape))
    return np.asarray(free_m[:, 0] < away_m - _BEFORE_M)


def _pairs(ping: IndexArray, sorted_pings: IndexArray) -> Iterator[tuple[IndexArray, IndexArray]]:
    """Yield pairs of items of the same ping, in blocks; the second ones must be sorted by ping."""
    starts = np.searchsorted(sorted_pings, ping, side="left")
    counts = np.searchsorted(sorted_pings, ping, side="right") - starts
    for part in blocks(counts):
        one, other = expand(starts[part], counts[part])
        yield one + part.start, other


def _parallel(a: ComplexArray, b: ComplexArray) -> BoolArray:
    return np.asarray(np.abs(_cross(a, b)) <= _STRAIGHT * exact.magnitude(a) * exact.magnitude(b))


def _cross(a: ComplexArray, b: ComplexArray) -> FloatArray:
    return np.asarray(a.real * b.imag - a.imag * b.real)
