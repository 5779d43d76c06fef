"""The differential drive: the motion commands of the Scout.

Axis 1 of a command is the right wheel, axis 2 the left one, axis 3 is not used (vendor header
`Nclient.h` 1.29, whose names are STATE_VEL_RIGHT and STATE_VEL_LEFT). Units on the interface:
0.1 in, 0.1 in/s, 0.1 in/s^2. `hardware` turns commands into slices; here they are understood:

- speeds and accelerations beyond the limits of the robot definition are the limits; `ac` and `sp`
  take the magnitude (the vendor's library sends it without sign), and at least 1 unit; both count
  for the commands that follow;
- a command that comes while another runs replaces it, from the speed reached;
- `conf_tm`: when no command came for so long, the wheels brake to a standstill;
- `ws` gives up after its timeout; a timeout of 0 does not wait at all.

No degradation yet.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from crs_cc.requests import CODES
from crs_cc.sim import hardware
from crs_cc.sim.sensors import odometry
from crs_cc.units import tenths_inch_to_m

if TYPE_CHECKING:
    from crs_cc.sim.equipment import Equipment
    from crs_cc.sim.state import EnvState

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]
WholeArray = npt.NDArray[np.int64]
IndexArray = npt.NDArray[np.intp]
Messages = npt.NDArray[np.void]

IGNORE: Final = 0
VELOCITY: Final = 1
RELATIVE: Final = 2
LIMP: Final = 3
ACCELERATION: Final = 4
SPEED: Final = 5
"""Modes of `mv` (MV_IGNORE to MV_SP, vendor header `Nclient.h` 1.29)."""

_LONGEST_TIMEOUT: Final = 255  # [s]: an unsigned char
_ALL: Final = slice(None)


# -- time ------------------------------------------------------------------------------------------


def advance(
    state: EnvState, equipment: Equipment, rows: IndexArray | slice, to_s: FloatArray
) -> None:
    """Lets the wheels turn on to an instant, and stop in between where the time for it is up.

    Args:
        state: changed in place.
        equipment: the robots' constants.
        rows: which robots, k of them.
        to_s: the instant of each, not before the last one, shape (k,).
    """
    late = state.drive.deadline_s[rows] < to_s
    if late.any():
        stopped = np.arange(len(state.drive.clock_s))[rows][late]
        deadline_s = state.drive.deadline_s[stopped]
        _turn(state, equipment, stopped, deadline_s)
        standing = np.zeros((len(stopped), 2))
        ramp_mps2 = state.drive.ramp_mps2[stopped]
        hardware.plan_speed(state.drive.wheels, stopped, deadline_s, standing, ramp_mps2=ramp_mps2)
        state.drive.deadline_s[stopped] = np.inf
        _remember(state, stopped, CODES["CONF_TM"])
    _turn(state, equipment, rows, to_s)


def settle_waits(
    state: EnvState, equipment: Equipment, rows: IndexArray, limit_s: float
) -> FloatArray:
    """Ends the waits of robots that end before a limit.

    A robot that waits gives no commands, so its wheels can be turned on to the end of its wait.

    Args:
        state: changed in place.
        equipment: the robots' constants.
        rows: robots that wait, k of them.
        limit_s: the end of the current cycle.

    Returns:
        the instant at which each wait ended, infinite for those that go on, shape (k,).
    """
    end_s = _wait_end_s(state, rows)
    # The time for a stop may be up before; then the wheels stand earlier than it seemed.
    cut = (state.drive.deadline_s[rows] < end_s) & (state.drive.deadline_s[rows] < limit_s)
    if cut.any():
        deadline_s = state.drive.deadline_s[rows[cut]]
        advance(state, equipment, rows[cut], np.nextafter(deadline_s, np.inf))
        end_s = _wait_end_s(state, rows)
    ended = end_s < limit_s
    advance(state, equipment, rows[ended], end_s[ended])
    state.drive.waiting[rows[ended]] = False
    return np.where(ended, end_s, np.inf)


def _wait_end_s(state: EnvState, rows: IndexArray) -> FloatArray:
    stands_s = np.where(state.drive.waiting[rows], state.drive.wheels.end_s(rows), -np.inf).max(
        axis=1
    )
    end_s = np.minimum(stands_s, state.drive.wait_until_s[rows])
    return np.asarray(np.maximum(end_s, state.drive.clock_s[rows]))


def _turn(
    state: EnvState, equipment: Equipment, rows: IndexArray | slice, to_s: FloatArray
) -> None:
    way_m = hardware.advance(state.drive.wheels, rows, to_s)
    state.drive.clock_s[rows] = to_s
    state.drive.slice_m[rows] += way_m
    odometry.count_turns(state, equipment, rows, way_m)
    facing_rad = state.drive.facing_rad[rows]
    x_m, y_m, turn_rad = odometry.arc(facing_rad, way_m, equipment.wheel_base_m[rows])
    state.drive.moved_m[rows, 0] += x_m
    state.drive.moved_m[rows, 1] += y_m
    state.drive.facing_rad[rows] = facing_rad + turn_rad


# -- commands --------------------------------------------------------------------------------------


def ac(state: EnvState, equipment: Equipment, rows: IndexArray, messages: Messages) -> None:
    """Sets accelerations."""
    _set_limited(state.drive.ramp_mps2, equipment.ramp_limit_mps2, rows, messages["i"][:, :2])


def sp(state: EnvState, equipment: Equipment, rows: IndexArray, messages: Messages) -> None:
    """Sets the speeds of `pr`."""
    _set_limited(state.drive.move_mps, equipment.speed_limit_mps, rows, messages["i"][:, :2])


def pr(state: EnvState, _equipment: Equipment, rows: IndexArray, messages: Messages) -> None:
    """Starts a relative move."""
    _move(state, rows, messages["i"][:, :2])
    _remember(state, rows, CODES["PR"])


def vm(state: EnvState, equipment: Equipment, rows: IndexArray, messages: Messages) -> None:
    """Sets wheel speeds."""
    _run_at(state, equipment, rows, messages["i"][:, :2])
    _remember(state, rows, CODES["VM"])


def mv(state: EnvState, equipment: Equipment, rows: IndexArray, messages: Messages) -> BoolArray:
    """Commands each axis in a mode of its own; refuses modes that the vendor's client refuses."""
    modes, values = messages["i"][:, [0, 2, 4]], messages["i"][:, [1, 3]]
    good = np.asarray(((modes >= IGNORE) & (modes <= SPEED)).all(axis=1))
    rows, wheels, values = rows[good], modes[good, :2], values[good]
    _set_limited(
        state.drive.ramp_mps2, equipment.ramp_limit_mps2, rows, values, wheels == ACCELERATION
    )
    _set_limited(state.drive.move_mps, equipment.speed_limit_mps, rows, values, wheels == SPEED)
    _run_at(state, equipment, rows, values, wheels == VELOCITY)
    _move(state, rows, values, wheels == RELATIVE)
    _stop(state, rows, wheels == LIMP)
    moves = ((wheels == VELOCITY) | (wheels == RELATIVE) | (wheels == LIMP)).any(axis=1)
    _remember(state, rows[moves], CODES["MV"])
    return good


