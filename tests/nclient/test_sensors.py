"""The sensors except sonars, as a program sees them in a world of known distances."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from crs_cc.sim.files import world_xml
from tests.nclient.drive import drive

INCH = 0.0254
NOMAD = '<robot definition="nomad200" x="0" y="0"/>'
RADIUS_IN = 22.5 / 2.54
TENTH_M = INCH / 10
WALL = '<wall x1="2.05m" y1="-5m" x2="2.05m" y2="5m" thickness="0.1m"/>'  # 2 m ahead of the middle
CORNER = (
    '<wall x1="1.55m" y1="-5m" x2="1.55m" y2="0.35m" thickness="0.1m"/>'
    '<wall x1="1.55m" y1="0.35m" x2="-5m" y2="0.35m" thickness="0.1m"/>'
)
PRINT_POS = (
    'printf("%ld %ld %ld %ld %ld %ld\\n", p.config.configX, p.config.configSteer,'
    " p.config.configTurret, p.config.velTrans, p.config.timeStamp, p.timeStamp);"
)


def near_wall(distance_in: float) -> str:
    """Return a wall at a distance ahead of a Nomad's shell."""
    x_in = RADIUS_IN + distance_in + 1
    return f'<wall x1="{x_in}in" y1="-5m" x2="{x_in}in" y2="5m" thickness="2in"/>'


def own(folder: Path, robot: str, old: str, new: str) -> str:
    """Write a known definition with a change; return its path."""
    text = (Path(world_xml.__file__).parents[0] / "robots" / f"{robot}.xml").read_text()
    assert old in text
    path = folder / "own.xml"
    path.write_text(text.replace(old, new))
    return str(path)


# -- bumpers -----------------------------------------------------------------------------------


@pytest.mark.function("get_bp")
def test_bumper_bit_is_on_side_of_contact():
    done = drive(
        """connect_robot(1); vm(100, 100, 0);
        do get_bp(); while (State[STATE_BUMPER] == 0);
        printf("%ld\\n", State[STATE_BUMPER]);
        st(); usleep(500000); get_bp(); printf("%ld\\n", State[STATE_BUMPER]);
        pr(-50, -50, 0); ws(1, 1, 0, 20); get_bp(); printf("%ld\\n", State[STATE_BUMPER]);""",
        elements='<robot x="0" y="0"/><wall x1="30in" y1="-2m" x2="30in" y2="2m"/>',
    )
    assert done.numbers == [1, 1, 0]  # switch 0 is in front, also while it is at rest at the wall


@pytest.mark.function("get_bp")
def test_collision_of_robots_presses_bumpers_of_both():
    done = drive(
        "connect_robot(1); vm(100, 100, 0); sleep(6); get_bp();"
        'printf("%ld\\n", State[STATE_BUMPER]);',
        "connect_robot(1); do get_bp(); while (State[STATE_BUMPER] == 0);"
        'printf("%ld\\n", State[STATE_BUMPER]);',
        elements='<robot x="0" y="0"/><robot x="40in" y="0" heading="90"/>',
    )
    assert [int(text) for text in done.output] == [1, 1 << 2]  # ahead, and on the left


# -- infrared ----------------------------------------------------------------------------------


@pytest.mark.function("get_ir")
def test_infrared_reads_inches_to_wall():
    done = drive(
        'connect_robot(1); printf("%d\\n", get_ir());'
        'printf("%ld %ld\\n", State[STATE_IR_0], State[STATE_IR_8]);',
        elements=NOMAD + near_wall(6.2),
    )
    assert done.numbers == [1, 6, 15]


@pytest.mark.function("conf_ir")
def test_conf_ir_selects_sensors_and_history():
    done = drive(
        """int first[16] = {1, 255}, all[16] = {0, 1, 2, 15, 255};
        connect_robot(1);
        conf_ir(0, first); usleep(100000); get_ir();
        printf("%ld %ld\\n", State[STATE_IR_0], State[STATE_IR_1]);
        conf_ir(10, all); usleep(100000); get_ir(); printf("%ld\\n", State[STATE_IR_0]);
        conf_ir(5, all);
        do { usleep(100000); get_ir(); } while (State[STATE_IR_0] > 6);
        conf_ir(0, all); usleep(100000); get_ir(); printf("%ld\\n", State[STATE_IR_0]);""",
        elements=NOMAD + near_wall(5),
    )
    off, near, held, now = done.numbers
    assert (off, held, now) == (15, 15, 5)
    assert near < 15


# -- compass -----------------------------------------------------------------------------------


