"""Quiet time: programs advance through timesteps in which nothing happens in the world.

See `sim/engine/quiet_time.py` for what is quiet. The timesteps are only counted.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.session.session_state import NEVER_S

if TYPE_CHECKING:
    from crs_cc.core.arrays import IndexArray
    from crs_cc.session.session_state import SessionState

_NOBODY: Final = np.zeros(0, np.intp)


class QuietPrograms:
    """The quiet time of a session's programs."""

    def __init__(self, state: SessionState) -> None:
        """Prepare for quiet time in a session, given its state."""
        self._state = state

    def run(self, end: int, answer: Callable[[IndexArray], None]) -> None:
        """Run timesteps, up to a number of them, in which nothing happens in the world.

        Return before one in which several programs run or a request arrives, and in one in which
        the only program that runs has stopped.

        Args:
            end: the maximum number of timesteps.
            answer: answers programs that have asked for anything.
        """
        state, environment = self._state, self._state.environment
        until = min(environment.quiet_until(), environment.cycle + end - state.timesteps)
        until = min(until, state.network.next_cycle() - 1)
        while environment.cycle < until:
            on_link = state.due_s < NEVER_S
            runs_s = np.where(state.alive & ~on_link, state.clock_s, state.due_s)
            first = int(runs_s.argmin())
            self.skip(self._cycle_of(float(runs_s[first]), until) - environment.cycle)
            runs_s[first], is_request = NEVER_S, bool(on_link[first])
            alone_until = self._cycle_of(float(runs_s.min()), until)
            if is_request or environment.cycle >= alone_until:
                return
            if not self._run_alone(first, alone_until, answer):
                return

    def _run_alone(self, robot: int, until: int, answer: Callable[[IndexArray], None]) -> bool:
        """Run a program in quiet cycles in which no other runs; return False if it asks for more.

        Args:
            robot: its robot.
            until: the first cycle in which it is not alone.
            answer: answers it.
        """
        state, environment = self._state, self._state.environment
        timestep_s, begin = environment.timestep_s, environment.cycle
        clock_s = state.clock_s[robot : robot + 1]
        requesting, cycle, rounds = _NOBODY, begin, state.rounds
        while cycle < until and not requesting.size:
            end_s = (cycle + 1) * timestep_s
            if clock_s[0] < end_s:
                rounds += state.fleet.run_rounds(end_s)
                requesting = state.fleet.take_requesting()
            if not requesting.size:
                cycle, rounds = cycle + 1, 0
        self.skip(cycle - begin)
        state.rounds = rounds
        answer(requesting)
        return not requesting.size

    def skip(self, cycles: int) -> None:
        """End quiet cycles whose programs have used them up."""
        if cycles:
            self._state.environment.skip(cycles)
            self._state.timesteps += cycles
            self._state.rounds = 0

    def _cycle_of(self, time_s: float, last: int) -> int:
        """Return the cycle of a time, at least the current one and at most `last`."""
        timestep_s, first = self._state.environment.timestep_s, self._state.environment.cycle
        if time_s >= last * timestep_s:
            return last
        cycle = max(int(time_s / timestep_s) - 1, first)
        while time_s >= (cycle + 1) * timestep_s:
            cycle += 1
        return cycle
