"""The GPS receiver.

    reading = position of the robot's centre + normal deviates with the definition's noise

in x and y of the world frame, to the nearest 0.1 inch. The receiver measures when the program
requests it, but no more often than its rate allows, or on its timer; requests in between return the
previous measurement. Degradation (`gps`): if x or y is dropped there is no fix, and requests fail
until the next measurement. The model was chosen by us: the CRS report (6.2) suggests such a device
without specifying it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from crs_cc.core.quantity import LENGTH
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.number_sensor import Value, number_sensor
from crs_cc.sim.model.attribute import attribute, period, rate

if TYPE_CHECKING:
    from crs_cc.core.arrays import FloatArray
    from crs_cc.sim.devices.sensor import Measurement


@dataclass(frozen=True, slots=True)
class Gps:
    """A GPS receiver."""

    rate_hz: float = rate("1Hz")
    noise_m: float = attribute("noise", LENGTH, "0m", "Standard deviation of each coordinate.")
    period_s: float = period()


def measure(now: Measurement) -> FloatArray:
    """Return x and y in the world frame [m], (k, 2)."""
    return mount_poses(now.state, now.constants, now.rows)[:, :2]


DEVICE = number_sensor(
    name="gps",
    title="GPS",
    element="gps",
    summary="Measures the position of the robot in the world",
    does="measures the position of the robot in the world",
    model=Gps,
    values=(Value("x", "x in the world"), Value("y", "y in the world")),
    kind=LENGTH,
    measure=measure,
    nothing="there is no fix, and the request fails",
    source=__file__,
    number=0,
    stream=5,
)
