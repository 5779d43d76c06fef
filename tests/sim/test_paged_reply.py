"""Pages of readings are those that copying number by number gives, for any robots together."""

from __future__ import annotations

import numpy as np
import pytest

from crs_cc.requests import MESSAGE
from crs_cc.sim.state.paged_reply import PagedReply

DEVICES, ROOM, PAGE = 7, 150, 62


def one_by_one(reply: PagedReply, rows, first, messages, places) -> None:
    """Write pages as `PagedReply.page` does."""
    for row, begin, place in zip(rows.tolist(), first.tolist(), places.tolist(), strict=True):
        width = int(reply.width[row])
        count = min(max(int(reply.count[row]) - begin, 0), PAGE // width) if begin >= 0 else 0
        numbers = reply.numbers[row, begin * width : (begin + count) * width] if count else []
        content = np.array(numbers, "<i4").view(np.uint8)
        messages["data"][place, : len(content)] = content
        messages["size"][place], messages["result"][place] = 4 * count * width, count
        messages["i"][place, 0] = width


@pytest.mark.parametrize("seed", range(30))
def test_pages_are_those_copied_one_by_one(seed: int) -> None:
    rng = np.random.default_rng(seed)
    reply, expected = PagedReply.nothing(DEVICES, ROOM), np.zeros((DEVICES, ROOM), np.int32)
    for _ in range(6):
        everybody = np.arange(DEVICES)
        rows = everybody if rng.random() < 0.5 else np.flatnonzero(rng.random(DEVICES) < 0.6)
        width, most = int(rng.choice([1, 2, 4])), int(rng.choice([1, 20, 200]))
        counts = rng.integers(0, most + 1, len(rows))
        numbers = rng.integers(-9999, 9999, (len(rows), most, width))
        reply.keep(rows, width, counts, numbers)
        for row, count, told in zip(rows.tolist(), counts.tolist(), numbers, strict=True):
            size = min(count, ROOM // width) * width
            expected[row, :size] = told.reshape(-1)[:size]
            assert (reply.count[row], reply.width[row]) == (size // width, width)
        assert reply.numbers.tolist() == expected.tolist()
        asked = everybody if rng.random() < 0.5 else rows
        first = rng.integers(-2, 90, len(asked)) if rng.random() < 0.5 else np.full(len(asked), 31)
        others = int(rng.integers(0, 2))
        messages = np.zeros(len(asked) + others, MESSAGE)
        messages["data"] = rng.integers(0, 256, messages["data"].shape)
        wanted, places = messages.copy(), np.arange(len(asked)) + others
        one_by_one(reply, asked, first, wanted, places)
        reply.page(asked, first, messages, places)
        assert messages.tobytes() == wanted.tobytes()
