"""The inclinometer: how the robot is tilted.

    pitch = atan(rise of the ground ahead) + noise      above 0 with the nose up
    roll  = atan(rise of the ground to the left) + noise      above 0 with the left side up

per metre, under the robot's middle, where ahead is where the mount points; to the nearest 0.1
degree, with normal deviates. It measures when the program asks, at most at its rate, or by its
timer; between two measurements it replies with the last one. On level ground both are 0, also at a
ledge: robots do not tip. Acceleration and bumps, which disturb real ones, have no effect. All of it
was chosen by us.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.quantity import ANGLE
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.model.device import Device, Value, attribute, period, rate

if TYPE_CHECKING:
    from crs_cc.core.arrays import FloatArray
    from crs_cc.sim.devices.sensor import Measurement


@dataclass(frozen=True, slots=True)
class Inclinometer:
    """An inclinometer on the mount.

    Attributes:
        rate_hz: how often it measures at most.
        noise_rad: standard deviation of the error of pitch and of roll.
        period_s: how often it measures by its timer; 0 for when it is asked.
    """

    rate_hz: float = rate("20Hz")
    noise_rad: float = attribute(
        "noise", ANGLE, "0deg", "Standard deviation of the error of pitch and of roll."
    )
    period_s: float = period()


def measure(now: Measurement) -> FloatArray:
    """Return pitch and roll [rad], (k, 2)."""
    tilt_rad = np.zeros((len(now.rows), 2))
    if now.equipment.inclines is not None:
        x_m, y_m, direction = mount_poses(now.state, now.equipment, now.rows).T
        gradient = now.equipment.inclines.terrain.gradient(x_m, y_m)
        cos, sin = np.cos(direction), np.sin(direction)
        tilt_rad[:, 0] = np.arctan(cos * gradient[:, 0] + sin * gradient[:, 1])
        tilt_rad[:, 1] = np.arctan(cos * gradient[:, 1] - sin * gradient[:, 0])
    return tilt_rad


DEVICE = Device(
    name="tilt",
    title="Inclinometer",
    element="inclinometer",
    summary="An inclinometer: how the robot is tilted",
    does="reads how the robot is tilted",
    model=Inclinometer,
    values=(Value("pitch", "pitch, nose up"), Value("roll", "roll, left side up")),
    kind=ANGLE,
    measure=measure,
    source=__file__,
    number=6,
    stream=29,
)
