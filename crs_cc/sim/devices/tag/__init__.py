"""Tagging: removes the heat of all objects nearby, so that no robot senses them any more.

"All the object in the radius of three from the robot will no more possess any heat" (CRS report,
appendix A, `tagTarget`). Distances are those of the heat sensor (`heat`), with a range of its own;
the robot itself keeps its heat. Degradation (`tag`) applies to the range; if it is dropped no
object loses its heat.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray
from crs_cc.sim.devices.heat import hot_things

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext


_NOTHING_M: Final = -1.0  # below every distance


def tag(context: RequestContext) -> BoolArray:
    """Remove the heat nearby, and answer with the number of objects; refuse robots without."""
    state, constants = context.state, context.constants
    has = np.asarray(constants.tag_range_m[context.rows] > 0.0)
    rows = context.rows[has]
    range_m = constants.tag_range_m[rows]
    reach_m = constants.degradations.alter(
        state, "tag", rows, range_m[:, None], state.drive.clock_s[rows]
    )[:, 0]
    reach_m = np.where(np.isnan(reach_m), _NOTHING_M, reach_m)
    robot, thing, _ = hot_things(state, constants, rows, reach_m)
    state.heat.left[thing] = 0.0
    context.clear_data()
    context.put("things", np.bincount(robot, minlength=len(rows)), has)
    return has
