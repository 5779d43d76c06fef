"""Snapshots lie where they are needed, in bounded memory; changes of the user are never lost."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np

from crs_cc.debug.timeline.change import Change
from crs_cc.debug.timeline.console import ConsolePosition
from crs_cc.debug.timeline.history import INTERVAL, History, RunSnapshot
from crs_cc.debug.timeline.position import BEGINNING, Position
from crs_cc.runtime.resident_pages import CHUNK


def moment(number: int, size: int = 100) -> RunSnapshot:
    """Return a snapshot that is unlike all others."""
    content: Any = np.random.default_rng(number).integers(0, 256, size, np.uint8)
    return RunSnapshot(content, ConsolePosition(number, ()))


def at(timestep: int) -> Position:
    return Position(timestep, 0)


def forward(history: History, first: int, last: int, size: int = 100) -> None:
    """Run over some timesteps as the engine does."""
    for timestep in range(first, last):
        if history.should_keep(at(timestep)):
            history.keep(at(timestep), moment(timestep, size))


def begun(**options: int) -> History:
    history = History(**options)
    history.keep(BEGINNING, moment(0))
    return history


def timesteps(history: History, until: int) -> list[int]:
    places, here = [], at(until)
    while here > BEGINNING:
        here, _ = history.before(Position(here.timestep - 1, 999))
        places.append(here.timestep)
    return places[::-1]


def test_before_returns_the_latest_snapshot_not_later() -> None:
    history = begun()
    history.keep(at(5), moment(5))
    history.keep(Position(5, 2, 0, 40), moment(6))
    assert history.before(at(4))[0] == BEGINNING
    assert history.before(at(5))[0] == at(5)
    assert history.before(Position(5, 2, 0, 39))[0] == at(5)
    found, kept = history.before(Position(9, 0))
    assert found == Position(5, 2, 0, 40)
    assert kept.console.written == 6
    assert np.array_equal(kept.session, moment(6).session)


def test_forward_there_is_one_snapshot_per_interval() -> None:
    history = begun()
    forward(history, 0, 4 * INTERVAL + 1)
    assert timesteps(history, 100) == [n * INTERVAL for n in range(5)]


def test_many_robots_have_longer_intervals() -> None:
    history = begun(robots=80)
    forward(history, 0, 21)
    assert timesteps(history, 100) == [0, 20]


def test_gaps_are_filled_where_the_user_goes_back() -> None:
    history = begun()
    forward(history, 0, 101)
    found, _ = history.before(Position(83, 1, 0, 7))
    assert found == at(80)
    forward(history, 80, 84)
    assert timesteps(history, 87)[-5:] == [70, 80, 81, 82, 83]
    forward(history, 100, 121)
    assert timesteps(history, 121)[-3:] == [100, 110, 120]


def test_old_snapshots_are_thinned_and_the_start_is_kept() -> None:
    history = begun(most_bytes=100 * CHUNK)
    forward(history, 0, 5000, CHUNK)
    assert history.size <= 100 * CHUNK
    assert len(history) > 50
    places = timesteps(history, 5000)
    assert places[0] == 0
    assert places[-5:] == [4950, 4960, 4970, 4980, 4990]
    away = [(4990 - one, other - one) for one, other in itertools.pairwise(places)]
    assert all(gap <= max(INTERVAL, 0.5 * distance) for distance, gap in away)


def test_snapshots_are_dense_near_the_user() -> None:
    history = begun(most_bytes=100 * CHUNK)
    forward(history, 0, 2000, CHUNK)
    found, _ = history.before(at(700))
    forward(history, found.timestep, 700, CHUNK)
    places = timesteps(history, 700)
    assert places[-5:] == [695, 696, 697, 698, 699]
    assert history.size <= 100 * CHUNK


def test_snapshots_of_changes_are_never_thinned() -> None:
    history = begun(most_bytes=30 * CHUNK)
    forward(history, 0, 12, CHUNK)
    edit = Position(11, 3, 0, 99)
    history.branch(Change(edit, ""), moment(-1 % 1000, CHUNK))
    forward(history, 12, 2000, CHUNK)
    assert history.before(Position(12, 0))[0] >= edit
    assert np.array_equal(history.at(edit).session, moment(999, CHUNK).session)
    assert history.next_edit(BEGINNING) == edit
    assert history.next_edit(edit) is None


def test_a_change_drops_later_snapshots() -> None:
    history = begun()
    forward(history, 0, 31)
    history.branch(Change(at(20), ""), moment(777))
    assert timesteps(history, 100) == [0, 10, 20]
    assert history.at(at(20)).console.written == 777
    history.branch(Change(at(10), ""), moment(778))
    assert history.next_edit(BEGINNING) == at(10)
    assert history.next_edit(at(10)) is None


def test_changes_may_exceed_the_limit() -> None:
    history = begun(most_bytes=3 * CHUNK)
    for timestep in range(1, 9):
        history.branch(Change(at(timestep), ""), moment(timestep, CHUNK))
    assert timesteps(history, 9) == list(range(9))


def test_backward_search_intervals_grow() -> None:
    history = begun()
    forward(history, 0, 2001)
    walk = [place.timestep for place in history.back_from(at(1998))]
    assert walk[:4] == [1990, 1980, 1950, 1880]
    assert walk[-1] == 0
    assert len(walk) < 20
    assert list(history.back_from(BEGINNING)) == []


def test_a_branch_shares_common_snapshots() -> None:
    history = begun()
    forward(history, 0, 100, 10 * CHUNK)
    before = history.size
    other = history.fork(at(50))
    assert other.size - before < CHUNK
    assert timesteps(other, 100)[-1] == 50
    other.branch(Change(at(20), ""), moment(1, CHUNK))
    assert np.array_equal(history.at(at(50)).session, moment(50, 10 * CHUNK).session)
    assert history.snapshots_before(at(20)) == [at(0), at(10)]


def test_a_branch_has_memory_for_its_own_snapshots() -> None:
    history = begun(most_bytes=40 * CHUNK)
    forward(history, 0, 1000, CHUNK)
    other = history.fork(at(500))
    other.branch(Change(at(500), ""), moment(1, CHUNK))
    forward(other, 501, 1000, CHUNK)
    assert sum(place > at(500) for place in other.snapshots_before(at(1000))) > 5
