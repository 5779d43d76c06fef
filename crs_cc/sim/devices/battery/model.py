"""Constants of batteries."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from crs_cc.core.quantity import ENERGY, FORCE, POWER, VOLTAGE
from crs_cc.sim.model.attribute import SHARE, Choice, Voltages, attribute

_MAX_STEPS: Final = 64


@dataclass(frozen=True, slots=True, kw_only=True)
class Battery:
    """A battery and its load."""

    capacity_j: float = attribute(
        "capacity", ENERGY, None, "Energy when fully charged.", positive=True
    )
    charge: float = attribute("charge", SHARE, "1", "Initial state of charge, as a fraction.")
    power_w: float = attribute("power", POWER, "0W", "Constant power consumption.")
    curve_v: tuple[float, ...] = attribute(
        "curve", Voltages(_MAX_STEPS), None,
        "Voltages from empty to full, at equal steps of charge, linearly interpolated.",
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class MotorBattery(Battery):
    """The battery of the motors: a `Battery` with the load of the drive."""

    friction_n: float = attribute("friction", FORCE, "0N", "Friction force on a turning wheel.")
    efficiency: float = attribute(
        "efficiency", SHARE, "1",
        "Fraction of the energy drawn for friction and acceleration that reaches the wheels.",
    )  # fmt: skip
    stall_w: float = attribute(
        "stall", POWER, "0W", "Additional power consumption while the robot is blocked."
    )
    cutoff_v: float = attribute(
        "cutoff", VOLTAGE, "0V", "Voltage below which the motors exert no force."
    )
    is_in_status: bool = attribute(
        "in-status", Choice((("yes", True), ("no", False))), "no",
        "Whether bits 2 and 3 of State[41] report the charge: 0 for low, 1 for medium, 2 for high.",
    )  # fmt: skip


ENDLESS: Final = Battery(capacity_j=math.inf, curve_v=(12.0,))
"""The supply of computers without a battery."""

ENDLESS_MOTORS: Final = MotorBattery(capacity_j=math.inf, curve_v=(12.0,))
"""The supply of motors without a battery."""
