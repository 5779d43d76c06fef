"""The distinct members of a sequence, so that equal ones are computed once.

>>> members, places = distinct(["scout", "nomad", "scout"])
>>> members, places.tolist()
(['scout', 'nomad'], [0, 1, 0])
>>> map_distinct(["scout", "nomad", "scout"], len)
[5, 5, 5]
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from typing import TypeVar

import numpy as np

from crs_cc.core.arrays import IndexArray

Member = TypeVar("Member", bound=Hashable)
Value = TypeVar("Value")


def distinct(items: Sequence[Member]) -> tuple[list[Member], IndexArray]:
    """Return the distinct items in the order of their first places, and each item's place there."""
    places = {item: place for place, item in enumerate(dict.fromkeys(items))}
    return list(places), np.array([places[item] for item in items], dtype=np.intp)


def map_distinct(items: Sequence[Member], value: Callable[[Member], Value]) -> list[Value]:
    """Return a value for each item, computed once for equal ones."""
    found = {item: value(item) for item in dict.fromkeys(items)}
    return [found[item] for item in items]
