"""The map of a run: the world, the paths of its robots, and their contacts."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.debug.world import world_map

if TYPE_CHECKING:
    from crs_cc.debug.view import View

_MAX_PATHS: Final = 30  # more are unreadable


def run_map(
    view: View, columns: int, rows: int, *, robot: int = -1, across_m: float | None = None
) -> world_map.WorldMap:
    """Draw the current state of a run.

    Args:
        view: the run.
        columns: the width [cells], at least 1.
        rows: the height [cells], at least 1.
        robot: the robot whose sensors' echoes are drawn, -1 for none.
        across_m: the size of the window around that robot [m]; None for the whole world.
    """
    environment, event_history = view.session.environment, view.run.event_history
    timestep, state = view.position.timestep, environment.state
    here = np.column_stack([state.x_m, state.y_m])
    paths = [
        np.concatenate([path, here[number : number + 1]]) if len(path) else path
        for number, path in enumerate(event_history.paths(timestep)[:_MAX_PATHS])
    ]
    if across_m is None:
        seen = world_map.MapWindow.whole(environment, columns, rows, paths)
    else:
        seen = world_map.MapWindow.around(environment, robot, columns, rows, across_m)
    contacts = event_history.contacts(timestep)
    return world_map.WorldMap(environment, seen, robot=robot, paths=paths, contacts=contacts)
