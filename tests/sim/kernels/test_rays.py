"""The kernel of rays measures what numpy measures with all pairs of beam and shape, to the bit."""

from __future__ import annotations

import math

import numpy as np
import pytest

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.geometry import rays
from crs_cc.sim.geometry.contact_mask import Pieces
from crs_cc.sim.geometry.obstacles import Obstacles
from crs_cc.sim.geometry.rays import Fan, nearest
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.kernels.program import Kernels
from crs_cc.sim.kernels.surveys import Shapes, scan
from crs_cc.sim.model.world import Box
from tests.sim.geometry import numpy_rays
from tests.sim.geometry.test_rays import RING, crowd

FEW = [(0.3, -0.1, 0.2, 0.6, 3.0), (-0.25, 0.2, 2.0, 0.0, 6.0), (0.0, 0.0, 4.0, 0.01, 2.0)]
WIDE = [(0.1, 0.0, way, 0.9, 4.0) for way in (0.0, 1.0, 5.0)]
SCAN = [(0.15, 0.0, way, 0.002, 7.0) for way in np.linspace(-math.pi / 2, math.pi / 2, 91)]
FANS = {
    "ring": Fan.of(RING),
    "few": Fan.of(FEW),
    "wide": Fan.of(WIDE),
    "scan": Fan.of(SCAN),
    "all around": Fan.of((0.0, 0.0, n * math.pi / 8, 0.0, 5.0) for n in range(16)),
}
WORLDS = [crowd(robots, seed=robots) for robots in (20, 150)]


def look(
    world: int, fan: Fan, *, turned: bool = True
) -> tuple[FloatArray, FloatArray, IndexArray, Obstacles, IndexArray]:
    """Return poses, distances, objects, and what they were measured from."""
    scene = Scene(WORLDS[world])
    start, own = scene.start[: scene.robots].copy(), np.arange(scene.robots)
    if not turned:
        start[:, 2] = np.rint(start[:, 2]) * (math.pi / 4)
    moving = scene.moving(scene.start[:, :2], scene.start[:, 2])
    obstacles = Obstacles(scene.fixed, moving, fan.reach_m, fan.start_m)
    objects = np.zeros((scene.robots, len(fan)), dtype=np.intp)
    found_m = nearest(fan, start, obstacles, own=own, objects=objects)
    return start, found_m, objects, obstacles, own


@pytest.mark.parametrize("world", range(len(WORLDS)))
@pytest.mark.parametrize("turned", [True, False])
@pytest.mark.parametrize("fan", FANS.values(), ids=FANS.keys())
def test_distances_and_objects_are_those_of_numpy(fan: Fan, world: int, *, turned: bool) -> None:
    poses, found_m, objects, obstacles, own = look(world, fan, turned=turned)
    wanted_m, wanted = numpy_rays.nearest(fan, poses, obstacles, own)
    assert np.array_equal(found_m, wanted_m)
    assert np.array_equal(objects, wanted)
    assert np.isfinite(found_m).mean() > 0.2
    assert np.array_equal(nearest(fan, poses, obstacles, own=own), found_m)


def test_the_checked_build_measures_the_same_without_an_error(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    _, unchecked_m, _, _, _ = look(1, FANS["ring"])
    checked = Kernels(checked=True)
    monkeypatch.setattr(rays, "kernels", lambda: checked)
    assert np.array_equal(look(1, FANS["ring"])[1], unchecked_m)


def test_one_call_and_many_measure_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    _, together_m, objects, _, _ = look(1, FANS["ring"])
    small = Kernels()
    small.room = 1600
    monkeypatch.setattr(rays, "kernels", lambda: small)
    _, found_m, found, _, _ = look(1, FANS["ring"])
    assert np.array_equal(found_m, together_m)
    assert np.array_equal(found, objects)


@pytest.mark.parametrize("checked", [False, True])
@pytest.mark.parametrize("fan", FANS.values(), ids=FANS.keys())
def test_all_shapes_at_once_are_measured_as_those_near(fan: Fan, *, checked: bool) -> None:
    poses, _, _, obstacles, own = look(0, fan)
    scene = Scene(WORLDS[0])
    pieces = Pieces(scene, fan.start_m)
    solid = next(each for each in scene.fixed_solids if isinstance(each, Box))
    poses[::3, :2] = solid.pose.x_m, solid.pose.y_m
    found_m = nearest(fan, poses, obstacles, own=own)
    covered = pieces.cover(fan, poses)
    found_m[covered] = 0.0
    assert covered.any()
    own_kernels, shapes = Kernels(checked=checked), Shapes.of(*obstacles.rows(), pieces.rows)
    together_m = scan(own_kernels, fan.table, poses, own, shapes)
    assert together_m is not None
    assert np.array_equal(together_m, found_m)
    own_kernels.room = 100
    assert scan(own_kernels, fan.table, poses, own, shapes) is None
