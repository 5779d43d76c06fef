"""What must be true of a run of each sample, whatever the numbers are to the last digit."""

from __future__ import annotations

import re

import numpy as np
import pytest

from tests.samples.driving import INCH_M, Drive


def touches_nothing(drive: Drive) -> None:
    assert [robot.collisions for robot in drive.robots] == [0] * len(drive.robots)


def gets_about(drive: Drive) -> None:
    touches_nothing(drive)
    assert drive.robot.distance_m > 6
    assert drive.squares(0.5) > 10


def closes_its_square(drive: Drive) -> None:
    touches_nothing(drive)
    assert np.hypot(*(drive.places[-1] - drive.places[0])) < 0.07
    assert drive.robot.distance_m == pytest.approx(4 * 40 * INCH_M, rel=0.01)
    x_m, y_m = drive.places.T
    area_m2 = 0.5 * np.sum(x_m * np.roll(y_m, -1) - y_m * np.roll(x_m, -1))
    assert area_m2 == pytest.approx((40 * INCH_M) ** 2, rel=0.05)
    (error_in,) = drive.numbers(r"error of closure (.*) in")
    assert error_in < 3


def stops_at_the_wall(drive: Drive) -> None:
    assert drive.robot.collisions >= 1
    assert drive.places[-1] == pytest.approx(drive.places[-2], abs=0.01)


def counts_the_doors(drive: Drive) -> None:
    """The places are those of `worlds/corridor.xml`, 30 in less: where the robot starts."""
    touches_nothing(drive)
    pattern = r"(left|right) +(\S+) to +(\S+) in +(\w+)"
    found = [
        (side, kind, float(start), float(end))
        for side, start, end, kind in re.findall(pattern, drive.text)
    ]
    doors = {
        ("left", "door"): [(60, 96), (300, 336)],
        ("left", "passage"): [(156, 240)],
        ("right", "door"): [(110, 146), (192, 228), (366, 402)],
    }
    assert {(side, kind) for side, kind, _, _ in found} == set(doors)
    for key, places in doors.items():
        seen = [(start, end) for side, kind, start, end in found if (side, kind) == key]
        assert np.array(seen) == pytest.approx(np.array(places), abs=4)


def arrives_untouched(drive: Drive) -> None:
    touches_nothing(drive)
    (x_in, y_in, off_in) = drive.numbers(r"arrived at \((\S+), (\S+)\), (\S+) in from the goal")
    assert off_in < 6
    assert drive.places[-1] - drive.places[0] == pytest.approx(
        [x_in * INCH_M, y_in * INCH_M], abs=0.1
    )
