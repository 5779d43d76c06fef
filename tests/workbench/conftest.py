"""The recording that these tests read, and the browser in which they look at pages."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import Any

import pytest

from tests.commands import python_in
from tests.recorded import recorded
from tests.recorded_fields import fields_folder
from tests.workbench.in_browser import FLAGS, chromium

__all__ = ["fields_folder", "recorded"]


@pytest.fixture
def forks(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the commands that a page starts be forks."""
    monkeypatch.setattr(sys, "executable", python_in(tmp_path_factory.mktemp("python")))


@pytest.fixture(scope="package")
def browser() -> Iterator[Any]:
    """Return Chromium, for this package and not for the session.

    Playwright leaves an event loop running until it is closed, and the screens of the terminal,
    tested by the same worker, start one of their own.
    """
    command = chromium()
    playwright = pytest.importorskip("playwright.sync_api")
    with playwright.sync_playwright() as started:
        made = started.chromium.launch(executable_path=command, args=FLAGS)
        yield made
        made.close()
