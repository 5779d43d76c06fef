"""Traction: the effect of contacts on a robot's wheels and so on its encoders.

When something holds a robot up, or pushes it, along its wheels:

- motors that are weaker than the wheels' grip stall or are overrun: the encoders count the
  true rolling of the wheels. A relative move continues, with its motors working, until it is
  complete;
- wheels whose grip is weaker than the motors slip: the encoders count as without a contact;
- a robot that is at rest and held (`st`) yields to a push stronger than its grip, with wheels
  that do not turn;
- limp wheels (`lp`) roll with any push stronger than their friction, and their encoders count.

The force of the motors grows with the lag of the wheels, so at the end of a relative move, where
the rest is small, it is less than what is needed to push a box, or to slide along a wall. So a move
that has stalled for a while, within two units of the interface of its goal, is complete.

Across the wheels everything slips. Motors that have stalled for the time `give-up` of the robot
definition stop, as if the program had called `st`.

The true motion in a cycle is known only at its end; until then the encoders count as if it
continued as in the cycle before. All of this was chosen by us: no source describes how the vendor's
motor controller behaves when a robot is held up.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, any_of
from crs_cc.sim.devices import odometry
from crs_cc.sim.devices.drive.constants import weighted
from crs_cc.sim.kernels import exact
from crs_cc.sim.kernels.program import pairs
from crs_cc.sim.model.axis import AXES
from crs_cc.sim.state import motion_profile
from crs_cc.sim.state.bodies import Pull
from crs_cc.sim.state.rows import ALL, Rows, take

if TYPE_CHECKING:
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


_SAME_M: Final = 1e-9  # smaller differences of distances are rounding errors
_STANDS_MPS: Final = 0.005  # slower wheels are at rest; chosen by us
_ARRIVED_S: Final = 0.5  # a move that stalls for this time
_ARRIVED_UNITS: Final = 2  # within this distance of its goal is complete; chosen by us


def pull(state: EnvState, constants: RobotConstants) -> Pull:
    """Return the drives' action in a cycle to whose end all axes have been turned."""
    return Pull(state.drive.moved_m.copy(), facing_rad(state), is_limp(state, constants))


def facing_rad(state: EnvState) -> FloatArray:
    """Return the rolling directions of wheels in a cycle to whose end all axes were turned."""
    return (state.heading_rad + state.drive.facing_rad) / 2


def is_limp(state: EnvState, constants: RobotConstants, rows: Rows = ALL) -> BoolArray:
    """Return which robots roll freely, with all wheels limp, (k,)."""
    limp = state.drive.limp[rows]
    return np.asarray(limp[:, 0] & (limp[:, 1] | constants.drives.synchro[rows]))


def turned(
    state: EnvState,
    constants: RobotConstants,
    rows: IndexArray | slice,
    motion: FloatArray,
    for_s: FloatArray,
) -> FloatArray:
    """Return the motion that encoders count while the motors turn the axes.

    Args:
        state: changed in place.
        constants: the robots' constants.
        rows: which robots, k of them.
        motion: motion of each axis by the motors, shape (k, 3).
        for_s: duration of it, shape (k,).

    Returns:
        the counted motion, shape (k, 3).
    """
    if not state.drive.hindered.any():
        return motion
    driven_m = weighted(motion, constants.drives.forward[rows])
    ahead_m = driven_m - state.drive.forward_mps[rows] * for_s
    ahead_m = np.where(state.drive.hindered[rows], ahead_m, 0.0)
    state.drive.ahead_m[rows] += ahead_m
    return np.asarray(motion - ahead_m[:, None] * constants.drives.rolls[rows])


def speed(state: EnvState, constants: RobotConstants, rows: IndexArray) -> FloatArray:
    """Return the speeds of robots' axes as measured by their encoders, shape (k, 3)."""
    now_s, driven = state.drive.clock_s[rows], take(state.drive.axes.speed, rows)
    driven = constants.degradations.speeds(state, "drive", rows, driven, now_s)
    if not any_of(state.drive.hindered):
        return np.asarray(driven)
    lag_mps = weighted(driven, constants.drives.forward[rows]) - state.drive.forward_mps[rows]
    lag_mps = np.where(state.drive.hindered[rows], lag_mps, 0.0)
    return np.asarray(driven - lag_mps[:, None] * constants.drives.rolls[rows])


