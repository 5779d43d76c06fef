"""The bumper ring: equal switches around the body, pressed by what touches them.

    switch = floor((bearing + half a switch) / a switch)

with the bearing of the contact from ahead, counter-clockwise; so switch 0 is centred ahead and the
switches count like the sonars. Switch n is bit n of `State[33]`, which is 3 bytes wide. The vendor
does not say how the Scout's switches lie; this layout was chosen by us (see `robots/scout.xml`).

A switch is pressed at a cycle's start when something touched it in the cycle before. No degradation
yet.

>>> eight = np.array([8, 8, 8])
>>> pressed(np.array([0.0, math.pi / 2, -0.3]), eight).tolist()    # ahead, left, ahead right
[1, 4, 1]
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    pass

FloatArray = npt.NDArray[np.float64]
WholeArray = npt.NDArray[np.int64]


def pressed(bearing_rad: FloatArray, switches: WholeArray) -> npt.NDArray[np.int32]:
    """Gives the bit of the switch at each bearing.

    Args:
        bearing_rad: bearings of contacts in the robot frame.
        switches: how many switches the robot has; 0 for no bumpers.
    """
    number = np.floor(bearing_rad * switches / (2 * math.pi) + 0.5).astype(np.int64)
    bits = np.left_shift(1, number % np.maximum(switches, 1))
    return np.where(switches > 0, bits, 0).astype(np.int32)
