"""Quiet time: cycles in which nothing observable can happen.

In a world at rest, a cycle changes only what is a function of time: its number, the time to which
the axes have been turned, the physics' count of cycles, and the sonars' firings, whose echoes are
those of a world at rest. So any number of such cycles is executed at once, when the state is read,
with the same result to the last bit.

A world is at rest if no body and no axis moves, nothing is touched, held or pressed, no message is
on its way, and no degradation acts on a drive. It stays so until the next event whose time is
known: a measurement by a timer, the end of a wait or of a command timeout, the onset or end of a
degradation or an outage, a robot that joins or leaves, a time of a goal. Requests come from
outside.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.sim.devices.bumper.state import bumper_state
from crs_cc.sim.devices.waits import when

if TYPE_CHECKING:
    from crs_cc.sim.engine.world_data import WorldData
    from crs_cc.sim.state.env_state import EnvState

NEVER: Final = 2**53
"""A cycle that is never reached; doubles are exact up to here."""

MARGIN: Final = 2
"""Cycles before an event: a wait that ends in a cycle is reported by the one before; rounding."""
_MOTIONS: Final = ("drive", "wheels", "odometry")


def quiet_until(data: WorldData) -> int:
    """Return a cycle before which nothing can happen: the current one if something can now.

    Nothing must have been changed since before the last cycle, which was executed. So all that
    follows a change by a cycle is in the state already: another cycle at rest changes nothing.
    """
    cycle = data.state.cycle
    if not _is_at_rest(data):
        return cycle
    event_s = _next_event_s(data)
    if not event_s < NEVER * data.timestep_s:
        return NEVER
    return max(cycle, int(event_s / data.timestep_s) - MARGIN)


def catch_up(data: WorldData, cycles: int) -> None:
    """Execute the quiet cycles before the current one, whose number has been advanced already."""
    state, constants = data.state, data.constants
    present = np.flatnonzero(state.presence.present)
    until_s = np.full(len(present), constants.last_time_s(state.cycle - 1))
    data.devices.sonars.catch_up(state, constants, data.rays, present, until_s)
    state.drive.clock_s[present] = data.time_s
    data.physics.skip(state.bodies, cycles)
    data.devices.fields.skip(state, cycles)
    data.goals.skip(state, cycles)


def _is_at_rest(data: WorldData) -> bool:
    state = data.state
    moves = state.bodies.velocity_mps.any() or not _axes_stand(state)
    if moves or state.bodies.spin_radps.any() or state.bodies.slipping.any():
        return False
    if state.drive.hindered.any() or len(state.contacts_before) or state.bodies.touching.any():
        return False
    if bumper_state(state).pressed.any() or state.bodies.holds.any() or data.log.snapshot():
        return False
    if any(data.constants.degradations.affects(state, device) for device in _MOTIONS):
        return False
    devices = data.devices
    if not (devices.handling.is_idle(state) and devices.messenger.is_idle(state)):
        return False
    return data.physics.is_idle(state.bodies)


def _axes_stand(state: EnvState) -> bool:
    """Return whether all axes have come to rest, and are where their motions end."""
    axes = state.drive.axes
    moving = axes.speed.any() or (axes.travelled != axes.total).any()
    return not moving and bool((axes.end_s() <= state.drive.clock_s[:, None]).all())


def _next_event_s(data: WorldData) -> float:
    """Return the time of the next event that is known; infinite for none."""
    state, waiting = data.state, np.flatnonzero(data.state.waits.code)
    times = [
        state.timers.soonest_s[state.presence.present],
        state.drive.deadline_s,
        when(data.waits, state, waiting),
        data.devices.messenger.outages_s(state),
    ]
    known_s = min(state.degradation.next_s, data.due_s, data.goals.due_s(state))
    return min(float(known_s), *(float(each.min(initial=np.inf)) for each in times))
