"""The motion of all bodies in a cycle, to the end of which the axes have been advanced."""

from __future__ import annotations

from typing import TYPE_CHECKING

from crs_cc.sim.devices.drive import traction
from crs_cc.sim.engine.falls import log_falls
from crs_cc.sim.engine.step import NO_SLICES, Slices, slices_of
from crs_cc.sim.kernels.tables import ADVANCED, NOT_HANDLED
from crs_cc.sim.state.bodies import NO_CONTACTS, Contacts

if TYPE_CHECKING:
    from crs_cc.sim.engine.world_data import WorldData


def move(data: WorldData, *, tells_slices: bool) -> tuple[Slices, Contacts, list[int]]:
    """Move the bodies along the slices of the cycle, which are complete now, and reset the slices.

    Return the slices if `tells_slices`, the contacts, and the robots whose batteries are empty.
    """
    end_s = data.end_s
    state, constants, handling = data.state, data.constants, data.devices.handling
    before_m = state.bodies.position_m[: len(state.heading_rad)].copy()
    slices, contacts, found = NO_SLICES, NO_CONTACTS, NOT_HANDLED
    times_s = data.timestep_s, end_s
    if data.physics.may_skip_cycle(state.bodies, state.drive.moved_m, traction.facing_rad(state)):
        if tells_slices:
            slices = slices_of(state, data.axes, data.timestep_s)
        found, empty, data.is_weary = state.rows.finish(
            state, (data.timestep_s, end_s), None, constants.kinds
        )
    else:
        pull = handling.pull(state, constants, traction.pull(state, constants), end_s)
        contacts = data.physics.step(state.bodies, pull)
    if found != ADVANCED:
        # Wheels that were held up have not turned; only now the robots' true motion is known.
        displacement_m = state.bodies.position_m[: len(before_m)] - before_m
        traction.apply_contacts(state, constants, displacement_m)
        if tells_slices:
            slices = slices_of(state, data.axes, data.timestep_s)
        log_falls(constants, data.log, end_s, before_m, displacement_m)
        uphill_m = traction.ground_distances_m(constants, before_m, displacement_m)
        total_m = None if uphill_m is None else state.distance_m + uphill_m
        _, empty, data.is_weary = state.rows.finish(state, times_s, before_m, constants.kinds)
        if total_m is not None:
            state.distance_m[:] = total_m
    # Hands grasp what is there now; held objects change the bodies.
    if handling.end_cycle(state, constants, contacts, end_s):
        data.physics.start_from(state.bodies)
    return slices, contacts, empty
