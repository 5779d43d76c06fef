"""The common part of grippers and hands: their commands, and the choice of the object to grasp.

>>> nearest(np.array([0, 0, 1]), np.array([0.2, 0.1, 0.3]), np.array([True, True, False])).tolist()
[1]
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.sim.geometry.scene import Scene

COMMANDS: Final = "#define CRS_OPEN 0\n#define CRS_CLOSE 1"
"""The commands in C; a definition may be repeated (C17 6.10.3p2)."""


def can_be_taken(scene: Scene, objects: IndexArray, most_kg: FloatArray) -> BoolArray:
    """Return which pushable objects are not part of another one and not too heavy."""
    near = [scene.pushables[obj] for obj in objects.tolist()]
    mass_kg = np.array([math.inf if obj.part_of else obj.mass_kg for obj in near])
    return np.asarray(mass_kg <= most_kg)


def nearest(taker: IndexArray, away_m: FloatArray, good: BoolArray) -> IndexArray:
    """Return the pair of each taker with the nearest object, among the valid pairs.

    Args:
        taker: the taker of each pair, (n,).
        away_m: distance of the object, (n,).
        good: which pairs are valid, (n,).

    Returns:
        the pairs, by ascending taker; of equally near ones the first.
    """
    order = np.flatnonzero(good)
    order = order[np.lexsort((away_m[order], taker[order]))]
    return order[np.unique(taker[order], return_index=True)[1]]
