"""The drive: the motion commands.

On a differential drive (Scout) axis 1 of a command is the right wheel, axis 2 the left one, axis 3
is not used; on a synchro drive (Nomad 200) they are translation, steering and turret (vendor header
`Nclient.h` 1.29, which calls the speeds STATE_VEL_TRANS and STATE_VEL_RIGHT, and so on). Units on
the interface: 0.1 in or 0.1 deg, also per second and per second squared. `motion_profile` turns
commands into slices; here they are interpreted:

- speeds and accelerations are clipped to the limits of the robot definition; `ac` and `sp`
  take the magnitude (the vendor's library sends it without sign), and at least 1 unit; both count
  for the commands that follow;
- a command that comes while another runs replaces it, from the speed reached;
- `conf_tm`: when no command arrives for this time, the axes brake to a standstill;
- `ws` ends after its timeout; a timeout of 0 does not wait at all, or waits forever, as the
  robot definition specifies;
- `zr` sets the odometry of a differential drive to 0 at once. A synchro drive stops, turns steering
  and turret to their zero marks, with the speeds of `sp`, and then does so; until then the program
  waits, 120 s at most, and `conf_tm` is off.

`traction` has the effect of contacts, `rolling` the errors of the wheels.

Degradation applies to the speeds of the axes at three places: `drive` is the motors' response to
commands, which the encoders measure; `wheels` is its effect on the floor, which they do not measure
(a wheel that slips); `odometry` is what they count. A dead motor holds its wheel. The motor
controller does not notice: a move ends at its nominal time, wherever the wheels are.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, any_of
from crs_cc.requests import CODES
from crs_cc.sim.devices import odometry
from crs_cc.sim.devices.drive import traction
from crs_cc.sim.devices.drive.constants import weighted
from crs_cc.sim.kernels.tables import ADVANCED, NOT_HANDLED
from crs_cc.sim.model.axis import AXES
from crs_cc.sim.state import motion_profile
from crs_cc.sim.state.rows import simplest, take

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


IGNORE: Final = 0
VELOCITY: Final = 1
RELATIVE: Final = 2
LIMP: Final = 3
ACCELERATION: Final = 4
SPEED: Final = 5
"""Modes of `mv` (MV_IGNORE to MV_SP, vendor header `Nclient.h` 1.29)."""

_AXES: Final = ("axis1", "axis2", "axis3")
_BYTE: Final = 255  # timeouts are unsigned chars [s]
_ZERO_TIMEOUT_S: Final = 120.0  # the vendor's client waits this long (`Ndirect.c` 2.7)
_TURN: Final = 2 * math.pi


# -- time ------------------------------------------------------------------------------------------


def advance(
    state: EnvState, constants: RobotConstants, rows: IndexArray | slice, to_s: FloatArray
) -> None:
    """Advance the axes to a time, stopping those whose command timeout expires before.

    Args:
        state: changed in place.
        constants: the robots' constants.
        rows: which robots, k of them.
        to_s: the time of each, not before the last one, shape (k,).
    """
    if advance_freely(state, constants, rows, to_s) == ADVANCED:
        return
    late = state.drive.deadline_s[rows] < to_s
    if late.any():
        stopped = np.arange(len(state.drive.clock_s))[rows][late]
        deadline_s = state.drive.deadline_s[stopped]
        _advance_axes(state, constants, stopped, deadline_s)
        _stop(state, constants, stopped, ~state.drive.limp[stopped])
        state.drive.deadline_s[stopped] = np.inf
        _note_command(state, stopped, CODES["CONF_TM"])
    if advance_freely(state, constants, rows, to_s) != ADVANCED:
        _advance_axes(state, constants, rows, to_s)


def advance_freely(
    state: EnvState,
    constants: RobotConstants,
    rows: IndexArray | slice,
    to_s: FloatArray,
    last_s: float = -math.inf,
    *,
    renews: bool = False,
) -> int:
    """Advance the axes as commanded, if nothing else happens to any of the robots before.

    Args:
        state: changed in place.
        constants: the robots' constants.
        rows: which robots, k of them.
        to_s: the time of each, not before the last one, shape (k,).
        last_s: the time up to which it matters what sensors do.
        renews: whether command timeouts restart then.

    Returns:
        `ADVANCED`, or what happens to one of them; then some of the others may be advanced.
    """
    if not moves_as_commanded(state, constants):
        return NOT_HANDLED
    return state.rows.advance(rows, to_s, last_s, constants.kinds, renews=renews)


def moves_as_commanded(state: EnvState, constants: RobotConstants) -> bool:
    """Return whether robots that nothing holds up move as their axes are commanded."""
    return constants.inclines is None and not constants.degradations.affects_motion(state)


def renew_deadline(state: EnvState, rows: IndexArray) -> None:
    """Restart the command timeout at the time to which the axes have been turned."""
    state.drive.deadline_s[rows] = state.drive.clock_s[rows] + state.drive.timeout_s[rows]


def rest_s(state: EnvState, rows: IndexArray) -> FloatArray:
    """Return when the axes that robots wait for will be at rest, or the wait times out.

    If the command timeout expires before, they stop earlier.
    """
    end_s = state.drive.axes.end_s(rows)
    # A move that is held up is not complete at its nominal end.
    late = state.drive.hindered[rows, None] & (state.drive.axes.limit[rows] > 0.0)
    end_s = np.where(late, np.inf, end_s)
    rest_s = np.where(state.waits.axes[rows], end_s, -np.inf).max(axis=1)
    end_s = np.minimum(rest_s, state.waits.until_s[rows])
    return np.asarray(np.maximum(end_s, state.drive.clock_s[rows]))


def _advance_axes(
    state: EnvState, constants: RobotConstants, rows: IndexArray | slice, to_s: FloatArray
) -> None:
    """Advance the axes of robots, some of which are degraded, or on slopes."""
    motion = motion_profile.advance(state.drive.axes, rows, to_s)
    from_s = state.drive.clock_s[rows].copy()
    move, limit = constants.degradations.move, constants.drives.speed_limit
    motion = move(state, "drive", rows, motion, from_s=from_s, to_s=to_s, limit=limit)
    turned = traction.turned(state, constants, rows, motion, to_s - from_s)
    state.drive.clock_s[rows] = to_s
    counted = move(state, "odometry", rows, turned, from_s=from_s, to_s=to_s)
    if turned.any() or counted.any():
        state.drive.slice[rows] += turned
        odometry.count_turns(state, constants, rows, counted)
    motion = move(state, "wheels", rows, motion, from_s=from_s, to_s=to_s, limit=limit)
    if not motion.any():
        return
    facing_rad = state.drive.facing_rad[rows]
    turn_rad = weighted(motion, take(constants.drives.true_turn, rows))
    arc_m = weighted(motion, take(constants.drives.true_forward, rows))
    x_m, y_m = odometry.arc(facing_rad, arc_m, turn_rad)
    if constants.inclines is not None:
        place_m = state.bodies.position_m[: len(state.heading_rad)][rows]
        x_m, y_m = constants.inclines.shortened(place_m, x_m, y_m)
    state.drive.moved_m[rows, 0] += x_m
    state.drive.moved_m[rows, 1] += y_m
    state.drive.facing_rad[rows] = facing_rad + turn_rad
    if constants.drives.turrets:
        state.drive.turret_rad[rows] += motion[:, 2]


# -- commands --------------------------------------------------------------------------------------


def ac(context: RequestContext) -> None:
    """Set accelerations."""
    ramp, limit = context.state.drive.ramp, context.constants.drives.ramp_limit
    _set(ramp, limit, context.constants, context.rows, context.columns(*_AXES))


def get_ra(context: RequestContext) -> None:
    """Reply the accelerations in the vendor's units."""
    unit = context.constants.drives.unit[context.rows]
    ramp = context.state.drive.ramp[context.rows]
    values = np.divide(ramp, unit, out=np.zeros_like(ramp), where=unit > 0.0)
    for axis, name in enumerate(("ramp1", "ramp2", "ramp3")):
        context[name] = np.rint(values[:, axis])


