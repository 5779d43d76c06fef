"""`crs_laser` from C: ranges by the laser's beams."""

import math

import numpy as np
import pytest

from tests.device.robot import scout_with
from tests.nclient.drive import drive

ASK = """
int ranges[482], i, count = crs_laser(ranges, 482);
for (i = 0; i < count; i++)
    printf("%d\\n", ranges[i]);
"""
WALL = '<robot x="0" y="0"/><wall x1="101in" y1="0" x2="101in" y2="9m" thickness="2in"/>'


@pytest.mark.function("crs_laser")
def test_ranges_are_in_order_from_right_to_left(tmp_path):
    """On the left half a wall at 100 in, whose round end is ahead; right of it nothing."""
    laser = '<laser field-of-view="90deg" range="10m" forward="4in" mode="51"/>'
    ranges = np.array(drive(ASK, robot=scout_with(tmp_path, laser), elements=WALL).numbers)
    angle = np.radians((np.arange(482) - 240.5) * 90 / 482)
    left = angle > math.radians(1)
    assert len(ranges) == 482
    assert ranges[left] == pytest.approx(960 / np.cos(angle[left]), abs=0.51)
    assert (ranges[angle < -math.radians(1)] == -1).all()


def test_number_of_ranges_is_set_by_conf_ls(tmp_path):
    laser = '<laser points="100" field-of-view="90deg" range="10m"/>'
    program = f"connect_robot(1); conf_ls(51, 20, 20, 6, 4); {ASK}"
    ranges = drive(program, robot=scout_with(tmp_path, laser), elements=WALL).numbers
    assert ranges[:3] == [-1, -1, -1]
    angle = [math.radians(15 * step) for step in (0.5, 1.5, 2.5)]
    assert ranges[3:] == pytest.approx([1000 / math.cos(each) for each in angle], abs=0.51)


def test_laser_that_is_off_or_missing_returns_nothing(tmp_path):
    laser = '<laser field-of-view="90deg" range="10m"/>'
    program = "int range; return crs_laser(&range, 1);"
    assert drive(program, robot=scout_with(tmp_path, laser), elements=WALL).status == 0
    assert drive(program, elements=WALL).status == 0
