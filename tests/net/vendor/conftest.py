"""Clients of these tests send requests without pauses, so the timeout for them is short."""

from __future__ import annotations

import pytest

from crs_cc.net.vendor import conversation, switchboard


@pytest.fixture(autouse=True)
def no_patience(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(switchboard, "CLIENT_TIMEOUT_S", 0.02)
    monkeypatch.setattr(conversation, "MAX_TRIES", 5)
