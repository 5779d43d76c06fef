"""`crs_gripper` and `crs_get_gripper` from C."""

import pytest

from tests.device.robot import scout_with
from tests.nclient.drive import drive
from tests.sim.gripping import GRIPPER

SHOW = 'crs_get_gripper(&o, &b, &w); printf("%d %d %d\\n", o, b, w);'
CAN = '<robot x="0" y="0"/><cylinder x="26cm" y="0" radius="4cm" mass="1kg"/>'


@pytest.mark.function("crs_gripper", "crs_get_gripper")
def test_gripper_grasps_and_releases_can(tmp_path):
    robot = scout_with(tmp_path, GRIPPER)
    program = (
        f"int o, b, w; {SHOW} crs_gripper(CRS_CLOSE); sleep(2); {SHOW}"
        f"crs_gripper(CRS_OPEN); sleep(2); {SHOW}"
    )
    done = drive(program, robot=robot, elements=CAN)
    assert done.numbers == [79, 1, 0, 31, 1, 1000, 79, 1, 0]


def test_null_pointers_are_accepted(tmp_path):
    robot = scout_with(tmp_path, GRIPPER)
    assert drive("return crs_get_gripper(NULL, NULL, NULL);", robot=robot).status == 1


def test_robot_without_gripper_returns_false():
    assert drive("return crs_gripper(CRS_CLOSE) + crs_get_gripper(0, 0, 0);").status == 0
