"""`crs_period` and `crs_age`: sensors that measure independently of requests."""

import re
from pathlib import Path

import numpy as np
import pytest

from crs_cc.core.errors import WorldError
from crs_cc.session.device_library import device_headers
from crs_cc.session.library import HEADERS
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import empty_world, load_robot, parse_world
from crs_cc.sim.model.attribute import attributes_of
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.registry import devices, sensor_count
from tests.device.robot import scout_with
from tests.nclient.drive import drive
from tests.sim.driver import Driver


def _rate(device: Device) -> str:
    has_rate = "rate" in {each.name for each in attributes_of(device.model)}
    return "rate='100Hz'" if has_rate else ""


GIVEN = {
    "compass": "on='yes'",
    "heat": "range='3m'",
    "infrared": "step='1in' order='0'",
    "laser": "field-of-view='90deg' range='5m' mode='51'",
}
ROWS = [device for device in devices() if device.number is not None]
SENSORS = {device.name.upper(): device.number for device in ROWS}
GPS_10_HZ = '<gps rate="10Hz" period="0.1s"/>'
REGISTERED = "".join(f"<{each.element} {_rate(each)} {GIVEN.get(each.name, '')}/>" for each in ROWS)


def test_header_and_simulator_use_same_sensor_numbers():
    text = (HEADERS / "crs.h").read_text() + device_headers()[0][1]
    defined = re.findall(r"#define CRS_SENSOR_(\w+) (\d+)", text)
    assert {name: int(number) for name, number in defined} == SENSORS
    assert sorted(SENSORS.values()) == list(range(sensor_count()))
    fixed = ("GPS", "CAMERA", "HEAT", "LASER", "INFRARED", "COMPASS", "TILT")
    assert [SENSORS[name] for name in fixed] == list(range(7))
    assert (SENSORS["LIGHT"], SENSORS["SOUND"], SENSORS["ALTITUDE"]) == (7, 8, 9)


@pytest.mark.function("crs_age")
def test_periodic_sensor_measures_at_multiples_of_its_period(tmp_path):
    """Requested at 1.23 s (plus 1 ms on the network), the last measurement is from 1.2 s."""
    program = """
    int x, y;
    usleep(1230000);
    printf("%d\\n", crs_age(CRS_SENSOR_GPS));
    crs_gps(&x, &y);
    printf("%d\\n", crs_age(CRS_SENSOR_GPS));
    """
    ages = drive(program, robot=scout_with(tmp_path, GPS_10_HZ)).numbers
    assert ages == pytest.approx([30.5, 32.5], abs=1.01)  # crs_gps does not make it measure


def test_periodic_sensor_fires_independently_of_requests(tmp_path):
    """Every 70 ms, in timesteps of 50 ms: the last one before the end of each timestep."""
    robot = scout_with(tmp_path, '<gps rate="100Hz" period="70ms"/>')
    driver = Driver.of(empty_world(robot=robot))
    for cycle in range(1, 30):
        driver.run(1)
        turn = np.ceil(cycle * 0.05 / 0.07 - 1e-9) - 1  # the end belongs to the next timestep
        assert driver.state.devices.gps.at_s[0] == pytest.approx(turn * 0.07, abs=1e-12)
    assert driver.state.devices.gps.count[0] == turn + 1


def test_periodic_measurement_uses_pose_at_its_time(tmp_path):
    """At 10 in/s for a while, it has measured at the last of its times, 0.33 s apart."""
    program = """
    int x, y;
    connect_robot(1);
    ac(200, 200, 0); sp(100, 100, 0); vm(100, 100, 0);
    usleep(3000000);
    crs_period(CRS_SENSOR_GPS, 330);
    usleep(500000);
    crs_gps(&x, &y);
    printf("%d %d\\n", x, crs_age(CRS_SENSOR_GPS));
    crs_period(CRS_SENSOR_GPS, 0);
    crs_gps(&x, &y);
    printf("%d %d\\n", x, crs_age(CRS_SENSOR_GPS));
    """
    done = drive(program, robot=scout_with(tmp_path, '<gps rate="100Hz"/>'), timestep="100ms")
    periodic, age, now, fresh = done.numbers
    assert 150 < age < 185
    assert fresh <= 2
    # The measurement lags by the distance moved since, at 0.01 in per millisecond.
    assert now - periodic == pytest.approx((age + 2 - fresh) / 10, abs=1.1)


