"""Which tests quick runs leave out, folder by folder: all of them would take too long."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Final

import pytest

HERE: Final = Path(__file__).parent

ALL: Final = 1_000_000

FIRST_OF_EACH_FILE: Final = {
    HERE / "cli": ALL,
    HERE / "device": 1,
    HERE / "nclient": 1,  # each of these compiles and runs a C program
    HERE / "report": 1,
    HERE / "runtime": 4,
    HERE / "session": ALL,
    HERE / "sim": 6,
    HERE / "sim" / "degradation": 6,
    HERE / "sim" / "server": 2,  # each of these makes worlds anew
}
"""How many tests of each file in a folder quick runs take, and of each of them one case."""


def mark_others_slow(items: list[pytest.Item]) -> None:
    """Marks the other tests of these folders as slow; `items` are all tests, in order."""
    quick: Counter[Path] = Counter()
    seen: set[str] = set()
    for item in items:
        most = FIRST_OF_EACH_FILE.get(item.path.parent)
        if most is None:
            continue
        name = item.nodeid.split("[")[0]
        if name in seen or quick[item.path] == most:
            item.add_marker(pytest.mark.slow)
        else:
            quick[item.path] += 1
        seen.add(name)
