"""Splitting text into comments, strings and tokens by regular expressions."""

from __future__ import annotations

import re
from pathlib import Path

PACKAGE = Path(__file__).parents[3] / "crs_cc"
POSSESSIVE_GROUP = re.compile(r"\)[*+?]\+|\)\{[0-9,]+\}\+")


def test_no_group_is_repeated_possessively() -> None:
    """Before Python 3.11.5, what the last, failed repetition had read was lost (gh-106052).

    Comments of headers ended nowhere then, so that no program compiled. Single characters may be
    repeated so (`[^"]*+`), and a group in an atomic one: `(?>(?:...)*)`.
    """
    assert POSSESSIVE_GROUP.search(r"/\*(?:\*(?!/)[^*]*+)*+")
    found = [
        f"{path.relative_to(PACKAGE)}: {line.strip()}"
        for path in sorted(PACKAGE.rglob("*.py"))
        for line in path.read_text().splitlines()
        if POSSESSIVE_GROUP.search(line)
    ]
    assert found == []
