"""Light and sound: hand-computed readings of sources in the world and on robots."""

import numpy as np
import pytest

from crs_cc.requests import CODES, MESSAGE
from tests.sim.gripping import gripping

WIDE = 'length="100m" width="100m" origin="centre" edge="0"'
ROBOT = '<robot x="0" y="0"/>'
EYES = '<light-sensors number="8"/>'
EARS = "<microphones/>"
LAMP, SPEAKER = "<lamp/>", '<speaker loudest="500"/>'
SCREEN = '<box x="1m" y="0" length="10cm" width="50cm"/>'


def eyes(driver, robot=0, count=8):
    """Return the readings of the light sensors."""
    message, _ = driver.post("GET_LIGHT", robot=robot)
    assert message["i"][0] == count
    return message["data"].view("<i4")[:count].tolist()


def ears(driver, robot=0):
    """Return the levels of the eight tones, and the direction of the loudest [0.1 deg]."""
    message, _ = driver.post("GET_SOUND", robot=robot)
    return message["data"].view("<i4")[:8].tolist(), int(message["i"][0])


def test_light_follows_inverse_square_and_cosine_law(tmp_path):
    """A light of 800 at 2 m ahead: 200 straight on, 141 at 45 degrees, none at 90 and behind."""
    driver = gripping(tmp_path, ROBOT + '<light x="2m" y="0" brightness="800"/>', WIDE, EYES)
    assert eyes(driver) == [200, 141, 0, 0, 0, 0, 0, 141]


def test_sensors_turn_with_robot_and_are_numbered_from_first(tmp_path):
    """Four sensors, the first at 45 degrees, of a robot that looks up; the light is to the left."""
    light = '<light x="-1m" y="0" brightness="100"/>'
    ring = '<light-sensors number="4" first="45deg"/>'
    driver = gripping(tmp_path, '<robot x="0" y="0" heading="90"/>' + light, WIDE, ring)
    assert eyes(driver, count=4) == [71, 71, 0, 0]


def test_lights_are_added(tmp_path):
    lights = '<light x="1m" y="0" brightness="100"/><light x="0" y="2m" brightness="400"/>'
    driver = gripping(tmp_path, ROBOT + lights, WIDE, EYES)
    assert eyes(driver) == [100, 141, 100, 71, 0, 0, 0, 71]


def test_obstacle_casts_shadow(tmp_path):
    """The screen hides the light ahead; the one to the side is in sight."""
    lights = '<light x="2m" y="0" brightness="800"/><light x="0" y="2m" brightness="400"/>'
    driver = gripping(tmp_path, ROBOT + SCREEN + lights, WIDE, EYES)
    assert eyes(driver) == [0, 71, 100, 71, 0, 0, 0, 0]


def test_light_out_of_range_is_not_sensed(tmp_path):
    light = '<light x="2m" y="0" brightness="800"/>'
    for range_m, reads in (("1.9m", 0), ("2.1m", 200)):
        driver = gripping(tmp_path, ROBOT + light, WIDE, f'<light-sensors range="{range_m}"/>')
        assert eyes(driver)[0] == reads


def test_robots_see_lamps_of_others_only(tmp_path):
    """Robot 1 looks at robot 0 from 2 m ahead, and shines with 400; robot 0 with 800."""
    robots = ROBOT + '<robot x="2m" y="0" heading="180"/>'
    driver = gripping(tmp_path, robots, WIDE, EYES, LAMP)
    driver.post("LIGHT", 800, robot=0)
    driver.post("LIGHT", 400, robot=1)
    assert [eyes(driver, robot)[0] for robot in (0, 1)] == [100, 200]
    driver.post("LIGHT", 2**31 - 1, robot=0)  # no brighter than 1000
    driver.post("LIGHT", -1, robot=1)
    assert [eyes(driver, robot)[0] for robot in (0, 1)] == [0, 250]


def test_robot_in_between_casts_shadow(tmp_path):
    robots = ROBOT + '<robot x="1m" y="0"/><robot x="2m" y="0"/>'
    driver = gripping(tmp_path, robots, WIDE, EYES, LAMP)
    driver.post("LIGHT", 800, robot=2)
    assert eyes(driver)[0] == 0
    assert eyes(driver, 1)[0] == 800


def test_sound_level_falls_with_distance_and_powers_add(tmp_path):
    """100 at 1 m of tone 3 from two sides: 100 * sqrt 2; tone 5 at 4 m: 25."""
    places = ("0", "1m", 3), ("1m", "0", 3), ("-4m", "0", 5)
    sounds = "".join(f'<sound x="{x}" y="{y}" tone="{tone}"/>' for x, y, tone in places)
    driver = gripping(tmp_path, ROBOT + sounds, WIDE, EARS)
    assert ears(driver) == ([0, 0, 0, 141, 0, 25, 0, 0], 450)


def test_obstructed_sound_has_quarter_of_pressure(tmp_path):
    sound = '<sound x="2m" y="0" level="400" tone="1"/>'
    open_air = gripping(tmp_path, ROBOT + sound, WIDE, EARS)
    assert ears(open_air) == ([0, 200, 0, 0, 0, 0, 0, 0], 0)
    behind = gripping(tmp_path, ROBOT + sound + SCREEN, WIDE, EARS)
    assert ears(behind) == ([0, 50, 0, 0, 0, 0, 0, 0], 0)


