"""The laser of the Nomad 200: points and segments by hand-computed numbers, pages, modes."""

import math

import numpy as np
import pytest

from crs_cc.core.errors import WorldError
from crs_cc.requests import CODES, MESSAGE
from crs_cc.sim.devices.vendor_state import LASER
from crs_cc.sim.geometry.split_and_merge import segments
from crs_cc.sim.model.registry import device
from tests.sim.driver import INCH, Driver, open_world, own_world, world_of

NOMAD = '<robot definition="nomad200" x="0" y="0"/>'
WALL = '<wall x1="2.05m" y1="-5m" x2="2.05m" y2="5m" thickness="0.1m"/>'  # 2 m ahead
CORNER = (
    '<wall x1="1.55m" y1="-5m" x2="1.55m" y2="0.35m" thickness="0.1m"/>'
    '<wall x1="1.55m" y1="0.35m" x2="-5m" y2="0.35m" thickness="0.1m"/>'
)
EXACT = 'field-of-view="60deg" range="3m" forward="0.2m" rate="30Hz" noise="0mm"'
TENTH = INCH / 10


def readings(driver: Driver, name: str = "GET_LS", robot: int = 0, at_s: float = 0.0) -> list:
    """Return what the client would write to Laser: the readings of all pages."""
    message, _ = driver.post(name, robot=robot, at_s=at_s)
    assert message["result"] == 1
    return pages(driver, int(message["i"][0]), robot)


def pages(driver: Driver, count: int, robot: int = 0, predicted: int = 0) -> list:
    found: list = []
    while len(found) < count:
        page, _ = driver.post("LASER_PAGE", len(found), predicted, robot=robot)
        size, width = int(page["result"]), int(page["i"][0])
        assert 1 <= size <= 62 // width
        numbers = page["data"][: 4 * size * width].view("<i4").reshape(size, width)
        found += [tuple(row) for row in numbers.tolist()]
    assert len(found) == count
    return found


def laser(elements: str, *conf: int) -> Driver:
    driver = Driver.of(open_world(NOMAD + elements))
    assert driver.post("CONF_LS", *(conf or (51, 20, 20, 20, 4)))[0]["result"] == 1
    return driver


def test_points_on_wall_are_intersections_with_beams():
    found = readings(laser(WALL))
    assert len(found) == 20
    for number, (x, y) in enumerate(found):
        angle = math.radians((number - 9.5) * 3)  # 20 points in 60 degrees, from the right
        assert x == round(2.0 / TENTH)
        assert y == round((2.0 - 0.2) * math.tan(angle) / TENTH)


def test_points_out_of_range_are_omitted():
    # From 0.2 m ahead of the middle 2.9 m along x are in range, at 30 degrees they are not.
    elements = '<wall x1="3.15m" y1="-5m" x2="3.15m" y2="5m" thickness="0.1m"/>'
    found = readings(laser(elements, 51, 20, 20, 60, 4))
    edge_deg = math.degrees(math.acos(2.9 / 3.0))
    assert len(found) == 2 * int(edge_deg + 0.5)  # one each degree, at 0.5, 1.5, ...
    assert readings(laser("")) == []


def test_beam_straight_ahead_without_hit_causes_no_warning():
    with np.errstate(all="raise"):  # an infinite distance times the sine of 0
        assert readings(laser("", 51, 20, 20, 7, 4)) == []
        assert len(readings(laser(WALL, 51, 20, 20, 7, 4))) == 7


def test_482_points_are_returned_in_pages():
    found = readings(laser(WALL, 51, 20, 20, 482, 4))
    assert len(found) == 482
    assert found == sorted(found, key=lambda point: point[1])
    assert len(readings(laser(WALL, 51, 20, 20, 0, 4))) == 482
    assert len(readings(laser(WALL, 51, 20, 20, -1, 4))) == 482
    assert len(readings(laser(WALL, 51, 20, 20, 1, 4))) == 1


def test_corner_gives_two_segments():
    driver = laser(CORNER, 33, 20, 20, 482, 4)
    message, _ = driver.post("GS")
    found = pages(driver, int(message["i"][0]))
    assert len(found) == 2
    # From the right: the wall ahead from -30 degrees to the corner, then the left wall back.
    right_y = -1.3 * math.tan(math.radians(30)) / TENTH
    left_x = (0.2 + 0.3 / math.tan(math.radians(30))) / TENTH
    corner = 1.5 / TENTH, 0.3 / TENTH
    assert found[0] == pytest.approx((corner[0], right_y, *corner), abs=3)
    assert found[1] == pytest.approx((*corner, left_x, corner[1]), abs=3)


def test_get_ls_returns_points_and_get_sg_segments_in_every_mode():
    for mode, width in ((33, 4), (1, 4), (51, 2), (19, 2)):
        driver = laser(CORNER, mode, 20, 20, 100, 4)
        assert len(readings(driver, "GET_LS")) == 100
        assert len(readings(driver, "GET_SG")) == 2
        assert len(readings(driver, "GS")[0]) == width
        assert driver.ask("GS")[LASER] == mode


