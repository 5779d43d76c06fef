"""The point of a line segment that is nearest to a given point.

    share    = clip(across . along / along . along, 0, 1)
    nearest  = start + share * along
    distance = |across - share * along|

with `across` from the segment's start to the place, and `along` from its start to its end. Of a
segment of length 0 the start is nearest. All four parts are numbers or arrays that broadcast.

>>> distance(np.array([3.0, 5.0, -3.0]), 1.0, 4.0, 0.0).round(6).tolist()
[1.0, 1.414214, 3.162278]
>>> float(nearest_fraction(3.0, 1.0, 0.0, 0.0)), float(distance(3.0, 4.0, 0.0, 0.0))
(0.0, 5.0)
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np

from crs_cc.core.arrays import FloatArray

Number: TypeAlias = FloatArray | float


def nearest_fraction(
    across_x: Number, across_y: Number, along_x: Number, along_y: Number
) -> FloatArray:
    """Return the fraction of segments, 0 to 1, at the points nearest to given positions."""
    length2 = along_x * along_x + along_y * along_y
    share = (across_x * along_x + across_y * along_y) / np.where(length2 > 0.0, length2, 1.0)
    return np.asarray(np.clip(share, 0.0, 1.0))


def distance(across_x: Number, across_y: Number, along_x: Number, along_y: Number) -> FloatArray:
    """Return the distances of points to segments."""
    share = nearest_fraction(across_x, across_y, along_x, along_y)
    x, y = across_x - share * along_x, across_y - share * along_y
    return np.asarray(np.sqrt(x * x + y * y))
