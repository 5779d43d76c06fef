"""`crs_light`, `crs_sound`, `crs_get_light` and `crs_get_sound` from C."""

import pytest

from tests.device.robot import scout_with
from tests.nclient.drive import drive

ELEMENTS = (
    '<robot x="0" y="0"/><light x="2m" y="0" brightness="400"/>'
    '<sound x="0" y="2m" level="300" tone="2"/>'
)
SHOW = 'for (i = 0; i < 8; i++) printf("%d ", n[i]); printf("%d\\n", got);'


@pytest.mark.function("crs_get_light", "crs_get_sound")
def test_lights_and_sounds_of_the_world_are_sensed(tmp_path):
    robot = scout_with(tmp_path, "<light-sensors/><microphones/>")
    program = (
        f"int n[8] = {{0}}, i, got, d; got = crs_get_light(n, 8); {SHOW}"
        f'got = crs_get_sound(n, 8, &d); {SHOW} printf("%d\\n", d);'
        'got = crs_get_light(n, 2); printf("%d %d\\n", got, crs_get_sound(n, -1, NULL));'
    )
    done = drive(program, robot=robot, elements=ELEMENTS)
    light = [100, 71, 0, 0, 0, 0, 0, 71, 8]
    assert done.numbers == [*light, 0, 0, 150, 0, 0, 0, 0, 0, 8, 900, 2, 0]


@pytest.mark.function("crs_light", "crs_sound")
def test_robots_sense_lamps_and_speakers_of_each_other(tmp_path):
    robot = scout_with(tmp_path, "<light-sensors/><microphones/><lamp/><speaker/>")
    sense = (
        "int n[8], m[8]; usleep(200000); crs_get_light(n, 8); crs_get_sound(m, 8, 0);"
        'printf("%d %d\\n", n[0], m[5]);'
    )
    show = 'printf("%d\\n", crs_light(400) + crs_sound(600, 5));'
    elements = '<robot x="0" y="0"/><robot x="2m" y="0"/>'
    done = drive(sense, show, robot=robot, elements=elements)
    assert done.output == ["100 300\n", "2\n"]


def test_robot_without_beacons_returns_false():
    program = "int n[8]; return crs_light(1) + crs_sound(1, 1) + crs_get_light(n, 8)"
    assert drive(f"{program} + crs_get_sound(n, 8, 0);").status == 0
