"""Quick runs take one case of each test."""

from __future__ import annotations

import pytest

from tests.quick import mark_others_slow


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    mark_others_slow(items, folder=__file__)
