"""Which tests quick runs leave out, folder by folder: all of them would take too long."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Final

import pytest

HERE: Final = Path(__file__).parent

ALL: Final = 1_000_000

FIRST_OF_EACH_FILE: Final = {
    HERE / "c": ALL,
    HERE / "cli": 4,
    HERE / "debug": 1,
    HERE / "device": 1,
    HERE / "nclient": 1,  # each of these compiles and runs a C program
    HERE / "report": 1,
    HERE / "runtime": 2,
    HERE / "runtime" / "codegen": ALL,
    HERE / "session": 3,
    HERE / "sim": 3,
    HERE / "sim" / "server": 2,  # each of these makes worlds anew
}
"""How many tests of each file in a folder quick runs take, and of each of them one case.

Folders within one are as it is, if they are not named themselves.
"""


def most_of(path: Path) -> int | None:
    """Gives how many tests of a file quick runs take, or None for all of them and all cases."""
    named = (FIRST_OF_EACH_FILE[each] for each in path.parents if each in FIRST_OF_EACH_FILE)
    return next(named, None)


def mark_others_slow(items: list[pytest.Item]) -> None:
    """Marks the other tests of these folders as slow; `items` are all tests, in order."""
    quick: Counter[Path] = Counter()
    seen: set[str] = set()
    for item in items:
        most = most_of(item.path)
        if most is None:
            continue
        name = item.nodeid.split("[")[0]
        if name in seen or quick[item.path] == most:
            item.add_marker(pytest.mark.slow)
        else:
            quick[item.path] += 1
        seen.add(name)
