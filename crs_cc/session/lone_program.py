"""Cycles of a world in which nothing happens, and only one program runs.

They are what they are in `Session`: the program gets the fuel that it needs to reach the end of the
cycle, is suspended when it has used that up, and its clock advances by what it has used. But as
there is nobody else, no array over robots is searched, and the cycles of the environment are
skipped together afterwards.
"""

from __future__ import annotations

import math

from crs_cc.requests import SUSPENDED
from crs_cc.session.session_state import SessionState


def run_alone(state: SessionState, robot: int, until: int) -> tuple[int, bool]:
    """Run a program until it stops, or has used up its cycles.

    Args:
        state: changed in place, except for the number of timesteps; the program can run.
        robot: its robot.
        until: the first cycle in which it is not alone.

    Returns:
        the number of cycles that it has used up, and whether it has stopped in the one after these,
        at a request, a breakpoint or its end; then its round is to be ended.
    """
    fleet, begin = state.fleet, state.environment.cycle
    timestep_s, speed_hz = state.environment.timestep_s, float(state.speed_hz[robot])
    clock_s, used = float(state.clock_s[robot]), 0
    slot = fleet.slots[robot : robot + 1]
    run, fuel, status, code = (slot[name] for name in ("run", "fuel", "status", "code"))
    cycle, budget = begin, 0
    while cycle < until:
        end_s = (cycle + 1) * timestep_s
        if clock_s >= end_s:
            cycle, state.rounds = cycle + 1, 0
            continue
        budget = math.ceil((end_s - clock_s) * speed_hz)
        run[0], fuel[0] = 1, budget
        state.halted = fleet.run_round()
        if status[0] != SUSPENDED or code[0] or state.halted is not None:
            break
        burnt = budget - int(fuel[0])
        used += burnt
        clock_s += burnt / speed_hz
        state.rounds += 1
    state.fuel[robot] += used
    state.clock_s[robot] = clock_s
    stopped = cycle < until
    if stopped:
        state.pending[robot] = budget
    return cycle - begin, stopped
