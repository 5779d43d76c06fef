"""The common part of sensors that measure ranges along beams: laser, camera, infrared ring."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.core.quantity import ANGLE, LENGTH
from crs_cc.sim.model.attribute import attribute

if TYPE_CHECKING:
    from crs_cc.sim.devices.sensor import Measurement, Readings


def field_of_view(default: str | None) -> Any:
    """Return the field `field_of_view_rad` of a sensor: the angle that its beams cover."""
    return attribute(
        "field-of-view", ANGLE, default, "Field of view, symmetric about the front.",
        positive=True, most="360deg",
    )  # fmt: skip


def forward() -> Any:
    """Return the field for a sensor's position ahead of the mount's centre."""
    return attribute(
        "forward", LENGTH, "0m", "Position, forward of the centre of the turret.", signed=True
    )


def height(default: str = "30cm") -> Any:
    """Return the field `z_m` of a sensor: the height of its beams above the ground."""
    return attribute(
        "height", LENGTH, default, "Height above the ground: beams pass over lower objects."
    )


def alike(kinds: IndexArray) -> Iterator[tuple[int, IndexArray]]:
    """Yield each kind of several sensors, in ascending order, and the places of its sensors.

    >>> [(kind, places.tolist()) for kind, places in alike(np.array([5, 2, 5]))]
    [(2, [1]), (5, [0, 2])]
    """
    if len(kinds) and (kinds == kinds[0]).all():
        yield int(kinds[0]), np.arange(len(kinds))
        return
    for kind in sorted(set(kinds.tolist())):
        yield kind, np.flatnonzero(kinds == kind)


def triangulated(now: Measurement, range_m: FloatArray, deviates: FloatArray) -> FloatArray:
    """Return ranges with errors that grow with the square of the range, as for two lenses.

    Args:
        now: has the standard deviation at a range of 1 m, `noise_m`.
        range_m: the true ranges, infinite for nothing, (k, values).
        deviates: standard normal deviates, (k, values).
    """
    seen_m = np.where(np.isfinite(range_m), range_m, 0.0)
    spread_m = now.settings["noise_m"][:, None] * np.square(seen_m)
    return np.asarray(np.maximum(range_m + deviates * spread_m, 0.0))


def nearest_text(readings: Readings, number: int, width: int) -> str:
    """Return the least of the first `width` ranges of a sensor's last reading, for inspectors."""
    if readings.at_s[number] < 0.0:
        return "no reading"
    range_m = readings.value[number, :width]
    least_m = float(np.min(range_m, where=np.isfinite(range_m), initial=math.inf))
    return f"nearest {LENGTH.show(least_m)}" if math.isfinite(least_m) else "nothing in range"