def st(state: EnvState, _equipment: Equipment, rows: IndexArray, _messages: Messages) -> None:
    """Stops the wheels and holds them."""
    _stop(state, rows)
    _remember(state, rows, CODES["ST"])


def lp(state: EnvState, _equipment: Equipment, rows: IndexArray, _messages: Messages) -> None:
    """Lets the wheels go limp: they roll out, as fast as they would brake."""
    _stop(state, rows)
    _remember(state, rows, CODES["LP"])


def ws(state: EnvState, _equipment: Equipment, rows: IndexArray, messages: Messages) -> None:
    """Begins to wait until the chosen wheels stand still; `settle_waits` ends it."""
    state.drive.waiting[rows] = messages["i"][:, :2] != 0
    timeout_s = np.clip(messages["i"][:, 3], 0, _LONGEST_TIMEOUT)
    state.drive.wait_until_s[rows] = state.drive.clock_s[rows] + timeout_s


def conf_tm(state: EnvState, _equipment: Equipment, rows: IndexArray, messages: Messages) -> None:
    """Sets the time without a command after which the wheels stop, 0 for never."""
    timeout_s = np.clip(messages["i"][:, 0], 0, _LONGEST_TIMEOUT).astype(np.float64)
    state.drive.timeout_s[rows] = np.where(timeout_s > 0.0, timeout_s, np.inf)


def _set_limited(
    setting: FloatArray,
    limit: FloatArray,
    rows: IndexArray,
    values: npt.NDArray[np.int32],
    which: BoolArray | bool = True,
) -> None:
    wanted = np.maximum(np.abs(values.astype(np.float64)), 1.0)
    limited = np.minimum(tenths_inch_to_m(wanted), limit[rows, None])
    setting[rows] = np.where(which, limited, setting[rows])


def _run_at(
    state: EnvState,
    equipment: Equipment,
    rows: IndexArray,
    values: npt.NDArray[np.int32],
    which: BoolArray | bool = True,
) -> None:
    limit_mps = equipment.speed_limit_mps[rows, None]
    target_mps = np.clip(tenths_inch_to_m(values.astype(np.float64)), -limit_mps, limit_mps)
    ramp_mps2 = state.drive.ramp_mps2[rows]
    now_s = state.drive.clock_s[rows]
    hardware.plan_speed(
        state.drive.wheels, rows, now_s, target_mps, ramp_mps2=ramp_mps2, which=which
    )


def _move(
    state: EnvState, rows: IndexArray, values: npt.NDArray[np.int32], which: BoolArray | bool = True
) -> None:
    hardware.plan_move(
        state.drive.wheels,
        rows,
        state.drive.clock_s[rows],
        tenths_inch_to_m(values.astype(np.float64)),
        limit_mps=state.drive.move_mps[rows],
        ramp_mps2=state.drive.ramp_mps2[rows],
        which=which,
    )


def _stop(state: EnvState, rows: IndexArray, which: BoolArray | bool = True) -> None:
    standing = np.zeros((len(rows), 2))
    now_s, ramp_mps2 = state.drive.clock_s[rows], state.drive.ramp_mps2[rows]
    hardware.plan_speed(state.drive.wheels, rows, now_s, standing, ramp_mps2=ramp_mps2, which=which)


def _remember(state: EnvState, rows: IndexArray, code: int) -> None:
    state.drive.command[rows] = code
    state.drive.command_cycle[rows] = state.cycle