def sp(context: RequestContext) -> None:
    """Set the speeds of `pr`."""
    speed, limit = context.state.drive.move_speed, context.constants.drives.speed_limit
    _set(speed, limit, context.constants, context.rows, context.columns(*_AXES))


def pr(context: RequestContext) -> None:
    """Start a relative move."""
    _move(context.state, context.constants, context.rows, context.columns(*_AXES))
    _remember(context, context.rows)


def vm(context: RequestContext) -> None:
    """Set speeds."""
    _run_at(context.state, context.constants, context.rows, context.columns(*_AXES))
    _remember(context, context.rows)


def mv(context: RequestContext) -> BoolArray:
    """Command each axis in a mode of its own; refuse the modes that the vendor's client refuses."""
    state, constants = context.state, context.constants
    modes = context.columns("mode1", "mode2", "mode3")
    values = context.columns("value1", "value2", "value3")
    good = np.asarray(((modes >= IGNORE) & (modes <= SPEED)).all(axis=1))
    rows, modes, values = context.rows[good], modes[good], values[good]
    settings = (
        (ACCELERATION, state.drive.ramp, constants.drives.ramp_limit),
        (SPEED, state.drive.move_speed, constants.drives.speed_limit),
    )
    for mode, setting, limit in settings:
        _set(setting, limit, constants, rows, values, which=modes == mode)
    _run_at(state, constants, rows, values, modes == VELOCITY)
    _move(state, constants, rows, values, modes == RELATIVE)
    _release(state, constants, rows, modes == LIMP)
    moves = ((modes == VELOCITY) | (modes == RELATIVE) | (modes == LIMP)).any(axis=1)
    _remember(context, rows[moves])
    return good


