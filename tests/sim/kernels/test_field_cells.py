"""The kernels of pheromone fields against the same in numpy: equal to the bit."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from crs_cc.core.arrays import FloatArray, Int64Array
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.geometry.field_grid import NOWHERE, TILE, FieldGrid
from crs_cc.sim.kernels import exact
from crs_cc.sim.kernels import field_cells as kernel
from crs_cc.sim.kernels.field_cells import Trails, antenna_cells, trail_cells
from crs_cc.sim.model.fields import Field
from crs_cc.sim.model.world import Area
from tests.sim.kernels.test_drive import moving

AREA = Area(-1.0, -2.0, 4.3, 3.1)
FIELDS = (Field("a", cell_m=0.1), Field("b", cell_m=0.07), Field("c", cell_m=1.0))
MEASURES = np.array([[30.0, 2.0**-16], [1e6, 3.7e-5], [1e6, 2.0**-15]])
SLACK_M = 1e-6


class Small:
    """Kernels with little room, so that robots come in parts."""

    def __init__(self, room: int) -> None:
        self._kernels, self.room, self.calls = kernel.kernels(), room, 0

    def __getattr__(self, name: str):
        return getattr(self._kernels, name)

    def call(self, *arguments: int) -> None:
        self.calls += 1
        self._kernels.call(*arguments)

    def antennae(self, *arguments: Any) -> Int64Array:
        self.calls += 1
        return self._kernels.antennae(*arguments)


@pytest.fixture(params=[None, 2500], ids=["at once", "in parts"])
def parts(request, monkeypatch):
    """Run kernels with all robots at once, or in parts, and check that there were some."""
    if request.param is None:
        yield
        return
    small = Small(request.param)
    monkeypatch.setattr(kernel, "kernels", lambda: small)
    yield
    assert small.calls > 2


def random_poses(random: np.random.Generator, robots: int) -> FloatArray:
    """Return poses, of which some are at the edge of the area or outside."""
    return np.column_stack([
        random.uniform(-1.2, 3.5, robots), random.uniform(-2.2, 1.3, robots),
        random.uniform(-7, 7, robots),
    ])  # fmt: skip


@pytest.mark.usefixtures("parts")
@pytest.mark.parametrize("one_for_all", [True, False])
def test_antennae_end_in_the_cells_that_numpy_finds(one_for_all: bool) -> None:
    grid, random, robots = FieldGrid(AREA, FIELDS), np.random.default_rng(1), 400
    poses = random_poses(random, robots)
    ends_m = random.uniform(-0.4, 0.4, (3, 2, 1 if one_for_all else robots))
    ends_m[2, :, 0] = np.nan  # a robot with two antennae
    tiles, places = antenna_cells(kernel.kernels(), grid.table, ends_m, poses)
    x_m, y_m, heading_rad = poses.T
    ahead = exact.turn(np.ascontiguousarray(heading_rad))
    end_x_m = x_m + (ahead.real * ends_m[:, 0] - ahead.imag * ends_m[:, 1])
    end_y_m = y_m + (ahead.imag * ends_m[:, 0] + ahead.real * ends_m[:, 1])
    for field in range(len(FIELDS)):
        cells = grid.cells(field, end_x_m, end_y_m)
        assert (tiles[field] == cells // TILE).all()
        assert (places[field] == cells % TILE).all()
        assert 0 < np.count_nonzero(cells == NOWHERE) < cells.size


def test_robots_are_where_their_mounts_are() -> None:
    state, constants = moving(3)
    state.bodies.slipping[::3] = True
    state.base_rad[:] = np.linspace(1, 5, len(state.base_rad))
    assert constants.drives.turrets
    assert constants.drives.synchros
    home = state.rows.resident_kernels(constants.kinds)
    assert home is not None
    grid, ends_m = FieldGrid(Area(-9.0, -9.0, 30.0, 30.0), FIELDS), np.full((2, 2, 1), 0.7)
    for rows in (np.arange(len(state.base_rad)), np.array([4, 1, 2, 8])):
        expected = antenna_cells(
            kernel.kernels(), grid.table, ends_m, mount_poses(state, constants, rows)
        )
        expected = expected[0].copy(), expected[1].copy()
        for robots in (rows, len(rows)) if rows[0] == 0 else (rows,):
            found = antenna_cells(home, grid.table, ends_m, robots)
            for ours, theirs in zip(found, expected, strict=True):
                assert (ours == theirs).all()


def trails_by_numpy(grid: FieldGrid, trails: Trails) -> tuple[Int64Array, Int64Array]:
    """Return the cells and integers of trails, piece by piece."""
    position_m, from_m, moved_m, per_m, field = trails
    way_m = position_m - from_m
    straight_m = exact.hypot(way_m[:, 0], way_m[:, 1])
    way_m[~(straight_m <= moved_m + SLACK_M)] = 0.0
    pieces = np.ceil(straight_m / grid.cell_m[field])
    pieces = np.where(pieces <= kernel.PIECES, np.maximum(pieces, 1.0), kernel.PIECES)
    amount = np.minimum(per_m * moved_m / pieces, MEASURES[field, 0])
    deposit = np.rint(amount / MEASURES[field, 1]).astype(np.int64)
    found = []
    for number in range(int(pieces.max())):
        there = pieces > number
        back = 1.0 - (number + 0.5) / pieces[there]
        place_m = position_m[there] - way_m[there] * back[:, None]
        cells = grid.cells(field[there], place_m[:, 0], place_m[:, 1])
        found.append(np.stack([cells, deposit[there]])[:, cells != NOWHERE])
    cells, laid = np.concatenate(found, axis=1)
    return cells, laid


def pairs(found: tuple[Int64Array, Int64Array]) -> list[tuple[int, int]]:
    """Return cells with their integers, in an order of their own."""
    cells, laid = found
    return sorted(zip(cells.tolist(), laid.tolist(), strict=True))


@pytest.mark.usefixtures("parts")
def test_trails_are_those_of_numpy_in_any_order() -> None:
    grid, random, robots = FieldGrid(AREA, FIELDS), np.random.default_rng(2), 400
    position_m, way_m = random_poses(random, robots)[:, :2], random.normal(0, 0.4, (robots, 2))
    way_m[2::7] *= 100.0  # farther than the largest number of pieces
    way_m[3::7] = 0.0
    moved_m = np.hypot(*way_m.T) + random.uniform(-1e-6, 1e-6, robots)
    moved_m[1::7] *= 0.5  # carried
    way_m[::7] = np.nan  # new in the world
    per_m, field = random.uniform(0, 500, robots), random.integers(0, len(FIELDS), robots)
    per_m[4::7] = 1e300
    trails = Trails(position_m, position_m - way_m, moved_m, per_m, field)
    found = trail_cells(grid.table, MEASURES, trails)
    assert len(found[0]) > robots
    assert pairs(found) == pairs(trails_by_numpy(grid, trails))
    order = random.permutation(robots)
    other = Trails(*(column[order] for column in trails))
    assert pairs(trail_cells(grid.table, MEASURES, other)) == pairs(found)
