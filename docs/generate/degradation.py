"""The table of `docs/degradation.md`: devices that can be degraded, with their elements."""

from __future__ import annotations

import dataclasses
from functools import cache
from types import SimpleNamespace
from unittest.mock import MagicMock

from crs_cc.sim.files.known_robots import known_robots
from crs_cc.sim.files.world_xml import empty_world
from crs_cc.sim.model import registry
from crs_cc.sim.model.degradable import Degradable
from crs_cc.sim.model.degradation import degradables, shown
from crs_cc.sim.model.robot import RobotModel
from docs.generate import Fillers, table

_FIRST = ("scout", "nomad200")


def devices() -> str:
    """Return the table of all devices."""
    return table(
        ("device", "value", "unit", "elements", "if a value is dropped"),
        [_row(device) for device in degradables().values()],
    )


def _row(device: Degradable) -> tuple[str, ...]:
    title = f"{device.title} (actuator)" if device.acts else device.title
    return f"`{device.name}`", title, _unit(device), _elements(device), device.nothing


def _unit(device: Degradable) -> str:
    names = [name for robot in _robots() for name in device.elements(robot)]
    kinds = dict.fromkeys(device.kind_of(name) for name in names if name)
    return ", ".join(kind.default or "-" for kind in kinds) or device.kind.default or "-"


@cache
def _robots() -> list[RobotModel]:
    names = [*_FIRST, *(name for name in known_robots() if name not in _FIRST)]
    return [empty_world(robot=name).robots[0].model for name in names]


def _elements(device: Degradable) -> str:
    """Return the elements of the robots that have the device."""
    found: dict[str, str] = {}
    for robot in _robots():
        names = device.elements(robot)
        if names:
            found.setdefault(shown(names), robot.name)
    if not found:  # no bundled robot has it
        names = device.elements(_robot_with(device))
        numbers = "0" if device.width == 1 else f"0 to {device.width - 1}"
        return shown(names) if len(names) == device.width > 1 else numbers
    if len(found) == 1:
        return next(iter(found))
    return "; ".join(f"{each} ({name})" for each, name in found.items())


def _robot_with(degradable: Degradable) -> RobotModel:
    """Return a stand-in for a robot that has a device with its default attributes."""
    row = next(each for each in registry.devices() if degradable in each.degradables)
    robot = MagicMock(spec=RobotModel)
    fields = dataclasses.fields(row.model)
    robot.device.return_value = SimpleNamespace(**{each.name: each.default for each in fields})
    return robot


FILLERS: Fillers = {"devices": devices}
