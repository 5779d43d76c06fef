"""Tagging: takes the heat from all things near, so that no robot senses them any more.

"All the object in the radius of three from the robot will no more possess any heat" (CRS report,
appendix A, `tagTarget`). What is near is what the heat sensor says (`sensors.heat`), within a range
of its own; the robot itself keeps its heat.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from crs_cc.sim.sensors.heat import hot_things

if TYPE_CHECKING:
    from crs_cc.sim.equipment import Equipment
    from crs_cc.sim.state import EnvState

BoolArray = npt.NDArray[np.bool_]
IndexArray = npt.NDArray[np.intp]
Messages = npt.NDArray[np.void]


def tag(state: EnvState, equipment: Equipment, rows: IndexArray, messages: Messages) -> BoolArray:
    """Takes the heat away, and answers with how many things lost it; refuses robots without."""
    range_m = equipment.tag_range_m[rows]
    robot, thing = hot_things(state, equipment, rows, range_m)
    state.heat.left[thing] = 0.0
    messages["size"] = 0
    messages["i"][:, 0] = np.bincount(robot, minlength=len(rows))
    return np.asarray(range_m > 0.0)
