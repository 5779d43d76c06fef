"""The heat sensor of the CRS report: the total heat around the robot.

    reading = round(sum over all other objects within the range of heat * share(distance))
    share(distance) = 1, or if the object has a spread, max(0, 1 - distance / spread)

The distance of an object is that of its nearest point from the robot's centre. Direction and
obstacles have no effect: the purpose of the sensor is "to find the density of objects with heat in
an area" (report, 4.3.3). So an object of heat 1 without a spread reads 1 anywhere in the range; one
with a spread can be found by following the gradient. The formula was chosen by us, the report has
none. Objects are at their positions at the start of the timestep. It measures on request, or on its
timer. Degradation (`heat`): a dropped or negative value reads 0.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.requests import LARGEST
from crs_cc.sim.devices.timers import read_on_request
from crs_cc.sim.geometry.cell_list import CellList
from crs_cc.sim.state.timers import HEAT

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


def read(
    state: EnvState,
    constants: RobotConstants,
    _around: RayCaster,
    rows: IndexArray,
    at_s: FloatArray,
) -> None:
    """Measure with heat sensors.

    Args:
        state: changed in place.
        constants: the robots' constants.
        rows: robots with such a sensor, k of them.
        at_s: the time of each, shape (k,).
    """
    sensed = _heat(state, constants, rows)[:, None]
    sensed = constants.degradations.alter(state, "heat", rows, sensed, at_s)
    mine = constants.heat[rows]
    state.heat_sensor.reading[mine] = np.nan_to_num(sensed[:, 0])
    state.heat_sensor.at_s[mine] = at_s


def get_heat(context: RequestContext) -> BoolArray:
    """Answer HEAT and SENSE_HEAT with the heat around; refuse robots without such a sensor."""
    mine = context.constants.heat[context.rows]
    has = np.asarray(mine >= 0)
    read_on_request(context, read, HEAT, has)
    reading = context.state.heat_sensor.reading[mine[has]]
    context.clear_data()
    context.put("heat", np.clip(np.rint(reading), 0.0, LARGEST).astype(np.int32), has)
    return has


def _heat(state: EnvState, constants: RobotConstants, rows: IndexArray) -> FloatArray:
    """Return the heat around robots, (k,)."""
    robot, thing, distance_m = hot_things(state, constants, rows, constants.heat_range_m[rows])
    share = np.clip(1.0 - distance_m / constants.shapes.spread_m[thing], 0.0, 1.0)
    heat = np.bincount(robot, share * state.heat.left[thing], minlength=len(rows))
    return heat.astype(np.float64)


def hot_things(
    state: EnvState, constants: RobotConstants, rows: IndexArray, range_m: FloatArray
) -> tuple[IndexArray, IndexArray, FloatArray]:
    """Return pairs of a robot and a hot object, other than itself, in its range.

    Args:
        state: the state.
        constants: the robots' and the objects' constants.
        rows: robots, k of them.
        range_m: maximum range of each, (k,).

    Returns:
        the robot of each pair, as an index into `rows`, the object, as in `Scene.names`, and
            their distance.
    """
    hot = np.flatnonzero(state.heat.left > 0.0)
    if not len(hot):
        return hot, hot, np.zeros(0)
    things = constants.shapes
    poses = things.poses(state.bodies)
    reach_m = float(range_m.max(initial=0.0) + things.reach_m[hot].max())
    x_m, y_m = state.x_m[rows], state.y_m[rows]
    robot, found = CellList(poses[hot, 0], poses[hot, 1], reach_m).near(x_m, y_m)
    thing = hot[found]
    distance_m = things.distance_m(poses, thing, x_m[robot], y_m[robot])
    near = (distance_m <= range_m[robot]) & (thing != rows[robot])
    return robot[near], thing[near], distance_m[near]
