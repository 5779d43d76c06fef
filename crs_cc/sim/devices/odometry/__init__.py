"""Odometry: the pose of a robot as computed from the motion of its wheels.

A differential drive, with the motion of its right and left wheel:

    turn     = (right - left) / wheel base
    distance = (right + left) / 2

A synchro drive measures distance and turn by its axes 1 and 2. While the speeds of the axes are
constant, the robot drives along an arc; its chord is distance * sinc(turn / 2), at half the turn
from the old heading (exact: J. Borenstein, H. R. Everett, L. Feng, "Where am I?", 1996, section
1.2, has the same with the arc in place of the chord). `drive.traction` specifies what is counted
when a robot is held up.

Encoders count in steps: the motion of an axis is reported as a whole number of them. Units on the
interface: 0.1 in and 0.1 deg (vendor header `Nclient.h` 1.29). Odometry assumes nominal wheels;
`drive.rolling` has their errors.

>>> quarter = np.array([np.pi / 2]), np.array([np.pi / 2])    # along a circle of radius 1
>>> [round(float(part[0]), 6) for part in arc(np.array([0.0]), *quarter)]
[1.0, 1.0]
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.core.units import tenths_deg_to_rad, tenths_inch_to_m
from crs_cc.sim.devices.drive.constants import DRIVE_SIZE
from crs_cc.sim.kernels.program import ROBOTS_AT_ONCE, kernels
from crs_cc.sim.kernels.tables import COUNTS
from crs_cc.sim.model.axis import AXES
from crs_cc.sim.state.odometry import OdometryState
from crs_cc.sim.state.rows import Rows, parts, take

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


COLUMNS: Final = 10
"""Numbers of a robot in the columns of odometry."""

_FULL_TURN: Final = 3600  # [0.1 deg]


def arc(
    heading_rad: FloatArray, arc_m: FloatArray, turn_rad: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return the displacement along an arc.

    Args:
        heading_rad: the heading before, shape (k,).
        arc_m: length of the arc, shape (k,).
        turn_rad: change of the heading on it, shape (k,).

    Returns:
        change of x and of y [m].
    """
    return kernels().arcs(heading_rad, arc_m, turn_rad)


def count_turns(
    state: EnvState, constants: RobotConstants, rows: IndexArray | slice, motion: FloatArray
) -> None:
    """Add the axes' motion since the last call to the odometry, in encoder counts."""
    for some, part in parts(rows, len(motion), ROBOTS_AT_ONCE):
        k = part.stop - part.start
        table = take(constants.drives.table, some)
        found = kernels().columns(COUNTS, k, [table, *columns(state.odometry, some), motion[part]])
        note(state.odometry, some, found[DRIVE_SIZE * k :].reshape(-1), k)


def columns(odometry: OdometryState, rows: Rows) -> list[FloatArray]:
    """Return the columns of some robots that kernels change, see `kernels/drive.c`."""
    pose = odometry.x_m, odometry.y_m, odometry.heading_rad, odometry.turret_rad
    return [take(column, rows) for column in (odometry.shaft, odometry.reported, *pose)]


def note(odometry: OdometryState, rows: Rows, found: FloatArray, count: int) -> None:
    """Set the odometry of robots from the columns that a kernel has changed."""
    shafts, poses = found[: 6 * count].reshape(2, count, AXES), found[6 * count : COLUMNS * count]
    odometry.shaft[rows], odometry.reported[rows] = shafts
    odometry.x_m[rows], odometry.y_m[rows], odometry.heading_rad[rows], turret_rad = poses.reshape(
        4, count
    )
    odometry.turret_rad[rows] = turret_rad


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
