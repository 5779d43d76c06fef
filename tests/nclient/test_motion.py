"""The motion commands, as a program uses them and as the robot truly moves."""

from __future__ import annotations

import pytest

from tests.nclient.drive import drive


@pytest.mark.function("pr", "ws")
@pytest.mark.parametrize("way", [100, -250, 1])
def test_pr_drives_its_distance(way):
    done = drive(f"connect_robot(1); pr({way}, {way}, 0); ws(1, 1, 0, 60);")
    assert done.x_in[-1] == pytest.approx(way / 10, abs=0.005)
    assert done.y_in[-1] == 0.0
