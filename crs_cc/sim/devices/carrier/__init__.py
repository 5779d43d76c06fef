"""The carrier: takes items from sources and drops them in nests, without a gripper.

It replaces what a study does not want to simulate: items have no body and no weight, and taking
one needs nothing but to be there. A robot carries as many as its `capacity`. Requests of a timestep
are answered in rounds, those of a round in the order of the world's robots: of two robots that take
the last item, the first one gets it. `devices.foraging` describes the places.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int64Array
from crs_cc.requests import device_request
from crs_cc.requests.request import fields
from crs_cc.robot_api.row import OURS, Function
from crs_cc.sim.devices.foraging import Foraging
from crs_cc.sim.devices.installed import Installed
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.model.attribute import Count, attribute
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.robot import devices_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.events import EventLog

_MAX_ITEMS: Final = 1000  # items; our choice


@dataclass(frozen=True, slots=True)
class Carrier:
    """A carrier."""

    capacity: int = attribute(
        "capacity",
        Count(1, _MAX_ITEMS),
        "1",
        f"Maximum number of items that the robot can carry, 1 to {_MAX_ITEMS}.",
    )


@dataclass(slots=True)
class CarrierState:
    """Carriers; arrays have a row for each robot with one, n of them.

    Attributes:
        items: the items on each, (n,).
    """

    items: Int64Array

    @classmethod
    def at_start(cls, models: Sequence[Carrier]) -> CarrierState:
        """Return empty carriers."""
        return cls(np.zeros(len(models), dtype=np.int64))


class Carriers:
    """The carriers of all robots that have one.

    Attributes:
        foraging: the sources and nests.
    """

    def __init__(self, row: Device, world: WorldModel, log: EventLog) -> None:
        self._name = row.name
        self._log = log
        self.foraging = Foraging(world)
        found = devices_of([robot.model for robot in world.robots], row.name)
        self._capacity = np.array([each.capacity for each in found if each is not None])

    def take(self, context: RequestContext) -> BoolArray:
        """Answer TAKE_ITEM; refuse where no source has an item, and robots that are full."""
        items, numbers = self._items(context)
        good: BoolArray = numbers >= 0
        good[good] = items[numbers[good]] < self._capacity[numbers[good]]
        there = self.foraging.in_source(_place_m(context))
        good &= there.any(axis=1)
        for each in np.flatnonzero(good).tolist():
            source = self.foraging.take(context.state, there[each])
            good[each] = source is not None
            if source is not None:
                items[numbers[each]] += 1
                self._say(context, each, f"took an item from '{source.id}'")
        return good

    def drop(self, context: RequestContext) -> BoolArray:
        """Answer DROP_ITEM; refuse where no nest is, and robots that carry nothing."""
        items, numbers = self._items(context)
        good: BoolArray = numbers >= 0
        good[good] = items[numbers[good]] > 0
        there = self.foraging.in_nest(_place_m(context))
        good &= there.any(axis=1)
        for each in np.flatnonzero(good).tolist():
            nest = self.foraging.drop(context.state, there[each])
            assert nest is not None
            items[numbers[each]] -= 1
            self._say(context, each, f"brought an item to '{nest.id}'")
        return good

    def count(self, context: RequestContext) -> BoolArray:
        """Answer ITEMS with the number of items on the robot."""
        items, numbers = self._items(context)
        has: BoolArray = numbers >= 0
        context.put("items", items[numbers[has]], has)
        return has

    def _items(self, context: RequestContext) -> tuple[Int64Array, IndexArray]:
        """Return the items on all carriers, and the number of each robot's; -1 for none, (k,)."""
        items = context.state.device(self._name, CarrierState).items
        return items, context.constants.numbers[self._name][context.rows]

    def _say(self, context: RequestContext, each: int, text: str) -> None:
        at_s, robot = float(context.at_s[each]), int(context.rows[each])
        self._log.say(at_s, "item", text, robot)


def _place_m(context: RequestContext) -> FloatArray:
    """Return the centres of robots, (k, 2)."""
    return mount_poses(context.state, context.constants, context.rows)[:, :2]


def install(row: Device, world: WorldModel, _seed: int, log: EventLog) -> Installed:
    """Return the carriers of a world's robots."""
    carriers = Carriers(row, world, log)
    handlers = {
        "TAKE_ITEM": carriers.take,
        "DROP_ITEM": carriers.drop,
        "ITEMS": carriers.count,
    }
    return Installed(handlers=handlers, device=carriers)


def _inspect(state: EnvState, number: int) -> str:
    items = int(state.device("carrier", CarrierState).items[number])
    return f"{items} item{'' if items == 1 else 's'}"


DEVICE = Device(
    name="carrier",
    title="Carrier",
    element="carrier",
    summary="Carries items from sources to nests; programs use it with crs_take() and crs_drop()"
    " (crs.h).",
    model=Carrier,
    state=CarrierState.at_start,
    install=install,
    requests=(
        device_request(
            "TAKE_ITEM", 233, "int crs_take(void)", "takes an item from the source under the robot"
        ),
        device_request(
            "DROP_ITEM", 234, "int crs_drop(void)", "drops an item in the nest under the robot"
        ),
        device_request(
            "ITEMS", 235, "int crs_items(void)", "returns the number of items on the robot",
            results=fields(("items", "i[0]", "1", "their number")),
        ),
    ),
    functions=(
        Function(
            "int crs_take(void)",
            "takes an item from the source that the robot's centre is in; also FALSE if there is"
            " none, if it is empty, or if the robot can carry no more",
            posts=("TAKE_ITEM",), source=(OURS,),
        ),
        Function(
            "int crs_drop(void)",
            "drops an item in the nest that the robot's centre is in; also FALSE if there is"
            " none, or if the robot carries nothing", posts=("DROP_ITEM",), source=(OURS,),
        ),
        Function(
            "int crs_items(void)",
            "returns the number of items that the robot carries, -1 if it has no carrier",
            posts=("ITEMS",), source=(OURS,),
        ),
    ),
    inspect=_inspect,
    source=__file__,
)  # fmt: skip
