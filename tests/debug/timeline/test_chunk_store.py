"""Snapshots share what is equal, come back as they were, and are counted to the last byte."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from crs_cc.debug.timeline.chunk_store import ChunkStore
from crs_cc.runtime.resident_pages import CHUNK


@dataclass(frozen=True)
class Part:
    content: npt.NDArray[np.uint8]
    name: str


def test_snapshots_round_trip() -> None:
    store = ChunkStore()
    content = np.arange(3 * CHUNK + 5, dtype=np.uint8).reshape(-1, 1)
    files = {b"log": b"x" * 10_000, b"short": b"y"}
    part = Part(np.array([1, 2], np.uint8), "two")
    given = store.get(store.add((Part(content, "all"), part, files, None, 7)))
    assert given[0].name == "all"
    assert given[0].content.dtype == np.uint8
    assert np.array_equal(given[0].content, content)
    assert given[1] is part
    assert given[2:] == (files, None, 7)


def test_another_snapshot_costs_only_changed_chunks() -> None:
    store = ChunkStore()
    memory = np.random.default_rng(1).integers(0, 256, 50 * CHUNK, np.uint8)
    store.add(Part(memory.copy(), "a"))
    before = store.size
    assert before > 50 * CHUNK
    memory[17 * CHUNK] += 1
    store.add(Part(memory.copy(), "b"))
    assert CHUNK < store.size - before < CHUNK + 2000


def test_equal_chunks_of_robots_are_stored_once() -> None:
    store = ChunkStore()
    memory = np.random.default_rng(1).integers(0, 256, 10 * CHUNK, np.uint8)
    store.add(tuple(Part(memory.copy(), str(robot)) for robot in range(100)))
    assert store.size < 11 * CHUNK + 100 * 1500


def test_shared_objects_stay_shared_and_are_counted_once() -> None:
    store = ChunkStore()
    part = Part(np.zeros(1000, np.uint8), "shared")
    first = store.add((part,))
    before = store.size
    second = store.add((part, 1))
    assert store.size - before < 1000
    assert store.get(second)[0] is store.get(first)[0] is part


def test_dropping_snapshots_in_any_order_frees_everything() -> None:
    random = np.random.default_rng(3)
    store, taken, shared = ChunkStore(), [], Part(np.ones(9 * CHUNK, np.uint8), "all")
    for number in range(20):
        memory = np.zeros(4 * CHUNK, np.uint8)
        memory[number % 4 * CHUNK] = number
        pieces = {b"a": bytes([number]) * 5000, b"b": b""}
        taken.append(store.add((Part(memory, "x"), shared, pieces, number, ())))
    for number in random.permutation(20).tolist():
        assert store.size > 0
        assert store.get(taken[number])[2][b"a"] == bytes([number]) * 5000
        store.remove(taken[number])
    assert store.size == 0
