"""Errors planted in programs are found where they are, see `planted_errors`, `bench/planted.py`."""

from __future__ import annotations

import pytest

from tests.c.planted_errors import RIGHT, WRONG, Planted, look, planted

NOT_FOUND = {
    "first/product_of_ticks", "second/count_down", "second/sum_of_samples",
}  # fmt: skip
"""What is not found yet, or not where it is; docs/checks.md says why."""


@pytest.mark.parametrize("case", list(planted()), ids=lambda case: case.name)
def test_a_planted_error_is_found_on_its_line_and_its_twin_is_clean(case: Planted) -> None:
    found = look(case.path, WRONG)
    if case.name in NOT_FOUND:
        assert (found.severity, found.line) != (case.severity, case.line)
    else:
        assert (found.severity, found.line) == (case.severity, case.line), found.text
        assert case.text in found.text
    if case.origin:
        assert any(f":{case.origin}:" in note for note in found.notes), found.notes
    assert not look(case.path, RIGHT).severity
