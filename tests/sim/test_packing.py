"""A restored state equals the packed one, and shares nothing with it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.state.env_state import EnvState
from crs_cc.sim.state.snapshot_codec import packed

ROOT = Path(__file__).parents[2]


@dataclass
class Inner:
    flags: npt.NDArray[np.bool_]
    count: int


@dataclass
class Outer:
    whole: npt.NDArray[np.int32]
    inner: Inner
    none: npt.NDArray[np.float64]
    rows: npt.NDArray[np.void]


def outer() -> Outer:
    rows = np.zeros(2, np.dtype([("id", "<U3"), ("x", "<f8"), ("on", "?")]))
    rows[1] = "abc", 0.1, True
    flags = np.array([True, False, True])
    return Outer(np.arange(6, dtype=np.int32)[::2], Inner(flags, 7), np.zeros((0, 4)), rows)


def test_packed_state_is_restored_completely() -> None:
    again = packed(outer()).state()
    assert again.whole.tolist() == [0, 2, 4]
    assert again.whole.dtype == np.int32
    assert (again.inner.flags.tolist(), again.inner.count) == ([True, False, True], 7)
    assert again.none.shape == (0, 4)
    assert again.rows.tolist() == [("", 0.0, False), ("abc", 0.1, True)]


def test_restored_state_shares_no_memory() -> None:
    state = outer()
    kept = packed(state)
    first, second = kept.state(), kept.state()
    state.inner.flags[:] = False
    first.rows["x"] = 9.0
    assert second.inner.flags.tolist() == kept.state().inner.flags.tolist() == [True, False, True]
    assert second.rows["x"].tolist() == [0.0, 0.1]


def test_states_of_equal_structure_share_it() -> None:
    first = packed(outer())
    assert packed(outer(), like=first).layout is first.layout
    longer = outer()
    longer.none = np.zeros((1, 4))
    assert packed(longer, like=first).state().none.shape == (1, 4)


def test_restored_state_has_same_hash() -> None:
    state = EnvState.at_start(load_world(ROOT / "worlds" / "mixed.xml"))
    assert packed(state).state().sha256() == state.sha256()
