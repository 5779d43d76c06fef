"""The kernel of echoes finds what numpy finds, to the bit."""

from __future__ import annotations

import math

import numpy as np
import pytest

from crs_cc.sim.geometry import echoes
from crs_cc.sim.geometry.echoes import first_echo
from crs_cc.sim.geometry.obstacles import Obstacles
from crs_cc.sim.geometry.pings import ANY_ANGLE, Pings, Points
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.kernels.program import Kernels
from tests.sim.geometry import numpy_echoes
from tests.sim.geometry.test_rays import crowd

REACH_M = 6.7


def case(seed: int, lobe_rad: float, critical_rad: float) -> tuple[Pings, Obstacles, Scene]:
    """Return pings of a crowd's robots in all directions, some of them turned to round angles."""
    scene = Scene(crowd(60, seed=seed))
    start = scene.start[: scene.robots]
    random = np.random.default_rng(seed)
    rows = []
    for x_m, y_m, heading_rad in start.tolist() * 3:
        turn = heading_rad + random.uniform(-3.0, 3.0) if random.random() < 0.8 else math.pi / 4
        place = complex(x_m, y_m)
        off = complex(0.2 * math.cos(turn), 0.2 * math.sin(turn))
        rows.append((place, place + off, turn))
    pings = Pings.of(rows, random.uniform(0.05, 0.6), 6.0, lobe_rad, critical_rad)
    pings.own[:] = np.arange(len(rows)) % scene.robots
    moving = scene.moving(scene.start[:, :2], scene.start[:, 2])
    return pings, Obstacles(scene.fixed, moving, REACH_M, 0.3), scene


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("critical", [ANY_ANGLE, math.radians(30)])
@pytest.mark.parametrize("lobe", [0.0, math.radians(9)])
def test_echoes_are_those_of_numpy(seed: int, lobe: float, critical: float) -> None:
    pings, around, scene = case(seed, lobe, critical)
    random = np.random.default_rng(seed)
    which = np.arange(0, len(pings), 3)
    place = random.uniform(0.2, 3.0, len(which)) + 1j * random.uniform(-0.1, 0.1, len(which))
    voices = Points(which, place, random.uniform(0.2, 3.0, len(which)), np.ones(len(which)))
    echo_range = random.uniform(0.3, 1.0, len(scene.names))
    for arguments in ((None, None), (voices, None), (None, echo_range), (voices, echo_range)):
        found_m = first_echo(pings, around, *arguments)
        assert found_m.tolist() == numpy_echoes.first_echo(pings, around, *arguments).tolist()


def test_the_checked_build_hears_the_same_without_an_error(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    pings, around, _ = case(1, math.radians(9), math.radians(30))
    unchecked_m = first_echo(pings, around)
    checked = Kernels(checked=True)
    monkeypatch.setattr(echoes, "kernels", lambda: checked)
    assert first_echo(pings, around).tolist() == unchecked_m.tolist()


def test_one_call_and_many_hear_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    pings, around, _ = case(2, 0.0, math.radians(30))
    together_m = first_echo(pings, around)
    small = Kernels()
    small.room = 1000
    monkeypatch.setattr(echoes, "kernels", lambda: small)
    assert first_echo(pings, around).tolist() == together_m.tolist()


def test_pings_of_different_kinds_share_a_call() -> None:
    pings, around, _ = case(3, 0.0, ANY_ANGLE)
    pings.falloff[::2] = 1 / math.radians(9) ** 2
    pings.critical_rad[::3] = math.radians(30)
    found_m = first_echo(pings, around)
    assert found_m.tolist() == numpy_echoes.first_echo(pings, around).tolist()
    alone_m = [first_echo(pings.part(slice(i, i + 1)), around)[0] for i in range(8)]
    assert found_m[:8].tolist() == alone_m
