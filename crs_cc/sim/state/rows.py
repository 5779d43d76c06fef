"""Selections of robots, and their rows of an array.

>>> table = np.array([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]])
>>> take(table, np.array([2, 0])).tolist(), take(table, ALL) is table
([[5.0, 6.0], [1.0, 2.0]], False)
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import IndexArray

Scalar = TypeVar("Scalar", bound=np.generic)

Rows: TypeAlias = "IndexArray | slice"
"""A selection of robots: their indices, or `ALL`."""

ALL: Final = slice(None)


def take(values: npt.NDArray[Scalar], rows: Rows) -> npt.NDArray[Scalar]:
    """Return `values[rows]`, read-only: faster than indexing if they lie together."""
    if isinstance(rows, slice) or not values.flags.c_contiguous:
        return values[rows]
    return values.take(rows, axis=0)


def simplest(rows: IndexArray, count: int) -> Rows:
    """Return `ALL` if rows are all of `count` robots in order: slices take less time.

    >>> simplest(np.array([0, 1]), 2), simplest(np.array([0, 0]), 2).tolist()
    (slice(None, None, None), [0, 0])
    """
    if len(rows) != count or (count > 1 and not (rows[1:] > rows[:-1]).all()):
        return rows
    return ALL


def parts(rows: Rows, count: int, most: int) -> Iterator[tuple[Rows, slice]]:
    """Yield parts of a selection of `count` robots, with their places in it.

    >>> [(some.tolist(), part.start) for some, part in parts(np.array([7, 8, 9]), 3, most=2)]
    [([7, 8], 0), ([9], 2)]
    """
    if count <= most:
        yield rows, slice(0, count)
        return
    for first in range(0, count, most):
        part = slice(first, min(first + most, count))
        yield part if isinstance(rows, slice) else rows[part], part
