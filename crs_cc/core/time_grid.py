"""Comparison of simulated times, which are sums of timesteps and so inexact.

>>> is_due(np.array([0.0, 0.1]), np.array([0.3, 0.3]), np.array([0.1 + 0.2, 0.3])).tolist()
[True, False]
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray

ROUNDING_S: Final = 1e-9
"""Times closer than this are equal."""


def is_due(last_s: FloatArray, at_s: FloatArray, interval_s: FloatArray) -> BoolArray:
    """Return which sensors are due to measure again.

    Args:
        last_s: time of each last measurement; below 0 for never, (k,).
        at_s: time of each next measurement, (k,).
        interval_s: the minimum time between two measurements, (k,).
    """
    return np.asarray((last_s < 0.0) | (at_s - last_s >= interval_s - ROUNDING_S))
