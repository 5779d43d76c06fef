"""Which tests quick runs leave out where all of them would take too long."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest


def mark_others_slow(items: list[pytest.Item], *, folder: str, first: int | None = None) -> None:
    """Marks tests as slow, but for the first ones of each file, one case of each.

    Args:
        items: all tests that were collected, in order.
        folder: a file in the folder whose tests are meant.
        first: how many tests of a file are quick; all by default.
    """
    quick: Counter[Path] = Counter()
    seen: set[str] = set()
    for item in items:
        if item.path.parent != Path(folder).parent:
            continue
        name = item.nodeid.split("[")[0]
        if name in seen or quick[item.path] == first:
            item.add_marker(pytest.mark.slow)
        else:
            quick[item.path] += 1
        seen.add(name)
