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
    assert survive(nested(name, 3000)) == ""


def test_a_damaged_source_is_compiled_or_refused() -> None:
    for source in islice(sources(seed=7), 60):
        assert survive(source) == "", source


@pytest.mark.parametrize("seed", range(4))
def test_many_damaged_sources_are_compiled_or_refused(seed: int) -> None:
    for source in islice(sources(seed), 200):
        assert survive(source) == "", source
