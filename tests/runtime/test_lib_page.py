"""The accuracy of `math.h` that `docs/library.md` shows keeps its guarantees."""

from __future__ import annotations

from docs.generate.library import ACCURACY
from tests.runtime.test_lib_math import MEASURED


def test_the_page_shows_what_was_measured() -> None:
    assert ACCURACY == MEASURED


def test_the_errors_on_the_page_are_within_the_documented_bounds() -> None:
    for line in MEASURED.read_text().splitlines()[1:]:
        name, promised, found = line.split("\t")
        assert float(found) <= float(promised), name