def test_conf_sg_sets_how_points_become_segments():
    door = (
        '<wall x1="1.55m" y1="-5m" x2="1.55m" y2="-0.1m" thickness="0.1m"/>'
        '<wall x1="1.55m" y1="0.1m" x2="1.55m" y2="5m" thickness="0.1m"/>'
    )
    driver = laser(door, 33, 20, 20, 482, 4)
    assert driver.post("CONF_SG", 50, 4, 30)[0]["result"] == 1
    assert len(readings(driver, "GET_SG")) == 2  # the door is 10 cm wide, 39 tenths of an inch
    driver.post("CONF_SG", 50, 4, 60)
    assert len(readings(driver, "GET_SG")) == 1
    driver.post("CONF_SG", 50, 500, 60)
    assert readings(driver, "GET_SG") == []


def test_points_turn_with_turret():
    driver = laser(WALL)
    driver.ask("PR", 0, 0, -200)
    driver.run_s(10)
    # The wall is now seen at 20 degrees to the left: x cos 20 - y sin 20 is its distance.
    turn = math.radians(20)
    found = readings(driver)
    assert len(found) > 5
    for x, y in found:
        assert x * math.cos(turn) + y * math.sin(turn) == pytest.approx(2.0 / TENTH, abs=1)


@pytest.mark.parametrize("mode", [0, 50, 2])
def test_laser_that_is_off_returns_nothing(mode):
    driver = laser(WALL, mode)
    for name in ("GET_LS", "GET_SG", "GS"):
        assert readings(driver, name) == []
    assert driver.ask("GS")[LASER] == mode


@pytest.mark.parametrize("mode", [3, 5, 7, 35, 17, 49, 2**31 - 1, -1])
def test_pixel_modes_are_refused(mode):
    driver = laser(WALL)
    assert driver.post("CONF_LS", mode, 20, 20, 20, 4)[0]["result"] == 0
    assert driver.ask("GS")[LASER] == 51


def test_pages_contain_readings_of_last_reply():
    driver = laser(WALL)
    message, _ = driver.post("GS")
    first = pages(driver, int(message["i"][0]))
    driver.ask("VM", 100, 0)
    before = driver.post("GS")[0]
    told = pages(driver, int(before["i"][0]))
    driver.run_s(2)
    assert pages(driver, int(before["i"][0])) == told == first
    later = readings(driver)
    assert later[0][0] < first[0][0] - 50
    for page in (-1, 482, 2**31 - 1, -(2**31)):
        assert driver.post("LASER_PAGE", page)[0]["result"] == 0


def test_mask_excludes_laser_from_states_only():
    driver = laser(WALL)
    mask = bytes([0] + [1] * 41 + [0, 1])
    driver.ask("CT", data=mask)
    assert driver.post("GS")[0]["i"][0] == 0
    assert len(readings(driver, "GET_LS")) == 20


def test_rate_is_limited_to_30_hz():
    driver = Driver.of(open_world(NOMAD + WALL, timestep="10ms"))
    driver.ask("CONF_LS", 51, 20, 20, 20, 4)
    driver.ask("VM", 200, 0)
    driver.run_s(1)
    seen = []
    for _ in range(100):
        seen.append(readings(driver)[9][0])
        driver.run(1)
    assert 25 <= len(set(seen)) <= 31


def test_laser_sees_other_robots_only():
    other = '<robot x="1.2m" y="0"/>'
    driver = laser(other)
    found = readings(driver)
    nearest = min(x for x, _ in found)
    assert nearest == pytest.approx((1.2 - 8 * INCH) / TENTH, abs=1)


def test_snapshots_contain_reported_readings():
    driver = laser(WALL)
    count = int(driver.post("GS")[0]["i"][0])
    told, snapshot, before = pages(driver, count), driver.environment.snapshot(), driver.state
    driver.ask("VM", 100, 0)
    driver.run_s(3)
    readings(driver)
    driver.environment.restore(snapshot)
    assert pages(driver, count) == told
    assert driver.state is not before


def test_robots_with_and_without_lasers_in_one_batch():
    elements = f'<robot x="0" y="5m"/>{NOMAD}<robot x="0" y="-5m"/>'
    driver = Driver.of(open_world(elements + WALL))
    messages = np.zeros(3, MESSAGE)
    messages["i"][:, :5] = 51, 20, 20, 20, 4
    everybody = np.arange(3)
    driver.environment.serve(CODES["CONF_LS"], everybody, messages, np.zeros(3))
    assert messages["result"].tolist() == [0, 1, 0]
    driver.environment.serve(CODES["GS"], everybody, messages, np.zeros(3))
    assert messages["i"][:, 0].tolist() == [0, 20, 0]
    messages["i"][:, :2] = 0
    driver.environment.serve(CODES["LASER_PAGE"], everybody, messages, np.zeros(3))
    assert messages["result"].tolist() == [0, 20, 0]


