"""The battery of the robot's computers, discharged at constant power; see `devices.battery`."""

from __future__ import annotations

from crs_cc.sim.devices.battery.model import Battery
from crs_cc.sim.devices.installed import Installed
from crs_cc.sim.model.device import Device

DEVICE = Device(
    name="computer_battery",
    title="Computer battery",
    element="computer-battery",
    summary="The battery that powers the computers. Without a battery, the computers run forever.",
    model=Battery,
    state=lambda _models: (),
    install=lambda *_: Installed(),
    source=__file__,
)