@pytest.mark.function("conf_cp", "get_cp")
def test_compass_reads_turret_direction_when_on():
    done = drive(
        """connect_robot(1); get_cp(); printf("%ld\\n", State[STATE_COMPASS]);
        printf("%d\\n", conf_cp(1)); get_cp(); printf("%ld\\n", State[STATE_COMPASS]);
        da(0, 0); pr(0, 0, 455); ws(0, 0, 1, 20);
        get_cp(); printf("%ld\\n", State[STATE_COMPASS]);
        conf_cp(0); pr(0, 0, 100); ws(0, 0, 1, 20);
        get_cp(); printf("%ld\\n", State[STATE_COMPASS]);""",
        elements='<robot definition="nomad200" x="0" y="0" heading="60"/>',
    )
    assert done.numbers == [0, 1, 600, 1055, 1055]


@pytest.mark.function("conf_cp")
def test_compass_calibration_turns_turret_once(tmp_path):
    done = drive(
        """connect_robot(1); conf_cp(2); ws(0, 0, 1, 255);
        gs(); printf("%ld %d", State[STATE_CONF_TURRET], posTimeGet());""",
        robot=own(tmp_path, "nomad200", 'calibration="180s"', 'calibration="20s"'),
    )
    turret, time_ms = done.numbers
    assert turret in {0, 3599}
    assert time_ms == pytest.approx(20_000, abs=1_000)


# -- laser -------------------------------------------------------------------------------------

PRINT_LASER = """
    for (i = 1; i <= %s * Laser[0]; i++) printf("%%d ", Laser[i]);"""


@pytest.mark.function("conf_ls", "get_ls")
def test_laser_points_are_on_wall():
    done = drive(
        'int i; connect_robot(1); printf("%d ", conf_ls(51, 20, 20, 20, 4)); Laser[0] = 0;'
        'printf("%d ", get_ls());' + PRINT_LASER % 2,
        elements=NOMAD + WALL,
    )
    configured, read, *numbers = done.numbers
    assert (configured, read, len(numbers)) == (1, 1, 40)
    for number in range(20):
        angle = math.radians((number - 9.5) * 3)
        expected = 2.0 / TENTH_M, 1.8 * math.tan(angle) / TENTH_M
        assert numbers[2 * number : 2 * number + 2] == [round(each) for each in expected]


@pytest.mark.function("conf_sg", "get_sg")
def test_laser_segments_are_sides_of_corner():
    done = drive(
        "int i; connect_robot(1); conf_ls(33, 20, 20, 482, 4);"
        'printf("%d ", conf_sg(50, 4, 30)); printf("%d ", get_sg());' + PRINT_LASER % 4,
        elements=NOMAD + CORNER,
    )
    configured, read, *numbers = done.numbers
    assert (configured, read) == (1, 1)
    corner = 1.5 / TENTH_M, 0.3 / TENTH_M
    right_y = -1.3 * math.tan(math.radians(30)) / TENTH_M
    left_x = (0.2 + 0.3 / math.tan(math.radians(30))) / TENTH_M
    assert numbers == pytest.approx(
        [corner[0], right_y, *corner, *corner, left_x, corner[1]], abs=3
    )


@pytest.mark.function("conf_ls", "get_ls")
def test_every_state_includes_all_laser_points():
    done = drive(
        """int i; connect_robot(1); conf_ls(51, 20, 20, 482, 4); gs();
        printf("%d %ld %d %d ", Laser[0], State[STATE_LASER], Laser[1], Laser[2 * Laser[0] - 1]);
        conf_ls(50, 20, 20, 20, 4); gs(); printf("%d", Laser[0]);""",
        elements=NOMAD + WALL,
    )
    assert done.numbers == [482, 51, 787, 787, 0]


# -- devices that a Scout does not have ---------------------------------------------------------


@pytest.mark.function("get_ir", "get_cp", "get_ls", "get_sg", "conf_ir", "conf_cp", "conf_ls")
@pytest.mark.parametrize("client", ["nclient", "ndirect"])
def test_scout_refuses_missing_devices(client):
    done = drive(
        """int order[16] = {255};
        connect_robot(1, MODEL_SCOUT2, "/dev/ttyS0", 38400);
        printf("%d %d %d %d %d %d %d %d\\n", get_ir(), get_cp(), get_ls(), get_sg(),
               conf_ir(0, order), conf_cp(1), conf_ls(51, 20, 20, 20, 4), conf_sg(50, 4, 30));
        gs();
        printf("%ld %ld %ld %d\\n", State[STATE_IR_0], State[STATE_COMPASS], State[STATE_LASER],
               Laser[0]);""",
        client=client,
    )
    numbers = [int(word) for line in done.output[0].splitlines()[-2:] for word in line.split()]
    assert numbers == [0] * 12


# -- positions and times -----------------------------------------------------------------------


@pytest.mark.function("posDataRequest", "posDataCheck")
def test_pos_data_are_attached_on_request():
    done = drive(
        """connect_robot(1); printf("%d ", posDataCheck());
        printf("%d ", posDataRequest(POS_SONAR | POS_LASER));
        printf("%d %d %d", posDataCheck(), POS_SONAR_P != 0, POS_BUMPER_P != 0);""",
    )
    assert done.numbers == [0, 1, 10, 1, 0]


