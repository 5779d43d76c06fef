"""Spots of one colour in rows of pixels.

>>> colours = np.array([[0xFF0000, 0xFF0000, 0, 0x00FF00, 0x00FF00], [0x00FF00, 0, 0, 0, 0]])
>>> ranges = np.array([[210, 200, -1, 90, 80], [70, 0, 0, 0, 0]])
>>> for spot in zip(*(each.tolist() for each in blobs(colours, ranges, np.array([5, 1])))):
...     print(*map(hex, spot[3:4]), *spot)
0xff0000 0 0 2 16711680 200
0xff00 0 3 5 65280 80
0xff00 1 0 1 65280 70
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import IndexArray

_NO_COLOUR = -1


def blobs(
    colours: npt.NDArray[np.integer], ranges: npt.NDArray[np.integer], columns: IndexArray
) -> tuple[IndexArray, IndexArray, IndexArray, npt.NDArray[np.integer], npt.NDArray[np.integer]]:
    """Return the runs of adjacent columns with one colour in several pictures.

    Args:
        colours: the colour of each column, from left to right, (k, most).
        ranges: the range of each, below 0 where there is nothing, (k, most).
        columns: the number of columns of each picture, at least 1, (k,).

    Returns:
        picture, first column, column after the last one, colour and least range of each blob, from
        left to right in one picture after the other.
    """
    inside = np.arange(colours.shape[1]) < columns[:, None]
    shown = np.where(ranges >= 0, colours, _NO_COLOUR)[inside]
    begins = np.cumsum(columns) - columns  # of each picture in the row of all pixels
    is_first = np.ones(len(shown), dtype=np.bool_)
    np.not_equal(shown[1:], shown[:-1], out=is_first[1:])
    is_first[begins] = True
    first = np.flatnonzero(is_first)
    after = np.append(first[1:], len(shown))
    nearest = np.minimum.reduceat(ranges[inside], first)
    found = np.flatnonzero(shown[first] != _NO_COLOUR)
    first, after, nearest = first[found], after[found], nearest[found]
    owner = np.searchsorted(begins, first, side="right") - 1
    return owner, first - begins[owner], after - begins[owner], shown[first], nearest
