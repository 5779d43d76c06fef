"""Errors planted in programs are found where they are, see `planted_errors`, `bench/planted.py`."""

from __future__ import annotations

import pytest

from tests.c.planted_errors import RIGHT, WRONG, Planted, look, planted

NOT_FOUND = {
    "first/heap_difference", "first/known_pointer", "first/lost_list", "first/pointer_difference",
    "first/pointer_order", "first/product_of_ticks", "first/va_arg_long_long", "second/count_down",
    "second/end_of_other", "second/length_of_heap", "second/lost_block", "second/offset_in_other",
    "second/pointer_to_known", "second/sum_of_samples", "second/va_arg_pointer_double",
    "second/va_arg_too_wide",
}  # fmt: skip
"""What is not found yet, or not where it is; docs/checks.md says why."""

OTHER_KINDS = {"first/printf_later": "missing argument", "first/va_arg_double": "missing argument"}
"""Errors that are found as something else."""


@pytest.mark.parametrize("case", list(planted()), ids=lambda case: case.name)
def test_a_planted_error_is_found_on_its_line_and_its_twin_is_clean(case: Planted) -> None:
    found = look(case.path, WRONG)
    if case.name in NOT_FOUND:
        assert (found.severity, found.line) != (case.severity, case.line)
    else:
        assert (found.severity, found.line) == (case.severity, case.line), found.text
        assert OTHER_KINDS.get(case.name, case.text) in found.text
    if case.origin:
        assert any(f":{case.origin}:" in note for note in found.notes), found.notes
    assert not look(case.path, RIGHT).severity
