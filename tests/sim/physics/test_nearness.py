"""Among many robots, only those that are near something are in the physics' space."""

from __future__ import annotations

import math
import pickle

import numpy as np
import pytest

from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.physics.nearness import Nearness
from crs_cc.sim.physics.simulation import Physics
from tests.sim.driver import world_of
from tests.sim.physics.test_simulation import DT, Bench, go_back

SIDE = 9  # robots in a row
CROWD = "".join(
    f'<robot x="{1 + column}m" y="{1 + row}m"/>' for row in range(SIDE) for column in range(SIDE)
)
PUCKS = "".join(f'<cylinder x="{0.5 + n}m" y="0.5m" radius="6cm" mass="1kg"/>' for n in range(SIDE))
AREA = f'length="{SIDE + 1}m" width="{SIDE + 1}m"'
SHORT = SIDE * SIDE


def wandering(cycles: int, seed: int):
    """Yield displacements of a crowd; some of it stand, and all turn now and then."""
    rng = np.random.default_rng(seed)
    for number in range(cycles):
        if number % 15 == 0:
            angle = rng.uniform(0, math.tau, SHORT)
            speed_mps = rng.choice([0.0, 0.3, 0.6], SHORT)
        yield DT * speed_mps[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])


def columns(cycles: int):
    """Yield displacements by which neighbours meet in pairs, part, and the others drive alone."""
    way_m = np.zeros((SHORT, 2))
    way_m[0::3, 0], way_m[1::3, 0] = 0.02, -0.015
    way_m[2::3, 1] = 0.01
    way_m[5::9] = way_m[8::9] = 0.0
    for number in range(cycles):
        yield way_m if number % 70 < 50 else -way_m


def run(bench: Bench, ways) -> list[list[bytes]]:
    found = []
    for way_m in ways:
        bench.pull(way_m)
        found.append(bench.digest())
    return found


@pytest.mark.parametrize("pucks", ["", PUCKS])
def test_robots_that_are_left_out_move_as_in_the_space(monkeypatch, pucks):
    world = world_of(CROWD + pucks, AREA)
    bench = Bench(world)
    left_out, ways = [], list(columns(130))
    for way_m in ways:
        contacts = bench.pull(way_m)
        left_out.append((bench.digest(), contacts))
        assert len(bench.physics._space.numbers) < SHORT + 4
    assert sum(len(contacts.robot) > 0 for _, contacts in left_out) > 20
    monkeypatch.setattr(Physics, "leaves_out", False)
    whole = Bench(world)
    for way_m, (digest, found) in zip(ways, left_out, strict=True):
        contacts = whole.pull(way_m)
        assert np.array_equal([contacts.robot, contacts.other], [found.robot, found.other])
        # Which of two surfaces' points it is depends on pymunk's search tree.
        assert contacts.x_m == pytest.approx(found.x_m, abs=0.01)
        assert whole.digest() == digest


def test_snapshot_in_a_crowd_replays_to_the_same_bits(monkeypatch):
    monkeypatch.setattr("crs_cc.sim.physics.simulation.REBUILD", 30)
    world, ways = world_of(CROWD + PUCKS, AREA), list(wandering(75, seed=1))
    bench = Bench(world)
    expected = run(bench, ways)
    for at in (0, 29, 30, 44, 61):
        bench = Bench(world)
        run(bench, ways[:at])
        snapshot = pickle.loads(pickle.dumps((bench.physics.snapshot(), bench.bodies)))
        assert run(bench, ways[at:]) == expected[at:]
        for again in (bench, Bench(world)):
            go_back(again, snapshot)
            assert run(again, ways[at:]) == expected[at:]


def test_many_touch_in_a_crowd_and_none_sinks_in():
    bench = Bench(world_of(CROWD + PUCKS, AREA))
    touched, worst_m = set(), 0.0
    for way_m in wandering(200, seed=2):
        contacts = bench.pull(way_m)
        touched |= set(zip(contacts.robot.tolist(), contacts.other.tolist(), strict=True))
        worst_m = max(worst_m, bench.depth_m())
    assert len(touched) > 100
    assert worst_m < 0.01


def test_room_is_what_measuring_all_would_give():
    scene = Scene(world_of(CROWD + PUCKS, AREA))
    nearness, position_m, sizes = Nearness(scene, 0.1), scene.start[:, :2].copy(), set()
    rng = np.random.default_rng(3)
    for _ in range(60):
        need_m = rng.uniform(0.05, 0.5)
        near = nearness.find(position_m, need_m).tolist()
        assert near == Nearness(scene, 0.1).find(position_m, need_m).tolist()
        sizes.add(len(near))
        way_m = rng.normal(size=position_m.shape)
        way_m *= rng.uniform(0, need_m / 2, (len(way_m), 1)) / np.hypot(*way_m.T)[:, None]
        position_m += way_m
        nearness.use(need_m)
    assert len(sizes) > 20


def test_all_are_near_if_anything_is_too_quick_to_know():
    scene = Scene(world_of(CROWD, AREA))
    assert len(Nearness(scene, 0.01).find(scene.start[:, :2], 0.5)) == SHORT + 4