def test_excess_segments_are_dropped(tmp_path):
    noisy = (EXACT, EXACT.replace('noise="0mm"', 'noise="200mm"'))
    elements = '<robot x="0" y="0"/>' + WALL
    driver = Driver.of(own_world(tmp_path, noisy, elements=elements, robot="nomad200"))
    driver.ask("CONF_LS", 33, 20, 20, 482, 1)
    driver.ask("CONF_SG", 0, 0, -1)
    assert len(readings(driver, "GET_SG")) == 241  # four numbers each, of the 964 in Laser


def test_large_errors_make_no_negative_range(tmp_path):
    """-1 is no object in range; at 2 m the deviation is 20 m here."""
    noisy = (EXACT, EXACT.replace('noise="0mm"', 'noise="5m"'))
    elements = '<robot x="0" y="0"/>' + WALL
    driver = Driver.of(own_world(tmp_path, noisy, elements=elements, robot="nomad200"))
    driver.ask("CONF_LS", 51, 20, 20, 60, 1)
    assert driver.post("LASER")[0]["i"][0] == 60
    page, _ = driver.post("READINGS", 3)
    ranges = page["data"][: 4 * 60].view("<i4")
    assert (ranges >= 0).all()
    assert (ranges == 0).any()


def test_inspector_shows_nearest_range_of_laser():
    driver, inspect = laser(WALL), device("laser").inspect
    assert inspect(driver.state, 0).startswith("nearest 1.80")
    driver.post("CONF_LS", 0)
    assert inspect(driver.state, 0) == "no reading"


def test_scout_has_no_laser():
    driver = Driver.of(world_of('<robot x="5m" y="5m"/>'))
    for name in ("GET_LS", "GET_SG", "CONF_LS", "CONF_SG", "LASER_PAGE"):
        assert driver.post(name, 51)[0]["result"] == 0
    assert driver.post("GS")[0]["i"][0] == 0


def test_noise_grows_with_square_of_distance_and_shrinks_by_averaging(tmp_path):
    noisy = (EXACT, EXACT.replace('noise="0mm"', 'noise="10mm"'))
    spread = {}
    for far_m, pixels in ((1.0, 1), (2.0, 1), (2.0, 16)):
        wall = WALL.replace("2.05m", f"{far_m + 0.25}m")
        elements = '<robot x="0" y="0"/>' + wall
        driver = Driver.of(own_world(tmp_path, noisy, elements=elements, robot="nomad200"))
        driver.ask("CONF_LS", 51, 20, 20, 482, pixels)
        points = np.array(readings(driver))
        middle = points[200:280]
        spread[far_m, pixels] = middle[:, 0].std() * TENTH
    assert spread[1.0, 1] == pytest.approx(0.01, rel=0.3)
    assert spread[2.0, 1] == pytest.approx(0.04, rel=0.3)
    assert spread[2.0, 16] == pytest.approx(0.01, rel=0.3)


# -- segments ----------------------------------------------------------------------------------


def test_noisy_points_on_line_are_one_segment():
    rng = np.random.default_rng(1)
    points = np.column_stack([np.linspace(0, 1000, 200), rng.normal(300, 3, 200)])
    found = segments(points, threshold=50, min_points=4, gap=30)
    assert len(found) == 1
    assert found[0] == pytest.approx([0, 300, 1000, 300], abs=5)


def test_box_corner_in_front_of_wall_gives_three_or_four_segments():
    left = np.column_stack([np.linspace(0, 100, 30), np.linspace(100, 0, 30)])
    right = np.column_stack([np.linspace(100, 200, 30)[1:], np.linspace(0, 100, 30)[1:]])
    wall = np.column_stack([np.full(40, 500.0), np.linspace(200, 400, 40)])
    found = segments(np.concatenate([left, right, wall]), threshold=5, min_points=4, gap=30)
    assert found.round().tolist() == [
        [0, 100, 100, 0], [100, 0, 200, 100], [500, 200, 500, 400],
    ]  # fmt: skip


@pytest.mark.parametrize("count", [0, 1, 2, 3])
def test_few_points_are_handled(count):
    points = np.zeros((count, 2))
    assert len(segments(points, 50, 4, 30)) == 0
    assert len(segments(points, 0, 0, 0)) == (count >= 2)


def test_cloud_of_482_points_takes_bounded_work():
    points = np.random.default_rng(2).uniform(-1000, 1000, (482, 2))
    assert len(segments(points, threshold=0, min_points=2, gap=1e9)) <= 481


@pytest.mark.parametrize(
    ("bad", "message"),
    [
        ('field-of-view="361deg" range="3m"', "must be 360deg or less"),
        ('field-of-view="60deg" range="0m"', "range: '0m' must be greater than 0"),
        ('field-of-view="60deg" range="3m" mode="3"', "mode"),
        ('field-of-view="60deg"', "range"),
    ],
)
def test_invalid_lasers_are_refused(tmp_path, bad, message):
    changes = (f'{EXACT}\n         mode="0"', bad)
    with pytest.raises(WorldError) as caught:
        own_world(tmp_path, changes, robot="nomad200")
    assert any(message in each.render() for each in caught.value.diagnostics)
