"""The marks that programs draw, as shapes in the world frame: for pictures, viewers and recordings.

Modes and colours are those of the vendor's header (`Nclient.h` 1.29): a copied mark stays, and one
that is combined by exclusive or disappears when it is drawn a second time. Where the header is
silent, chosen by us: angles are in 0.1 degree, an arc runs from its first angle to its second one,
counter-clockwise from the x axis, and the rectangle around it reaches right and down from its
corner, as y goes up in the world.

>>> line = Drawing.of(0, [LINE, 0, 0, 100, 50, 0, 0, 18])
>>> line.colour, line.xor
('Red', True)
>>> [stroke.round(6).tolist() for stroke in line.strokes_m(0.2)]
[[[0.0, 0.0], [0.254, 0.127]]]
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Self

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.core.units import tenths_deg_to_rad, tenths_inch_to_m
from crs_cc.sim.kernels import exact

if TYPE_CHECKING:
    from crs_cc.sim.state.drawings import DrawingState


ROBOT: Final = 0
LINE: Final = 1
ARC: Final = 2
ARROW: Final = 3
"""The small arrow that `draw_robot` leaves in mode 2; programs cannot draw it alone."""

BLACK: Final = "Black"
COLOURS: Final = (
    "Blue", "NavyBlue", "RoyalBlue", "SteelBlue", "CadetBlue", "Green", "SeaGreen", "ForestGreen",
    "DarkGreen", "LimeGreen", "Yellow", "Orange", "LightCoral", "DeepPink", "OrangeRed", "Red",
    "IndianRed", "VioletRed", "DeepPink", "Maroon",
)  # fmt: skip
"""The colours of the vendor's header, the first of which is colour 1."""

_COPY: Final = {ROBOT: 3, LINE: 1, ARC: 1, ARROW: 3}
_WITH_ARROW: Final = 2  # the mode of a robot with an arrow
_LAST_BLACK: Final = {ROBOT: 3, LINE: 2, ARC: 2, ARROW: 3}
_TURN: Final = 3600
_POINTS: Final = 48  # of a full turn
_ARROW: Final = 0.4  # of the robot's radius


@dataclass(frozen=True, slots=True)
class Drawing:
    """One mark in the picture.

    Attributes:
        robot: whose program drew it.
        kind: ROBOT, LINE, ARC or ARROW.
        numbers: its geometry, as given by the program [0.1 in, 0.1 deg]: x, y, heading, turret of a
            robot or an arrow; both ends of a line; left, top, width, height, both angles of an arc.
        colour: its name in the vendor's header.
        xor: whether it disappears when it is drawn a second time.
    """

    robot: int
    kind: int
    numbers: tuple[int, ...]
    colour: str
    xor: bool

    @classmethod
    def of(cls, robot: int, mark: Sequence[int]) -> Self:
        """Return the mark for the arguments of a valid request DRAW: kind, six numbers, mode."""
        kind, *numbers, mode = mark
        last = _LAST_BLACK[kind]
        colour = BLACK if mode <= last else COLOURS[mode - last - 1]
        return cls(robot, kind, tuple(numbers), colour, mode != _COPY[kind])

    def strokes_m(self, radius_m: float) -> list[FloatArray]:
        """Return the lines of the mark, in the world frame [m], shape (points, 2) each.

        Args:
            radius_m: the radius of the robot whose program drew it.
        """
        if self.kind == LINE:
            ends = tenths_inch_to_m(np.array(self.numbers[:4], dtype=np.float64))
            return [ends.reshape(2, 2)]
        if self.kind == ARC:
            left, top, width, height = (tenths_inch_to_m(float(n)) for n in self.numbers[:4])
            begin, end = self.numbers[4:6]
            middle = left + width / 2, top - height / 2
            return [_bow(middle, (width / 2, height / 2), begin, end)]
        x_m, y_m = (tenths_inch_to_m(float(n)) for n in self.numbers[:2])
        heading_rad, turret_rad = (tenths_deg_to_rad(float(n)) for n in self.numbers[2:4])
        if self.kind == ARROW:
            return [_arrow(x_m, y_m, heading_rad, _ARROW * radius_m)]
        body = _bow((x_m, y_m), (radius_m, radius_m), 0, _TURN)
        front = _spoke(x_m, y_m, heading_rad, radius_m)
        if self.numbers[2] == self.numbers[3]:
            return [body, front]
        return [body, front, _spoke(x_m, y_m, turret_rad, radius_m / 2)]


def is_mode(kind: int, mode: int) -> bool:
    """Return whether a shape can be drawn in a mode."""
    return kind in (ROBOT, LINE, ARC) and 1 <= mode <= _LAST_BLACK[kind] + len(COLOURS)


def marks_of(mark: Sequence[int]) -> list[tuple[int, ...]]:
    """Return the marks that a valid request DRAW adds: its own, and perhaps an arrow.

    >>> marks_of([ROBOT, 10, 20, 900, 0, 0, 0, 2])
    [(0, 10, 20, 900, 0, 0, 0, 2), (3, 10, 20, 900, 0, 0, 0, 3)]
    """
    own = tuple(mark)
    if (mark[0], mark[-1]) != (ROBOT, _WITH_ARROW):
        return [own]
    return [own, (ARROW, *own[1:-1], _COPY[ARROW])]


def is_xor(kind: int, mode: int) -> bool:
    """Return whether a mark disappears when it is drawn a second time."""
    return mode != _COPY[kind]


def drawings_in(state: DrawingState) -> list[Drawing]:
    """Return all marks, later ones on top."""
    pairs = zip(state.robots.tolist(), state.marks.tolist(), strict=True)
    return [Drawing.of(robot, mark) for robot, mark in pairs]


def _bow(
    middle: tuple[float, float], half: tuple[float, float], begin: int, end: int
) -> FloatArray:
    """Return an arc of an ellipse from one angle to another [0.1 deg], at most a full turn."""
    sweep = max(-_TURN, min(end - begin, _TURN))
    count = max(2, math.ceil(abs(sweep) / _TURN * _POINTS) + 1)
    angle = tenths_deg_to_rad(np.linspace(begin, begin + sweep, count))
    return np.array(middle) + np.column_stack([exact.cos(angle), exact.sin(angle)]) * half


def _spoke(x_m: float, y_m: float, heading_rad: float, length_m: float) -> FloatArray:
    end = x_m + length_m * exact.cos(heading_rad), y_m + length_m * exact.sin(heading_rad)
    return np.array([(x_m, y_m), end])


def _arrow(x_m: float, y_m: float, heading_rad: float, length_m: float) -> FloatArray:
    angle = heading_rad + np.array([math.pi, 0.0, 0.7, 0.0, -0.7])
    size_m = length_m * np.array([1.0, 1.0, 0.6, 1.0, 0.6])
    return np.column_stack([x_m + size_m * exact.cos(angle), y_m + size_m * exact.sin(angle)])
