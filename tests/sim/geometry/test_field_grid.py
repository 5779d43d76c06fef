"""The cells of pheromone fields, and what is added to them, against plain loops."""

from __future__ import annotations

import math
from collections import Counter

import numpy as np
import pytest

from crs_cc.sim.devices import field_tiles
from crs_cc.sim.geometry.field_grid import NOWHERE, SIDE, TILE, FieldGrid
from crs_cc.sim.model.fields import Field
from crs_cc.sim.model.world import Area
from crs_cc.sim.state.fields import FieldState

AREA = Area(-1.0, -2.0, 4.3, 3.1)
FIELDS = (Field("a", cell_m=0.1), Field("b", cell_m=0.07), Field("c", cell_m=1.0))
OUTSIDE = [(-1.1, 0.0), (0.0, -2.1), (3.4, 0.0), (0.0, 1.2), (math.nan, 0.0), (0.0, math.inf)]


def cell(grid: FieldGrid, field: int, x_m: float, y_m: float) -> int:
    """Return the cell of a place as the module's docstring says it."""
    inside = AREA.x_min_m <= x_m and AREA.y_min_m <= y_m
    if not (inside and math.isfinite(x_m) and math.isfinite(y_m)):
        return NOWHERE
    column = math.floor((x_m - AREA.x_min_m) / FIELDS[field].cell_m)
    row = math.floor((y_m - AREA.y_min_m) / FIELDS[field].cell_m)
    if column >= grid.columns[field] or row >= grid.rows[field]:
        return NOWHERE
    tile = int(grid.first_tile[field]) + row // SIDE * -(-int(grid.columns[field]) // SIDE)
    return (tile + column // SIDE) * TILE + row % SIDE * SIDE + column % SIDE


@pytest.mark.parametrize("outside", [[], OUTSIDE], ids=["inside", "some outside"])
def test_cells_are_those_of_a_plain_loop(outside: list[tuple[float, float]]) -> None:
    grid, random = FieldGrid(AREA, FIELDS), np.random.default_rng(3)
    places = [*zip(random.uniform(-1, 3.3, 200), random.uniform(-2, 1.1, 200), strict=True)]
    x_m, y_m = np.array(places + outside).T
    fields = random.integers(0, len(FIELDS), len(x_m))
    found = grid.cells(fields, x_m, y_m)
    each = zip(fields.tolist(), x_m.tolist(), y_m.tolist(), strict=True)
    assert found.tolist() == [cell(grid, *one) for one in each]
    assert (np.count_nonzero(found == NOWHERE) > 0) == bool(outside)
    there = found != NOWHERE
    assert (np.broadcast_to(grid.field(found[there]), there.sum()) == fields[there]).all()
    for field in range(len(FIELDS)):
        assert (grid.cells(field, x_m, y_m)[fields == field] == found[fields == field]).all()


def test_what_is_added_at_once_is_summed_and_then_cut() -> None:
    grid, random = FieldGrid(AREA, FIELDS[:1]), np.random.default_rng(4)
    none = np.zeros(0, np.int64)
    state = FieldState(
        np.array([1.0]), none, none, 1, np.full(1, NOWHERE), np.zeros((1, TILE), np.int64)
    )
    expected: Counter[int] = Counter()
    for _ in range(5):
        cells = grid.cells(0, random.uniform(0, 0.5, 300), random.uniform(0, 0.5, 300))
        amounts = random.integers(0, 50, 300)
        field_tiles.add(state, grid, cells, amounts, np.int64(500))
        for one, amount in zip(cells.tolist(), amounts.tolist(), strict=True):
            expected[one] += amount
        expected = Counter({one: min(amount, 500) for one, amount in expected.items()})
    every = np.arange(grid.tiles * TILE)
    found = field_tiles.read(state, grid, every // TILE, every % TILE)
    assert {one: amount for one, amount in enumerate(found.tolist()) if amount} == +expected
    assert 500 in expected.values()
    assert field_tiles.read(state, grid, *np.divmod([NOWHERE], TILE)).tolist() == [0]
