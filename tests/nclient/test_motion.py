"""The motion commands, as a program uses them and as the robot truly moves."""

from __future__ import annotations

import math

import pytest

from tests.nclient.drive import drive

BASE_IN = 13.590  # between the wheels of a Scout
LINK_S = 60 * 10 / 38400  # what a command with three numbers and its reply take

NOW = "struct timeval a, b; connect_robot(1); gettimeofday(&a, NULL);"
PASSED = """gettimeofday(&b, NULL);
printf("%.4f ", b.tv_sec - a.tv_sec + (b.tv_usec - a.tv_usec) * 1e-6); a = b;"""
TELL = 'printf("%ld %ld %ld %ld ", State[34], State[35], State[36], State[37]);'
SPEEDS = 'printf("%ld %ld %ld ", State[38], State[39], State[40]);'

WALL = '<robot x="0" y="0"/><wall x1="50in" y1="-3m" x2="50in" y2="3m" thickness="2in"/>'
AT_WALL_IN = 50 - 1 - 8


# -- moves -------------------------------------------------------------------------------------


@pytest.mark.function("pr", "ws")
@pytest.mark.parametrize("way", [100, -250, 1])
def test_pr_drives_commanded_distance(way):
    done = drive(f"connect_robot(1); pr({way}, {way}, 0); ws(1, 1, 0, 60);")
    assert done.x_in[-1] == pytest.approx(way / 10, abs=0.005)
    assert done.y_in[-1] == 0.0


@pytest.mark.function("pr", "sp", "ac", "ws")
@pytest.mark.parametrize(
    ("acceleration", "speed", "way", "seconds"),
    [
        (200, 100, 400, 4.5),  # 0.5 s up, 3.5 s at 10 in/s, 0.5 s down: 2.5 + 35 + 2.5 in
        (100, 200, 100, 2.0),  # up to 10 in/s and down at once: 5 + 5 in
        (-50, -50, -100, 3.0),  # magnitudes: 1 s up, 1 s at 5 in/s, 1 s down
    ],
)
def test_move_takes_time_of_trapezoidal_profile(acceleration, speed, way, seconds):
    done = drive(
        f"""{NOW} ac({acceleration}, {acceleration}, 0); sp({speed}, {speed}, 0);
        gettimeofday(&a, NULL); pr({way}, {way}, 0); ws(1, 1, 0, 60); {PASSED}"""
    )
    assert done.numbers == [pytest.approx(seconds + LINK_S, abs=0.002)]
    assert done.x_in[-1] == pytest.approx(way / 10, abs=0.005)


@pytest.mark.function("pr")
def test_robot_turns_by_difference_of_wheels():
    done = drive("connect_robot(1); pr(100, -100, 0); ws(1, 1, 0, 60);")
    assert done.heading_deg[-1] == pytest.approx(math.degrees(20 / BASE_IN), abs=0.01)
    done = drive("connect_robot(1); sp(100, 50, 0); ac(100, 50, 0); pr(200, 100, 0); ws(1,1,0,60);")
    turn = 10 / BASE_IN
    assert done.heading_deg[-1] == pytest.approx(math.degrees(turn), abs=0.01)
    radius_in = 15 / turn
    assert done.x_in[-1] == pytest.approx(radius_in * math.sin(turn), abs=0.02)
    assert done.y_in[-1] == pytest.approx(radius_in * (1 - math.cos(turn)), abs=0.02)


@pytest.mark.function("pr")
def test_pr_returns_at_once():
    done = drive(f"{NOW} pr(1000, 1000, 0); {PASSED}", seconds=1)
    assert done.numbers == [pytest.approx(LINK_S, abs=0.001)]


@pytest.mark.function("pr", "vm")
def test_new_command_starts_from_speed_reached():
    done = drive(
        """connect_robot(1); pr(1000, 1000, 0); usleep(1000000);
        pr(-50, -50, 0); ws(1, 1, 0, 60); gs(); printf("%ld", State[34]);"""
    )
    # When it comes the robot is 2.5 in + 10 in/s (0.5 s + the line) from the start, and goes back
    # 5 in from there.
    there_in = 2.5 + 10 * (0.5 + LINK_S) - 5
    assert done.x_in[-1] == pytest.approx(there_in, abs=0.02)
    assert done.numbers == [pytest.approx(10 * there_in, abs=1)]
    assert max(done.x_in) == pytest.approx(there_in + 5 + 2.5, abs=0.05)


@pytest.mark.function("vm", "st")
def test_vm_keeps_its_speed_until_st():
    done = drive(
        f"connect_robot(1); vm(100, 100, 0); sleep(3); get_rv(); {SPEEDS} st(); ws(1, 1, 0, 9);"
    )
    assert done.numbers == [100, 100, 0]
    # What the ramp up lacks the ramp down has: 10 in/s times 3 s and what get_rv and st take.
    line_s = (6 + 12 + 6 + 48) * 10 / 38400
    assert done.x_in[-1] == pytest.approx(10 * (3 + line_s), abs=0.1)


