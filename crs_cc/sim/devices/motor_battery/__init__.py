"""The battery of the robot's motors, and the voltages of both batteries; see `devices.battery`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from crs_cc.core.quantity import VOLTAGE
from crs_cc.sim.devices.battery import Batteries
from crs_cc.sim.devices.battery.model import MotorBattery
from crs_cc.sim.devices.battery.state import BatteryState
from crs_cc.sim.devices.installed import Installed
from crs_cc.sim.model.degradable import Degradable
from crs_cc.sim.model.device import Device

if TYPE_CHECKING:
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.events import EventLog


def install(_row: Device, world: WorldModel, _seed: int, _log: EventLog) -> Installed:
    """Return the batteries of a world's robots."""
    return Installed(device=Batteries(world))


DEVICE = Device(
    name="motor_battery",
    title="Motor battery",
    element="motor-battery",
    summary="The battery that powers the motors. Without a battery, the motors run forever.",
    model=MotorBattery,
    state=BatteryState.at_start,
    install=install,
    degradables=(
        Degradable(
            "battery", "voltage", VOLTAGE, lambda _robot: ("computers", "motors"), 2,
            "the lowest voltage is read",
        ),
    ),
    source=__file__,
)  # fmt: skip
