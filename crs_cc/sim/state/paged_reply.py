"""Readings that are too long for one message: the last reply, kept for its further pages.

>>> from crs_cc.requests import MESSAGE
>>> told = PagedReply.nothing(1, room=6)
>>> told.keep(0, width=2, numbers=np.array([1, 2, 3, 4]))
>>> message = np.zeros(1, MESSAGE)
>>> told.page(0, first=1, message=message[0])
>>> message["result"].tolist(), message["i"][0, 0], message["data"][0, :8].view("<i4").tolist()
([1], np.int32(2), [3, 4])
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import Int32Array
from crs_cc.requests import DATA_SIZE

_PAGE: Final = DATA_SIZE // 4  # numbers


@dataclass(slots=True)
class PagedReply:
    """Readings for the pages that programs request; a row for each robot with the device.

    Attributes:
        count: number of readings, (n,).
        width: numbers in each, (n,).
        numbers: the numbers, one reading after the other, (n, room).
    """

    count: Int32Array
    width: Int32Array
    numbers: Int32Array

    @classmethod
    def nothing(cls, count: int, room: int) -> Self:
        """Return no readings, with space for `room` numbers."""
        return cls(
            np.zeros(count, dtype=np.int32),
            np.full(count, 1, dtype=np.int32),
            np.zeros((count, room), dtype=np.int32),
        )

    def keep(self, row: int, width: int, numbers: npt.NDArray[np.number]) -> None:
        """Replace the readings of a device, as many as there is space for."""
        count = min(numbers.size, self.numbers.shape[1]) // width
        self.width[row], self.count[row] = width, count
        self.numbers[row, : count * width] = numbers.ravel()[: count * width]

    def page(self, row: int, first: int, message: np.void) -> None:
        """Write a page to a message: number of readings, numbers in each, and the numbers.

        Args:
            row: the device.
            first: the first reading of the page; any number.
            message: changed in place.
        """
        width = int(self.width[row])
        left = int(self.count[row]) - first if first >= 0 else 0
        count = min(max(left, 0), _PAGE // width)
        part = self.numbers[row, first * width : (first + count) * width] if count else ()
        size = 4 * len(part)
        message["data"][:size] = np.array(part, dtype="<i4").view(np.uint8)
        message["size"], message["result"], message["i"][0] = size, count, width
