"""Adding a robot to a state: existing rows are kept, the new one has its initial values.

Every part of the state has a row for each robot, or for each that has some device, in the order of
the robots. So the rows of the new robot are those by which the initial state of a world with it
alone is longer than that of an empty one. Arrays that list the robots and then other objects get
their row in between.
"""

from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from typing import Any

import numpy as np

from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.env_state import EnvState


def grown(state: EnvState, world: WorldModel) -> EnvState:
    """Return a state extended by a world's last robot, which is new and has not joined yet.

    Args:
        state: the state without it; the result may share arrays with it.
        world: the world with it.
    """
    robots, robot = len(world.robots) - 1, world.robots[-1]
    empty = replace(
        world, robots=(), walls=(), boxes=(), cylinders=(), polygons=(), degradations=()
    )
    alone = replace(empty, robots=(robot,))
    larger: EnvState = _grown(state, EnvState.at_start(empty), EnvState.at_start(alone))
    larger.presence = state.presence.with_another()
    larger.bodies = state.bodies.with_robot(robot.start)
    objects = len(state.heat.left)
    larger.heat.left = np.insert(state.heat.left, robots, 0.0)
    toucher, touched = np.divmod(state.contacts_before, objects)
    larger.contacts_before = toucher * (objects + 1) + touched + (touched >= robots)
    return larger


def _grown(value: Any, before: Any, after: Any) -> Any:
    """Return a value, followed by the rows of `after` that `before` lacks."""
    if is_dataclass(value) and not isinstance(value, type):
        three = (value, before, after)
        names = [field.name for field in fields(value)]
        return type(value)(**{name: _grown(*(getattr(e, name) for e in three)) for name in names})
    if isinstance(value, np.ndarray):
        more = after[len(before) :]
        return np.concatenate([value, more]) if len(more) else value
    if isinstance(value, tuple):
        return value + after[len(before) :]
    return value