def test_robots_hear_others_from_their_direction(tmp_path):
    """Robot 1 is 2 m to the left of robot 0, which looks along x."""
    driver = gripping(tmp_path, ROBOT + '<robot x="0" y="2m"/>', WIDE, EARS, SPEAKER)
    driver.post("SOUND", 300, 7, robot=1)
    assert ears(driver) == ([0, 0, 0, 0, 0, 0, 0, 150], 900)
    assert ears(driver, 1) == ([0] * 8, 0)
    driver.post("SOUND", 900, 0, robot=1)  # no louder than 500
    assert ears(driver)[0][0] == 250
    assert driver.post("SOUND", 100, 8, robot=1)[0]["result"] == 0
    assert driver.post("SOUND", 100, -1, robot=1)[0]["result"] == 0


def test_noise_is_proportional_as_defined(tmp_path):
    """500 readings of 1000: the deviation is 50, its standard error 3.2% of that."""
    elements = ROBOT + '<light x="1m" y="0" brightness="1000"/><sound x="1m" y="0" level="1000"/>'
    devices = EYES.replace("/>", ' noise="0.05"/>'), '<microphones noise="0.05"/>'
    driver = gripping(tmp_path, elements, WIDE, *devices)
    lights = np.array([eyes(driver)[0] for _ in range(500)])
    sounds = np.array([ears(driver)[0][0] for _ in range(500)])
    for readings in (lights, sounds):
        assert readings.std() == pytest.approx(50, rel=0.12)
        assert readings.mean() == pytest.approx(1000, abs=8)
    assert abs(np.corrcoef(lights, sounds)[0, 1]) < 0.16


def test_batched_readings_equal_single_readings(tmp_path):
    robots = "".join(
        f'<robot x="{n % 6 * 2}m" y="{n // 6 * 2}m" heading="{n * 37}"/>' for n in range(30)
    )
    lights = '<light x="3m" y="3m" brightness="500"/><light x="7m" y="5m" brightness="300"/>'
    driver = gripping(tmp_path, robots + lights, WIDE, EYES, LAMP)
    for robot in range(0, 30, 3):
        driver.post("LIGHT", 100 * robot, robot=robot)
    messages = np.zeros(30, MESSAGE)
    driver.environment.serve(CODES["GET_LIGHT"], np.arange(30), messages, np.zeros(30))
    together = messages["data"].view("<i4")[:, :8].tolist()
    assert together == [eyes(driver, robot) for robot in range(30)]
    assert max(map(max, together)) > 100


def test_beacons_are_reproduced_from_snapshot(tmp_path):
    devices = EYES.replace("/>", ' noise="0.1"/>'), EARS, LAMP, SPEAKER
    driver = gripping(tmp_path, ROBOT + '<robot x="2m" y="0"/>', WIDE, *devices)
    driver.post("LIGHT", 500, robot=1)
    driver.post("SOUND", 300, 4, robot=1)
    first = eyes(driver)
    snapshot = driver.environment.snapshot()
    found = []
    for _ in range(2):
        driver.environment.restore(snapshot)
        found.append((eyes(driver), ears(driver), driver.environment.hash()))
        driver.post("LIGHT", 0, robot=1)
        driver.run(2)
    assert found[0] == found[1]
    assert found[0][0] != first


@pytest.mark.parametrize(("fault", "device", "reads"), [
    ('device="light" element="0" gain="0.5"', EYES, [100, 141]),
    ('device="light" dead="yes"', EYES, [0, 0]),
])  # fmt: skip
def test_light_sensors_can_be_degraded(tmp_path, fault, device, reads):
    elements = (
        ROBOT + '<light x="2m" y="0" brightness="800"/>' + f'<degradation robot="robot0" {fault}/>'
    )
    assert eyes(gripping(tmp_path, elements, WIDE, device))[:2] == reads


def test_lamps_speakers_and_microphones_can_be_degraded(tmp_path):
    faults = "".join(
        f'<degradation robot="{robot}" device="{device}" gain="0.5"/>'
        for robot, device in (("robot1", "lamp"), ("robot1", "speaker"), ("robot0", "sound"))
    )
    robots = ROBOT + '<robot x="1m" y="0"/>'
    driver = gripping(tmp_path, robots + faults, WIDE, EYES, EARS, LAMP, SPEAKER)
    driver.post("LIGHT", 800, robot=1)
    driver.post("SOUND", 400, 2, robot=1)
    assert eyes(driver)[0] == 400
    assert ears(driver)[0][2] == 100


def test_robot_without_beacons_is_refused(tmp_path):
    driver = gripping(tmp_path, ROBOT, WIDE)
    names = ("LIGHT", "SOUND", "GET_LIGHT", "GET_SOUND")
    assert [int(driver.post(name)[0]["result"]) for name in names] == [0, 0, 0, 0]


def test_light_at_centre_counts_as_10_cm_away(tmp_path):
    driver = gripping(tmp_path, ROBOT + '<light x="1cm" y="0" brightness="10"/>', WIDE, EYES)
    assert eyes(driver)[0] == 1000
