"""Frames of a run that is watched."""

from __future__ import annotations

import numpy as np

from crs_cc.workbench.frame_blocks import unpacked
from crs_cc.workbench.frame_store import FrameStore


def filled(count: int, most_bytes: int = 2**20, rows: int = 3) -> FrameStore:
    store = FrameStore(most_bytes)
    rng = np.random.default_rng(1)
    for number in range(count):
        store.add(number / 20, rng.random((3, rows)))
    return store


def times(store: FrameStore) -> list[float]:
    found: list[float] = []
    for number, begin_s, end_s in store.index():
        content = store.content(number)
        assert content is not None
        own, _ = unpacked(content)
        assert (own[0], own[-1]) == (begin_s, end_s)
        found += own
    return found


def test_blocks_have_every_frame_and_a_second_each() -> None:
    store = filled(50)
    assert times(store) == [number / 20 for number in range(50)]
    assert [round(end - begin, 2) for _, begin, end in store.index()] == [0.95, 0.95, 0.45]


def test_a_diverging_run_discards_later_data() -> None:
    store = filled(50)
    before = {number for number, _, _ in store.index()}
    store.truncate(1.5)
    assert times(store)[-1] == 1.5
    store.add(1.55, np.zeros((3, 3)))
    assert times(store)[-2:] == [1.5, 1.55]
    assert {number for number, _, _ in store.index()} - before  # what has changed has a new number


def test_memory_is_bounded_and_old_frames_are_thinned() -> None:
    store = filled(4000, most_bytes=60_000)
    content = [store.content(number) for number, _, _ in store.index()]
    assert sum(len(each) for each in content if each) < 70_000
    known = times(store)
    assert known[0] == 0.0
    assert known[-1] == 3999 / 20
    assert np.diff(known[-20:]).max() < 0.06
    assert known == sorted(known)
