"""For any source there is soon a program or an error with a location."""

from __future__ import annotations

from itertools import islice

import pytest

from tests.frontend.fuzzing import NESTED, nested, sources, survive


@pytest.mark.parametrize("name", NESTED)
def test_deep_nesting_is_compiled_or_refused(name: str) -> None:
    for depth in (3, 300):
        assert survive(nested(name, depth)) == "", depth


@pytest.mark.parametrize("name", NESTED)
def test_very_deep_nesting_is_compiled_or_refused(name: str) -> None:
    assert survive(nested(name, 1500)) == ""


@pytest.mark.parametrize("seed", range(4))
def test_damaged_sources_are_compiled_or_refused(seed: int) -> None:
    """A sample that is the same in every run; `make fuzz-frontend` tries thousands of new ones."""
    for source in islice(sources(seed), 60):
        assert survive(source) == "", source
