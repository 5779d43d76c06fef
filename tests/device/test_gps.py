"""`crs_gps` from C: the robot's position, and the receiver's errors."""

import numpy as np
import pytest

from tests.device.robot import scout_with
from tests.nclient.drive import drive

ASK = 'int x, y, got = crs_gps(&x, &y); printf("%d %d %d\\n", got, x, y);'


@pytest.mark.function("crs_gps")
def test_position_is_in_tenths_of_an_inch(tmp_path):
    robot = scout_with(tmp_path, '<gps rate="1Hz"/>')
    done = drive(ASK, robot=robot, elements='<robot x="30in" y="-4in"/>')
    assert done.numbers == [1, 300, -40]


def test_previous_measurement_is_returned_between_two_measurements(tmp_path):
    robot = scout_with(tmp_path, '<gps rate="1Hz"/>')
    ask = 'crs_gps(&x, &y); printf("%d\\n", x);'
    program = f"int x, y; connect_robot(1); vm(100, 100, 0); {ask} usleep(500000); {ask}"
    now, same, later = drive(f"{program} sleep(2); {ask}", robot=robot).numbers
    assert now == same < later


def test_robot_without_gps_returns_false():
    assert drive("int x, y; return crs_gps(&x, &y);").status == 0


def test_noise_has_standard_deviation_of_definition(tmp_path):
    """2,000 readings of a robot at rest: the standard error is 1.6% of the deviation."""
    robot = scout_with(tmp_path, '<gps rate="1kHz" noise="10in"/>')
    loop = 'for (i = 0; i < 2000; i++) { crs_gps(&x, &y); printf("%d %d\\n", x, y); }'
    readings = np.array(drive(f"int i, x, y; {loop}", robot=robot).numbers).reshape(-1, 2) / 10
    assert readings.std(axis=0) == pytest.approx([10, 10], rel=0.06)
    assert abs(readings.mean(axis=0)).max() < 1.0
    assert abs(np.corrcoef(readings.T)[0, 1]) < 0.08


def test_slow_receiver_measures_at_its_first_request(tmp_path):
    """Not 10 s later, until when it would report 0, 0."""
    robot = scout_with(tmp_path, '<gps rate="0.1Hz"/>')
    assert drive(ASK, robot=robot, elements='<robot x="30in" y="-4in"/>').numbers == [1, 300, -40]
