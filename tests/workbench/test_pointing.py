"""A program asks the user for a pose: he clicks a place and a direction, in a real browser."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from crs_cc.workbench.pointing import Pose
from tests.workbench.in_browser import page_in, running, wait

ROOM = (
    """<world version="1"><area length="6m" width="4m"/><robot id="anna" x="3m" y="2m"/></world>"""
)


def test_two_clicks_answer_a_request_for_a_pose(tmp_path: Path, browser: Any) -> None:
    answers: list[Pose] = []
    with (
        running(tmp_path, "int main(void) { return 0; }", ROOM) as screen,
        page_in(browser, screen, flat=True) as page,
    ):

        def ask() -> None:
            screen.pointing.ask(0, answers.append)
            screen.publish()

        wait(page, "crs.views.active")
        screen.player.submit(ask)
        note = "document.querySelector('.pointing')"
        wait(page, f"!{note}.hidden && {note}.textContent.includes('anna')")
        page.evaluate("crs.views.place(() => [1, 2, 0])")
        wait(page, f"{note}.textContent.includes('direction')")
        page.evaluate("crs.views.place(() => [1, 3, 0])")
        wait(page, f"{note}.hidden")
        refused = page.evaluate(
            "crs.model.channel.request('point', { robot: 0, x_m: 1, y_m: 2, heading_deg: 0 })"
            ".catch((error) => error.message)"
        )
    assert answers == [pytest.approx((1.0, 2.0, 90.0))]
    assert refused == "no program has asked for a pose for robot 0"
