"""`crs_heat` from C: the sum of the heat in range, and the spread of heat."""

import pytest

from tests.device.robot import scout_with
from tests.nclient.drive import drive
from tests.sim.driver import Driver, open_world

ASK = 'int heat, got = crs_heat(&heat); printf("%d %d\\n", got, heat);'
STOVE = '<cylinder x="{}m" y="0" radius="20cm" heat="{}" spread="{}m"/>'


def around(elements: str) -> list[float]:
    return drive(ASK, elements=f'<robot x="0" y="0"/>{elements}').numbers


@pytest.mark.function("crs_heat")
def test_reading_is_sum_of_heat_in_range():
    """A Scout's range is 3 m; without a spread, the distance in the range has no effect."""
    stoves = "".join(
        f'<cylinder x="{x}m" y="0" radius="20cm" heat="{heat}"/>'
        for x, heat in ((1, 5), (-2, 7), (4, 100))
    )
    assert around(stoves) == [1, 12]


@pytest.mark.parametrize(
    ("away_m", "told"),
    [(0.5, 75), (1.0, 50), (1.5, 25), (1.992, 0), (2.5, 0)],
)
def test_heat_with_spread_decreases_linearly_to_zero(away_m, told):
    """100 at the stove's shell, 0 at 2 m from it, and a straight line between."""
    assert around(STOVE.format(away_m + 0.2, 100, 2)) == [1, told]


def test_spread_heat_is_summed_before_rounding():
    """A quarter of 1 is sensed from each of two: half of 1, and so 0; from three of them 1."""
    stove = '<cylinder x="{}m" y="{}m" radius="20cm" heat="1" spread="2m"/>'
    two = stove.format(1.7, 0) + stove.format(-1.7, 0)
    assert around(two) == [1, 0]
    assert around(two + stove.format(0, 1.7)) == [1, 1]


def test_report_sense_heat_returns_same_sum():
    driver = Driver.of(open_world('<robot x="0" y="0"/>' + STOVE.format(1.2, 100, 2)))
    assert driver.post("HEAT")[0]["i"][0] == driver.post("SENSE_HEAT")[0]["i"][0] == 50


def test_robot_without_heat_sensor_returns_false(tmp_path):
    path = tmp_path / "scout-with.xml"
    scout_with(tmp_path)
    path.write_text(path.read_text().replace('<heat range="3m"/>', ""))
    assert drive("int heat; return crs_heat(&heat);", robot=str(path)).status == 0