@pytest.mark.function("vm", "ac", "get_rv")
def test_speeds_change_with_acceleration():
    read = f"usleep(250000); get_rv(); {SPEEDS}"
    done = drive(f"connect_robot(1); ac(200, 100, 0); vm(100, -100, 0); {read}{read}{read}")
    right, left, turret = done.numbers[0::3], done.numbers[1::3], done.numbers[2::3]
    line_s = 18 * 10 / 38400
    for number, speeds in enumerate(zip(right, left, strict=True), 1):
        since_s = number * (0.25 + line_s)
        expected = min(200 * since_s, 100), -min(100 * since_s, 100)
        assert speeds == pytest.approx(expected, abs=2)
    assert turret == [0, 0, 0]


@pytest.mark.function("ac", "sp", "vm")
def test_speed_is_limited_to_maximum_of_robot():
    done = drive(
        f"""connect_robot(1); ac(30000, 30000, 0); sp(30000, 30000, 0); vm(9999, -9999, 0);
        sleep(2); get_rv(); {SPEEDS} st(); ws(1, 1, 0, 9); pr(2000, 2000, 0);
        sleep(2); get_rv(); {SPEEDS}""",
        seconds=20,
    )
    assert done.numbers == [394, -394, 0, 394, 394, 0]  # 1 m/s


@pytest.mark.function("mv")
def test_mv_commands_each_axis_in_its_own_mode():
    done = drive(
        f"""connect_robot(1);
        printf("%d ", mv(MV_AC, 400, MV_SP, 50, MV_IGNORE, 0));
        printf("%d ", mv(MV_VM, 100, MV_PR, 100, MV_IGNORE, 0));
        sleep(1); get_rv(); {SPEEDS}
        sleep(4); get_rv(); {SPEEDS}
        printf("%d ", mv(MV_LP, 0, MV_VM, 0, MV_IGNORE, 0)); ws(1, 1, 0, 20); get_rv(); {SPEEDS}
        printf("%d %d ", mv(MV_PA, 1, 0, 0, 0, 0), mv(0, 0, 0, 0, -1, 0));"""
    )
    assert done.numbers == [1, 1, 100, 50, 0, 100, 0, 0, 1, 0, 0, 0, 0, 0]


@pytest.mark.function("mv")
def test_mv_without_motion_keeps_motion():
    done = drive(
        "connect_robot(1); pr(100, 100, 0); mv(0, 1, 0, 2, 0, 3); mv(MV_SP, 1, MV_AC, 1, 0, 0);"
        "ws(1, 1, 0, 20);"
    )
    assert done.x_in[-1] == pytest.approx(10, abs=0.005)


# -- waiting -----------------------------------------------------------------------------------


@pytest.mark.function("ws")
def test_ws_times_out_without_stopping_axes():
    done = drive(f"{NOW} vm(100, 100, 0); {PASSED} ws(1, 1, 0, 2); {PASSED} get_rv(); {SPEEDS}")
    assert done.numbers[1:] == [pytest.approx(2 + 58 * 10 / 38400, abs=0.002), 100, 100, 0]


@pytest.mark.function("ws")
def test_ws_waits_for_selected_axes():
    done = drive(
        f"""{NOW} pr(100, 300, 0); ws(1, 0, 0, 60); {PASSED} ws(0, 1, 0, 60); {PASSED}
        ws(0, 0, 0, 60); {PASSED}"""
    )
    # 10 in take 1.5 s, 30 in take 3.5 s.
    at_once = pytest.approx(58 * 10 / 38400, abs=0.002)
    assert done.numbers == [pytest.approx(1.5 + LINK_S, abs=0.002), pytest.approx(2, abs=0.01),
                            at_once]  # fmt: skip


@pytest.mark.function("ws")
def test_timeouts_of_ws_are_bytes_and_0_does_not_wait():
    done = drive(
        f"{NOW} vm(50, 50, 0); {PASSED} ws(1, 1, 0, 0); {PASSED} ws(1, 1, 0, 257); {PASSED}"
    )
    line_s = 58 * 10 / 38400
    assert done.numbers[1:] == pytest.approx([line_s, 1 + line_s], abs=0.002)


@pytest.mark.function("conf_tm", "vm")
def test_robot_stops_after_command_timeout():
    done = drive("connect_robot(1); conf_tm(2); vm(100, 100, 0); sleep(9); gs();")
    assert done.x_in[-1] == pytest.approx(20, abs=0.02)
    assert done.x_in[round(4 / 0.05)] == pytest.approx(20, abs=0.02)


