"""Odometry: the pose of a robot as computed from the motion of its wheels.

A differential drive, with the motion of its right and left wheel:

    turn = (right - left) / wheel base
    way  = (right + left) / 2

A synchro drive measures way and turn by its axes 1 and 2. While the speeds of the axes are
constant, the robot drives along an arc; its chord is way * sinc(turn / 2), at half the turn from
the old heading (exact: J. Borenstein, H. R. Everett, L. Feng, "Where am I?", 1996, section 1.2, has
the same with the arc in place of the chord). `drive.traction` specifies what is counted when a
robot is held up.

Encoders count in steps: the motion of an axis is reported as a whole number of them. Units on the
interface: 0.1 in and 0.1 deg (vendor header `Nclient.h` 1.29). Odometry assumes nominal wheels;
`drive.rolling` has their errors.

>>> quarter = np.array([math.pi / 2]), np.array([math.pi / 2])    # along a circle of radius 1
>>> [round(float(part[0]), 6) for part in arc(np.array([0.0]), *quarter)]
[1.0, 1.0]
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.core.units import tenths_deg_to_rad, tenths_inch_to_m
from crs_cc.sim.devices.drive.constants import weighted
from crs_cc.sim.kernels.program import kernels
from crs_cc.sim.state.rows import take

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


_TURN: Final = 2 * math.pi
_FULL_TURN: Final = 3600  # [0.1 deg]


def arc(
    heading_rad: FloatArray, way_m: FloatArray, turn_rad: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return the displacement along an arc.

    Args:
        heading_rad: the heading before, shape (k,).
        way_m: length of the arc, shape (k,).
        turn_rad: change of the heading on it, shape (k,).

    Returns:
        change of x and of y [m].
    """
    return kernels().arcs(heading_rad, way_m, turn_rad)


def count_turns(
    state: EnvState, constants: RobotConstants, rows: IndexArray | slice, way: FloatArray
) -> None:
    """Add the axes' motion since the last call to the odometry, in encoder counts."""
    way = _counted(state, constants, rows, way)
    heading_rad = state.odometry.heading_rad[rows]
    turn_rad = weighted(way, take(constants.drives.turn, rows))
    x_m, y_m = arc(heading_rad, weighted(way, take(constants.drives.forward, rows)), turn_rad)
    state.odometry.x_m[rows] += x_m
    state.odometry.y_m[rows] += y_m
    state.odometry.heading_rad[rows] = (heading_rad + turn_rad) % _TURN
    if constants.drives.turrets:
        turret_rad = state.odometry.turret_rad[rows] + np.where(
            constants.drives.turret[rows], way[:, 2], 0.0
        )
        state.odometry.turret_rad[rows] = turret_rad % _TURN


def _counted(
    state: EnvState, constants: RobotConstants, rows: IndexArray | slice, way: FloatArray
) -> FloatArray:
    """Return the motion in whole counts; the remainder counts later."""
    shaft, count = take(state.odometry.shaft, rows) + way, take(constants.drives.count, rows)
    reported = np.rint(shaft / count) * count
    whole = reported - take(state.odometry.told, rows)
    state.odometry.shaft[rows], state.odometry.told[rows] = shaft, reported
    return np.asarray(whole)


def dp(context: RequestContext) -> None:
    """Set x and y."""
    odometry, rows = context.state.odometry, context.rows
    odometry.x_m[rows] = tenths_inch_to_m(context["x"].astype(np.float64))
    odometry.y_m[rows] = tenths_inch_to_m(context["y"].astype(np.float64))


def da(context: RequestContext) -> None:
    """Set the heading, and the angle of the turret where there is one."""
    odometry, rows = context.state.odometry, context.rows
    angles = (context.columns("heading", "turret") % _FULL_TURN).astype(np.float64)
    heading_rad, turret_rad = tenths_deg_to_rad(angles).T
    odometry.heading_rad[rows] = heading_rad
    odometry.turret_rad[rows] = np.where(context.constants.drives.turret[rows], turret_rad, 0.0)


def zero(state: EnvState, rows: IndexArray) -> None:
    """Set everything to 0."""
    state.odometry.x_m[rows] = 0.0
    state.odometry.y_m[rows] = 0.0
    state.odometry.heading_rad[rows] = 0.0
    state.odometry.turret_rad[rows] = 0.0
