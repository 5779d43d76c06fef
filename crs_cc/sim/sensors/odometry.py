"""Odometry: where a robot believes to be, from the turns of its wheels.

    turn = (right - left) / wheel base
    way  = (right + left) / 2

While both wheels keep their speeds the robot runs along an arc; its chord is way * sinc(turn / 2),
at half the turn from the old heading (exact: J. Borenstein, H. R. Everett, L. Feng, "Where am I?",
1996, section 1.2, gives the same with the chord taken for the arc). Wheels that slip turn all the
same, so after a collision odometry is wrong, as it is on the robot.

Units on the interface: 0.1 in and 0.1 deg (vendor header `Nclient.h` 1.29). No degradation yet.

>>> quarter = np.array([[math.pi / 2 * 1.1, math.pi / 2 * 0.9]])    # radius 1, base 0.2
>>> [round(float(part[0]), 6) for part in arc(np.array([0.0]), quarter, np.array([0.2]))]
[1.0, 1.0, 1.570796]
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from crs_cc.units import tenths_deg_to_rad, tenths_inch_to_m

if TYPE_CHECKING:
    from crs_cc.sim.equipment import Equipment
    from crs_cc.sim.state import EnvState

FloatArray = npt.NDArray[np.float64]
IndexArray = npt.NDArray[np.intp]
Messages = npt.NDArray[np.void]

_TURN: Final = 2 * math.pi


def arc(
    heading_rad: FloatArray, way_m: FloatArray, wheel_base_m: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Gives the change of a pose when the wheels run their ways.

    Args:
        heading_rad: the heading before, shape (k,).
        way_m: way of the right and of the left wheel, shape (k, 2).
        wheel_base_m: distance between the wheels, shape (k,).

    Returns:
        change of x, of y [m], and of the heading [rad].
    """
    turn = (way_m[:, 0] - way_m[:, 1]) / wheel_base_m
    chord = (way_m[:, 0] + way_m[:, 1]) / 2 * np.sinc(turn / _TURN)  # sinc(x) is sin(pi x) / pi x
    direction = heading_rad + turn / 2
    return chord * np.cos(direction), chord * np.sin(direction), turn


def count_turns(
    state: EnvState, equipment: Equipment, rows: IndexArray | slice, way_m: FloatArray
) -> None:
    """Takes the wheels' ways since the last time into the odometry."""
    heading_rad = state.odometry.heading_rad[rows]
    x_m, y_m, turn_rad = arc(heading_rad, way_m, equipment.wheel_base_m[rows])
    state.odometry.x_m[rows] += x_m
    state.odometry.y_m[rows] += y_m
    state.odometry.heading_rad[rows] = (heading_rad + turn_rad) % _TURN


def dp(state: EnvState, _equipment: Equipment, rows: IndexArray, messages: Messages) -> None:
    """Sets x and y."""
    state.odometry.x_m[rows] = tenths_inch_to_m(messages["i"][:, 0].astype(np.float64))
    state.odometry.y_m[rows] = tenths_inch_to_m(messages["i"][:, 1].astype(np.float64))


def da(state: EnvState, _equipment: Equipment, rows: IndexArray, messages: Messages) -> None:
    """Sets the heading; the Scout has no turret."""
    heading = messages["i"][:, 0] % 3600
    state.odometry.heading_rad[rows] = tenths_deg_to_rad(heading.astype(np.float64))


def zr(state: EnvState, _equipment: Equipment, rows: IndexArray, _messages: Messages) -> None:
    """Sets everything to 0. The N200 also turns to its zero marks; the Scout has none."""
    state.odometry.x_m[rows] = 0.0
    state.odometry.y_m[rows] = 0.0
    state.odometry.heading_rad[rows] = 0.0
