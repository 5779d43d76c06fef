"""Which parts of `State` a program wants to hear of: the vendor's `Smask`, as `ct` handed it over.

The client takes from a state only what the mask has (`runtime/lib/robot`); here it decides which
sensors measure at all. Indices are those of the vendor header `Nclient.h` 1.29.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import ByteArray

NUM_MASK: Final = 44
POS_DATA: Final = 0  # which sensors' positions are wanted, bit by bit
INFRARED: Final = slice(1, 17)
LASER: Final = slice(42, 43)
COMPASS: Final = slice(43, 44)


def first_mask(robots: int) -> ByteArray:
    """Return what `init_mask` sets: everything, but no positions."""
    mask = np.ones((robots, NUM_MASK), dtype=np.uint8)
    mask[:, POS_DATA] = 0
    return mask
