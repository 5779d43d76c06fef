"""The contents of the pheromone fields of a world: only tiles of cells that are not empty.

Amounts are integers, so that sums do not depend on the order of robots. A field evaporates without
any work: an integer u represents the amount

    u * UNIT * exp(-(t - base) / evaporation)        at the time t

where the base is the same for all cells of a field; see `devices.fields`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int64Array
from crs_cc.sim.geometry.field_grid import NOWHERE, TILE
from crs_cc.sim.model.world import WorldModel

UNIT: Final = 1.0 / 65536.0
"""Amount of the integer 1 at the base time; our choice. 10^6 times e^5 (the largest factor between
two bases) from each of 100,000 robots at once is less than 2^63."""

EMPTY: Final = 0
"""The slot of all tiles that hold nothing."""


class _WithDirectory:
    """Where the tiles of a state are, besides its fields."""

    __slots__ = ("_directory",)

    used: int
    tile: Int64Array

    def __post_init__(self) -> None:
        self._directory: IndexArray | None = None

    def directory(self, tiles: int) -> IndexArray:
        """Return the slot of each of all tiles, `EMPTY` for those that hold nothing.

        The last entry is that of `NOWHERE`.
        """
        if self._directory is None:
            self._directory = np.zeros(tiles + 1, dtype=np.intp)
            self._enter(1)
        return self._directory

    def _forget(self) -> None:
        """Drop the directory, as tiles have other slots now."""
        self._directory = None

    def _enter(self, first: int) -> None:
        """Enter the tiles from a slot on into the directory."""
        if self._directory is not None:
            self._directory[self.tile[first : self.used]] = np.arange(first, self.used)


@dataclass(slots=True)
class FieldState(_WithDirectory):
    """The contents of all fields.

    Attributes:
        evaporation_s: evaporation time of each field, infinite for never, (fields,).
        deposit_cell: the cells of deposits in this timestep, see `geometry.field_grid`,
            (deposits,).
        deposit: their integers, (deposits,).
        used: number of slots in use, the first ones.
        tile: the tile in each slot; `NOWHERE` for the first one, which is empty, (slots,).
        amount: the integers of its cells, (slots, 64).
    """

    evaporation_s: FloatArray
    deposit_cell: Int64Array
    deposit: Int64Array
    used: int
    tile: Int64Array
    amount: Int64Array

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return empty fields."""
        none = np.zeros(0, dtype=np.int64)
        return cls(
            evaporation_s=np.array([field.evaporation_s for field in world.fields]),
            deposit_cell=none,
            deposit=none,
            used=1,
            tile=np.full(1, NOWHERE),
            amount=np.zeros((1, TILE), dtype=np.int64),
        )

    def make(self, tiles: Int64Array) -> None:
        """Give tiles a slot that have none; they may be named several times."""
        if not len(tiles):
            return
        tiles = np.unique(tiles)
        first, self.used = self.used, self.used + len(tiles)
        if self.used > len(self.tile):
            size = max(2 * len(self.tile), self.used)
            tile, amount = self.tile, self.amount
            self.tile = np.full(size, NOWHERE)
            self.amount = np.zeros((size, TILE), dtype=np.int64)
            self.tile[:first], self.amount[:first] = tile[:first], amount[:first]
        self.tile[first : self.used] = tiles
        self._enter(first)

    def drop_empty(self) -> None:
        """Drop the tiles that hold nothing, and the memory that is free then."""
        keep: BoolArray = (self.amount[: self.used] != 0).any(axis=1)
        keep[EMPTY] = True
        if keep.all():
            return
        self.tile, self.amount = self.tile[: self.used][keep], self.amount[: self.used][keep]
        self.used = len(self.tile)
        self._forget()
