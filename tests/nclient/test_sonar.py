"""The sonars as a C program sees them: hand-computed distances, and their age."""

from __future__ import annotations

import math

import pytest

from tests.nclient.drive import OPEN, drive

SHELL_IN = 8.0
TELL = 'for (int i = 0; i < 16; i++) printf("%ld ", State[STATE_SONAR_0 + i]);\n'
BEAM = math.atan2(45, 255)  # to each side


def ring(elements: str, setup: str = "") -> list[int]:
    """Return the readings of a Scout at the origin for objects."""
    done = drive(f"connect_robot(1); get_sn(); {TELL}", elements=OPEN + elements, setup=setup)
    return [int(number) for number in done.numbers]


def wall(distance_in: float, turned_deg: float, thick_in: float = 1.0) -> str:
    """Return a wall at a distance from the origin, its normal turned off the heading."""
    turn = math.radians(turned_deg)
    middle = (distance_in + thick_in / 2) * complex(math.cos(turn), math.sin(turn))
    along = 800 * 1j * complex(math.cos(turn), math.sin(turn))
    (one, other) = (middle - along, middle + along)
    return (
        f'<wall x1="{one.real}in" y1="{one.imag}in" x2="{other.real}in" y2="{other.imag}in"'
        f' thickness="{thick_in}in"/>'
    )


def expected_wall(number: int, distance_in: float, turned_deg: float) -> int:
    """Return a sonar's reading of a wall, from the foot of the perpendicular.

    The sonar is 8 in from the centre, so the wall is 8 in times the cosine of the angle between
    sonar and normal nearer to it; where the foot is out of the beam its side meets the wall first.
    """
    off = math.remainder(math.radians(22.5 * number - turned_deg), math.tau)
    foot = distance_in - SHELL_IN * math.cos(off)
    slant = max(abs(off) - BEAM, 0.0)
    reading = foot / math.cos(slant) if slant < math.pi / 2 else math.inf
    return 255 if reading > 255 else round(reading)


@pytest.mark.function("get_sn")
@pytest.mark.parametrize("turned", [0, 5, 11, 22.5, 45, 70])
def test_wall_is_measured_at_several_angles(turned):
    readings = ring(wall(100, turned))
    assert readings == [expected_wall(number, 100, turned) for number in range(16)]


@pytest.mark.function("get_sn")
@pytest.mark.parametrize("number", [0, 3, 8, 13])
def test_cylinder_is_measured_by_each_sonar(number):
    turn = math.radians(22.5 * number)
    place = f'x="{120 * math.cos(turn)}in" y="{120 * math.sin(turn)}in"'
    readings = ring(f'<cylinder {place} radius="12in"/>')
    assert readings[number] == 120 - 12 - SHELL_IN
    assert readings[number - 8] == 255


@pytest.mark.function("get_sn")
@pytest.mark.parametrize("setup", ["", "noisy"])
def test_corner_of_box_is_measured(setup):
    # The corner points at the robot, so that its faces are turned by 45 degrees.
    box = f'<box x="{90 + 10 * math.sqrt(2)}in" y="0" length="20in" width="20in" heading="45"/>'
    reading = ring(box, setup)[0]
    assert reading == pytest.approx(90 - SHELL_IN, abs=5 if setup else 0)


@pytest.mark.function("get_sn")
def test_smooth_wall_has_no_echo_beyond_critical_angle():
    # Sonar 2 looks at the wall ahead from 45 degrees; its beam begins at 35.
    assert ring(wall(60, 0))[2] == expected_wall(2, 60, 0) < 255
    assert ring(wall(60, 0), "noisy")[2] == 255


@pytest.mark.function("get_sn")
def test_get_sn_refreshes_only_sonars():
    done = drive(
        """
        connect_robot(1); State[STATE_CONF_X] = 77; State[STATE_SONAR_0] = -1;
        get_sn();
        printf("%ld %ld", State[STATE_CONF_X], State[STATE_SONAR_0]);
        """,
        elements=OPEN + wall(100, 0),
    )
    assert done.numbers == [77, 92]


