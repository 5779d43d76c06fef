"""The pictures of pages in docs/images can be regenerated."""

from __future__ import annotations

import pytest

pytest.importorskip("playwright.sync_api")

from tests.workbench.pictures import IMAGES, PICTURES


def test_every_picture_of_a_page_is_in_the_table() -> None:
    others = {"vscode"}  # by tests.vscode_shell
    assert {path.stem for path in IMAGES.glob("*.png")} == set(PICTURES) | others
