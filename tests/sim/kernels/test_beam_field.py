"""Beams among sorted shapes measure what they do against the pairs that numpy selects."""

from __future__ import annotations

import math

import numpy as np
import pytest

from crs_cc.sim.devices.ray_caster import RayCaster
from crs_cc.sim.geometry.rays import Fan, nearest
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.kernels import beam_field, program
from crs_cc.sim.state.env_state import EnvState
from tests.sim.driver import world_of

ELEMENTS = (
    '<wall x1="1m" y1="1m" x2="9m" y2="8m" thickness="5cm"/>'
    '<box x="3m" y="8m" heading="30" length="80cm" width="30cm"/>'
    '<cylinder x="7m" y="2m" radius="25cm"/>'
    '<polygon points="5,7.5 6,7.5 5.3,7.8 5,8.5"/>'
    '<box x="5m" y="2m" heading="50" length="40cm" width="30cm" mass="1kg"/>'
    '<cylinder x="2m" y="5m" radius="15cm" mass="1kg"/>'
)
ROBOTS = 40
BEAMS = [(0.2 * math.cos(a), 0.2 * math.sin(a), a, 0.0, 4.0) for a in np.arange(16) * math.pi / 8]
CONES = [(0.1, 0.05, a, math.radians(12), 9.0) for a in np.arange(5) * 1.2]


def crowd(elements: str = ELEMENTS):
    """Return a state, its scene, and poses at which robots overlap objects, and each other."""
    robots = "".join(f'<robot x="{11 + n % 8}m" y="{1 + n // 8}m"/>' for n in range(ROBOTS))
    world = world_of(elements + robots, 'length="20m" width="10m"')
    state, rng = EnvState.at_start(world), np.random.default_rng(7)
    state.bodies.position_m[:] = rng.uniform(-1, 11, state.bodies.position_m.shape)
    poses = np.column_stack([state.bodies.position_m[:ROBOTS], rng.uniform(0, 7, ROBOTS)])
    return state, Scene(world), poses


def by_pairs(rays: RayCaster, state, fan: Fan, poses):
    distance_m = nearest(fan, poses, rays.obstacles(state), own=np.arange(len(poses)))
    distance_m[rays._pieces.cover(fan, poses)] = 0.0
    return distance_m


@pytest.mark.parametrize("beams", [BEAMS, CONES])
@pytest.mark.parametrize("elements", [ELEMENTS, ""])
def test_distances_are_those_of_pairs(beams, elements):
    state, scene, poses = crowd(elements)
    fan, own = Fan.of(beams), np.arange(ROBOTS)
    rays = RayCaster(scene, [fan])
    for _ in range(5):
        assert rays.few_shapes(state, ROBOTS) is None
        expected = by_pairs(rays, state, fan, poses)
        assert rays.distances_m(state, fan, poses, own).tobytes() == expected.tobytes()
        assert (expected == 0).any() or not elements
        assert rays._is_sorted
        state.bodies.position_m[:] += 0.3
        state.cycle += 1


@pytest.mark.parametrize("threads", [2, 3])
def test_threads_measure_the_same_whenever_shapes_have_moved(monkeypatch, threads):
    monkeypatch.setattr(beam_field, "ROBOTS_PER_THREAD", 1)
    state, scene, poses = crowd()
    fan, own = Fan.of(BEAMS), np.arange(ROBOTS)
    rays = RayCaster(scene, [fan], threads)
    before = None
    for cycle in range(6):
        expected = by_pairs(rays, state, fan, poses)
        assert before is None or not np.array_equal(expected[1::2], before[1::2])
        few = 2 if cycle == 3 else ROBOTS  # then shapes are sorted in some instances only
        found = rays.distances_m(state, fan, poses[:few], own[:few])
        assert found.tobytes() == expected[:few].tobytes()
        before = expected
        state.bodies.position_m[:] += 0.3
        state.cycle += 1
    assert len(rays._field._sorted) == threads


def test_few_robots_are_measured_in_one_thread():
    state, scene, poses = crowd()
    fan = Fan.of(BEAMS)
    rays = RayCaster(scene, [fan], 2)
    rays.distances_m(state, fan, poses, np.arange(ROBOTS))
    assert len(rays._field._sorted) == 1


def test_beams_that_are_not_tried_hit_nothing():
    """A beam that is as wide as that makes the kernel try all beams with all shapes."""
    rng = np.random.default_rng(3)
    elements = "".join(
        f'<cylinder x="{x:.2f}m" y="{y:.2f}m" radius="{radius:.3f}m"/>'
        f'<box x="{y:.2f}m" y="{x:.2f}m" length="{2 * radius:.3f}m" width="5cm" heading="{x:.1f}"/>'
        for x, y, radius in rng.uniform((0, 0, 0.01), (10, 10, 0.8), (40, 3))
    )
    state, scene, poses = crowd(elements)
    slow, rays = (RayCaster(scene, [Fan.of(BEAMS)]) for _ in range(2))
    wide = (0.0, 0.0, 1.0, 1.0, 4.0)
    own, fans = np.arange(ROBOTS), (Fan.of(BEAMS), Fan.of([*BEAMS, wide]))
    for turn_rad in np.linspace(0.0, 7.0, 15):
        poses[:, 2] += turn_rad
        found, expected = (
            each.distances_m(state, fan, poses, own)
            for each, fan in zip((rays, slow), fans, strict=True)
        )
        assert found.tobytes() == np.ascontiguousarray(expected[:, : len(BEAMS)]).tobytes()


def test_robots_are_divided_if_their_beams_have_no_room(monkeypatch):
    state, scene, poses = crowd()
    fan = Fan.of(BEAMS)
    monkeypatch.setattr(beam_field, "_WORK", len(fan.table) + 7 * 37)
    rays = RayCaster(scene, [fan])
    expected = by_pairs(rays, state, fan, poses)
    assert np.array_equal(rays.distances_m(state, fan, poses, np.arange(ROBOTS)), expected)


@pytest.mark.parametrize("room", [50, 420, 700])
def test_without_room_pairs_are_selected(monkeypatch, room):
    state, scene, poses = crowd()
    fan = Fan.of(BEAMS)
    monkeypatch.setattr(beam_field, "_WORK", 3 * program._ARENA[0] - room)
    rays = RayCaster(scene, [fan])
    expected = by_pairs(rays, state, fan, poses)
    assert np.array_equal(rays.distances_m(state, fan, poses, np.arange(ROBOTS)), expected)
    assert rays._has_no_room


def test_checked_kernels_give_the_same(monkeypatch):
    state, scene, poses = crowd()
    fan = Fan.of(BEAMS)
    rays = RayCaster(scene, [fan])
    expected = by_pairs(rays, state, fan, poses)
    made = program.Kernels
    monkeypatch.setattr(beam_field, "Kernels", lambda **sizes: made(**sizes, checked=True))
    assert np.array_equal(rays.distances_m(state, fan, poses, np.arange(ROBOTS)), expected)


def test_a_fan_without_beams_measures_nothing():
    state, scene, poses = crowd()
    fan = Fan.of([])
    rays = RayCaster(scene, [fan])
    assert rays.distances_m(state, fan, poses, np.arange(ROBOTS)).shape == (ROBOTS, 0)
