"""Tagging: removes the heat of all objects nearby, so that no robot senses them any more.

"All the object in the radius of three from the robot will no more possess any heat" (CRS report,
appendix A, `tagTarget`). Distances are those of the heat sensor (`heat`), with a range of its own;
the robot itself keeps its heat. Degradation (`tag`) applies to the range; if it is dropped no
object loses its heat.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray
from crs_cc.core.quantity import LENGTH
from crs_cc.core.source import Diagnostics
from crs_cc.requests import device_request
from crs_cc.requests.request import fields
from crs_cc.robot_api.row import OURS, Function
from crs_cc.sim.devices import heat
from crs_cc.sim.devices.installed import Installed
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.degradable import Degradable, elements_of
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.robot import RobotModel, devices_of

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.events import EventLog


_NOTHING_M: Final = -1.0  # below every distance


@dataclass(frozen=True, slots=True)
class Tag:
    """A tagging device.

    Attributes:
        range_m: its range from the robot's centre.
    """

    range_m: float


def read(root: Element, reader: Reader) -> Tag | None:
    """Return the tagging device of a robot definition, None for a robot without one.

    It has no element of its own: the heat sensor's describes it, and reports errors.
    """
    found = heat.heat_and_tag(root, Reader(reader.file, Diagnostics()))
    return Tag(found.tag_range_m) if found is not None and found.tag_range_m > 0.0 else None


def write(robot: RobotModel) -> list[Element]:
    """Return the heat sensor's element for a robot without a heat sensor, else none."""
    tag: Tag | None = robot.device("tag")
    if tag is None or robot.device("heat") is not None:
        return []
    ranges = {"range": LENGTH.exact(0.0), "tag-range": LENGTH.exact(tag.range_m)}
    return [Element("heat", 0, ranges)]


def install(row: Device, world: WorldModel, _seed: int, _log: EventLog) -> Installed:
    """Return the handler of TAG and TAKE_HEAT."""
    found = devices_of([robot.model for robot in world.robots], row.name)
    ranges_m = np.array([tag.range_m for tag in found if tag is not None])

    def tag(context: RequestContext) -> BoolArray:
        """Remove the heat nearby, and answer with the number of objects; refuse robots without."""
        state, constants = context.state, context.constants
        numbers = constants.numbers[row.name][context.rows]
        has = np.asarray(numbers >= 0)
        rows, range_m = context.rows[has], ranges_m[numbers[has]]
        reach_m = constants.degradations.alter(
            state, row.name, rows, range_m[:, None], state.drive.clock_s[rows]
        )[:, 0]
        reach_m = np.where(np.isnan(reach_m), _NOTHING_M, reach_m)
        robot, obj, _ = heat.hot_objects(state, constants, rows, reach_m)
        state.heat.left[obj] = 0.0
        context.clear_data()
        context.put("objects", np.bincount(robot, minlength=len(rows)), has)
        return has

    return Installed(handlers={"TAG": tag, "TAKE_HEAT": tag})


DEVICE = Device(
    name="tag",
    title="Tagging device",
    element="",
    summary="Removes the heat of all objects in range.",
    model=Tag,
    read=read,
    write=write,
    install=install,
    requests=(
        device_request(
            "TAKE_HEAT", 229, "int crs_tag(void)", "removes the heat of all objects in range",
            results=fields(("objects", "i[0]", "1", "number of objects that lost heat")),
        ),
    ),
    functions=(
        Function(
            "int crs_tag(void)",
            "removes the heat of all objects in range, like tagTarget() of the CRS report; returns"
            " the number of objects, -1 if the robot cannot do this",
            posts=("TAKE_HEAT",), source=(OURS,),
        ),
    ),
    degradables=(
        Degradable(
            "tag", "tagging range", LENGTH, elements_of("tag", lambda _model: ("0",)), 1,
            "tagging has no effect", acts=True,
        ),
    ),
    source=__file__,
)  # fmt: skip
