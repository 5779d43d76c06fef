"""The infrared ring of the Nomad 200: its law, its order and its history."""

import math

import numpy as np
import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.devices.infrared import rings
from crs_cc.sim.devices.vendor_state import IR_0
from tests.sim.driver import Driver, open_world, own_world

RING = slice(IR_0, IR_0 + 16)
NOMAD = '<robot definition="nomad200" x="0" y="0"/>'
RADIUS_IN = 22.5 / 2.54
EXACT = 'step="1in" half-angle="5deg" reflectance="1" rate="20Hz" noise="0in"'
ALL_OFF = [15] * 16


def wall(distance_in: float) -> str:
    """Return a wall at a distance ahead of the shell of a Nomad at the origin."""
    x_in = RADIUS_IN + distance_in + 1
    return f'<wall x1="{x_in}in" y1="-5m" x2="{x_in}in" y2="5m" thickness="2in"/>'


def ring(driver: Driver, name: str = "GET_IR", robot: int = 0) -> list[int]:
    return driver.ask(name, robot=robot)[RING].tolist()


@pytest.mark.parametrize(
    ("distance_in", "reading"), [(0.3, 0), (0.7, 1), (6.2, 6), (6.6, 7), (14.4, 14), (14.6, 15)]
)
def test_reading_is_distance_in_inches_up_to_15(distance_in, reading):
    driver = Driver.of(open_world(NOMAD + wall(distance_in)))
    assert ring(driver)[0] == reading
    assert ring(driver)[5:12] == [15] * 7


def test_reading_without_object_is_15():
    assert ring(Driver.of(open_world(NOMAD))) == ALL_OFF
    assert ring(Driver.of(open_world(NOMAD + wall(40)))) == ALL_OFF


@pytest.mark.parametrize("number", range(16))
def test_sensors_are_numbered_counterclockwise_from_front(number):
    angle = math.radians(22.5) * number
    away_in = RADIUS_IN + 5 + 1
    x_in, y_in = away_in * math.cos(angle), away_in * math.sin(angle)
    pole = f'<cylinder x="{x_in}in" y="{y_in}in" radius="1in"/>'
    readings = ring(Driver.of(open_world(NOMAD + pole)))
    assert readings[number] == 5
    assert readings[(number + 8) % 16] == 15


def test_quarter_reflectance_doubles_apparent_distance(tmp_path):
    dark = (EXACT, EXACT.replace('reflectance="1"', 'reflectance="0.25"'))
    elements = '<robot x="0" y="0"/>' + wall(5)
    driver = Driver.of(own_world(tmp_path, dark, elements=elements, robot="nomad200"))
    assert ring(driver)[0] == 10
    elements = '<robot x="0" y="0"/>' + wall(7.6)
    driver = Driver.of(own_world(tmp_path, dark, elements=elements, robot="nomad200"))
    assert ring(driver)[0] == 15


def test_ring_turns_with_turret():
    driver = Driver.of(open_world(NOMAD + wall(6)))
    driver.ask("PR", 0, 0, 900)
    driver.run_s(10)
    readings = ring(driver)
    assert readings[12] == 6  # what was ahead is on the right of the turret
    assert readings[0] == 15


def test_history_keeps_share_of_last_reading():
    driver = Driver.of(open_world(NOMAD + wall(5)))
    message, _ = driver.post("CONF_IR", 5, data=bytes([0, 255]))
    assert message["result"] == 1
    levels = []
    for _ in range(4):  # from 15 half of the way to 5 each time
        driver.run(1)
        levels.append(ring(driver)[0])
    assert levels == [8, 6, 6, 5]  # 7.5, 6.25, 5.625, 5.3125: the reply to conf_ir had 10


def test_rate_is_limited_to_20_hz():
    driver = Driver.of(open_world(NOMAD + wall(5)))
    driver.post("CONF_IR", 5, data=bytes([0, 255]))
    driver.run(1)
    within = [ring(driver)[0] for _ in range(5)]
    assert len(set(within)) == 1  # one measurement, one step from 15 towards 5
    driver.run(1)
    assert ring(driver)[0] < within[0]


def test_history_0_has_no_memory_and_10_never_changes():
    driver = Driver.of(open_world(NOMAD + wall(5)))
    driver.ask("CONF_IR", 10, data=bytes(range(16)))
    for _ in range(5):
        driver.run(1)
        before = ring(driver)[0]
    assert before == rings(driver.state).level[0, 0]
    driver.ask("CONF_IR", 0, data=bytes(range(16)))
    driver.run(1)
    assert ring(driver)[0] == 5


