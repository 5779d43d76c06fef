"""The commands of the CRS report, as programs use them, and the resulting motion."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from tests.nclient.drive import Drive, drive

STANDING = "ws(1, 1, 0, 255);"


def run(body: str, elements: str = '<robot x="0" y="0"/>', **options) -> Drive:
    """Run the statements of a body."""
    done = drive(body, elements=elements, dialect="report", **options)
    assert done.session.result().robots[0].error is None
    return done


def cylinder(x_in: float, y_in: float = 0.0, heat: float = 0.0) -> str:
    """Return a cylinder of 10 inches and a Scout at the origin."""
    place = f'x="{x_in}in" y="{y_in}in" radius="10in" heat="{heat}"'
    return f'<robot x="0" y="0"/><cylinder {place}/>'


# -- motion ------------------------------------------------------------------------------------


@pytest.mark.parametrize(("speed", "ips"), [("10", 1.0), ("-25", -2.5), ("10.4", 1.0)])
def test_vm_sets_the_speed_of_both_wheels_in_tenths_of_inches(speed: str, ips: float):
    done = run(f"ac(1000, 1000, 0); vm({speed}); for (;;) get_bp();", seconds=5)
    assert (done.x_in[-1] - done.x_in[-41]) / 2 == pytest.approx(ips, abs=0.001)
    assert done.y_in[-1] == 0.0


def test_vm_with_three_arguments_sets_the_wheels():
    done = run("vm(50, -50, 0); for (;;) get_bp();", seconds=1)
    assert done.x_in[-1] == pytest.approx(0, abs=0.01)
    assert 0 < done.heading_deg[-1] < 180, "the right wheel ahead turns to the left"


def test_vm_can_be_pointed_at():
    done = run("int (*go)(double) = vm; go(100); for (;;) get_bp();", seconds=2)
    assert done.x_in[-1] > 10


@pytest.mark.parametrize("second", ["100", "-100", "0"])
def test_pr_goes_straight_by_its_first_argument(second: str):
    done = run(f"pr(100, {second}, 0); {STANDING}")
    assert done.x_in[-1] == pytest.approx(10.0, abs=0.005)
    assert done.y_in[-1] == 0.0


@pytest.mark.parametrize("tenths", [900, -900, 1800, 100])
def test_scout_pr_turns_to_the_right_by_tenths_of_degrees(tenths: int):
    done = run(f"scout_pr(0, {tenths}); {STANDING}")
    assert done.heading_deg[-1] == pytest.approx(-tenths / 10 % 360, abs=0.5)
    assert math.hypot(done.x_in[-1], done.y_in[-1]) < 0.01


def test_scout_pr_rounds_wheel_distances_to_the_nearest_tenth_of_an_inch():
    done = run(f"scout_pr(0, 100); {STANDING}")  # 11.8597: 12, where the vendor's macro has 11
    wheels = done.session.environment.world.robots[0].model.drive.wheel_base_m / 0.0254
    assert done.heading_deg[-1] == pytest.approx(360 - math.degrees(2.4 / wheels), abs=0.01)


def test_scout_pr_goes_on_by_tenths_of_inches():
    done = run(f"scout_pr(200, 0); {STANDING}")
    assert done.x_in[-1] == pytest.approx(20.0, abs=0.005)


def test_scout_vm_goes_and_turns():
    done = run("ac(2000, 2000, 0); scout_vm(0, 300); for (;;) get_bp();", seconds=3)
    turned_deg = (done.heading_deg[-1] - done.heading_deg[-21]) % 360
    assert turned_deg == pytest.approx(360 - 30, abs=0.5)


def test_st_stops_and_ws_waits_until_the_robot_stands():
    program = f"""vm(200); pr(300, 0, 0); st(); {STANDING}
        printf("%ld %ld\\n", State[STATE_VEL_RIGHT], State[STATE_MOTOR_STATUS]);"""
    done = run(program)
    assert done.output[0] == "0 0\n"
    assert 0 < done.x_in[-1] < 20


@pytest.mark.parametrize("arguments", ["1, 1, 0, 255", "0, 0, 0, 0", "1, 1, 0, 1"])
def test_ws_waits_for_both_wheels_whatever_its_arguments(arguments: str):
    done = run(f"sp(10, 10, 0); pr(30, 30, 0); ws({arguments});")
    assert done.x_in[-1] == pytest.approx(3.0, abs=0.005)


def test_ws_ends_when_the_robot_is_blocked():
    done = run(f"pr(1000, 0, 0); {STANDING} get_bp(); return State[STATE_BUMPER];", cylinder(60))
    assert done.status == 1
    assert done.session.time_s < 8


def test_mv_commands_each_wheel():
    done = run(f"mv(MV_PR, 100, MV_PR, 100, MV_IGNORE, 0); {STANDING}")
    assert done.x_in[-1] == pytest.approx(10.0, abs=0.005)


def test_ac_and_sp_set_what_pr_moves_with():
    slow = run(f"ac(1000, 1000, 0); sp(20, 20, 0); pr(100, 100, 0); {STANDING}")
    fastest_ips = max(after - before for before, after in pairwise(slow.x_in)) / 0.05
    assert fastest_ips == pytest.approx(2.0, abs=0.01)


def test_conf_tm_stops_a_robot_without_commands():
    done = run("#include <unistd.h>\nconf_tm(1); vm(100); sleep(5);")
    assert done.x_in[-1] < 16
    assert done.x_in[-1] == done.x_in[-20]


# -- position ----------------------------------------------------------------------------------


def test_dp_sets_the_position_in_tenths_of_inches():
    program = f"""dp(100, 200);
        printf("%ld %ld\\n", State[STATE_CONF_X], State[STATE_CONF_Y]);
        pr(50, 50, 0); {STANDING}
        printf("%ld %ld\\n", State[STATE_CONF_X], State[STATE_CONF_Y]);"""
    assert run(program).output[0] == "100 200\n150 200\n"


def test_the_heading_in_state_counts_as_the_vendors():
    program = f'scout_pr(0, 900); {STANDING} printf("%ld\\n", State[STATE_CONF_STEER]);'
    assert run(program).numbers[0] == pytest.approx(2700, abs=5)


# -- sensors -----------------------------------------------------------------------------------

PRINT_SONARS = """for (int i = STATE_SONAR_0; i <= STATE_SONAR_15; i++)
    printf("%ld ", State[i]);