@pytest.mark.function("conf_tm")
def test_any_command_restarts_command_timeout():
    done = drive(
        """int i; connect_robot(1); conf_tm(1); vm(100, 100, 0);
        for (i = 0; i < 10; i++) { usleep(900000); get_bp(); }"""
    )
    assert done.x_in[-1] > 85


@pytest.mark.function("conf_tm")
@pytest.mark.parametrize("timeout", [0, 256, 1000])
def test_conf_tm_takes_byte_and_0_disables_it(timeout):
    done = drive(f"connect_robot(1); conf_tm(1); conf_tm({timeout}); vm(100, 100, 0); sleep(8);")
    assert done.x_in[-1] > 75  # 1000 are 232 s


# -- stopping ----------------------------------------------------------------------------------


@pytest.mark.function("st", "lp")
def test_st_brakes_and_lp_rolls_out():
    ends = [
        drive(f"connect_robot(1); ac(400, 400, 0); vm(100, 100, 0); sleep(2); {how}(); sleep(5);")
        for how in ("st", "lp")
    ]
    # From 10 in/s: with 40 in/s2, and with the 0.3 m/s2 of the definition.
    further_in = 100 / 2 / (0.3 / 0.0254) - 100 / 2 / 40
    assert ends[1].x_in[-1] - ends[0].x_in[-1] == pytest.approx(further_in, abs=0.01)


TWO = '<robot x="0" y="0"/><robot x="30in" y="0"/>'


@pytest.mark.function("lp", "st")
def test_limp_robot_is_pushed_and_counts_it_while_held_one_stays():
    pushes = "connect_robot(1); sleep(1); vm(100, 100, 0); sleep(8);"
    for how, least, most in (("lp", 500, 700), ("st", 0, 9)):
        waits = f'connect_robot(1); {how}(); sleep(9); get_rc(); printf("%ld", State[34]);'
        done = drive(pushes, waits, elements=TWO)
        truth = (float(done.session.environment.state.x_m[1]) / 0.0254 - 30) * 10
        assert least <= truth <= most
        if how == "lp":
            assert float(done.output[1]) == pytest.approx(truth, abs=3)


@pytest.mark.function("vm", "get_rc", "gs")
def test_robot_at_wall_stalls_and_odometry_stops():
    done = drive(
        'connect_robot(1); vm(100, 100, 0); sleep(9); gs(); printf("%ld %ld %ld %ld ", State[34],'
        "State[38], State[39], State[41]); vm(-100, -100, 0); sleep(3); get_rc();"
        'printf("%ld", State[34]);',
        elements=WALL,
    )
    assert done.numbers[:4] == [pytest.approx(10 * AT_WALL_IN, abs=3), 0, 0, 3]
    assert done.numbers[4] == pytest.approx(10 * done.x_in[-1], abs=6)  # within a timestep
    assert max(done.x_in) == pytest.approx(AT_WALL_IN, abs=0.2)


@pytest.mark.function("pr", "ws")
def test_move_into_wall_does_not_complete():
    done = drive(
        f"{NOW} pr(900, 900, 0); {PASSED} ws(1, 1, 0, 15); {PASSED} pr(-10, -10, 0);"
        f"ws(1, 1, 0, 15); {PASSED}",
        elements=WALL,
    )
    assert done.numbers[1] == pytest.approx(15 + 58 * 10 / 38400, abs=0.01)
    assert done.numbers[2] < 3


@pytest.mark.function("pr")
def test_robot_pushes_box():
    box = '<box id="box" x="30in" y="0" length="10in" width="10in" mass="5kg"/>'
    done = drive(
        "connect_robot(1); pr(500, 500, 0); ws(1, 1, 0, 30);",
        elements=f'<robot x="0" y="0"/>{box}',
    )
    box_in = float(done.session.environment.state.bodies.position_m[1, 0]) / 0.0254
    assert done.x_in[-1] == pytest.approx(50, abs=0.2)
    assert box_in == pytest.approx(50 + 8 + 5, abs=0.5)


# -- where the robot is ------------------------------------------------------------------------


@pytest.mark.function("dp", "da")
def test_dp_and_da_set_odometry_without_motion():
    done = drive(
        f"connect_robot(1); dp(1234, -567); {TELL} da(-900, 100); {TELL} pr(100, 100, 0);"
        f"ws(1, 1, 0, 9); {TELL}"
    )
    assert done.numbers[:8] == [1234, -567, 0, 0, 1234, -567, 2700, 0]
    assert done.numbers[8:] == [1234, -667, 2700, 0]
    assert (done.x_in[-1], done.heading_deg[-1]) == (pytest.approx(10, abs=0.005), 0)


