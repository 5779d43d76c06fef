"""The order of sensors that is passed to `conf_sn` and `conf_ir`.

It ends with its last element, or before the first 255 (vendor header `Nclient.h` 1.29).

>>> content = np.zeros((2, 16), np.uint8)
>>> content[:, :3] = [[0, 8, 255], [4, 99, 5]]
>>> order, given, good = orders(np.array([3, 3]), content, 16)
>>> order[0, :3].tolist(), given.sum(axis=1).tolist(), good.tolist()
([0, 8, 255], [2, 3], [True, False])
"""

from __future__ import annotations

from typing import Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, IndexArray

_END: Final = 255


def orders(
    count: npt.NDArray[np.integer], content: npt.NDArray[np.integer], most: int
) -> tuple[IndexArray, BoolArray, BoolArray]:
    """Return the orders of some requests.

    Args:
        count: their lengths, (k,).
        content: their bytes, (k, bytes).
        most: maximum number of sensors, which are numbered from 0.

    Returns:
        sensor numbers, shape (k, most); which of them belong to the order, the first ones, shape
        (k, most); and whether each order contains only valid sensor numbers, shape (k,).
    """
    order = content[:, :most].astype(np.intp)
    given = np.arange(most) < np.clip(count, 0, most)[:, None]
    given &= np.cumsum(order == _END, axis=1) == 0
    return order, given, np.asarray(((order < most) | ~given).all(axis=1))
