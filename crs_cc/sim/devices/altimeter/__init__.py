"""The altimeter: height of the ground under the robot.

    height = height of the ground under the robot's centre + normal deviates

above level ground, to the nearest 0.1 inch, like a barometric altimeter that was calibrated there.
The altimeter measures when the program requests it, but no more often than its rate allows, or on
its timer; requests in between return the previous measurement. Robots do not tip over: at a ledge
the height is that of the ground under the centre. Degradation (`altitude`): if the value is
dropped, requests fail. The model was chosen by us.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.quantity import LENGTH
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.number_sensor import Value, number_sensor
from crs_cc.sim.model.attribute import attribute, period, rate

if TYPE_CHECKING:
    from crs_cc.core.arrays import FloatArray
    from crs_cc.sim.devices.sensor import Measurement


@dataclass(frozen=True, slots=True)
class Altimeter:
    """An altimeter."""

    rate_hz: float = rate("20Hz")
    noise_m: float = attribute("noise", LENGTH, "0m", "Standard deviation of the measured height.")
    period_s: float = period()


def measure(now: Measurement) -> FloatArray:
    """Return the height of the ground [m], (k, 1)."""
    if now.constants.inclines is None:
        return np.zeros((len(now.rows), 1))
    x_m, y_m, _ = mount_poses(now.state, now.constants, now.rows).T
    return now.constants.inclines.terrain.height_m(x_m, y_m)[:, None]


DEVICE = number_sensor(
    name="altitude",
    title="Altimeter",
    element="altimeter",
    summary="Measures the height of the ground under the robot",
    does="measures the height of the ground under the robot",
    model=Altimeter,
    values=(Value("height", "height above level ground"),),
    kind=LENGTH,
    measure=measure,
    source=__file__,
)
