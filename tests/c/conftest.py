"""Programs that recurse deeply run as they do for users."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from crs_cc.runtime import executable as host
from tests.c import rounds
from tests.conftest import USERS_SETTINGS

CACHED = (host.engine, host.compile_driver, rounds.loop)
"""What is made once for each engine."""


@pytest.fixture
def users_settings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Compile as for users, where the host's stack must last as long."""
    monkeypatch.setattr(host, "settings", USERS_SETTINGS)
    monkeypatch.setenv("CRS_CACHE", str(tmp_path / "users_cache"))
    for cached in CACHED:
        cached.cache_clear()
    yield
    for cached in CACHED:
        cached.cache_clear()