def st(context: RequestContext) -> None:
    """Stop the axes and hold them."""
    _stop(context.state, context.constants, context.rows)
    _remember(context, context.rows)


def lp(context: RequestContext) -> None:
    """Make the axes limp: the wheels roll out, steering and turret stop."""
    go_limp(context.state, context.constants, context.rows)


def go_limp(state: EnvState, constants: RobotConstants, rows: IndexArray) -> None:
    """Make the axes of robots limp, as `lp` does."""
    _release(state, constants, rows)
    _note_command(state, rows, CODES["LP"])


def ws(context: RequestContext) -> None:
    """Start to wait until the selected axes are at rest."""
    state, rows = context.state, context.rows
    state.waits.axes[rows] = context.columns(*_AXES) != 0
    timeout_s = (context["timeout_s"] & _BYTE).astype(np.float64)
    endless = (timeout_s == 0.0) & context.constants.drives.waits_forever[rows]
    until_s = state.drive.clock_s[rows] + timeout_s
    state.waits.until_s[rows] = np.where(endless, np.inf, until_s)


def zr(context: RequestContext) -> None:
    """Start to turn steering and turret to their zero marks, the shorter way; see `zeroed`.

    The marks are where wheels and turret point ahead of the base. A differential drive has none.
    """
    state, drives = context.state, context.constants.drives
    rows = context.rows[drives.synchro[context.rows]]
    _stop(state, context.constants, rows, np.arange(AXES) == 0)
    off_rad = np.zeros((len(rows), AXES))
    off_rad[:, 1] = state.base_rad[rows] - state.drive.facing_rad[rows]
    turret_rad = state.base_rad[rows] - state.drive.turret_rad[rows]
    off_rad[:, 2] = np.where(drives.turret[rows], turret_rad, 0.0)
    motion_profile.plan_move(
        state.drive.axes,
        rows,
        state.drive.clock_s[rows],
        (off_rad + math.pi) % _TURN - math.pi,
        limit=state.drive.move_speed[rows],
        ramp=state.drive.ramp[rows],
        which=np.arange(AXES) > 0,
    )
    state.waits.axes[rows] = True
    state.waits.until_s[rows] = state.drive.clock_s[rows] + _ZERO_TIMEOUT_S
    state.drive.deadline_s[rows] = np.inf  # until `zeroed`
    _remember(context, rows)


def zeroed(context: RequestContext) -> None:
    """Set the odometry to 0; fail for robots that have not reached their zero marks."""
    state, rows = context.state, context.rows
    stands = (state.drive.axes.end_s(rows) <= state.drive.clock_s[rows, None]).all(axis=1)
    done = stands | ~context.constants.drives.synchro[rows]
    odometry.zero(state, rows[done])
    context["done"] = done
    renew_deadline(state, rows)


def conf_tm(context: RequestContext) -> None:
    """Set the command timeout, after which the axes stop, 0 for none."""
    timeout_s = (context["timeout_s"] & _BYTE).astype(np.float64)
    timeout_s = np.where(timeout_s > 0.0, timeout_s, np.inf)
    context.state.drive.timeout_s[context.rows] = timeout_s
    renew_deadline(context.state, context.rows)


def _set(
    setting: FloatArray,
    limit: FloatArray,
    constants: RobotConstants,
    rows: IndexArray,
    values: Int32Array,
    *,
    which: BoolArray | bool = True,
) -> None:
    unit = constants.drives.unit[rows]
    least = np.where(unit > 0.0, unit, 1.0)
    wanted = np.maximum(np.abs(values.astype(np.float64)) * unit, least)
    setting[rows] = np.where(which, np.minimum(wanted, limit[rows]), setting[rows])


