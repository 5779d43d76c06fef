"""What fingers and hands take of all that is within their reach.

>>> nearest(np.array([0, 0, 1]), np.array([0.2, 0.1, 0.3]), np.array([True, True, False])).tolist()
[1]
"""

from __future__ import annotations

import math

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.sim.geometry.scene import Scene


def can_be_taken(scene: Scene, things: IndexArray, most_kg: FloatArray) -> BoolArray:
    """Tells which things, of those that can be pushed, are no part of others and not too heavy."""
    near = [scene.pushables[thing] for thing in things.tolist()]
    mass_kg = np.array([math.inf if thing.part_of else thing.mass_kg for thing in near])
    return np.asarray(mass_kg <= most_kg)


def nearest(taker: IndexArray, away_m: FloatArray, good: BoolArray) -> IndexArray:
    """Gives which pair of taker and thing counts for each taker: of the good ones the nearest.

    Args:
        taker: the taker of each pair, (n,).
        away_m: how far away the thing is, (n,).
        good: which pairs there can be, (n,).

    Returns:
        the pairs, by rising taker; of equally near ones the first.
    """
    order = np.flatnonzero(good)
    order = order[np.lexsort((away_m[order], taker[order]))]
    return order[np.unique(taker[order], return_index=True)[1]]