@pytest.mark.function("crs_period")
@pytest.mark.parametrize("sensor", SENSORS)
def test_timer_of_every_sensor_can_be_set_and_cleared(tmp_path, sensor):
    program = f"""
    int sensor = CRS_SENSOR_{sensor};
    printf("%d\\n", crs_age(sensor));
    printf("%d\\n", crs_period(sensor, 100));
    usleep(550000);
    printf("%d\\n", crs_age(sensor));
    printf("%d\\n", crs_period(sensor, 0));
    usleep(550000);
    printf("%d\\n", crs_age(sensor));
    """
    path = Path(scout_with(tmp_path))
    text = path.read_text().replace('<heat range="3m"/>', REGISTERED)
    path.write_text(text)
    before, first, age, second, old = drive(program, robot=str(path)).numbers
    assert (before, first, second) == (-1, 1, 1)
    assert 50 <= age <= 56
    assert 600 <= old <= 615


def test_rate_limits_period(tmp_path):
    driver = Driver.of(empty_world(robot=scout_with(tmp_path, '<gps rate="10Hz"/>')))
    assert driver.post("PERIOD", 0, 1)[0]["result"] == 1
    driver.run_s(1.0)
    assert driver.state.devices.gps.count[0] == 10


@pytest.mark.parametrize("arguments", [(1, 100), (6, 100), (-1, 100), (2**31 - 1, 0), (0, -1)])
def test_missing_sensor_and_negative_period_are_refused(tmp_path, arguments):
    driver = Driver.of(empty_world(robot=scout_with(tmp_path, '<gps rate="10Hz"/>')))
    assert driver.post("PERIOD", *arguments)[0]["result"] == 0
    assert not np.isfinite(driver.state.timers.soonest_s).any()
    if arguments[0]:
        assert driver.post("AGE", *arguments)[0]["result"] == 0


@pytest.mark.parametrize(
    ("attributes", "wrong"),
    [
        ('rate="10Hz" period="99ms"', "gps, period: must not be shorter than 1 / rate"),
        ('rate="1MHz" period="0.1ms"', "gps, period: must be 0, or 1ms or more"),
        ('period="-1s"', "gps, period: '-1s' must not be negative"),
    ],
)
def test_invalid_period_is_reported(tmp_path, attributes, wrong):
    with pytest.raises(WorldError, match=wrong):
        load_robot(Path(scout_with(tmp_path, f"<gps {attributes}/>")))


def test_timers_of_joining_robot_start_when_it_joins(tmp_path):
    """It joins at 1 s and measures every 0.3 s: at 1, 1.3 and 1.6 s."""
    robot = scout_with(tmp_path, '<gps rate="100Hz" period="300ms"/>')
    world = '<world version="1"><area length="9m" width="9m"/><robot x="1m" y="1m"/>{}</world>'
    guest = '<robot x="5m" y="5m" join="1s"/>'
    driver = Driver(Environment(parse_world(world.format(guest).encode(), "w", robot=robot), 1))
    driver.run_s(1.0)
    assert driver.state.devices.gps.count.tolist() == [4, 0]
    driver.run_s(0.7)
    assert driver.state.devices.gps.count.tolist() == [6, 3]
    assert driver.state.devices.gps.at_s[1] == pytest.approx(1.6)


