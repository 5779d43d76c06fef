"""Pings of sonars, and the targets that return their echoes."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, ComplexArray, FloatArray, IndexArray
from crs_cc.sim.kernels import exact

ANY_ANGLE: Final = math.pi / 2
"""The critical angle of diffuse faces, which return an echo at any angle of incidence."""


@dataclass(frozen=True, slots=True)
class Pings:
    """Simultaneous pings of k transducers.

    Attributes:
        place: the centre of each transducer's robot.
        start: the transducer's position.
        axis: its direction, of length 1.
        half_rad: the angle between the axis and the side of the beam, less than a right angle.
        range_m: maximum range on the axis.
        falloff: 1 / lobe^2 [1/rad^2], 0 for a sharp cone.
        critical_rad: the critical angle of faces.
        own: the number of the robot's own body, -1 for none.
    """

    place: ComplexArray
    start: ComplexArray
    axis: ComplexArray
    half_rad: FloatArray
    range_m: FloatArray
    falloff: FloatArray
    critical_rad: FloatArray
    own: IndexArray

    @classmethod
    def of(
        cls,
        beams: Iterable[tuple[complex, complex, float]],
        half_rad: float,
        range_m: float,
        lobe_rad: float = 0.0,
        critical_rad: float = ANY_ANGLE,
    ) -> Self:
        """Create pings of identical beams from each robot's centre, start, and direction."""
        rows = list(beams)
        count = len(rows)
        return cls(
            np.array([place for place, _, _ in rows], dtype=np.complex128),
            np.array([start for _, start, _ in rows], dtype=np.complex128),
            exact.turn(np.array([direction for _, _, direction in rows])),
            np.full(count, half_rad),
            np.full(count, range_m),
            np.full(count, 1 / (lobe_rad * lobe_rad) if lobe_rad else 0.0),
            np.full(count, critical_rad),
            np.full(count, -1, dtype=np.intp),
        )

    def __len__(self) -> int:
        return len(self.place)

    def part(self, which: slice | IndexArray) -> Self:
        """Return a part of the pings."""
        return type(self)(*(getattr(self, name)[which] for name in self.__slots__))

    def local(self, which: IndexArray, place: ComplexArray) -> ComplexArray:
        """Transform points to the frames of transducers, whose axes are x."""
        return exact.product(place - self.start.take(which), np.conjugate(self.axis.take(which)))

    def reach_m(self, which: IndexArray, angle_rad: FloatArray) -> FloatArray:
        """Return the maximum range of transducers at an angle off their axes."""
        falloff = self.falloff.take(which)
        return np.asarray(self.range_m.take(which) * exact.exp2(-falloff * angle_rad * angle_rad))


@dataclass(frozen=True, slots=True)
class Points:
    """Targets that return echoes, in the frames of transducers.

    Attributes:
        ping: the ping's index.
        place: their positions.
        reported_m: the distances that they report.
        share: the distance at which they are heard, relative to that of a hard object.
    """

    ping: IndexArray
    place: ComplexArray
    reported_m: FloatArray
    share: FloatArray

    @classmethod
    def at(cls, *parts: tuple[IndexArray, ComplexArray, FloatArray]) -> Self:
        """Create targets that report their own distance."""
        ping, place, share = (np.concatenate(column) for column in zip(*parts, strict=True))
        return cls(ping, place, exact.magnitude(place), share)

    def of_pings(self, part: slice) -> Self:
        """Return the targets of a part of the pings, which are renumbered."""
        found = self.where((self.ping >= part.start) & (self.ping < part.stop))
        return type(self)(found.ping - part.start, found.place, found.reported_m, found.share)

    def where(self, kept: BoolArray | IndexArray | slice) -> Self:
        """Return a selection of the targets."""
        return type(self)(*(getattr(self, name)[kept] for name in self.__slots__))
