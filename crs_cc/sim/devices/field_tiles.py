"""The tiles of pheromone fields: integers are read, added, scaled and spread."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import BoolArray, IndexArray, Int64Array
from crs_cc.sim.geometry.field_grid import NOWHERE, SIDE, TILE
from crs_cc.sim.state.fields import EMPTY

if TYPE_CHECKING:
    from crs_cc.sim.geometry.field_grid import FieldGrid
    from crs_cc.sim.state.fields import FieldState


def read(state: FieldState, grid: FieldGrid, tiles: Int64Array, places: Int64Array) -> Int64Array:
    """Return the integers at places in tiles, 0 for `NOWHERE`."""
    found = state.directory(grid.tiles).take(tiles)
    found *= TILE
    found += places
    return state.amount.reshape(-1).take(found)


def add(
    state: FieldState,
    grid: FieldGrid,
    cells: Int64Array,
    amounts: Int64Array,
    most: Int64Array | np.int64,
) -> None:
    """Add integers to cells, up to a largest one for each; cells may be named several times."""
    tiles, directory = cells // TILE, state.directory(grid.tiles)
    slots = directory.take(tiles)
    new = np.flatnonzero(slots == EMPTY)
    if len(new):
        state.make(tiles[new])
        slots[new] = directory.take(tiles[new])
    places = cells + (slots - tiles) * TILE
    flat = state.amount.reshape(-1)
    np.add.at(flat, places, amounts)
    flat[places] = np.minimum(flat.take(places), most)


def of(state: FieldState, grid: FieldGrid, field: int) -> IndexArray:
    """Return the slots of the tiles of a field."""
    tile, (first, after) = state.tile[: state.used], grid.first_tile[field : field + 2]
    return np.flatnonzero((tile >= first) & (tile < after))


def scale(state: FieldState, grid: FieldGrid, field: int, factor: float) -> None:
    """Multiply all integers of a field by a factor, and drop the tiles that are empty then."""
    slots = of(state, grid, field)
    state.amount[slots] = np.rint(state.amount[slots] * factor).astype(np.int64)
    state.drop_empty()


def spread(state: FieldState, grid: FieldGrid, field: int, share: float) -> None:
    """Move a share of the difference between neighbouring cells of a field to the lower one.

    It is rounded towards 0, so that nothing is lost and no cell falls below 0.
    """
    _make_neighbours(state, grid, field, share)
    slots, directory = of(state, grid, field), state.directory(grid.tiles)
    tiles, amounts = state.tile[slots], state.amount.reshape(-1, SIDE, SIDE)
    before, exist = amounts[slots], grid.exist(field, tiles)
    rights, tops = directory[grid.right(field, tiles)], directory[grid.above(field, tiles)]
    beside = np.concatenate([before[:, :, 1:], amounts[rights][:, :, :1]], axis=2)
    above = np.concatenate([before[:, 1:], amounts[tops][:, :1]], axis=1)
    # Nothing flows to a neighbour without a slot: `_make_neighbours` has made the others.
    exist_beside = np.concatenate([exist[:, :, 1:], _columns(rights != EMPTY)], axis=2)
    exist_above = np.concatenate([exist[:, 1:], _columns(tops != EMPTY).swapaxes(1, 2)], axis=1)
    to_right = np.where(exist_beside, _flow(before - beside, share), 0)
    to_top = np.where(exist_above, _flow(before - above, share), 0)
    after = before - to_right - to_top
    after[:, :, 1:] += to_right[:, :, :-1]
    after[:, 1:] += to_top[:, :-1]
    amounts[slots] = after
    amounts[rights, :, 0] += to_right[:, :, -1]
    amounts[tops, 0] += to_top[:, -1]


def _make_neighbours(state: FieldState, grid: FieldGrid, field: int, share: float) -> None:
    """Make the empty tiles that something flows to from others."""
    slots, directory = of(state, grid, field), state.directory(grid.tiles)
    tiles, amounts = state.tile[slots], state.amount[slots].reshape(-1, SIDE, SIDE)
    edges = (
        (amounts[:, :, -1], grid.right), (amounts[:, :, 0], grid.left),
        (amounts[:, -1], grid.above), (amounts[:, 0], grid.below),
    )  # fmt: skip
    found = [neighbour(field, tiles)[_flow(edge, share).any(axis=1)] for edge, neighbour in edges]
    wanted = np.concatenate(found)
    wanted = wanted[wanted != NOWHERE]
    state.make(wanted[directory[wanted] == EMPTY])


def _columns(flags: BoolArray) -> BoolArray:
    """Return a column of a tile for each flag, (tiles, 8, 1)."""
    return np.broadcast_to(flags[:, None, None], (len(flags), SIDE, 1))


def _flow(difference: Int64Array, share: float) -> Int64Array:
    """Return the flow along differences."""
    return (difference * share).astype(np.int64)