def _run_at(
    state: EnvState,
    constants: RobotConstants,
    rows: IndexArray,
    values: Int32Array,
    which: BoolArray | bool = True,
) -> None:
    run_at(state, constants, rows, values * take(constants.drives.unit, rows), which)


def run_at(
    state: EnvState,
    constants: RobotConstants,
    rows: IndexArray,
    speed: FloatArray,
    which: BoolArray | bool = True,
) -> None:
    """Set the speeds of axes, as `vm` does.

    Args:
        state: changed in place; the axes have been turned to the time of the command.
        constants: the robots' constants.
        rows: the robots, k of them.
        speed: of each axis [m/s or rad/s], clipped to its limit, (k, 3).
        which: which axes, (k, 3).
    """
    _engage_motors(state, constants, rows, which)
    _set_speeds(state, constants, rows, speed, which=which)


def _set_speeds(
    state: EnvState,
    constants: RobotConstants,
    rows: IndexArray,
    speed: FloatArray,
    *,
    which: BoolArray | bool,
    ramp: FloatArray | None = None,
) -> None:
    """Ramp axes to speeds, see `RobotRows.set_speeds`."""
    kinds = constants.kinds
    some = simplest(rows, len(kinds.kind))
    mask = None if which is True else np.broadcast_to(which, speed.shape)
    state.rows.set_speeds(some, speed, kinds, ramp=ramp, which=mask)


def _move(
    state: EnvState,
    constants: RobotConstants,
    rows: IndexArray,
    values: Int32Array,
    which: BoolArray | bool = True,
) -> None:
    _engage_motors(state, constants, rows, which)
    motion_profile.plan_move(
        state.drive.axes,
        rows,
        state.drive.clock_s[rows],
        values.astype(np.float64) * constants.drives.unit[rows],
        limit=state.drive.move_speed[rows],
        ramp=state.drive.ramp[rows],
        which=which,
    )


def _stop(
    state: EnvState, constants: RobotConstants, rows: IndexArray, which: BoolArray | bool = True
) -> None:
    _engage_motors(state, constants, rows, which)
    _set_speeds(state, constants, rows, np.zeros((len(rows), AXES)), which=which)


def turn_turret(
    state: EnvState, rows: IndexArray, turn_rad: float, speed_radps: FloatArray
) -> None:
    """Turn turrets by an angle, independently of the speed set by `sp`; other axes continue.

    Args:
        state: changed in place.
        rows: robots that have a turret, k of them.
        turn_rad: the angle, counter-clockwise.
        speed_radps: the speed of each, shape (k,).
    """
    turret = np.arange(AXES) == AXES - 1
    now_s, ramp = state.drive.clock_s[rows], state.drive.ramp[rows]
    motion, limit = np.full_like(ramp, turn_rad), np.broadcast_to(speed_radps[:, None], ramp.shape)
    motion_profile.plan_move(
        state.drive.axes, rows, now_s, motion, limit=limit, ramp=ramp, which=turret
    )


def _engage_motors(
    state: EnvState, constants: RobotConstants, rows: IndexArray, which: BoolArray | bool
) -> None:
    """Engage the motors of limp wheels again, at the speed at which these roll."""
    limp = state.drive.limp[rows]
    limp = limp if which is True else limp & which
    if any_of(limp):
        speed = state.drive.axes.speed
        speed[rows] = np.where(limp, traction.speed(state, constants, rows), speed[rows])
        state.drive.limp[rows] &= ~limp


def _release(
    state: EnvState, constants: RobotConstants, rows: IndexArray, which: BoolArray | bool = True
) -> None:
    rolls = constants.drives.rolls[rows] > 0.0
    roll_out_mps2 = constants.drives.roll_out_mps2[rows, None]
    ramp = np.where(rolls, roll_out_mps2, state.drive.ramp[rows])
    _set_speeds(state, constants, rows, np.zeros_like(ramp), which=which, ramp=ramp)
    state.drive.limp[rows] |= rolls & which


def _remember(context: RequestContext, rows: IndexArray) -> None:
    _note_command(context.state, rows, context.request.code)


def _note_command(state: EnvState, rows: IndexArray, code: int) -> None:
    state.drive.command[rows] = code
    state.drive.command_cycle[rows] = state.cycle
