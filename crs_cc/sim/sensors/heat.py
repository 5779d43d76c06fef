"""The heat sensor of the CRS report: how much heat there is around the robot.

    reading = round(sum of the heat of all other things within the range)

A thing is within the range when its nearest point is, seen from the robot's middle. Direction,
distance and what stands between count for nothing: the sensor is there "to find the density of
objects with heat in an area" (report, 4.3.3). So a thing of heat 1 reads 1 wherever in the range it
is. The law was chosen by us, the report has none. Things are where they were at the start of the
cycle. Degradation (`heat`): nothing, or less than nothing, reads 0.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from crs_cc.sim.neighbours import CellList

if TYPE_CHECKING:
    from crs_cc.sim.equipment import Equipment
    from crs_cc.sim.state import EnvState

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]
IndexArray = npt.NDArray[np.intp]
Messages = npt.NDArray[np.void]

_LARGEST: Final = 2**31 - 1


def sense(state: EnvState, equipment: Equipment, rows: IndexArray, messages: Messages) -> BoolArray:
    """Answers with the heat around each robot; refuses robots that have no such sensor."""
    range_m = equipment.heat_range_m[rows]
    robot, thing = hot_things(state, equipment, rows, range_m)
    heat = np.bincount(robot, state.heat.left[thing], minlength=len(rows)).astype(np.float64)
    heat = equipment.degradations.alter(
        state, "heat", rows, heat[:, None], state.drive.clock_s[rows]
    )[:, 0]
    heat = np.where(np.isnan(heat), 0.0, heat)
    messages["size"] = 0
    messages["i"][:, 0] = np.clip(np.rint(heat), 0.0, _LARGEST).astype(np.int32)
    return np.asarray(range_m > 0.0)


def hot_things(
    state: EnvState, equipment: Equipment, rows: IndexArray, range_m: FloatArray
) -> tuple[IndexArray, IndexArray]:
    """Gives pairs of a robot and a hot thing, other than itself, in its range.

    Args:
        state: the state.
        equipment: the robots' and the things' constants.
        rows: robots, k of them.
        range_m: how far each looks, (k,).

    Returns:
        the robot of each pair, as an index into `rows`, and the thing, as in `Scene.names`.
    """
    hot = np.flatnonzero(state.heat.left > 0.0)
    if not len(hot):
        return hot, hot
    things = equipment.things
    poses = things.poses(state.bodies)
    reach_m = float(range_m.max(initial=0.0) + things.reach_m[hot].max())
    x_m, y_m = state.x_m[rows], state.y_m[rows]
    robot, found = CellList(poses[hot, 0], poses[hot, 1], reach_m).near(x_m, y_m)
    thing = hot[found]
    near = things.distance_m(poses, thing, x_m[robot], y_m[robot]) <= range_m[robot]
    near &= thing != rows[robot]
    return robot[near], thing[near]
