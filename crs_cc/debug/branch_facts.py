"""The comparable state of a branch at many timesteps, without switching to it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from crs_cc.debug.branch_comparison import Facts, facts
from crs_cc.debug.timeline.position import Position

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.debug.engine import Debugger


def branch_facts(debugger: Debugger, name: str, timesteps: Sequence[int]) -> list[Facts]:
    """Return the comparable states of a branch at the starts of timesteps.

    The run is where it was afterwards, in the branch in which it was, and so is the other branch.

    Raises:
        DebugError: there is no such branch.
    """
    branches, run, view = debugger.branches, debugger.run, debugger.view
    own, here = branches.current, debugger.position
    looked_at = view.robot, view.frame, debugger.stop
    if name != own.name:
        branches.visit(name)
    shown = branches.current
    there = here if shown is own else shown.position
    found = []
    try:
        run.seek(there)
        if run.event_history.timesteps < timesteps[-1]:
            debugger.goto_timestep(timesteps[-1])
        for timestep in timesteps:
            run.seek(Position(timestep, 0))
            found.append(facts(view))
    finally:
        if shown is not own:
            branches.visit(own.name)
            shown.position = there
        run.seek(here)
        view.robot, view.frame, debugger.stop = looked_at
    return found
