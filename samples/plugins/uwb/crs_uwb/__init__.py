"""An ultra-wideband ranging radio: how far away the nearest other robot is.

    reading = distance between the middles of the two robots + normal deviates

to the nearest 0.1 inch. Walls do not block it. A robot out of range is not found; when none is, the
request fails. Real radios of this kind range to 10 cm or so; multipath, which misleads them, has no
effect here. The law and the range are chosen for this example.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.quantity import LENGTH
from crs_cc.sim.devices.number_sensor import Value, number_sensor
from crs_cc.sim.model.attribute import attribute, period, rate

if TYPE_CHECKING:
    from crs_cc.core.arrays import FloatArray
    from crs_cc.sim.devices.sensor import Measurement


@dataclass(frozen=True, slots=True)
class Radio:
    """A ranging radio.

    Attributes:
        rate_hz: how often it measures at most.
        range_m: how far away it finds robots.
        noise_m: standard deviation of the distance's error.
        period_s: how often it measures by its timer; 0 for when it is asked.
    """

    rate_hz: float = rate("10Hz")
    range_m: float = attribute("range", LENGTH, "30m", "Maximum distance of a detected robot.")
    noise_m: float = attribute("noise", LENGTH, "0m", "Standard deviation of the distance's error.")
    period_s: float = period()


def measure(now: Measurement) -> FloatArray:
    """Return the distance to the nearest other robot [m], NaN where none is in range, (k, 1)."""
    x_m, y_m = now.state.x_m, now.state.y_m
    away_m = np.hypot(x_m - x_m[now.rows, None], y_m - y_m[now.rows, None])
    away_m[:, ~now.state.presence.present] = np.inf
    away_m[np.arange(len(now.rows)), now.rows] = np.inf  # itself
    nearest_m = away_m.min(axis=1)
    return np.where(nearest_m <= now.settings["range_m"], nearest_m, np.nan)[:, None]


DEVICE = number_sensor(
    name="uwb",
    title="Ultra-wideband radio",
    element="uwb",
    summary="Measures the distance to the nearest other robot",
    does="measures the distance to the nearest other robot",
    model=Radio,
    values=(Value("distance", "distance between the centres of the robots"),),
    kind=LENGTH,
    measure=measure,
    nothing="there is no robot in range, and the request fails",
    source=__file__,
)