def test_timers_continue_from_snapshot(tmp_path):
    robot = scout_with(tmp_path, '<gps rate="100Hz" noise="1cm" period="30ms"/>')
    driver = Driver.of(empty_world(robot=robot))
    driver.run(3)
    snapshot = driver.environment.snapshot()
    hashes = []
    for _ in range(2):
        driver.environment.restore(snapshot)
        driver.run(4)
        hashes.append(driver.environment.hash())
    assert hashes[0] == hashes[1]


def test_laser_that_was_switched_off_has_no_measurement(tmp_path):
    """Its earlier readings are discarded; a request for their age was an internal error."""
    laser = "<laser field-of-view='90deg' range='5m' mode='51'/>"
    driver = Driver.of(empty_world(robot=scout_with(tmp_path, laser)))
    driver.post("LASER")
    assert driver.post("AGE", SENSORS["LASER"])[0]["i"][0] >= 0
    assert driver.post("CONF_LS", 0, 20, 20, 20, 4)[0]["result"] == 1
    assert driver.post("AGE", SENSORS["LASER"])[0]["i"][0] == -1


def test_light_sensors_and_microphones_with_timer_return_last_measurement(tmp_path):
    """A neighbour 2 m ahead shines (400) and sounds (600) from 0.5 s on; they measure each second.

    Requested at 0.7 s they report nothing, as at 0 s. From 1 s on it is 400 / 2^2, and 600 / 2.
    """
    devices = '<light-sensors period="1s"/><microphones period="1s"/><lamp/><speaker/>'
    robot = scout_with(tmp_path, devices)
    sense = """
    int n[8], m[8], i;
    for (i = 0; i < 2; i++) {
        usleep(700000);
        crs_get_light(n, 8);
        crs_get_sound(m, 8, NULL);
        printf("%d %d %d\\n", n[0], m[5], crs_age(CRS_SENSOR_LIGHT) / 100);
    }
    """
    show = "usleep(500000); crs_light(400); crs_sound(600, 5);"
    elements = '<robot x="0" y="0"/><robot x="2m" y="0"/>'
    done = drive(sense, show, robot=robot, elements=elements)
    assert done.output[0] == "0 0 7\n100 300 4\n"


def test_inclinometer_with_timer_returns_last_measurement(tmp_path):
    """It drives from level ground onto a ramp of 1 in 4 while the last reading is from before."""
    robot = scout_with(tmp_path, '<inclinometer period="20s"/>')
    program = """
    int pitch, roll, i;
    connect_robot(1);
    pr(600, 600, 0); ws(1, 1, 0, 15);
    for (i = 0; i < 2; i++) {
        crs_tilt(&pitch, &roll);
        printf("%d %d\\n", pitch, roll);
        crs_period(CRS_SENSOR_TILT, 0);
    }
    """
    ramp = '<surface><ramp x="2.6m" y="0" length="4m" width="4m" to="1m"/></surface>'
    done = drive(program, robot=robot, elements=f'{ramp}<robot x="0" y="0"/>')
    assert done.numbers == [0, 0, 140, 0]


def test_snapshot_contains_light_and_sound_measurements(tmp_path):
    devices = '<light-sensors period="70ms" noise="0.1"/><microphones period="40ms" noise="0.1"/>'
    light = '<light x="2m" y="0" brightness="400"/><sound x="0" y="2m" level="300" tone="2"/>'
    area = '<area length="4m" width="4m"/>'
    light = light.replace('"0"', '"1m"')
    world = f'<world version="1">{area}{light}<robot x="1m" y="1m"/></world>'
    robot = scout_with(tmp_path, devices)
    driver = Driver(Environment(parse_world(world.encode(), "w", robot=robot), 1))
    driver.run(3)
    assert driver.state.devices.light.count[0] == 3
    assert driver.state.devices.sound.count[0] == 4
    snapshot = driver.environment.snapshot()
    hashes = []
    for _ in range(2):
        driver.environment.restore(snapshot)
        driver.run(4)
        hashes.append(driver.environment.hash())
    assert hashes[0] == hashes[1]
