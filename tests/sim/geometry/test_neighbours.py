"""Neighbour search: no near point may be missed, for any distribution of points."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crs_cc.sim.geometry.cell_list import CellList
from crs_cc.sim.geometry.clearance import clearance_m
from crs_cc.sim.geometry.obstacles import Grid
from crs_cc.sim.geometry.scene import Scene
from tests.sim.driver import SCOUT_RADIUS_M, world_of

PLACES = st.lists(
    st.tuples(st.floats(-1e4, 1e4), st.floats(-1e4, 1e4)), min_size=1, max_size=40
)  # fmt: skip


def columns(places):
    table = np.array(places, dtype=np.float64)
    return table[:, 0], table[:, 1]


@settings(max_examples=100, deadline=None)
@given(PLACES, PLACES, st.floats(0.01, 1e4))
def test_every_point_within_reach_is_found_once(points, queries, reach_m):
    (x, y), (ask_x, ask_y) = columns(points), columns(queries)
    asked, found = CellList(x, y, reach_m).near(ask_x, ask_y)
    pairs = list(zip(asked.tolist(), found.tolist(), strict=True))
    distance = np.hypot(ask_x[:, None] - x, ask_y[:, None] - y)
    near = {(int(a), int(b)) for a, b in np.argwhere(distance <= reach_m)}
    assert near <= set(pairs)
    assert len(pairs) == len(set(pairs))
    assert asked.tolist() == sorted(asked.tolist())


def test_most_points_out_of_reach_are_skipped():
    rng = np.random.default_rng(1)
    x, y = rng.uniform(0, 100, (2, 3000))
    asked, _ = CellList(x, y, 2.0).near(x, y)
    assert len(asked) < 3000 * 3000 / 50


@settings(max_examples=60, deadline=None)
@given(
    st.lists(st.tuples(*[st.floats(-30, 30)] * 4), min_size=1, max_size=30),
    st.lists(st.tuples(st.floats(-60, 60), st.floats(-60, 60)), min_size=40, max_size=40),
    st.floats(0.5, 20),
)
def test_grid_finds_every_shape_within_reach(ends, places, reach_m):
    ends_m, radius_m = np.array(ends), np.full(len(ends), 0.25)
    place = np.array([complex(*spot) for spot in places])
    asked, found = Grid(ends_m, radius_m, reach_m).near(np.repeat(place, 40))  # no short cut
    pairs = {(int(a) // 40, int(b)) for a, b in zip(asked, found, strict=True)}
    for number, spot in enumerate(place):
        for shape, (x1, y1, x2, y2) in enumerate(ends):
            along = np.linspace(0, 1, 200)
            line = complex(x1, y1) + along * complex(x2 - x1, y2 - y1)
            if np.abs(line - spot).min() <= reach_m + 0.25:
                assert (number, shape) in pairs


@pytest.mark.parametrize(
    ("elements", "room_m"),
    [
        ("", 5.0),
        ('<robot x="5m" y="6m"/>', 1 - SCOUT_RADIUS_M),
        ('<cylinder x="8m" y="9m" radius="1m"/>', 4.0),
        ('<box x="7m" y="5m" heading="45" length="1m" width="1m"/>', 2 - math.sqrt(0.5)),
        ('<box x="5m" y="3m" length="9m" width="1m" mass="1kg"/>', 1.5),
        ('<cylinder x="5m" y="6m" radius="30cm" mass="1kg"/>', 0.7),
        ('<wall x1="2m" y1="2m" x2="4m" y2="5m" thickness="20cm"/>', 0.9),
    ],
)
def test_clearance_is_the_distance_to_the_nearest_object(elements, room_m):
    scene = Scene(world_of(f'<robot x="5m" y="5m"/>{elements}'))
    found_m = clearance_m(scene, scene.start[:, :2], scene.start[:, 2])
    assert found_m == pytest.approx(room_m - SCOUT_RADIUS_M)