def apply_contacts(state: EnvState, constants: RobotConstants, displacement_m: FloatArray) -> None:
    """End a cycle: apply the effect of contacts on robots to their axes and encoders.

    Args:
        state: changed in place; its headings are still those of the cycle's start.
        constants: the robots' constants.
        displacement_m: true displacement of each robot, world frame, (robots, 2).
    """
    off_m = displacement_m - state.drive.moved_m
    is_off, hindered = np.abs(off_m) > _SAME_M, state.drive.hindered
    if not (any_of(is_off) or any_of(hindered)):
        return
    drives, rows = constants.drives, np.flatnonzero(is_off[:, 0] | is_off[:, 1] | hindered)
    limp = is_limp(state, constants, rows)
    held_up = limp | (drives.yields[rows] & (state.drive.moved_m[rows] != 0.0).any(axis=1))
    held_up &= is_off[rows].any(axis=1)
    mine = held_up | hindered[rows]
    rows, limp, held_up = rows[mine], limp[mine], held_up[mine]
    facing_rad = (state.heading_rad[rows] + state.drive.facing_rad[rows]) / 2
    ahead = pairs(exact.turn(facing_rad))
    longer = np.ones(len(rows))
    if constants.inclines is not None:
        before_m = state.bodies.position_m[rows] - displacement_m[rows]
        longer = constants.inclines.length_ratios(before_m, ahead)
    short_m = np.where(held_up, -weighted(off_m[rows], ahead) * longer, 0.0)
    counted = (state.drive.ahead_m[rows] - short_m)[:, None] * drives.rolls[rows]
    odometry.count_turns(state, constants, rows, counted)
    state.drive.slice[rows] += counted
    state.drive.ahead_m[rows] = 0.0
    now_s = state.drive.clock_s[rows]
    motion_profile.fall_short(state.drive.axes, rows, now_s, short_m[:, None] * drives.rolls[rows])
    forward_mps = weighted(state.bodies.velocity_mps[rows], ahead) * longer
    state.drive.hindered[rows] = held_up
    state.drive.forward_mps[rows] = np.where(held_up, forward_mps, 0.0)
    stalled = held_up & ~limp & (np.abs(forward_mps) < _STANDS_MPS)
    _arrive(state, constants, rows[stalled])
    _give_up(state, constants, rows, stalled)


def _arrive(state: EnvState, constants: RobotConstants, rows: IndexArray) -> None:
    """End the moves of robots that have stalled for a while just before the goal."""
    axes, rolls = state.drive.axes, constants.drives.rolls[rows] > 0.0
    left = np.abs(take(axes.total, rows) - take(axes.travelled, rows))
    near = (take(axes.limit, rows) > 0.0) & (left <= _ARRIVED_UNITS * constants.drives.unit[rows])
    near &= state.drive.stalled_s[rows, None] >= _ARRIVED_S
    arrived = (near | ~rolls).all(axis=1, keepdims=True)
    motion_profile.end_here(axes, rows, np.asarray(rolls & arrived))


def ground_distances_m(
    constants: RobotConstants, before_m: FloatArray, displacement_m: FloatArray
) -> FloatArray | None:
    """Return the distances that robots moved along the ground [m], (robots,); None if it is flat.

    Args:
        constants: the robots' constants.
        before_m: their positions before, (robots, 2).
        displacement_m: their displacements, (robots, 2).
    """
    if constants.inclines is None:
        return None
    distance_m = exact.hypot(displacement_m[:, 0], displacement_m[:, 1])
    direction = displacement_m / np.maximum(distance_m, _SAME_M)[:, None]
    return np.asarray(distance_m * constants.inclines.length_ratios(before_m, direction))


def _give_up(
    state: EnvState, constants: RobotConstants, rows: IndexArray, stalled: BoolArray
) -> None:
    """Measure how long motors have stalled, and stop those that have for too long."""
    stalled_s = np.where(stalled, state.drive.stalled_s[rows] + constants.timestep_s, 0.0)
    tired = stalled_s >= constants.drives.give_up_s[rows] - _SAME_M
    state.drive.stalled_s[rows] = np.where(tired, 0.0, stalled_s)
    if tired.any():
        stops = rows[tired]
        state.drive.axes.speed[stops] = 0.0
        at_once = np.ones((len(stops), AXES))
        state.rows.set_speeds(stops, 0.0 * at_once, constants.kinds, ramp=at_once)
