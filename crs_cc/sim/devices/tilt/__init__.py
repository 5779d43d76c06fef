"""The inclinometer: pitch and roll of the robot.

    pitch = atan(slope of the ground in the forward direction) + noise    positive with the nose up
    roll  = atan(slope of the ground to the left) + noise      positive with the left side up

The slope is that under the robot's centre, and forward is the direction of the mount. Readings are
to the nearest 0.1 degree; the noise is normally distributed. The inclinometer measures when the
program requests it, but no more often than its rate allows, or on its timer; requests in between
return the previous measurement. On level ground both are 0, even at a ledge: robots do not tip
over. Acceleration and bumps, which disturb real inclinometers, have no effect. The model was chosen
by us.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.quantity import ANGLE
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.number_sensor import Value, number_sensor
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.attribute import attribute, period, rate

if TYPE_CHECKING:
    from crs_cc.core.arrays import FloatArray
    from crs_cc.sim.devices.sensor import Measurement


@dataclass(frozen=True, slots=True)
class Inclinometer:
    """An inclinometer on the mount."""

    rate_hz: float = rate("20Hz")
    noise_rad: float = attribute("noise", ANGLE, "0deg", "Standard deviation of pitch and of roll.")
    period_s: float = period()


def measure(now: Measurement) -> FloatArray:
    """Return pitch and roll [rad], (k, 2)."""
    tilt_rad = np.zeros((len(now.rows), 2))
    if now.constants.inclines is not None:
        x_m, y_m, direction = mount_poses(now.state, now.constants, now.rows).T
        gradient = now.constants.inclines.terrain.gradient(x_m, y_m)
        cos, sin = exact.cos(direction), exact.sin(direction)
        tilt_rad[:, 0] = exact.arctan(cos * gradient[:, 0] + sin * gradient[:, 1])
        tilt_rad[:, 1] = exact.arctan(cos * gradient[:, 1] - sin * gradient[:, 0])
    return tilt_rad


DEVICE = number_sensor(
    name="tilt",
    title="Inclinometer",
    element="inclinometer",
    summary="Measures pitch and roll of the robot",
    does="measures pitch and roll",
    model=Inclinometer,
    values=(
        Value("pitch", "pitch, positive with the nose up"),
        Value("roll", "roll, positive with the left side up"),
    ),
    kind=ANGLE,
    measure=measure,
    source=__file__,
    number=6,
    stream=29,
)
