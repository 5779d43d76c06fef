"""Spots of one colour in a row of pixels.

>>> colours = np.array([0xFF0000, 0xFF0000, 0, 0x00FF00, 0x00FF00, 0x00FF00])
>>> ranges = np.array([210, 200, -1, 90, 95, 80])
>>> for blob in blobs(colours, ranges):
...     first, after, colour, nearest = blob.tolist()
...     print(first, after, hex(colour), nearest)
0 2 0xff0000 200
3 6 0xff00 80
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import Int32Array


def blobs(colours: npt.NDArray[np.integer], ranges: npt.NDArray[np.integer]) -> Int32Array:
    """Return the runs of adjacent columns with one colour.

    Args:
        colours: the colour of each column, from left to right, (columns,).
        ranges: the range of each, below 0 where there is nothing, (columns,).

    Returns:
        first column, column after the last one, colour and least range of each, (blobs, 4).
    """
    if not len(colours):
        return np.zeros((0, 4), dtype=np.int32)
    something = ranges >= 0
    shown = np.where(something, colours, -1)
    first = np.concatenate([[0], np.flatnonzero(np.diff(shown)) + 1])
    after = np.append(first[1:], len(shown))
    nearest = np.minimum.reduceat(ranges, first)
    rows = np.column_stack([first, after, colours[first], nearest])
    return np.asarray(rows[something[first]], dtype=np.int32)
