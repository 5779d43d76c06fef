"""How close robots came to objects, worked out by hand."""

from __future__ import annotations

import numpy as np
import pytest

from crs_cc.sim.files.world_xml import parse_world
from crs_cc.workbench.clearances import Clearances, closest
from crs_cc.workbench.feed import Feed

WORLD = parse_world(
    b"""<world version="1"><area length="10m" width="10m"/>
  <wall id="screen" x1="5m" y1="1m" x2="5m" y2="9m" thickness="20cm"/>
  <robot id="ada" x="2m" y="5m"/>
  <robot id="bob" x="2m" y="9m"/>
</world>""",
    "room",
)
RADIUS_M = WORLD.robots[0].model.radius_m


@pytest.fixture
def feed() -> Feed:
    """Ada drives to 50 cm before the screen's face and back, twice; bob stands 4 m away."""
    made = Feed({}, 0.1)
    made.roster(0.0, ("ada", "bob"), ())
    way_m = [2.0, 3.4, 4.4 - RADIUS_M, 3.4, 2.0, 4.5 - RADIUS_M, 2.0]
    for number, x_m in enumerate(way_m):
        made.frame(number * 1.0, np.array([[x_m, 2.0], [5.0, 9.0], [0.0, 0.0]]))
    return made


def test_clearance_is_measured_from_outline_to_outline(feed: Feed) -> None:
    found = Clearances(WORLD, feed).of(0)
    assert found.times_s.tolist() == [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    assert found.gap_m[[1, 2, 5]] == pytest.approx([1.5 - RADIUS_M, 0.5, 0.4], abs=2e-4)


def test_each_approach_is_listed_once_the_closest_first(feed: Feed) -> None:
    found = closest(WORLD, feed, 0)
    assert found["robots"] == 2
    (time_s, robot, other, gap_m, x_m, y_m), second = found["approaches"]
    assert (time_s, robot, other) == (5.0, 0, "screen")
    assert (gap_m, x_m, y_m) == pytest.approx((0.4, 4.5 - RADIUS_M, 5.0), abs=1e-3)
    # Bob has come close to nothing: the closest of all is told, here the upper edge at y = 10 m.
    assert second[:3] == (0.0, 1, "edge-north")
    assert second[3] == pytest.approx(1.0 - RADIUS_M, abs=1e-3)


def test_absent_robots_have_no_clearance(feed: Feed) -> None:
    feed.frame(7.0, np.array([[np.nan, 2.0], [np.nan, 9.0], [0.0, 0.0]]))
    found = Clearances(WORLD, feed, 6.5).of(0)
    assert np.isnan(found.gap_m).tolist() == [True]
    assert not np.isnan(Clearances(WORLD, feed, 6.5).of(1).gap_m[0])
