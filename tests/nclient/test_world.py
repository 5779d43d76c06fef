"""Requests to the simulator: obstacles, poses of robots, and predictions."""

from __future__ import annotations

import pytest

from tests.nclient.drive import drive

BLOCK = "long block[21] = {4, 300, -200, 500, -200, 500, 200, 300, 200};"
LOOK = 'conf_sn(15, order); ws(1, 1, 1, 1); usleep(100000); gs(); printf("%ld ", State[17]);'
"""Fires only the front sonar, and prints its reading."""

ORDER = "int order[2] = {0, 255}; connect_robot(1);"


@pytest.mark.function("add_obstacle", "move_obstacle", "delete_obstacle")
@pytest.mark.parametrize("names", ["obstacle", "Obs"])
def test_obstacle_is_added_moved_and_deleted(names):
    done = drive(
        f"""{BLOCK} {ORDER}
        printf("%d ", add_{names}(block)); {LOOK}
        printf("%d ", move_{names}(block, 200, -100));
        printf("%ld %ld %ld ", block[0], block[1], block[8]); {LOOK}
        printf("%d ", delete_{names}(block)); {LOOK}
        printf("%d %d ", delete_{names}(block), move_{names}(block, 1, 1));
        block[0] = 11; printf("%d ", add_{names}(block));"""
    )
    assert done.numbers == [1, 22, 1, 4, 500, 100, 42, 1, 255, 1, 1, 1]


@pytest.mark.function("add_Obs", "move_Obs", "delete_Obs", "new_world")
def test_obstacle_stops_robot_until_new_world():
    done = drive(
        f"""{BLOCK} connect_robot(1); add_Obs(block);
        pr(600, 600, 0); ws(1, 1, 1, 6); gs(); printf("%d ", State[33] != 0);
        new_world(); vm(100, 100, 0); usleep(2000000); gs(); printf("%ld", State[33]);"""
    )
    assert done.numbers == [1, 0]
    bump = next(step for step in done.steps if len(step.contacts.robot))
    assert [bump.names[other] for other in bump.contacts.other] == ["obstacle-0"]
    at = done.steps.index(bump)
    assert done.x_in[at] == pytest.approx(22, abs=0.1)
    assert done.x_in[-1] > 30


@pytest.mark.function("add_obstacle")
def test_robots_share_added_obstacles():
    first = f"{BLOCK} connect_robot(1); add_obstacle(block); sleep(3);"
    second = f"{ORDER} sleep(1); {LOOK}"
    robots = '<robot x="0" y="0"/><robot x="-30in" y="60in" heading="-90deg"/>'
    assert drive(first, second, elements=robots).output[1] == "255 "
    robots = '<robot x="0" y="0"/><robot x="40in" y="60in" heading="-90deg"/>'
    assert drive(first, second, elements=robots).output[1] == "32 "


@pytest.mark.function("get_rpx")
def test_get_rpx_returns_poses_of_all_robots():
    robots = "".join(f'<robot x="{30 * n}in" y="{n}in" heading="{n}deg"/>' for n in range(23))
    done = drive(
        'long p[1 + 3 * 30]; int i; connect_robot(1); printf("%d ", get_rpx(p));'
        'for (i = 0; i <= 3 * p[0]; i++) printf("%ld ", p[i]);',
        *["return 0;"] * 22,
        elements=robots,
    )
    poses = [number for n in range(23) for number in (300 * n, 10 * n, 10 * n)]
    assert done.numbers == [1, 23, *poses]


@pytest.mark.function("create_robot", "connect_robot")
def test_create_robot_connects_to_existing_robot():
    done = drive('printf("%d ", create_robot(1) != 0); printf("%d", vm(10, 10, 0));')
    assert done.numbers == [1, 1]


@pytest.mark.function("quit_server")
def test_quit_server_ends_all_answers():
    done = drive(
        'connect_robot(1); printf("%d ", quit_server()); printf("%d ", gs());'
        'printf("%ld\\n", State[STATE_ERROR]); printf("%d", connect_robot(1));'
    )
    first, complaint, last = done.output[0].splitlines()
    assert first == "1 0 111"
    assert complaint.startswith("failed to connect to server on machine ")
    assert last == "0"


@pytest.mark.function("real_robot", "simulated_robot", "get_robot_conf", "special_request")
def test_functions_of_window_and_devices_fail():
    done = drive(
        "long conf[4]; unsigned char out[1024] = {7, 0, 1, 200}, in[1024];"
        'connect_robot(1); printf("%d %d %d %d %d", real_robot(), simulated_robot(),'
        " get_robot_conf(conf), special_request(out, in), vm(0, 0, 0));"
    )
    assert done.numbers == [1, 1, 0, 0, 1]


@pytest.mark.function("motion_check")
def test_motion_check_returns_first_collision():
    done = drive(
        f"""{BLOCK} double at[3] = {{7, 7, 7}}; connect_robot(1);
        printf("%d ", motion_check(0, 0.0, 0.0, 1000.0, 0.0, 0.0, 0.0, 0.0, at));
        add_obstacle(block);
        printf("%d ", motion_check(0, 0.0, 0.0, 1000.0, 0.0, 0.0, 0.0, 0.0, at));
        printf("%.2f %.2f %.2f ", at[0], at[1], at[2]);
        /* half circles to the left around the block's middle */
        printf("%d ", motion_check(1, 400.0, -600.0, -1.570796, 1.570796, 600.0, 400.0, 0.0, at));
        printf("%d ", motion_check(1, 400.0, -300.0, -1.570796, 1.570796, 300.0, 400.0, 0.0, at));
        printf("%d ", motion_check(1, 400.0, -250.0, -1.570796, 1.570796, 250.0, 400.0, 0.0, at));
        printf("%ld", State[STATE_ERROR]);"""
    )
    # The block's corners are sqrt(100^2 + 200^2) = 223.6 away from its centre, the radius is 80.
    assert done.numbers == [0, 1, 220, 0, 0, 0, 1, 1, 0]


@pytest.mark.function("predict_sensors")
def test_predicted_sensors_equal_measurement_at_that_pose():
    wall = '<wall x1="5ft" y1="-9ft" x2="5ft" y2="9ft"/>'
    done = drive(
        """long state[45]; int laser[965], i, off = 0; connect_robot(1);
        conf_ls(51, 20, 20, 60, 4); ct();
        printf("%d ", predict_sensors(300, 0, 0, 0, state, laser));
        pr(300, 0, 0); ws(1, 1, 1, 20); sleep(2); gs();
        for (i = 1; i <= 32; i++)
            off += abs(state[i] - State[i]) > 1;
        for (i = 1; i <= 2 * laser[0]; i++)
            off += abs(laser[i] - Laser[i]) > 1;
        printf("%d %d %d ", off, laser[0] > 10, laser[0] == Laser[0]);
        printf("%ld %ld", state[17], state[33]);""",
        elements=f'<robot x="0" y="0" definition="nomad200"/>{wall}',
    )
    # The centre of the wall is 60 in from the robot's old position, and 30 in from the new one.
    radius_in = done.session.environment.world.robots[0].model.radius_m / 0.0254
    assert done.numbers == [1, 0, 1, 1, round(30 - 0.05 / 0.0254 - radius_in), 0]