printf("\\n");"""


def test_sonars_read_tenths_of_inches_and_minus_1_for_no_echo():
    readings = run(f"sonarSensorCheck(); {PRINT_SONARS}", cylinder(50.3)).numbers
    assert readings[0] == 323
    assert readings[2:15] == [-1] * 13


def test_nothing_is_measured_before_a_check():
    assert run(f"dp(0, 0); {PRINT_SONARS}", cylinder(50)).numbers == [-1] * 16


def test_a_sonar_reading_stays_until_the_next_check():
    program = f"""sonarSensorCheck(); pr(100, 100, 0); {STANDING}
        printf("%ld ", State[STATE_SONAR_0]);
        sonarSensorCheck();
        printf("%ld\\n", State[STATE_SONAR_0]);"""
    assert run(program, cylinder(100)).numbers == [820, 720]


def test_get_sn_reads_the_sonars_in_the_firing_order():
    program = f"""int s_order[6] = {{0, 1, 4, 12, 15, 255}};
        conf_sn(1, s_order);
        for (int i = 0; i < 40; i++) get_sn();
        {PRINT_SONARS}
        sonarSensorCheck(); {PRINT_SONARS}"""
    done = run(program, '<robot x="2m" y="2m"/>', area='length="4m" width="4m"')
    ring, checked = done.numbers[:16], done.numbers[16:]
    assert [number for number in range(16) if ring[number] != -1] == [0, 1, 4, 12, 15]
    assert all(reading > 0 for reading in checked)


def test_a_bumper_reads_1_during_contact():
    program = f"""get_bp(); printf("%ld ", State[STATE_BUMPER]);
        while (State[STATE_BUMPER] != 1) {{ pr(100, 100, 0); {STANDING} get_bp(); }}
        printf("%ld ", State[STATE_BUMPER]);
        pr(-100, -100, 0); {STANDING} get_bp(); printf("%ld\\n", State[STATE_BUMPER]);"""
    assert run(program, cylinder(60)).numbers == [0, 1, 0]


@pytest.mark.parametrize("side", [(30, 0), (0, 30), (-30, 0)])
def test_a_bumper_on_any_side_reads_1(side: tuple[float, float]):
    x_in, y_in = side
    turn = f"scout_pr(0, {-10 * round(math.degrees(math.atan2(y_in, x_in)))}); {STANDING}"
    program = f"{turn} pr(250, 0, 0); {STANDING} get_bp(); return State[STATE_BUMPER];"
    assert run(program, cylinder(x_in, y_in)).status == 1


def test_the_heat_sensor_reads_the_heat_in_its_range():
    look = 'heatSensorCheck(); printf("%ld ", State[STATE_HEAT]);'
    assert run(look, cylinder(50, heat=1)).numbers == [1]
    assert run(look, cylinder(50, heat=0)).numbers == [0]
    assert run(look, cylinder(300, heat=1)).numbers == [0]


def test_tag_target_removes_the_heat():
    program = """heatSensorCheck(); printf("%ld ", State[STATE_HEAT]);
        tagTarget(); printf("%ld ", State[STATE_HEAT]);
        heatSensorCheck(); printf("%ld\\n", State[STATE_HEAT]);"""
    assert run(program, cylinder(50, heat=2)).numbers == [2, 2, 0]


# -- connection --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "arguments",
    [
        "ROBOT_ID, SERV_TCP_PORT, SERVER_MACHINE_NAME",
        'ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400',
        "1",
    ],
)
def test_connect_robot_accepts_the_arguments_of_tables_and_appendix(arguments: str):
    names = """int ROBOT_ID = 1; int SERV_TCP_PORT = 7019;
        String SERVER_MACHINE_NAME = "procyon.cis.ksu.edu";"""
    program = f'{names} if (!connect_robot({arguments})) return 1; printf("%d\\n", vm(10));'
    done = run(program)
    assert done.output[0] == "1\n"
    assert done.errors[0] == "", "there is no vendor who says hello"


def test_a_robot_need_not_be_connected():
    assert run(f"pr(100, 100, 0); {STANDING}").x_in[-1] == pytest.approx(10, abs=0.01)


def test_a_disconnected_robot_does_nothing_until_it_is_connected_again():
    program = f"""disconnect_robot(1);
        printf("%d %d\\n", pr(100, 100, 0), heatSensorCheck());
        connect_robot(1, 7019, "here"); printf("%d\\n", pr(50, 50, 0)); {STANDING}"""
    done = run(program)
    assert done.output[0] == "Not connected to any robot\n" * 2 + "0 0\n1\n"
    assert done.x_in[-1] == pytest.approx(5, abs=0.01)


@pytest.mark.parametrize("call", ["connect_robot", "disconnect_robot"])
def test_state_took_garbage_from_the_reply_to_a_connection(call: str):
    program = f"""
        void soil(void) {{ volatile int deep[999], i; for (i = 0; i < 999; i++) deep[i] = 7; }}
        void runcode() {{ dp(30, 40); soil(); {call}(1);
            printf("%ld %ld\\n", State[STATE_CONF_X], State[STATE_CONF_Y]); }}"""
    assert run(program).output[0] == "30 40\n"


def test_there_is_a_simulated_robot_and_no_real_one():
    assert run('printf("%d %d\\n", simulated_robot(), real_robot());').output[0] == "1 0\n"


def test_two_robots_sense_each_others_heat():
    elements = '<robot x="0" y="0" heat="1"/><robot x="1m" y="0" heat="1"/>'
    done = run('heatSensorCheck(); printf("%ld\\n", State[STATE_HEAT]);', elements)
    assert done.output == ["1\n", "1\n"]
