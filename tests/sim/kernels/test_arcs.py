"""The kernel of arcs computes what numpy computes, to the bit."""

from __future__ import annotations

import numpy as np

from crs_cc.sim.kernels import exact
from crs_cc.sim.kernels.program import BLOCK, kernels


def test_arcs_are_those_of_numpy() -> None:
    random = np.random.default_rng(4)
    heading_rad, turn_rad = random.uniform(-9, 9, BLOCK + 7), random.uniform(-1, 1, BLOCK + 7)
    way_m = random.uniform(-2, 2, BLOCK + 7)
    turn_rad[::5] = 0.0
    direction = heading_rad + turn_rad / 2
    half_rad = np.where(turn_rad == 0.0, 1e-20, turn_rad / 2)
    chord_m = way_m * (exact.sin(half_rad) / half_rad)
    x_m, y_m = kernels().arcs(heading_rad, way_m, turn_rad)
    assert (x_m == chord_m * exact.cos(direction)).all()
    assert (y_m == chord_m * exact.sin(direction)).all()
