"""Causes of the charge of batteries, and of values of the whole world."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from crs_cc.debug.motion_cause import Fact
from crs_cc.sim.devices.battery.model import Battery
from crs_cc.sim.devices.battery.state import motors_of

if TYPE_CHECKING:
    from crs_cc.sim.engine.environment import Environment


def battery_facts(environment: Environment, robot: int, name: str) -> Iterator[Fact]:
    """Return the energy drawn from a battery, `computer_battery` or `motor_battery`."""
    battery: Battery | None = environment.world.robots[robot].model.device(name)
    if battery is None:
        yield Fact("it is unlimited: the world file gives it no capacity")
        return
    yield Fact(f"it had {100 * battery.charge:g}% of {battery.capacity_j:g} J at first")
    joined_s = float(environment.state.presence.joined_s[robot])
    for_s = max(0.0, environment.time_s - joined_s)
    if battery.power_w:
        used_j = battery.power_w * for_s
        yield Fact(f"{battery.power_w:g} W for {for_s:.3f} s have taken {used_j:.6g} J")
    if name == "motor_battery":
        number = environment.device_number(name, robot)
        moved_j = float(motors_of(environment.state).moved_j[number])
        yield Fact(f"moving has taken {moved_j:.6g} J, with charges by hand taken off")


def world_facts(environment: Environment, name: str) -> Iterator[Fact]:
    """Return the cause of a value of the whole world."""
    timestep_s = environment.timestep_s
    if name in {"time", "timestep"}:
        yield Fact(f"{environment.state.cycle} timesteps of {timestep_s:g} s have been simulated")
