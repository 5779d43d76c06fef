"""Callbacks for the events of a run, by kind.

>>> sorted(EVENT_KINDS)[:4]
['bumper', 'bumper-pressed', 'bumper-released', 'collision']
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.core.suggest import unknown
from crs_cc.debug.world.events import KINDS, WorldEvent, is_of, world_events

if TYPE_CHECKING:
    from crs_cc.core.arrays import BoolArray
    from crs_cc.session.session_state import SessionState
    from crs_cc.sim.engine.passage import Passage
    from crs_cc.sim.engine.step import Step

_EXIT: Final = "exit"

EVENT_KINDS: Final = {
    _EXIT: "a program exited or failed, or its robot left",
    **{kind: text for kind, text in KINDS.items() if kind != "tick"},
}
"""The kinds of events with their meanings."""

Callback = Callable[[WorldEvent], Any]


class EventCallbacks:
    """The functions to call at events; the listener of a session."""

    def __init__(self) -> None:
        self._callbacks: list[tuple[str, Callback]] = []
        self._kinds: list[str] = []
        self._steps: list[Step] = []
        self._alive: BoolArray = np.zeros(0, np.bool_)

    def add(self, kind: str, function: Callback, state: SessionState) -> None:
        """Call a function at each event of a kind from now on.

        Raises:
            ValueError: there is no such kind.
        """
        if not callable(function):
            raise TypeError(f"function must be callable, not {function!r}")
        if kind not in EVENT_KINDS:
            raise ValueError(unknown("event kind", kind, tuple(EVENT_KINDS)))
        self._callbacks.append((kind, function))
        self._kinds = sorted({each for each, _ in self._callbacks} - {_EXIT})
        self._alive = state.alive.copy()

    def restart(self, state: SessionState) -> None:
        """Go on from another state: what has not been reported yet never happened there."""
        self._steps.clear()
        self._alive = state.alive.copy()

    def step(self, step: Step) -> None:
        """Keep a timestep for `report`."""
        if self._kinds:
            self._steps.append(step)

    def passed(self, passage: Passage) -> None:
        """Ignore calm timesteps, in which there are no events."""

    @property
    def are_wanted(self) -> bool:
        """Whether any function is to be called."""
        return bool(self._callbacks)

    def report(self, state: SessionState) -> None:
        """Call the functions for what has happened since the last call."""
        if not self._callbacks:
            return
        steps, self._steps = self._steps, []
        world = state.environment.world
        found = [each for step in steps for each in world_events(step, world, self._kinds)]
        for event in (*found, *self._ends(state)):
            for kind, function in tuple(self._callbacks):
                if is_of(event.kind, [kind]):
                    function(event)

    def _ends(self, state: SessionState) -> list[WorldEvent]:
        """Return an event for each program that has ended since the last call."""
        before, self._alive = self._alive, state.alive.copy()
        ended = before & ~self._alive[: len(before)]
        events = []
        for number in ended.nonzero()[0].tolist():
            result = state.robot_result(number)
            how: str = result.outcome
            if result.exit_status is not None:
                how = f"exited with status {result.exit_status}"
            text = f"{result.id} {how}"
            events.append(WorldEvent(result.time_s, _EXIT, number, text))
        return events