@pytest.mark.function("zr")
def test_zr_of_scout_sets_odometry_to_zero_at_once():
    done = drive(f"{NOW} pr(100, 50, 0); ws(1, 1, 0, 9); {PASSED} zr(); {PASSED} {TELL}")
    assert done.numbers[1:] == [pytest.approx(54 * 10 / 38400, abs=0.001), 0, 0, 0, 0]
    assert done.x_in[-1] > 7


@pytest.mark.function("place_robot")
def test_place_robot_moves_robot_and_odometry():
    done = drive(
        f"""connect_robot(1); pr(100, 0, 0); ws(1, 1, 0, 9);
        printf("%d ", place_robot(300, -400, 900, 0)); get_rc(); {TELL}
        pr(100, 100, 0); ws(1, 1, 0, 9);
        printf("%d ", place_robot(500, 0, 0, 0)); get_rc(); {TELL}""",
        elements=WALL,
    )
    assert done.numbers[:5] == [1, 300, -400, 900, 0]
    assert done.numbers[5:] == [1, 300, -300, 900, 0]  # the wall stands there; the client says yes
    assert [done.x_in[-1], done.y_in[-1]] == pytest.approx([30, -30], abs=0.01)
    assert done.heading_deg[-1] == pytest.approx(90, abs=0.01)


@pytest.mark.function("get_rc", "get_rv")
def test_get_rc_and_get_rv_refresh_only_their_part_of_state():
    done = drive(
        f"""connect_robot(1); vm(100, 100, 0); sleep(2);
        {TELL} {SPEEDS} get_rc(); {TELL} {SPEEDS} sleep(1); get_rv(); {TELL} {SPEEDS}"""
    )
    assert done.numbers[:7] == [0] * 7  # as vm left it
    x_at_2 = pytest.approx(175, abs=3)
    assert done.numbers[7:14] == [x_at_2, 0, 0, 0, 0, 0, 0]
    assert done.numbers[14:] == [done.numbers[7], 0, 0, 0, 100, 100, 0]


@pytest.mark.function("get_rc")
def test_odometry_of_noisy_scout_deviates_from_true_pose():
    program = f"connect_robot(1); pr(2000, 2000, 0); ws(1, 1, 0, 60); get_rc(); {TELL}"
    ideal, noisy = (drive(program, setup=setup) for setup in ("ideal", "noisy"))
    assert noisy.numbers == ideal.numbers == [2000, 0, 0, 0]
    off_in = math.hypot(*(a[-1] - b[-1] for a, b in ((noisy.x_in, ideal.x_in),
                                                    (noisy.y_in, ideal.y_in))))  # fmt: skip
    assert 0.3 < off_in < 5


# -- a Nomad 200 -------------------------------------------------------------------------------


@pytest.mark.function("pr", "vm", "ws", "zr", "da")
def test_nomad_200_drives_steers_and_turns_turret():
    done = drive(
        f"""connect_robot(1); ac(300, 500, 500); sp(100, 300, 300);
        pr(0, 900, -900); ws(0, 1, 1, 60); {TELL}
        pr(200, 0, 1800); ws(1, 1, 0, 60); {TELL} ws(1, 1, 1, 60); {TELL}
        vm(0, 100, -100); sleep(2); get_rv(); {SPEEDS} st(); ws(1, 1, 1, 9);
        zr(); {TELL} da(0, 450); {TELL}""",
        robot="nomad200",
    )
    told = done.numbers
    assert told[:4] == [0, 0, 900, 2700]
    assert told[4:7] == [0, 200, 900]
    # 20 in take 2.33 s; until then the turret, on at 30 deg/s, has turned 61 degrees.
    assert told[7] == pytest.approx(2700 + 610, abs=10)
    assert told[8:12] == [0, 200, 900, 900]
    assert told[12:15] == [0, 100, -100]
    assert told[15:] == [0, 0, 0, 0, 0, 0, 0, 450]
    state = done.session.environment.state
    assert [done.x_in[-1], done.y_in[-1]] == pytest.approx([0, 20], abs=0.01)
    for angle_rad in (state.heading_rad[0], state.mount_rad[0], state.base_rad[0]):
        assert math.remainder(float(angle_rad), math.tau) == pytest.approx(0, abs=1e-6)


@pytest.mark.function("zr")
def test_zr_of_nomad_200_blocks_until_aligned():
    done = drive(
        f"""{NOW} ac(300, 500, 500); sp(100, 300, 300); pr(0, 900, 0); ws(1, 1, 1, 60);
        gettimeofday(&a, NULL); zr(); {PASSED} {TELL}""",
        robot="nomad200",
    )
    # 90 degrees at 30 deg/s and 50 deg/s2.
    assert done.numbers[0] == pytest.approx(3.6, abs=0.05)
    assert done.numbers[1:] == [0, 0, 0, 0]
