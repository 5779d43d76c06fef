"""`crs_altitude` from C: the height of the ground under a robot, and the altimeter's errors."""

import numpy as np
import pytest

from tests.device.robot import scout_with
from tests.nclient.drive import drive

ASK = 'int height, got = crs_altitude(&height); printf("%d %d\\n", got, height);'
RAMP = '<surface><ramp x="0" y="0" length="4m" width="4m" to="1m"/></surface>'


@pytest.mark.parametrize(("x", "height"), [("0m", 197), ("1m", 295), ("-1.2m", 79)])
@pytest.mark.function("crs_altitude")
def test_reads_height_of_ramp(tmp_path, x, height):
    """The ramp rises from 0 at x = -2 m to 1 m at x = 2 m: 0.25 m per metre, 39.37 inches."""
    robot = scout_with(tmp_path, "<altimeter/>")
    done = drive(ASK, robot=robot, elements=f'{RAMP}<robot x="{x}" y="0"/>')
    assert done.numbers == [1, height]


def test_level_ground_reads_zero(tmp_path):
    assert drive(ASK, robot=scout_with(tmp_path, "<altimeter/>")).numbers == [1, 0]


def test_robot_without_altimeter_returns_false():
    assert drive("int height; return crs_altitude(&height);").status == 0


def test_noise_has_standard_deviation_of_definition(tmp_path):
    """2,000 readings of a robot at rest: the standard error is 1.6% of the deviation."""
    robot = scout_with(tmp_path, '<altimeter rate="1kHz" noise="10in"/>')
    loop = 'for (i = 0; i < 2000; i++) { crs_altitude(&h); printf("%d\\n", h); }'
    readings = np.array(drive(f"int i, h; {loop}", robot=robot).numbers)
    assert readings.std() == pytest.approx(100, rel=0.06)
    assert abs(readings.mean()) < 10


def test_bias_of_degradation_is_added(tmp_path):
    robot = scout_with(tmp_path, "<altimeter/>")
    fault = '<robot x="0" y="0"/><degradation robot="robot0" device="altitude" bias="10in"/>'
    assert drive(ASK, robot=robot, elements=fault).numbers == [1, 100]


def test_altimeter_with_timer_measures_independently_of_requests(tmp_path):
    robot = scout_with(tmp_path, '<altimeter period="1s"/>')
    ask = 'usleep(2500000); printf("%d\\n", crs_age(CRS_SENSOR_ALTITUDE));'
    (age,) = drive(ask, robot=robot).numbers
    assert 490 <= age <= 520
