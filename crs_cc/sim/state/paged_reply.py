"""Readings that are too long for one message: the last reply, kept for its further pages.

>>> from crs_cc.requests import MESSAGE
>>> reply, robots = PagedReply.nothing(2, room=6), np.array([0, 1])
>>> readings = np.array([[[1, 2], [3, 4]], [[5, 6], [0, 0]]])   # the second robot has only one
>>> reply.keep(robots, width=2, counts=np.array([2, 1]), numbers=readings)
>>> messages = np.zeros(2, MESSAGE)
>>> reply.page(robots, np.array([1, 0]), messages, places=robots)
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

from crs_cc.core.arrays import IndexArray, Int32Array, Records, all_of
from crs_cc.requests import DATA_SIZE
from crs_cc.sim.state.rows import simplest

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
        values = numbers.reshape(len(rows), size)
        if not (counts < numbers.shape[1]).any():
            self.numbers[rows, :size] = values
            return
        # Rows keep old numbers behind their readings.
        inside = np.arange(size) < (counts * width)[:, None]
        which = simplest(rows, len(self.count))
        if isinstance(which, slice):
            np.copyto(self.numbers[:, :size], values, where=inside, casting="unsafe")
        else:
            self.numbers[rows, :size] = np.where(inside, values, self.numbers[rows, :size])

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
        size = count * width
        # Behind the last page the messages' data stay.
        begin = np.where(size, start * width, 0)
        self._copy(rows, begin, size, messages["data"].view("<i4"), places)
        messages["size"][places], messages["result"][places] = 4 * size, count
        messages["i"][places, 0] = width

    def _copy(
        self,
        rows: IndexArray,
        begin: IndexArray,
        size: IndexArray,
        data: Int32Array,
        places: IndexArray,
    ) -> None:
        """Copy `size` numbers from `begin` on, of each device, to the starts of rows of `data`."""
        first, column = int(begin.max(initial=0)), np.arange(_PAGE)
        if all_of((begin == first) | (size == 0)):  # all ask for the same page
            numbers = self.numbers[:, first : first + _PAGE]
            numbers = numbers[simplest(rows, len(self.numbers))]
            where, count = simplest(places, len(data)), numbers.shape[1]
            inside = column[:count] < size[:, None]
            if isinstance(where, slice):
                np.copyto(data[:, :count], numbers, where=inside)
            else:
                data[where, :count] = np.where(inside, numbers, data[where, :count])
            return
        source = np.minimum(begin[:, None] + column, self.numbers.shape[1] - 1)
        numbers = self.numbers[rows[:, None], source]
        data[places] = np.where(column < size[:, None], numbers, data[places])