def test_only_sensors_in_order_measure():
    driver = Driver.of(open_world(NOMAD + wall(2)))
    driver.run(1)
    assert sum(reading < 15 for reading in ring(driver)) >= 3
    driver.ask("CONF_IR", 0, data=bytes([1, 255, 0]))
    driver.run(1)
    readings = ring(driver)
    assert [number for number, reading in enumerate(readings) if reading < 15] == [1]


@pytest.mark.parametrize("order", [bytes([16]), bytes([0, 200, 255])])
def test_conf_ir_refuses_invalid_sensors(order):
    driver = Driver.of(open_world(NOMAD))
    assert driver.post("CONF_IR", 0, data=order)[0]["result"] == 0
    assert rings(driver.state).on[0].all()


def test_every_state_contains_infrared_unless_masked():
    driver = Driver.of(open_world(NOMAD + wall(6)))
    assert ring(driver, "GS")[0] == 6
    mask = bytearray([0] + [1] * 43)
    mask[1:17] = bytes(16)
    assert driver.post("CT", data=bytes(mask))[0]["result"] == 1
    driver.ask("VM", 20, 0)
    driver.run_s(1)
    assert ring(driver, "GS")[0] == 6  # as it was
    assert ring(driver, "GET_IR")[0] < 6  # independent of the mask
    assert driver.post("CT", data=bytes(10))[0]["result"] == 0


def test_measurement_uses_pose_at_its_time():
    driver = Driver.of(open_world(NOMAD + wall(14), timestep="100ms"))
    driver.ask("AC", 300, 300)
    driver.ask("VM", 200, 0)
    driver.run_s(1.0)
    driven_in = driver.state.x_m[0] / 0.0254
    late = driver.post("GET_IR", at_s=driver.environment.time_s + 0.0999)[0]
    seen = late["data"][:180].view("<i4")[IR_0]
    assert seen == max(0, round(14 - driven_in - 20 * 0.0999))
    assert rings(driver.state).measured.configuration[0, 0] == late["data"][:180].view("<i4")[34]


def test_scout_has_no_infrared():
    driver = Driver.of(open_world('<robot x="0" y="0"/><robot definition="nomad200" x="0" y="9"/>'))
    for name in ("GET_IR", "CONF_IR"):
        assert driver.post(name)[0]["result"] == 0
        assert driver.post(name, robot=1)[0]["result"] == 1
    assert ring(driver, "GS") == [0] * 16


def test_noise_has_standard_deviation_of_definition(tmp_path):
    noisy = (EXACT, EXACT.replace('noise="0in"', 'noise="1in"').replace('step="1in"', 'step="4in"'))
    elements = '<robot x="0" y="0"/>' + wall(30)
    driver = Driver.of(own_world(tmp_path, noisy, elements=elements, robot="nomad200"))
    seen = []
    for _ in range(300):
        driver.run(1)
        driver.ask("GET_IR")
        seen.append(rings(driver.state).level[0, 0] * 4)
    assert np.mean(seen) == pytest.approx(30, abs=0.3)
    assert np.std(seen) == pytest.approx(1, abs=0.2)


@pytest.mark.parametrize(
    ("bad", "message"),
    [
        ('step="0in"', "step: '0in' must be greater than 0"),
        ('step="1in" half-angle="90deg"', "less than 90deg"),
        ('step="1in" half-angle="-1deg"', "half-angle: '-1deg' must not be negative"),
        ('step="1in" reflectance="2"', "reflectance"),
        ('step="1in" order="16"', "order: unknown sensor 16"),
        ('step="1in" history="11"', "history: '11' is not an integer from 0 to 10"),
    ],
)
def test_an_invalid_ring_is_refused_with_one_message(tmp_path, bad, message):
    with pytest.raises(WorldError) as caught:
        own_world(tmp_path, (EXACT, bad), robot="nomad200")
    assert sum(message in each.render() for each in caught.value.diagnostics) == 1


@pytest.mark.parametrize(("share", "reading"), [(1.0, 6), (0.25, 12), (0.16, 15), (0.0, 15)])
def test_lower_reflectance_increases_apparent_distance(share, reading):
    """6 in from the shell: twice as far for a quarter of the light, and 2.5 times for 0.16."""
    dark = wall(6).replace("/>", f' infrared="{share}"/>')
    assert ring(Driver.of(open_world(NOMAD + dark)))[0] == reading
