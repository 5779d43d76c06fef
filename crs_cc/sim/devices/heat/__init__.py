"""The heat sensor of the CRS report: the total heat around the robot.

    reading = round(sum over all other objects within the range of heat * share(distance))
    share(distance) = 1, or if the object has a spread, max(0, 1 - distance / spread)

The distance of an object is that of its nearest point from the robot's centre. Direction and
obstacles have no effect: the purpose of the sensor is "to find the density of objects with heat in
an area" (report, 4.3.3). An object of heat 1 without a spread therefore reads 1 anywhere in the
range; one with a spread can be found by following the gradient. The formula was chosen by us; the
report has none. Objects are at their positions at the start of the timestep. The sensor measures on
request, or on its timer. Degradation (`heat`): a dropped or negative value reads 0.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.core.quantity import HEAT, LENGTH
from crs_cc.requests import LARGEST, device_request
from crs_cc.requests.request import fields
from crs_cc.robot_api.row import OURS, Function
from crs_cc.sim.devices.sensor import Measurement, Readings, Sensor, last_values, listed
from crs_cc.sim.files.device_elements import read_attributes
from crs_cc.sim.geometry.cell_list import CellList
from crs_cc.sim.model.attribute import attribute, period
from crs_cc.sim.model.degradable import Degradable, elements_of
from crs_cc.sim.model.device import Device

if TYPE_CHECKING:
    from crs_cc.sim.devices.installed import Installed
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.files.document import Element, Reader
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.events import EventLog


@dataclass(frozen=True, slots=True)
class Heat:
    """A heat sensor and a tagging device, which removes heat."""

    range_m: float = attribute(
        "range", LENGTH, None, "Range, measured from the centre of the robot."
    )
    tag_range_m: float = attribute(
        "tag-range", LENGTH, "", "Range of tagTarget(). Default: the range of the sensor."
    )
    period_s: float = period()


def heat_and_tag(root: Element, reader: Reader) -> Heat | None:
    """Return the sensor that an element of a robot definition describes; None without it."""
    element = root.find_child("heat")
    if element is None:
        return None
    heat: Heat = read_attributes(Heat, element, reader)
    return heat if "tag-range" in element.attributes else replace(heat, tag_range_m=heat.range_m)


def read(root: Element, reader: Reader) -> Heat | None:
    """Return the heat sensor of a robot definition, None for a robot without one."""
    heat = heat_and_tag(root, reader)
    return heat if heat is not None and heat.range_m > 0.0 else None


def measure(now: Measurement) -> FloatArray:
    """Return the heat around robots, (k, 1)."""
    range_m = now.settings["range_m"]
    robot, obj, distance_m = hot_objects(now.state, now.constants, now.rows, range_m)
    share = np.clip(1.0 - distance_m / now.constants.shapes.spread_m[obj], 0.0, 1.0)
    heat = np.bincount(robot, share * now.state.heat.left[obj], minlength=len(now.rows))
    return heat.astype(np.float64)[:, None]


def hot_objects(
    state: EnvState, constants: RobotConstants, rows: IndexArray, range_m: FloatArray
) -> tuple[IndexArray, IndexArray, FloatArray]:
    """Return pairs of a robot and a hot object, other than itself, in its range.

    Returns:
        the robot of each pair, as an index into `rows`, the object, as in `Scene.names`, and
            their distance.
    """
    hot = np.flatnonzero(state.heat.left > 0.0)
    if not len(hot):
        return hot, hot, np.zeros(0)
    objects = constants.shapes
    poses = objects.poses(state.bodies)
    reach_m = float(range_m.max(initial=0.0) + objects.reach_m[hot].max())
    x_m, y_m = state.x_m[rows], state.y_m[rows]
    robot, found = CellList(poses[hot, 0], poses[hot, 1], reach_m).near(x_m, y_m)
    obj = hot[found]
    distance_m = objects.distance_m(poses, obj, x_m[robot], y_m[robot])
    near = (distance_m <= range_m[robot]) & (obj != rows[robot])
    return robot[near], obj[near], distance_m[near]


def install(row: Device, world: WorldModel, seed: int, _log: EventLog) -> Installed:
    """Return the heat sensors of a world's robots."""
    sensors = Sensor(row, world, seed, measure, 1, missing=0.0)

    def get_heat(context: RequestContext) -> BoolArray:
        """Answer HEAT and SENSE_HEAT with the heat around; refuse robots without such a sensor."""
        has, mine = sensors.measure_on_request(context)
        heat = sensors.readings(context.state).value[mine, 0]
        context.clear_data()
        context.put("heat", np.clip(np.rint(heat), 0.0, LARGEST).astype(np.int32), has)
        return has

    return sensors.installed({"HEAT": get_heat, "SENSE_HEAT": get_heat})


DEVICE = Device(
    name="heat",
    title="Heat sensor",
    element="heat",
    summary="An omnidirectional heat sensor; programs use it with heatSensorCheck() and tagTarget()"
    " (CRS report), or crs_heat() and crs_tag() (crs.h).",
    model=Heat,
    read=read,
    state=lambda models: Readings.never(len(models), 1),
    install=install,
    requests=(
        device_request(
            "SENSE_HEAT", 203, "int crs_heat(int *heat)", "reads the heat sensor",
            results=fields(("heat", "i[0]", "1", "the heat")),
        ),
    ),
    functions=(
        Function(
            "int crs_heat(int *heat)", "measures the total heat of the objects in range",
            posts=("SENSE_HEAT",), source=(OURS,),
        ),
    ),
    degradables=(
        Degradable(
            "heat", "heat that is read", HEAT, elements_of("heat", lambda _model: ("0",)), 1,
            "the reading is 0",
        ),
    ),
    inspect=listed("heat", 1),
    reading=last_values("heat"),
    number=2,
    source=__file__,
)  # fmt: skip
