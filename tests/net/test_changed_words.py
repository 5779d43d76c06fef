"""What has changed in slots crosses, and nothing else is believed."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crs_cc.net.changed_words import WORDS, pack, unpack

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
    changes = unpack(pack(known, here), COUNT)
    changes.enter(there)
    assert (there == here).all()
    assert (known == here).all()
    assert changes.places.tolist() == np.flatnonzero(here).tolist()


@given(st.binary(max_size=200), st.integers(0, 60), st.integers(0, 255))
@settings(max_examples=200, deadline=None)
def test_any_bytes_are_valid_changes_or_refused(noise: bytes, at: int, value: int) -> None:
    here = np.zeros((COUNT, WORDS), np.uint64)
    here[2, 5], here[4, :3] = 7, 1
    valid = bytearray(pack(np.zeros_like(here), here))
    valid[at % len(valid)] = value
    for content in (noise, bytes(valid), bytes(valid[:-1])):
        try:
            changes = unpack(content, COUNT)
        except ValueError:
            continue
        table = np.zeros_like(here)
        changes.enter(table)
        assert len(changes.places) == len(changes.words) <= len(content) // 8


def test_nothing_is_sent_twice() -> None:
    here = np.ones((COUNT, WORDS), np.uint64)
    known = np.zeros_like(here)
    assert len(pack(known, here)) == COUNT * WORDS // 8 + COUNT * WORDS * 8
    assert pack(known, here) == b""


def test_changes_of_another_number_of_words_than_declared_are_refused() -> None:
    here = np.ones((COUNT, WORDS), np.uint64)
    content = pack(np.zeros_like(here), here)
    for wrong in (content[:-8], content + bytes(8)):
        with pytest.raises(ValueError, match="another size"):
            unpack(wrong, COUNT)
    for wrong in (content[:-1], content[:10]):
        with pytest.raises(ValueError, match="end early"):
            unpack(wrong, COUNT)
