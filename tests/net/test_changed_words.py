"""Changes of slots are transmitted, and invalid ones are rejected."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crs_cc.net.changed_words import WORDS, KnownRows, Table
from crs_cc.net.slot_rules import IDLE_RULES, RULES
from crs_cc.net.word_kernel import ROWS, Rules
from crs_cc.requests import timing_offset

COUNT = 7
ALL = 2**64 - 1
ASKS = timing_offset("alive") // 8


def pack(known: Table, now: Table) -> bytes:
    """Return the differences between a table and a known one, and update the latter."""
    rows = KnownRows(len(known))
    rows.set(known)
    content = rows.pack(now)
    known[...] = rows.table()
    return content


def enter(content: bytes, table: Table, rules: Rules | None = None) -> bool:
    """Enter changes in a table, if they are valid."""
    rows = KnownRows(len(table))
    rows.set(table)
    try:
        return rows.enter(content, rules)
    finally:
        table[...] = rows.table()


def free() -> Rules:
    """Return rules that allow everything."""
    nothing = np.zeros(WORDS, np.uint64)
    return Rules(nothing, nothing + np.uint64(ALL), nothing.copy(), nothing.copy())


@given(
    st.lists(st.tuples(st.integers(0, COUNT - 1), st.integers(0, WORDS - 1), st.integers(0, 9))),
)
@settings(max_examples=50, deadline=None)
def test_both_tables_are_equal_after_changes(changes: list[tuple[int, int, int]]) -> None:
    here = np.zeros((COUNT, WORDS), np.uint64)
    there, known = here.copy(), here.copy()
    for row, word, value in changes:
        here[row, word] = value
    content = pack(known, here)
    assert len(content) in (0, 8 * (COUNT + np.count_nonzero(here)))
    enter(content, there)
    assert (there == here).all()
    assert (known == here).all()


@given(st.binary(max_size=200), st.integers(0, 200), st.integers(0, 255))
@settings(max_examples=200, deadline=None)
def test_arbitrary_bytes_are_valid_changes_or_rejected(noise: bytes, at: int, value: int) -> None:
    here = np.zeros((COUNT, WORDS), np.uint64)
    here[2, 5], here[4, :3] = 7, 1
    valid = bytearray(pack(np.zeros_like(here), here))
    valid[at % len(valid)] = value
    for content in (noise, bytes(valid), bytes(valid[:-1]), bytes(valid) + bytes(8)):
        table = np.zeros_like(here)
        try:
            enter(content, table)
        except ValueError:
            assert not table.any()
            continue
        masks = np.frombuffer(content, np.uint64, COUNT if content else 0)
        announced = sum(int(mask).bit_count() for mask in masks)
        assert len(content) == 8 * (len(masks) + announced)


def test_nothing_is_sent_twice() -> None:
    here = np.ones((COUNT, WORDS), np.uint64)
    known = np.zeros_like(here)
    assert len(pack(known, here)) == COUNT * (1 + WORDS) * 8
    assert pack(known, here) == b""


def test_changes_with_a_wrong_number_of_words_are_rejected() -> None:
    here = np.ones((COUNT, WORDS), np.uint64)
    content = pack(np.zeros_like(here), here)
    for wrong, reason in (
        (content[:-8], "end early"),
        (content[:-1], "end early"),
        (content[:16], "end early"),
        (content + bytes(8), "size other than"),
        (b"\xff" * 8 + content[8:], "not there"),
    ):
        table = np.zeros_like(here)
        with pytest.raises(ValueError, match=reason):
            enter(wrong, table)
        assert not table.any()


@pytest.mark.parametrize("count", [1, ROWS, ROWS + 1, 2 * ROWS + 7])
def test_tables_of_any_size_have_masks_and_words_in_parts(count: int) -> None:
    table = np.random.default_rng(count).integers(0, 3, (count, WORDS)).astype(np.uint64)
    table[:2000] = 0
    table[0, 1] = 5
    known, there = np.zeros_like(table), np.zeros_like(table)
    content = pack(known, table)
    alone = [
        pack(np.zeros_like(table[at : at + ROWS]), table[at : at + ROWS])
        or bytes(8 * min(ROWS, count - at))
        for at in range(0, count, ROWS)
    ]
    assert content == b"".join(alone)
    enter(content, there)
    assert (there == table).all()
    assert (known == table).all()


def test_one_invalid_row_after_many_prevents_all_changes() -> None:
    count = 2 * ROWS + 5
    here = np.ones((count, WORDS), np.uint64)
    content = pack(np.zeros_like(here), here)
    rules, table = free(), np.zeros_like(here)
    enter(content, table, rules)
    assert (table == here).all()
    here[-1, 9] = 8
    content = pack(np.zeros_like(here), here)
    rules.maximum[9] = 7
    table = np.zeros_like(here)
    with pytest.raises(ValueError, match="not its own"):
        enter(content, table, rules._replace(maximum=rules.maximum))
    assert not table.any()


@given(st.integers(0, ALL), st.integers(0, ALL), st.integers(0, ALL), st.integers(0, ALL))
def test_rules_are_exact_to_the_last_bit(before: int, after: int, fixed: int, most: int) -> None:
    rules = free()
    rules.fixed[3], rules.maximum[3], rules.monotonic[3] = fixed, most, ALL if fixed % 2 else 0
    known = np.zeros((2, WORDS), np.uint64)
    known[1, 3] = before
    here, there = known.copy(), known.copy()
    here[1, 3] = after
    content = pack(known.copy(), here)
    is_allowed = (before ^ after) & fixed == 0 and after <= most
    is_allowed = is_allowed and (not fixed % 2 or after >= before)
    if is_allowed or before == after:
        enter(content, there, rules)
        assert (there == here).all()
    else:
        with pytest.raises(ValueError, match="not its own"):
            enter(content, there, rules)
        assert (there == known).all()


def test_requesting_programs_are_found_and_must_have_run() -> None:
    here, there = np.zeros((2, COUNT, WORDS), np.uint64)
    here[3, 2] = 9
    assert not enter(pack(there.copy(), here), there, RULES)
    here[5, ASKS] = 1 << 32
    content = pack(there.copy(), here)
    with pytest.raises(ValueError, match="not its own"):
        enter(content, there.copy(), IDLE_RULES)
    assert enter(content, there, RULES)
