"""`crs_tilt` from C: pitch and roll of a robot on a ramp, and the inclinometer's errors."""

import math

import numpy as np
import pytest

from crs_cc.sim.engine.environment import Environment
from tests.device.robot import scout_with
from tests.nclient.drive import drive

ASK = 'int pitch, roll, got = crs_tilt(&pitch, &roll); printf("%d %d %d\\n", got, pitch, roll);'
RAMP = '<surface><ramp x="0" y="0" length="4m" width="4m" to="1m"/></surface>'
STEEP = round(10 * math.degrees(math.atan(0.25)))  # 14.0 degrees


@pytest.mark.parametrize(
    ("heading", "pitch", "roll"),
    [(0, STEEP, 0), (90, 0, -STEEP), (180, -STEEP, 0), (270, 0, STEEP), (60, 71, -122)],
)
@pytest.mark.function("crs_tilt")
def test_reads_pitch_and_roll_on_ramp(tmp_path, heading, pitch, roll):
    """At 60 degrees: atan(0.25 cos 60) = 7.1, and atan(0.25 sin 60) = 12.2 with the right side up.

    Up is along x. With the heading 90 degrees the right side is the upper one.
    """
    robot = scout_with(tmp_path, "<inclinometer/>")
    done = drive(ASK, robot=robot, elements=f'{RAMP}<robot x="0" y="0" heading="{heading}"/>')
    assert done.numbers == [1, pitch, roll]


def test_level_ground_reads_zero(tmp_path):
    robot = scout_with(tmp_path, "<inclinometer/>")
    assert drive(ASK, robot=robot).numbers == [1, 0, 0]
    level = RAMP.replace(
        "</surface>", '<plateau x="0" y="0" length="1" width="1" height="3m"/></surface>'
    )
    assert drive(ASK, robot=robot, elements=f'{level}<robot x="0" y="0"/>').numbers == [1, 0, 0]


def test_robot_without_inclinometer_returns_false():
    assert drive("int pitch, roll; return crs_tilt(&pitch, &roll);").status == 0


def test_noise_has_standard_deviation_of_definition(tmp_path):
    """2,000 readings of a robot at rest: the standard error is 1.6% of the deviation."""
    robot = scout_with(tmp_path, '<inclinometer rate="1kHz" noise="1deg"/>')
    loop = 'for (i = 0; i < 2000; i++) { crs_tilt(&p, &r); printf("%d %d\\n", p, r); }'
    readings = np.array(drive(f"int i, p, r; {loop}", robot=robot).numbers).reshape(-1, 2)
    assert readings.std(axis=0) == pytest.approx([10, 10], rel=0.06)
    assert abs(readings.mean(axis=0)).max() < 1.0


def test_snapshot_contains_last_measurement(tmp_path):
    robot = scout_with(tmp_path, '<inclinometer rate="1Hz" noise="1deg"/>')
    done = drive(ASK, robot=robot)
    environment = done.session.environment
    assert isinstance(environment, Environment)
    snapshot, now = environment.snapshot(), environment.hash()
    environment.state.devices.tilt.value[:] = 9.0
    assert environment.hash() != now
    environment.restore(snapshot)
    assert environment.hash() == now