@pytest.mark.function("posInfraredRingGet", "posInfraredGet", "posLaserGet", "posCompassGet")
def test_pos_data_contain_pose_at_measurement():
    done = drive(
        f"""PosData ring[INFRAREDS], p; int i;
        connect_robot(1); conf_cp(1); conf_ls(51, 20, 20, 20, 4);
        posDataRequest(POS_INFRARED | POS_LASER | POS_COMPASS);
        vm(50, 0, 100); sleep(2); gs();
        printf("%ld %ld %ld %ld %d %d\\n", State[STATE_CONF_X], State[STATE_CONF_STEER],
               State[STATE_CONF_TURRET], State[STATE_VEL_TRANS], posTimeGet(), posTimeGet());
        posInfraredRingGet(ring); p = ring[15]; {PRINT_POS}
        posInfraredGet(&p, 3); {PRINT_POS}
        posLaserGet(&p); {PRINT_POS}
        posCompassGet(&p); {PRINT_POS}""",
        elements=NOMAD,
    )
    told, *attached = [line.split() for line in done.output[0].splitlines()]
    assert attached == [told] * 4
    assert int(told[0]) > 50


@pytest.mark.function("posSonarRingGet", "posSonarGet")
def test_each_sonar_has_its_own_timestamp():
    done = drive(
        """PosData ring[SONARS], p; int i, order[16] = {0, 8, 4, 255};
        connect_robot(1); conf_sn(15, order); posDataRequest(POS_SONAR); sleep(2); get_sn();
        posSonarRingGet(ring); posSonarGet(&p, 8);
        for (i = 0; i <= 8; i += 4) printf("%lu ", ring[i].timeStamp);
        printf("%lu %lu", p.timeStamp, ring[5].timeStamp);""",
    )
    first, third, second, again, never = done.numbers
    assert len({first, second, third}) == 3
    assert max(first, second, third) - min(first, second, third) == pytest.approx(120, abs=17)
    assert again == second
    assert never == 0


@pytest.mark.function("posBumperGet")
def test_bumper_pos_data_are_those_of_hit():
    done = drive(
        f"""PosData p; long hit_ms; connect_robot(1); posDataRequest(POS_BUMPER);
        gs(); posBumperGet(&p); {PRINT_POS}
        vm(100, 100, 0); do get_bp(); while (State[STATE_BUMPER] == 0);
        hit_ms = posTimeGet(); sleep(2); gs(); posBumperGet(&p); {PRINT_POS}
        printf("%ld", hit_ms);""",
        elements='<robot x="0" y="0"/><wall x1="30in" y1="-2m" x2="30in" y2="2m"/>',
    )
    before, after = done.numbers[:6], done.numbers[6:12]
    assert before == [0] * 6
    hit_in = 30 - 0.05 / INCH - 8  # the wall is 10 cm thick
    assert after[0] == pytest.approx(10 * hit_in, abs=6)  # in the timestep of the hit
    assert after[4] == after[5] == pytest.approx(done.numbers[12], abs=60)


@pytest.mark.function("posTimeGet")
def test_board_time_is_that_of_last_reply_in_steps_of_16_4_ms():
    done = drive(
        """int i; connect_robot(1);
        for (i = 0; i < 5; i++) { sleep(1); gs(); printf("%d ", posTimeGet()); }
        sleep(1); printf("%d", posTimeGet());""",
    )
    *times, later = done.numbers
    for number, time in enumerate(times, 1):
        assert time == pytest.approx(1000 * number, abs=17 + 25 * number)
        assert time in {tick * 164 // 10 for tick in range(400)}
    assert later == times[-1]


# -- batteries ---------------------------------------------------------------------------------


@pytest.mark.function("voltCpuGet", "voltMotorGet")
def test_initial_voltages_are_those_of_full_batteries():
    done = drive(
        'connect_robot(1); gs(); printf("%.3f %.3f", voltCpuGet(), voltMotorGet());',
    )
    cpu, motor = done.numbers
    assert cpu == 12.0  # the maximum of the byte on the line
    assert motor == pytest.approx(12.7, abs=0.02)


@pytest.mark.function("voltMotorGet")
def test_driving_drains_motor_battery(tmp_path):
    cells = '''capacity="408Wh" power="5W" curve="10.5 11.5 11.8 12.0 12.2 12.4 12.7"'''
    done = drive(
        """float before; connect_robot(1); gs(); before = voltMotorGet();
        sp(300, 300, 0); pr(4000, 4000, 0); ws(1, 1, 0, 255); gs();
        printf("%.4f", before - voltMotorGet());""",
        robot=own(tmp_path, "scout", cells, 'capacity="1Wh" power="0W" curve="10 12"'),
    )
    # 40 N over 400 in, and half of the efficiency: 0.226 Wh of one; the curve is 2 V high.
    used_wh = 40 * 400 * INCH / 0.5 / 3600
    assert done.numbers[0] == pytest.approx(2 * used_wh, abs=0.04)
