"""Who hears a message is what testing all pairs with numpy finds, in order and to the bit."""

from __future__ import annotations

import numpy as np
import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.kernels import hearing
from crs_cc.sim.kernels.hearing import Hearing
from crs_cc.sim.kernels.program import Kernels

ROBOTS = 200


def crowd(seed: int, robots: int = ROBOTS, messages: int = 60):
    """Return places, who is there, messages, who is full, and groups; ranges are met exactly."""
    rng = np.random.default_rng(seed)
    places_m = rng.uniform(-9, 9, (robots, 2))
    places_m[::2] = np.rint(places_m[::2])
    places_m[5:8] += 400
    present, is_full = rng.random(robots) < 0.9, rng.random(robots) < 0.2
    said = np.empty((messages, 6))
    sender = rng.integers(0, robots, messages)
    said[:, :2], said[:, 2], said[:, 3] = places_m[sender], rng.integers(0, 12, messages), sender
    said[::9, 2] = 1e5
    said[:, 4] = np.where(rng.random(messages) < 0.2, rng.integers(0, robots, messages), -1)
    said[:, 5] = np.where(rng.random(messages) < 0.3, 1 << rng.integers(0, 32, messages), 0)
    return places_m, present, said, is_full, rng.integers(0, 2**32, robots, dtype=np.uint32)


def of_all_pairs(places_m, present, said, is_full, groups):
    """Return messages, hearers and distances, and which messages are missed."""
    away_m = places_m - said[:, None, :2]
    distance_m = np.sqrt(away_m[..., 0] * away_m[..., 0] + away_m[..., 1] * away_m[..., 1])
    bits = said[:, 5].astype(np.uint32)[:, None]
    several = said[:, 4:5] < 0
    robots = np.arange(len(places_m))
    meant = several & present & (distance_m <= said[:, 2:3]) & (robots != said[:, 3:4])
    meant &= (bits == 0) | (groups & bits != 0)
    hears = (meant & ~is_full) | (robots == said[:, 4:5])
    message, hearer = np.nonzero(hears)
    return message, hearer, distance_m[hears], (meant & is_full).any(axis=1)


def same(found, expected) -> bool:
    return all(
        ours.astype(theirs.dtype).tobytes() == theirs.tobytes()
        for ours, theirs in zip(found, expected, strict=True)
    )


@pytest.mark.parametrize("most", [hearing._MAX_MESSAGES, 7])
def test_hearers_are_those_of_all_pairs(monkeypatch, most: int) -> None:
    monkeypatch.setattr(hearing, "_MAX_MESSAGES", most)
    ours = Hearing()
    for seed in range(6):
        places_m, present, *rest = crowd(seed)
        ours.place(places_m, present)
        expected = of_all_pairs(places_m, present, *rest)
        assert len(expected[0]) > 300
        assert expected[3].any()
        assert same(ours.pairs(*rest), expected)


@pytest.mark.parametrize("robots", [1, 2, 64, 65])
def test_few_robots(robots: int) -> None:
    places_m, present, *rest = crowd(3, robots, 30)
    for here in (present, np.zeros_like(present), np.ones_like(present)):
        ours = Hearing()
        ours.place(places_m, here)
        assert same(ours.pairs(*rest), of_all_pairs(places_m, here, *rest))
    assert all(len(part) == 0 for part in ours.pairs(rest[0][:0], *rest[1:]))


def test_pairs_without_room_for_all_are_found_by_several_calls(monkeypatch) -> None:
    places_m, present, *rest = crowd(4)
    ours, calls = Hearing(), []
    ours.place(places_m, present)
    monkeypatch.setattr(ours._kernels, "room", ours._end + 4 * ROBOTS)
    call = ours._kernels.call
    monkeypatch.setattr(ours._kernels, "call", lambda *n: (calls.append(n), call(*n)))
    assert same(ours.pairs(*rest), of_all_pairs(places_m, present, *rest))
    assert len(calls) > 10


def test_more_robots_than_there_is_room_for_are_refused() -> None:
    with pytest.raises(WorldError, match="too many robots send messages: 700000"):
        Hearing().place(np.zeros((700_000, 2)), np.ones(700_000, dtype=np.bool_))


def test_the_checked_build_finds_the_same(monkeypatch) -> None:
    places_m, present, *rest = crowd(5)
    monkeypatch.setattr(hearing, "Kernels", lambda **sizes: Kernels(**sizes, checked=True))
    ours = Hearing()
    ours.place(places_m, present)
    assert same(ours.pairs(*rest), of_all_pairs(places_m, present, *rest))
