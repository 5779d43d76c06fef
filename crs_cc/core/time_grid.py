"""Instants in the world's time: sums of timesteps, and so never exact to the last bit.

>>> is_due(np.array([0.0, 0.1]), np.array([0.3, 0.3]), np.array([0.1 + 0.2, 0.3])).tolist()
[True, False]
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray

ROUNDING_S: Final = 1e-9
"""Instants that are no further apart are the same."""


def is_due(last_s: FloatArray, at_s: FloatArray, interval_s: FloatArray) -> BoolArray:
    """Tells which sensors may measure again.

    Args:
        last_s: when each measured last; below 0 for never, (k,).
        at_s: when each would measure, (k,).
        interval_s: the least time between two measurements, (k,).
    """
    return np.asarray(at_s - last_s >= interval_s - ROUNDING_S)
