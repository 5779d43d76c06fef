"""The conditions under which `CalmTime` may begin, and how long it may last.

It is calm while nothing touches or is held, no wait ends, no message is on its way, no device is
degraded, and no goal changes. Robots may drive as commanded.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.sim.devices import drive
from crs_cc.sim.devices.bumper.state import bumper_state
from crs_cc.sim.devices.waits import when
from crs_cc.sim.engine.quiet_time import MARGIN, NEVER

if TYPE_CHECKING:
    from crs_cc.sim.engine.world_data import WorldData


def is_calm(data: WorldData, devices: Iterable[str]) -> bool:
    """Return whether it is calm now.

    Args:
        data: the world.
        devices: those that must not be degraded, as kernels know them as they should be.
    """
    state, constants = data.state, data.constants
    if data.is_weary or not drive.moves_as_commanded(state, constants):
        return False
    if np.count_nonzero(state.drive.hindered):
        return False
    if np.count_nonzero(bumper_state(state).pressed) or len(state.contacts_before):
        return False
    if len(state.pos_data.reported) or data.log.snapshot():
        return False
    if any(constants.degradations.affects(state, device) for device in devices):
        return False
    messages = state.messages
    rest = messages.receptions, messages.packets, messages.shuts, messages.outbox
    return not any(map(len, rest)) and data.physics.calm_cycles(state.bodies)[0] > 0


def cycles_to_event(data: WorldData) -> int:
    """Return the number of cycles that may end before the next known event."""
    state = data.state
    known_s = float(state.degradation.next_s), data.due_s, data.goals.due_s(state)
    event_s = min(*known_s, _wait_ends_s(data))
    if not event_s < NEVER * data.timestep_s:
        return NEVER
    return int(event_s / data.timestep_s) - MARGIN - state.cycle


def _wait_ends_s(data: WorldData) -> float:
    """Return when the first wait may end, also as its robot's command timeout expires."""
    state = data.state
    if not np.count_nonzero(state.waits.code):
        return math.inf
    waiting = state.waits.code.nonzero()[0]
    ends_s = np.minimum(when(data.waits, state, waiting), state.drive.deadline_s[waiting])
    return float(ends_s.min())
