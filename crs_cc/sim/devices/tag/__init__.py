"""Tagging: takes the heat from all things near, so that no robot senses them any more.

"All the object in the radius of three from the robot will no more possess any heat" (CRS report,
appendix A, `tagTarget`). What is near is what the heat sensor says (`sensors.heat`), within a range
of its own; the robot itself keeps its heat. Degradation (`tag`) is that of the range; without one
nothing loses its heat.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, IndexArray, Records
from crs_cc.sim.devices.heat import hot_things

if TYPE_CHECKING:
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


_NOTHING_M: Final = -1.0  # nothing is so near


def tag(
    state: EnvState, constants: RobotConstants, rows: IndexArray, messages: Records
) -> BoolArray:
    """Takes the heat away, and answers with how many things lost it; refuses robots without."""
    has = np.asarray(constants.tag_range_m[rows] > 0.0)
    rows, range_m = rows[has], constants.tag_range_m[rows[has]]
    reach_m = constants.degradations.alter(
        state, "tag", rows, range_m[:, None], state.drive.clock_s[rows]
    )[:, 0]
    reach_m = np.where(np.isnan(reach_m), _NOTHING_M, reach_m)
    robot, thing, _ = hot_things(state, constants, rows, reach_m)
    state.heat.left[thing] = 0.0
    messages["size"] = 0
    messages["i"][has, 0] = np.bincount(robot, minlength=len(rows))
    return has
