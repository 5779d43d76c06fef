"""Readings that are too long for one message: the last reply, kept for its further pages.

>>> from crs_cc.requests import MESSAGE
>>> told, robots = PagedReply.nothing(2, room=6), np.array([0, 1])
>>> readings = np.array([[[1, 2], [3, 4]], [[5, 6], [0, 0]]])   # the second robot has only one
>>> told.keep(robots, width=2, counts=np.array([2, 1]), numbers=readings)
>>> messages = np.zeros(2, MESSAGE)
>>> told.page(robots, np.array([1, 0]), messages, places=robots)
>>> messages["result"].tolist(), messages["i"][:, 0].tolist()
([1, 1], [2, 2])
>>> messages["data"][:, :8].copy().view("<i4").tolist()
[[3, 4], [5, 6]]
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import IndexArray, Int32Array, Records
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

    def keep(
        self,
        rows: IndexArray,
        width: int,
        counts: npt.NDArray[np.integer],
        numbers: npt.NDArray[np.number],
    ) -> None:
        """Replace the readings of devices, as many as there is space for.

        Args:
            rows: the devices, k of them.
            width: numbers in each reading.
            counts: number of readings of each device, (k,).
            numbers: its readings; what follows the last one is ignored, (k, most, width).
        """
        room = self.numbers.shape[1] // width
        counts, numbers = np.minimum(counts, room), numbers[:, :room]
        self.width[rows], self.count[rows] = width, counts
        size = numbers.shape[1] * width
        told = numbers.reshape(len(rows), size)
        if (counts < numbers.shape[1]).any():  # rows keep old numbers behind their readings
            inside = np.arange(size) < (counts * width)[:, None]
            told = np.where(inside, told, self.numbers[rows, :size])
        self.numbers[rows, :size] = told

    def page(
        self,
        rows: IndexArray,
        first: npt.NDArray[np.integer],
        messages: Records,
        places: IndexArray,
    ) -> None:
        """Write pages to messages: number of readings, numbers in each, and the numbers.

        Args:
            rows: the devices, k of them.
            first: the first reading of each page; any numbers, (k,).
            messages: changed in place.
            places: the device's message among these, (k,).
        """
        width = self.width[rows].astype(np.intp)
        start = np.maximum(first, 0).astype(np.intp)
        left = np.where(first >= 0, self.count[rows] - start, 0)
        count = np.clip(left, 0, _PAGE // width)
        column, size = np.arange(_PAGE), count * width
        inside = column < size[:, None]
        # Behind the last page the messages' data stay.
        begin = np.where(size, start * width, 0)[:, None]
        source = np.minimum(begin + column, self.numbers.shape[1] - 1)
        data = messages["data"].view("<i4")
        data[places] = np.where(inside, self.numbers[rows[:, None], source], data[places])
        messages["size"][places], messages["result"][places] = 4 * size, count
        messages["i"][places, 0] = width
