"""The parts of `State` that a program requests: the vendor's `Smask`, as passed to `ct`.

The client takes from a state only the parts in the mask (`runtime/lib/robot`); the mask also
selects the sensors that measure. Indices are those of the vendor header `Nclient.h` 1.29.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import ByteArray

NUM_MASK: Final = 44
POS_DATA: Final = 0  # sensors whose positions are requested, as bits
INFRARED: Final = slice(1, 17)
LASER: Final = slice(42, 43)
COMPASS: Final = slice(43, 44)


def first_mask(robots: int) -> ByteArray:
    """Return the mask that `init_mask` sets: everything except positions."""
    mask = np.ones((robots, NUM_MASK), dtype=np.uint8)
    mask[:, POS_DATA] = 0
    return mask
