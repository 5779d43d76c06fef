"""Requests that are answered later, at the end of a wait.

The end of a wait is known in advance: running axes stop, a message in transit arrives, or the wait
times out. A waiting robot receives no commands, so that its axes can be advanced to the end of its
wait as soon as that is in the current cycle.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.devices import drive

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import Handler
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


@dataclass(frozen=True, slots=True)
class Wait:
    """The wait of one kind of request.

    Attributes:
        ends_s: returns when the waits of robots end as far as is known now, infinite for never;
            not before the times that the robots have reached, shape (k,).
        finish: answers the requests when the waits have ended.
    """

    ends_s: Callable[[EnvState, IndexArray], FloatArray]
    finish: Handler


def settle(
    waits: Mapping[int, Wait],
    state: EnvState,
    constants: RobotConstants,
    rows: IndexArray,
    limit_s: float,
) -> FloatArray:
    """End the waits of robots that end before a limit.

    Args:
        waits: the wait of each kind of request.
        state: changed in place.
        constants: the robots' constants.
        rows: the waiting robots, k of them.
        limit_s: the end of the current cycle.

    Returns:
        the time at which each wait ended, infinite for those that go on, shape (k,).
    """
    ends_s = when(waits, state, rows)
    # The command timeout may expire before; then the axes stop earlier than predicted.
    deadline_s = state.drive.deadline_s[rows]
    cut = (deadline_s < ends_s) & (deadline_s < limit_s)
    if cut.any():
        drive.advance(state, constants, rows[cut], np.nextafter(deadline_s[cut], np.inf))
        ends_s = when(waits, state, rows)
    ended = ends_s < limit_s
    drive.advance(state, constants, rows[ended], ends_s[ended])
    state.waits.end(rows[ended])
    return np.where(ended, ends_s, np.inf)


def when(waits: Mapping[int, Wait], state: EnvState, rows: IndexArray) -> FloatArray:
    """Return when the waits of robots will end, as far as is known now, shape (k,)."""
    ends_s, codes = np.full(len(rows), np.inf), state.waits.code[rows]
    for code in np.unique(codes).tolist():
        mine = codes == code
        ends_s[mine] = waits[code].ends_s(state, rows[mine])
    return ends_s
