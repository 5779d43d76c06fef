"""A state with room for one more robot: old rows stay, the new one is as at the start of a run.

Every part of the state has a row for each robot, or for each that has some device, in the order of
the robots. So what the new robot needs is what the start of a run with it has behind what the start
without it has. The arrays that list the robots and then other things get their row in between.
"""

from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from typing import Any

import numpy as np

from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.env_state import EnvState


def grown(state: EnvState, world: WorldModel) -> EnvState:
    """Return a state of a world whose last robot is new, and has not joined yet.

    Args:
        state: the state without it; arrays may be shared with it.
        world: the world with it.
    """
    robots, robot = len(world.robots) - 1, world.robots[-1]
    before = EnvState.at_start(replace(world, robots=world.robots[:-1]))
    larger: EnvState = _grown(state, before, EnvState.at_start(world))
    larger.presence = state.presence.with_another()
    larger.bodies = state.bodies.with_robot(robot.start)
    things = len(state.heat.left)
    larger.heat.left = np.insert(state.heat.left, robots, 0.0)
    toucher, touched = np.divmod(state.contacts_before, things)
    larger.contacts_before = toucher * (things + 1) + touched + (touched >= robots)
    return larger


def _grown(value: Any, before: Any, after: Any) -> Any:
    """Return a value, behind it what one has after that the other did not have before."""
    if is_dataclass(value) and not isinstance(value, type):
        names = [field.name for field in fields(value)]
        parts = ([getattr(each, name) for each in (value, before, after)] for name in names)
        return type(value)(*(_grown(*three) for three in parts))
    if isinstance(value, np.ndarray):
        more = after[len(before) :]
        return np.concatenate([value, more]) if len(more) else value
    if isinstance(value, tuple):
        return value + after[len(before) :]
    return value
