"""Room among sorted shapes is what measuring all pairs with numpy gives, to the bit."""

from __future__ import annotations

import numpy as np
import pytest

from crs_cc.core import segment
from crs_cc.sim.kernels import program, room_field
from crs_cc.sim.kernels.room_field import RoomField

LOOK_M = 1.5
DISCS = 150


def scene(seed: int, shapes: int = 60):
    """Return ends and radii of fixed shapes, and discs, some of which overlap or are beyond."""
    rng = np.random.default_rng(seed)
    start_m = rng.uniform(-5, 5, (shapes, 2))
    ends_m = np.column_stack([start_m, start_m + rng.normal(0, 2, (shapes, 2))])
    ends_m[::3, 2:] = ends_m[::3, :2]
    thick_m = np.where(np.arange(shapes) % 3, 0.0, rng.uniform(0.05, 0.8, shapes))
    ends_m[1::9], thick_m[1::9] = np.rint(ends_m[1::9]), 0.0
    discs = np.column_stack([rng.uniform(-12, 12, (DISCS, 2)), rng.uniform(0.0, 0.4, DISCS)])
    discs[::5, :2] = np.rint(discs[::5, :2])
    discs[-10:, :2] += 30
    return ends_m, thick_m, discs


def of_all_pairs(ends_m, thick_m, discs, which, need_m):
    mine, others = discs[which][:, None], discs[None]
    away_x, away_y = mine[..., 0] - others[..., 0], mine[..., 1] - others[..., 1]
    gap_m = np.sqrt(away_x * away_x + away_y * away_y) - others[..., 2] - mine[..., 2]
    gap_m[np.arange(len(which)), which] = np.inf
    ax, ay, bx, by = ends_m.T
    far_m = segment.distance(mine[..., 0] - ax, mine[..., 1] - ay, bx - ax, by - ay)
    far_m -= thick_m + mine[..., 2]
    room_m = np.minimum(gap_m.min(axis=1), far_m.min(axis=1, initial=np.inf))
    return np.minimum(room_m, LOOK_M), np.flatnonzero((far_m < need_m).any(axis=0))


@pytest.mark.parametrize("most", [room_field._MAX_DISCS, 7])
@pytest.mark.parametrize("shapes", [60, 0])
def test_room_is_that_of_all_pairs(monkeypatch, most, shapes):
    monkeypatch.setattr(room_field, "_MAX_DISCS", most)
    sizes = set()
    for seed in range(4):
        ends_m, thick_m, discs = scene(seed, shapes)
        field, rng = RoomField(ends_m, thick_m, LOOK_M), np.random.default_rng(seed)
        for _ in range(4):
            which, need_m = np.flatnonzero(rng.random(DISCS) < 0.4), rng.uniform(0.01, LOOK_M)
            room_m, near = field.measure(discs, which, need_m)
            wanted_m, wanted = of_all_pairs(ends_m, thick_m, discs, which, need_m)
            assert room_m.tobytes() == wanted_m.tobytes()
            assert np.array_equal(near, wanted)
            assert (room_m < 0).any()
            assert (room_m == LOOK_M).any()
            sizes.add(len(near))
            discs[:, :2] += rng.normal(0, 0.2, (DISCS, 2))
    assert len(sizes) > 10 or not shapes


def test_shapes_without_room_for_all_are_divided(monkeypatch):
    ends_m, thick_m, discs = scene(9)
    which = np.arange(DISCS)
    expected = of_all_pairs(ends_m, thick_m, discs, which, 0.3)
    monkeypatch.setattr(room_field, "_WORK", 3 * program._ARENA[0] // 2 - 120)
    monkeypatch.setattr(room_field, "_MAX_DISCS", 100)
    field = RoomField(ends_m, thick_m, LOOK_M)
    assert 1 < len(field._blocks) < len(ends_m)
    for found, wanted in zip(field.measure(discs, which, 0.3), expected, strict=True):
        assert np.array_equal(found, wanted)


def test_the_checked_build_measures_the_same(monkeypatch):
    ends_m, thick_m, discs = scene(1)
    which = np.arange(DISCS)
    made = program.Kernels
    monkeypatch.setattr(room_field, "Kernels", lambda **sizes: made(**sizes, checked=True))
    found = RoomField(ends_m, thick_m, LOOK_M).measure(discs, which, 0.3)
    expected = of_all_pairs(ends_m, thick_m, discs, which, 0.3)
    assert all(np.array_equal(*each) for each in zip(found, expected, strict=True))
