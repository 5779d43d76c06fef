"""Calm time: programs and the kernel that answers them take turns without Python.

See `sim/engine/calm_time.py` for what is calm, `runtime/partner.py` for how they take turns. What
this cannot do, the session does as always: each way of a run gives the same states and output.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import any_of
from crs_cc.sim.kernels.calm import ASKED, DRAWN, FULL, MAX_ROWS, REFUSED, CalmKernel
from crs_cc.sim.kernels.program import executable

if TYPE_CHECKING:
    from crs_cc.runtime.partner import Partner, Turns
    from crs_cc.session.hints import Hints
    from crs_cc.session.session_state import SessionState
    from crs_cc.sim.engine.calm_time import CalmTime
    from crs_cc.sim.engine.passage import Passage

_AGAIN: Final = frozenset({FULL, DRAWN})
_NEVER: Final = -1


class CalmPrograms:
    """The calm time of a session's programs.

    Attributes:
        is_allowed: whether there is any; only tests switch it off.
        is_worthwhile: whether anything was done in it when it was last tried, or something has been
            asked of a robot since; programs that print do so without it.
        passages: the passages since they were last taken, if an observer needs them.
    """

    def __init__(self, state: SessionState, hints: Hints) -> None:
        self._state, self._hints = state, hints
        self._partner: Partner | None = None
        self._turns: tuple[int, Turns] | None = None  # with slots at an address
        self._calm: CalmTime | None = None
        self._robots = 0  # that it was made for
        self._refused = _NEVER  # the cycle in which it was not calm
        self.is_allowed, self.is_worthwhile = True, False
        self.passages: list[Passage] = []

    def run(self, cycles: int, *, keeps: bool) -> int:
        """Run programs and cycles while it is calm.

        Args:
            cycles: how many cycles may end at most; with 0, programs use up the current one.
            keeps: whether an observer needs the passages.

        Returns:
            why it has ended, see `kernels.calm`: `REFUSED` if the session must continue by itself.
        """
        state, hints = self._state, self._hints
        environment = state.environment
        if not (self.is_allowed and self.is_worthwhile) or len(state.fleet) > MAX_ROWS:
            return REFUSED
        if environment.cycle == self._refused or hints.follows_moves or state.network.is_used:
            return REFUSED
        calm, most = self._calm_time(), hints.most_units()
        if calm is None or self._partner is None:
            return REFUSED
        while True:
            if not environment.begin_calm(calm, cycles, keeps=keeps, most=most):
                self._refused = environment.cycle
                return REFUSED
            verdict, ended = self._turn(calm, self._partner)
            cycles -= ended
            if verdict not in _AGAIN or not cycles:
                return verdict

    def _turn(self, calm: CalmTime, partner: Partner) -> tuple[int, int]:
        """Run programs and kernel alternately once; return why they ended, and the cycles."""
        state, kernel = self._state, calm.kernel
        kernel.tell(rounds=state.rounds)
        rounds = self._turns_with(kernel, partner).take()
        outcome = state.environment.end_calm(calm)
        verdict, ended = outcome.verdict, outcome.ended
        state.timesteps += ended
        state.rounds = outcome.rounds + rounds
        called_s = kernel.table("called", len(state.called_s))
        is_called = called_s > -np.inf
        self.is_worthwhile = bool(ended) or verdict != ASKED or any_of(is_called)
        np.copyto(state.called_s, called_s, where=is_called)
        called_s[:] = -np.inf
        if outcome.passage is not None:
            self.passages.append(outcome.passage)
        return verdict, ended

    def _turns_with(self, kernel: CalmKernel, partner: Partner) -> Turns:
        """Return the turns of the programs and the kernel, with its current tables."""
        records = kernel.address("records")
        if self._turns is None or self._turns[0] != records:
            self._turns = records, partner.turns(kernel.turn, records, self._robots)
        return self._turns[1]

    def _calm_time(self) -> CalmTime | None:
        """Return the kernel's calm time, started on first use; None if there can be none."""
        robots = len(self._state.fleet)
        if robots != self._robots:
            self._robots, self._calm, self._turns = robots, None, None
            if robots <= MAX_ROWS and self._partner is None:
                self._partner = self._state.fleet.partner(executable(checked=False))
            if robots <= MAX_ROWS and self._partner is not None:
                kernel = CalmKernel(self._partner.instance)
                self._calm = self._state.environment.calm_time(kernel)
        return self._calm
