"""The accuracy of `math.h` that `docs/library.md` shows keeps its guarantees."""

from __future__ import annotations

from docs.generate.library import ACCURACY
from tests.runtime.test_lib_math import MEASURED


def test_the_page_shows_what_was_measured() -> None:
    assert ACCURACY == MEASURED


def test_measured_errors_keep_the_guarantees() -> None:
    for line in MEASURED.read_text().splitlines()[1:]:
        name, promised, found = line.split("\t")
        assert float(found) <= float(promised), name
