"""What has changed in slots crosses, and nothing else is believed."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crs_cc.net.changed_words import WORDS, apply, pack

COUNT = 7


@given(
    st.lists(st.tuples(st.integers(0, COUNT - 1), st.integers(0, WORDS - 1), st.integers(0, 9))),
)
@settings(max_examples=50, deadline=None)
def test_both_tables_are_equal_after_changes(changes: list[tuple[int, int, int]]) -> None:
    here = np.zeros((COUNT, WORDS), np.uint64)
    there, known = here.copy(), here.copy()
    for row, word, value in changes:
        here[row, word] = value
    rows = apply(pack(known, here), there)
    assert (there == here).all()
    assert (known == here).all()
    assert rows.tolist() == np.flatnonzero(here.any(axis=1)).tolist()


@given(st.binary(max_size=200), st.integers(0, 60), st.integers(0, 255))
@settings(max_examples=200, deadline=None)
def test_what_does_not_fit_changes_nothing(noise: bytes, at: int, value: int) -> None:
    here = np.zeros((COUNT, WORDS), np.uint64)
    here[2, 5], here[4, :3] = 7, 1
    valid = bytearray(pack(np.zeros_like(here), here))
    valid[at % len(valid)] = value
    for content in (noise, bytes(valid), bytes(valid[:-1])):
        table = np.zeros_like(here)
        try:
            apply(content, table)
        except ValueError:
            assert not table.any()


def test_nothing_is_sent_twice() -> None:
    here = np.ones((COUNT, WORDS), np.uint64)
    known = np.zeros_like(here)
    assert len(pack(known, here)) > COUNT * WORDS * 8
    assert len(pack(known, here)) == 4


def test_rows_out_of_order_are_rejected() -> None:
    here = np.zeros((COUNT, WORDS), np.uint64)
    here[1, 0] = here[2, 0] = 1
    content = bytearray(pack(np.zeros_like(here), here))
    content[4:12] = content[8:12] + content[4:8]
    with pytest.raises(ValueError, match="not there"):
        apply(bytes(content), np.zeros_like(here))