# -- conf_sn -----------------------------------------------------------------------------------


def subset(order: str, rate: int = 15, wait_us: int = 1_000_000) -> list[int]:
    """Return the sonars that hear a wall around them after a call of `conf_sn`."""
    done = drive(
        f"""
        {order}
        connect_robot(1);
        conf_sn({rate}, order); usleep({wait_us}); get_sn(); {TELL}
        """,
        elements='<robot x="50in" y="50in"/>',
        area='length="100in" width="100in"',
    )
    assert done.status == 0
    return [number for number, reading in enumerate(done.numbers) if reading < 255]


@pytest.mark.function("conf_sn")
@pytest.mark.parametrize(
    ("order", "heard"),
    [
        ("int order[16] = {0,2,15,1,14,3,13,4,12,5,11,6,10,7,9,8};", list(range(16))),
        ("int order[16] = {4, 12, 0, 255};", [0, 4, 12]),
        ("int order[1] = {255};", []),
        ("int *order = NULL;", []),
        ("int order[2] = {9, -1};", [9]),
    ],
)
def test_conf_sn_order_ends_at_255(order, heard):
    assert subset(order) == heard


@pytest.mark.function("conf_sn")
@pytest.mark.parametrize(
    ("rate", "interval_s"), [(0, 0.04), (15, 0.06), (50, 0.2), (255, 1.02), (256, 0.04)]
)
def test_conf_sn_fires_every_rate_times_4_ms(rate, interval_s):
    order = "int order[3] = {0, 1, 255};"
    done = drive(f"{order} connect_robot(1); conf_sn({rate}, order); usleep(990000);")
    environment = done.session.environment
    sonar = environment.state.devices.sonar
    since_s = environment.time_s - float(sonar.start_s[0])
    assert since_s > 0.99
    assert sonar.turn[0] == math.ceil(since_s / interval_s)


@pytest.mark.function("conf_sn")
def test_readings_age_until_next_firing():
    # At 20 in/s towards a wall: sonar 0 fires each half second, so its reading falls by 10 in.
    done = drive(
        """
        int order[16] = {0, 4, 8, 12, 255}, i;
        connect_robot(1);
        conf_sn(125 / 4, order);             /* 31 x 4 ms x 4 sonars = 0.496 s */
        ac(500, 500, 0); vm(200, 200, 0); usleep(1000000);
        for (i = 0; i < 40; i++) {
            gs();
            printf("%ld %ld\\n", State[STATE_CONF_X], State[STATE_SONAR_0]);
            usleep(33000);
        }
        """,
        elements=OPEN + wall(200, 0),
    )
    pairs = list(zip(done.numbers[::2], done.numbers[1::2], strict=True))
    late_in = [SHELL_IN + reading + x / 10 - 200 for x, reading in pairs]
    assert min(late_in) > -0.6
    assert max(late_in) == pytest.approx(20 * 0.5, abs=2)
    assert len({reading for _, reading in pairs}) in {4, 5}


@pytest.mark.function("conf_sn", "get_sn")
def test_two_robots_measure_each_other():
    done = drive(
        f"""
        int order[2] = {{0, 255}};
        connect_robot(1); conf_sn(0, order); usleep(200000); get_sn(); {TELL}
        """,
        elements='<robot x="0" y="0"/><robot x="116in" y="0" heading="180"/>',
    )
    for output in done.output:
        assert [int(word) for word in output.split()] == [100, *[255] * 15]


@pytest.mark.function("conf_sn")
def test_carmen_style_program_switches_sonars_off():
    done = drive(
        """
        int order[16] = {0,2,15,1,14,3,13,4,12,5,11,6,10,7,9,8};
        connect_robot(1);
        printf("%d ", conf_sn(0, order)); usleep(300000); gs();
        printf("%ld ", State[STATE_SONAR_0]);
        printf("%d ", conf_sn(0, NULL)); gs();
        printf("%ld", State[STATE_SONAR_0]);
        """,
        elements=OPEN + wall(50, 0),
    )
    assert done.numbers == [1, 42, 1, 255]
