"""`crs_arm_move`, `crs_arm_turn`, `crs_arm_get`, `crs_hand` and `crs_get_hand` from C."""

import pytest

from tests.device.robot import scout_with
from tests.nclient.drive import drive

ARM = '<arm x="10in" upper="10in" fore="10in" shoulder-speed="90deg/s" elbow-speed="90deg/s"/>'
SHOW = 'crs_arm_get(&s, &e, &x, &y); printf("%d %d %d %d\\n", s, e, x, y);'
CAN = '<robot x="0" y="0"/><cylinder x="30in" y="0" radius="2in" mass="500g"/>'


@pytest.mark.function("crs_arm_move", "crs_arm_turn", "crs_arm_get")
def test_tip_position_follows_from_joint_angles(tmp_path):
    """Stretched out 30 inches ahead; up and ahead 20 and 10; with the elbow at 180, 10 and 0."""
    robot = scout_with(tmp_path, ARM)
    program = (
        f"int s, e, x, y; {SHOW} crs_arm_move(900, -900); sleep(2); {SHOW}"
        f"crs_arm_turn(-900, 900); sleep(2); {SHOW} return crs_arm_get(0, 0, 0, 0);"
    )
    done = drive(program, robot=robot)
    assert done.numbers == [0, 0, 300, 0, 900, -900, 200, 100, 0, 0, 300, 0]
    assert done.status == 1


@pytest.mark.function("crs_hand", "crs_get_hand")
def test_hand_lifts_object_at_tip(tmp_path):
    robot = scout_with(tmp_path, ARM)
    show = 'crs_get_hand(&w); printf("%d\\n", w);'
    program = (
        f"int w; {show} crs_hand(CRS_CLOSE); usleep(100000); {show}"
        f"crs_hand(CRS_OPEN); usleep(100000); {show}"
    )
    assert drive(program, robot=robot, elements=CAN).numbers == [0, 500, 0]


def test_robot_without_arm_returns_false():
    ask = "crs_arm_move(0, 0) + crs_arm_turn(0, 0) + crs_arm_get(0, 0, 0, 0)"
    assert drive(f"int w; return {ask} + crs_hand(CRS_CLOSE) + crs_get_hand(&w);").status == 0
