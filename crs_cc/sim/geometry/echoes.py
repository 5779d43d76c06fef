"""Sonar echoes: the distance at which the first echo of a ping appears.

A beam is a cone around its axis, with its apex at the transducer. A target at an angle `a` off the
axis is detected up to the distance

    reach(a) = range * 2 ** -(a / lobe)^2

`lobe` is the angle at which the sound pressure falls to one half (-6 dB). A transducer receives
with the same directivity as it sends, so an echo's pressure falls with the square of its lobe, and
with the square of the distance, as sound spreads in both directions; with both squared, the reach
falls as the lobe itself. The Gaussian is the usual approximation of the main lobe of a piston
(R. Kuc, M. W. Siegel, "Physically based simulation model for acoustic sensor robot navigation",
1987). Side lobes are ignored: the highest one of a piston has 0.13 of the pressure, so it would
reach 0.13 of the range. A lobe of 0 is a sharp cone, with the same reach at its side as on its
axis.

Echoes come from:

- a face (a side of a box or wall) at an angle of incidence of up to `critical`: a smooth face
  reflects all other sound away (same source). The foot of the perpendicular always returns an echo;
- a corner, where a face ends or two faces meet, and the nearest point of a cylinder or robot: from
  any direction. Where a face continues in another one there is no corner;
- a cylinder's flank, where its nearest point is outside of the beam.

Feet, corners and nearest points are computed exactly, where a few rays would miss a thin pillar;
faces and flanks at the sides of the beam, and for a lobe along rays in between as well. An object
with an absorbing surface is heard at a shorter distance: see `surfaces`. Where faces with
different surfaces meet in a corner, the softer one decides.

A target behind an object is not heard, whether that object returns an echo or not. A transducer on
or inside an object, or with an object between itself and its robot's centre, hears an echo at
distance 0.

Points in the plane are complex numbers, x + i y [m], so that rotations are products.

>>> from crs_cc.sim.model.world import Area, Cylinder, Pose, WorldModel
>>> from crs_cc.sim.geometry.obstacles import Obstacles
>>> from crs_cc.sim.geometry.scene import NOTHING, Scene
>>> world = WorldModel("w", Area(0, 0, 9, 9, 0), cylinders=(Cylinder("c", Pose(3, 1), 0.5),))
>>> obstacles = Obstacles(Scene(world).fixed, NOTHING, reach_m=6.0, start_m=0.2)
>>> ahead = Pings.of([(1 + 1j, 1.2 + 1j, 0.0)], half_rad=0.2, range_m=5.0)
>>> first_echo(ahead, obstacles)
array([1.3])
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import ComplexArray, FloatArray, IndexArray
from crs_cc.sim.geometry.cell_list import blocks
from crs_cc.sim.geometry.outline_query import ObstacleQuery
from crs_cc.sim.geometry.pings import Pings, Points
from crs_cc.sim.kernels import surveys
from crs_cc.sim.kernels.program import kernels, pairs
from crs_cc.sim.kernels.tables import PING_SIZE

_NO_CROSSTALK: Final = np.zeros((0, 4))
_MANY: Final = 1 << 10  # more shapes of a ping than this may be equal ones


def first_echo(
    pings: Pings,
    obstacles: ObstacleQuery,
    crosstalk: Points | None = None,
    echo_range: FloatArray | None = None,
) -> FloatArray:
    """Return the distance of each ping's first echo.

    Args:
        pings: the pings.
        obstacles: the obstacles.
        crosstalk: pings of other sonars, heard if they are in the beam and nothing hides them.
        echo_range: the distance at which each object, as in `Scene.names`, is heard, relative to
            that of a hard one, (objects,); None if all are hard.

    Returns:
        distances from the transducers [m], infinite without an echo, shape (k,).
    """
    found_m = np.empty(len(pings))
    for part, outlines in obstacles.blocks(pings.place):
        heard = None if crosstalk is None else crosstalk.of_pings(part)
        shapes = _Shapes.near(pings.part(part), outlines, heard, echo_range)
        found_m[part] = shapes.first_echo(absorbing=echo_range is not None)
    return found_m


@dataclass(frozen=True, slots=True)
class _Shapes:
    """Pings, and all that may be in their beams, by rising ping.

    Attributes:
        counts: how many faces, circles and pings of other sonars each has, shape (k, 3).
        faces: ends, length and share of the faces.
        circles: centre, radius and share of the circles.
        crosstalk: position, reported distance and share of pings of other sonars.
    """

    pings: Pings
    counts: IndexArray
    faces: FloatArray
    circles: FloatArray
    crosstalk: FloatArray

    @classmethod
    def near(
        cls,
        pings: Pings,
        obstacles: ObstacleQuery,
        crosstalk: Points | None,
        echo_range: FloatArray | None,
    ) -> Self:
        """Return the candidates in the beams."""
        place, own, count = pings.place, pings.own, len(pings)
        if count == 1 and crosstalk is None:
            faces, circles = obstacles.segment_rows(place), obstacles.circle_rows(place, own)
            if len(faces) <= _MANY and len(circles) <= _MANY:
                circles = circles[circles[:, 1] != own[0]]
                counts = np.array([[len(faces), len(circles), 0]])
                parts = _heard(faces, echo_range), _heard(circles, echo_range)
                return cls(pings, counts, *parts, _NO_CROSSTALK)
        face_share: FloatArray | float = 1.0
        circle_share: FloatArray | float = 1.0
        if echo_range is None:
            near_segments = obstacles.segments_near(place)
            near_circles = obstacles.circles_near(place, own)
        else:
            near_segments, objects = obstacles.segments_and_objects(place)
            face_share = echo_range[objects]
            near_circles, objects = obstacles.circles_and_objects(place, own)
            circle_share = echo_range[objects]
        ping, start, end, length_m = near_segments
        faces, face_count = _table(count, ping, (start, end), (length_m, face_share))
        ping, middle, radius_m = near_circles
        circles, circle_count = _table(count, ping, (middle,), (radius_m, circle_share))
        heard, crosstalk_count = np.zeros((0, 4)), np.zeros(count, np.intp)
        if crosstalk is not None:
            numbers = crosstalk.reported_m, crosstalk.share
            heard, crosstalk_count = _table(count, crosstalk.ping, (crosstalk.place,), numbers)
        counts = np.column_stack([face_count, circle_count, crosstalk_count])
        return cls(pings, counts, faces, circles, heard)

    def first_echo(self, *, absorbing: bool) -> FloatArray:
        """Return the first echo of each ping [m].

        Args:
            absorbing: whether there are absorbing surfaces.
        """
        table, shapes = self._table(), (self.faces, self.circles, self.crosstalk)
        widths = [each.shape[1] for each in shapes]
        if table.size + sum(each.size for each in shapes) + len(table) <= kernels().room:
            return surveys.echoes(kernels(), (table, *shapes), absorbing=absorbing)
        ends = np.vstack([np.zeros((1, 3), np.intp), self.counts.cumsum(axis=0)])
        found_m = np.empty(len(table))
        sizes = (self.counts * widths).sum(axis=1) + PING_SIZE + 1
        for part in blocks(sizes, kernels().room):
            few = [
                each[ends[part.start, kind] : ends[part.stop, kind]]
                for kind, each in enumerate(shapes)
            ]
            found_m[part] = surveys.echoes(kernels(), (table[part], *few), absorbing=absorbing)
        return found_m

    def _table(self) -> FloatArray:
        """Return the rows of the pings that the kernel reads, see `kernels/echoes.c`."""
        pings = self.pings
        table = np.empty((len(pings), PING_SIZE))
        table[:, 0:2] = pairs(pings.place)
        table[:, 2:4] = pairs(pings.start)
        table[:, 4:6] = pairs(pings.axis)
        table[:, 6], table[:, 7] = pings.half_rad, pings.range_m
        table[:, 8], table[:, 9] = pings.falloff, pings.critical_rad
        table[:, 10:13] = self.counts
        return table


def _heard(rows: FloatArray, echo_range: FloatArray | None) -> FloatArray:
    """Return rows of shapes as the kernel of echoes reads them, from those for rays."""
    found = np.empty((len(rows), rows.shape[1] - 1))
    found[:, :-1] = rows[:, 2:]
    found[:, -1] = 1.0 if echo_range is None else echo_range[rows[:, 1].astype(np.intp)]
    return found


def _table(
    count: int,
    ping: IndexArray,
    points: tuple[ComplexArray, ...],
    numbers: tuple[FloatArray | float, ...],
) -> tuple[FloatArray, IndexArray]:
    """Return rows of points and numbers by rising ping, and the number of rows of each ping."""
    table = np.empty((len(ping), 2 * len(points) + len(numbers)))
    for column, point in enumerate(points):
        table[:, 2 * column : 2 * column + 2] = pairs(point)
    for column, each in enumerate(numbers, start=2 * len(points)):
        table[:, column] = each
    if count > 1:
        order = np.argsort(ping, kind="stable")
        ping, table = ping[order], table[order]
    if len(ping) > count * _MANY:
        kept = _first_two(ping, table)
        ping, table = ping[kept], table[kept]
    return table, np.bincount(ping, minlength=count)


def _first_two(ping: IndexArray, table: FloatArray) -> IndexArray:
    """Return the indices of the first two of equal shapes; more make no difference."""
    rows = np.column_stack([ping, table])
    _, first = np.unique(rows, axis=0, return_index=True)
    others = np.setdiff1d(np.arange(len(rows)), first)
    _, second = np.unique(rows[others], axis=0, return_index=True)
    return np.sort(np.concatenate([first, others[second]]))
