"""Energy used by the motors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Self

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.model.axis import AXES

if TYPE_CHECKING:
    from crs_cc.sim.devices.battery.model import MotorBattery
    from crs_cc.sim.state.env_state import EnvState


@dataclass(slots=True)
class BatteryState:
    """The motor batteries; arrays have a row for each robot with one, n of them.

    Their constant load follows from the time, as do the computers' batteries.

    Attributes:
        moved_j: energy used for moving, (n,).
        speed_mps: the axes' speeds at the last update, (n, 3).
    """

    moved_j: FloatArray
    speed_mps: FloatArray

    @classmethod
    def at_start(cls, batteries: Sequence[MotorBattery]) -> Self:
        """Return batteries of robots that have not moved yet."""
        return cls(np.zeros(len(batteries)), np.zeros((len(batteries), AXES)))


def motors_of(state: EnvState) -> BatteryState:
    """Return the state of the motor batteries."""
    return state.device("motor_battery", BatteryState)
