"""Robots that messages are for, sorted by grid cell in the memory of kernels.

>>> hearing = Hearing()
>>> places_m = np.array([[0.0, 0.0], [3.0, 4.0], [9.0, 0.0]])
>>> hearing.place(places_m, np.ones(3, dtype=np.bool_))
>>> nobody, none = np.zeros(3, dtype=np.bool_), np.zeros(3, np.uint32)
>>> said = np.array([[0.0, 0.0, 6.0, 0.0, -1.0, 0.0]])
>>> found = hearing.pairs(said, nobody, none)
>>> found.message.tolist(), found.hearer.tolist(), found.distance_m.tolist()
([0], [1], [5.0])
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final, NamedTuple

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Records
from crs_cc.core.errors import WorldError
from crs_cc.core.source import Location
from crs_cc.sim.kernels.program import Kernels
from crs_cc.sim.kernels.sorted_shapes import grid_of, sort_shapes
from crs_cc.sim.kernels.tables import HEAR

_NUMBER: Final = 8  # bytes
_BITS: Final = 64  # of a number
_MAX_MESSAGES: Final = 1024  # for one call of the kernel
_MIN_CELL_M: Final = 0.1
_PAIR: Final = np.dtype([("message", "<i4"), ("hearer", "<i4"), ("distance_m", "<f8")])
_NONE: Final = np.zeros((0, 7)), np.zeros((0, 14))


class Heard(NamedTuple):
    """Pairs of a message and a robot that it is for, by message and then by robot.

    Attributes:
        message: the messages, (p,).
        hearer: the robots, (p,).
        distance_m: how far each is from where the message is sent, (p,).
        is_missed: whether a robot in range of each message to several is full, (messages,).
    """

    message: IndexArray
    hearer: IndexArray
    distance_m: FloatArray
    is_missed: BoolArray


class Hearing:
    """Robots that may hear messages."""

    def __init__(self) -> None:
        self._kernels = Kernels(is_arena=True)
        self._robots = self._end = 0  # how many, and where they end in the memory

    def place(self, places_m: FloatArray, present: BoolArray) -> None:
        """Sort the robots by position.

        Args:
            places_m: where they are, (robots, 2).
            present: which of them are in the world, (robots,).

        Raises:
            WorldError: there is no room for all.
        """
        here, self._robots = np.flatnonzero(present), len(places_m)
        circles = np.zeros((len(here), 5))
        circles[:, 1], circles[:, 2:4] = here, places_m[here]
        grid = grid_of(circles[:, 2:4], _MIN_CELL_M, max(len(here), 1))
        place, size = 3 * self._robots, 0
        if place < self._kernels.room:
            self._kernels.lay(places_m.tobytes())
            tables = _NONE[0], circles, _NONE[1]
            size = sort_shapes(self._kernels, place, tables, grid)
        self._end = place + size
        if not size or self._kernels.room - self._end < 4 * self._robots:
            raise WorldError.at(
                Location("<world>"), f"too many robots send messages: {self._robots}"
            )

    def pairs(
        self, messages: FloatArray, is_full: BoolArray, groups: npt.NDArray[np.uint32]
    ) -> Heard:
        """Return which robots messages are for.

        A message to one robot is for that one, wherever it is; one to several is for those in
        range which are in its group, but for its sender and those that are full.

        Args:
            messages: of each, where it is sent and how far it is heard [m], its sender, the robot
                that it is for, -1 for several, and its groups as bits, 0 for all; (k, 6).
            is_full: which robots are full, (robots,).
            groups: the groups of robots as bits, (robots,).
        """
        self._kernels.lay(np.column_stack([is_full, groups]).tobytes(), 2 * self._robots)
        found = [self._few_pairs(messages[first : first + _MAX_MESSAGES], first)
                 for first in range(0, len(messages), _MAX_MESSAGES)]  # fmt: skip
        pairs = _joined([part for parts, _ in found for part in parts], _PAIR)
        message, hearer = (pairs[name].astype(np.intp) for name in ("message", "hearer"))
        is_missed = _joined([each for _, each in found], np.dtype(np.bool_))
        return Heard(message, hearer, pairs["distance_m"].copy(), is_missed)

    def _few_pairs(self, messages: FloatArray, first: int) -> tuple[list[Records], BoolArray]:
        """Return the same of messages that have room, numbered from `first` on."""
        kernels, count = self._kernels, len(messages)
        kernels.lay(messages.tobytes(), self._end)
        missed = self._end + messages.size
        marks = missed + count // 2 + 1
        pairs = marks + (self._robots + _BITS - 1) // _BITS
        found, done, size = [], 0, _PAIR.itemsize // _NUMBER
        sizes = self._robots, (kernels.room - pairs) // size
        while done < count:
            places = 3 * self._robots, self._end, marks, missed
            kernels.call(HEAR, done, count, *sizes, *places)
            done = kernels.result
            number = kernels.arena[missed:].view(np.int32)[count]
            some = kernels.arena[pairs : pairs + number * size].view(_PAIR).copy()
            some["message"] += first
            found.append(some)
        return found, kernels.arena[missed:].view(np.int32)[:count] != 0


def _joined(parts: Sequence[npt.NDArray[Any]], dtype: np.dtype[Any]) -> npt.NDArray[Any]:
    """Return arrays as one."""
    return parts[0] if len(parts) == 1 else np.concatenate([np.zeros(0, dtype), *parts])
