"""The states of the devices of `registry.devices()`.

>>> from crs_cc.sim.files.world_xml import empty_world
>>> [name for name in device_states(empty_world()).__slots__ if name == "tilt"]
['tilt']
"""

from __future__ import annotations

import dataclasses
from functools import cache
from typing import Any, Final

from crs_cc.sim.model.registry import devices
from crs_cc.sim.model.robot import devices_of
from crs_cc.sim.model.world import WorldModel

_NAME: Final = "DeviceStates"


def device_states(world: WorldModel) -> Any:
    """Return a dataclass with the state of each device of the registry that has one, by name."""
    models = [robot.model for robot in world.robots]
    columns = {}
    for each in devices():
        if each.state is None:
            continue
        found = devices_of(models, each.name)
        has = found if each.dense else [model for model in found if model is not None]
        columns[each.name] = each.state(has)
    return _columns()(**columns)


@cache
def _columns() -> type:
    names = [each.name for each in devices() if each.state is not None]
    columns = dataclasses.make_dataclass(_NAME, names, slots=True)
    columns.__module__ = __name__  # where pickle looks for it, see `__getattr__`
    return columns


def __getattr__(name: str) -> type:
    if name == _NAME:
        return _columns()
    raise AttributeError(name)
