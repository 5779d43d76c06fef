"""The grid of fixed outlines."""

import tracemalloc

import numpy as np

from crs_cc.sim.geometry.obstacles import Grid


def test_many_shapes_in_one_place_take_bounded_memory():
    sides = np.tile([(3.0, 2.0, 4.0, 2.0)], (150_000, 1))
    tracemalloc.start()
    grid = Grid(sides, np.zeros(len(sides)), reach_m=6.5)
    found = [grid.near(np.array([place])) for place in (3.5 + 2j, 9.9 + 2j)]
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 400e6  # a list for each cell of 0.8 m was 2 GB
    for _, shapes in found:
        assert np.array_equal(shapes, np.arange(len(sides)))
