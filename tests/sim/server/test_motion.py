"""Paths against obstacles: by hand, against many small steps, and against a drive."""

import math

import numpy as np
import pytest

from tests.sim.driver import INCH, Driver, open_world

ELEMENTS = (
    '<robot x="0" y="0"/><box x="100in" y="0" length="40in" width="80in"/>'
    '<cylinder x="0" y="100in" radius="12in"/><robot x="-100in" y="0"/>'
    '<wall x1="-50in" y1="-100in" x2="50in" y2="-100in" thickness="10in"/>'
)
"""A robot of 8 in radius with an object at every side."""


def check(driver: Driver, kind: int, *numbers: float) -> tuple[float, float, float] | None:
    """Return x, y [in] and the direction of the normal [deg]; None where nothing is hit."""
    data = np.zeros(7)
    data[: len(numbers)] = numbers
    message, _ = driver.post("MOTION_CHECK", kind, data=data.tobytes())
    if not message["result"]:
        return None
    x, y, normal = message["f"][:3].tolist()
    return x / 10, y / 10, math.degrees(normal)


def straight(driver: Driver, *inches: float) -> tuple[float, float, float] | None:
    return check(driver, 0, *(10 * number for number in inches))


def arc(driver: Driver, turn, radius: float, centre, start=None):
    first, last = math.radians(turn[0]), math.radians(turn[1])
    if start is None:
        start = centre + radius * np.array([math.cos(first), math.sin(first)])
    inches = 10 * np.array([*start, radius, *centre])
    return check(driver, 1, *inches[:2], first, last, *inches[2:])


BY_HAND = {
    "a box ahead": ((0, 0, 200, 0), (72, 0, 0)),
    "a cylinder": ((0, 0, 0, 200), (0, 80, 90)),
    "another robot": ((0, 0, -150, 0), (-84, 0, 180)),
    "the long side of a wall": ((0, 0, 0, -150), (0, -87, -90)),
    "a path that ends before": ((0, 0, 71, 0), None),
    "a path that ends in contact": ((0, 0, 72, 0), None),
    "the corner of a box": (
        (0, 44.8, 200, 44.8),
        (80 - 6.4, 44.8, math.degrees(math.atan2(-4.8, 6.4))),
    ),
    "past the corner of a box": ((0, 48.01, 200, 48.01), None),
    "a cylinder from aside": ((-100, 112, 100, 112), (-16, 112, math.degrees(math.atan2(-12, 16)))),
    "the round end of a wall": (
        (200, -99, 60, -99),
        (50 + math.sqrt(13**2 - 1), -99, 180 + math.degrees(math.asin(1 / 13)) - 360),
    ),
    "from far away": ((5000, 0, 0, 0), (128, 0, 180)),
    "no path": ((0, 0, 0, 0), None),
    "away from what it touches": ((72, 0, 0, 0), None),
    "along what it touches": ((72, -30, 72, 30), None),
    "into what it touches": ((72, 0, 90, 0), (72, 0, 0)),
    "out of what it is deep in": ((75, 0, 0, 0), None),
    "further into what it is in": ((75, 0, 90, 0), (75, 0, 0)),
}


@pytest.mark.parametrize("name", BY_HAND)
def test_straight_paths_by_hand(name):
    path, expected = BY_HAND[name]
    found = straight(Driver.of(open_world(ELEMENTS)), *path)
    assert found == (None if expected is None else pytest.approx(expected, abs=1e-6))


def test_arcs_by_hand():
    driver = Driver.of(open_world(ELEMENTS))
    # A half circle from the origin around 0, 40: its right-most point is 40 away from the axis.
    assert arc(driver, (-90, 90), 32, (0, 32)) is None
    # Around 0, 46 the robot comes up to the cylinder from below: their middles are 20 apart where
    # 46 + 46 cos t is the height and 46 sin t the way aside, seen from the top.
    found = arc(driver, (-90, 90), 46, (0, 46))
    assert math.hypot(found[0], found[1] - 100) == pytest.approx(20)
    assert math.hypot(found[0], found[1] - 46) == pytest.approx(46)
    assert found[0] > 0
    # To the right, and backwards from the second end, the same on the other side.
    other = arc(driver, (-90, -270), 46, (0, 46))
    assert other[:2] == pytest.approx((-found[0], found[1]))
    assert arc(driver, (90, 270), 46, (0, 46), start=(0, 0)) == pytest.approx(other)
    # More than a turn is a turn.
    assert arc(driver, (-90, 1e5), 46, (0, 46)) == pytest.approx(found)
    assert arc(driver, (-90, 1e5), 32, (0, 32)) is None


@pytest.mark.parametrize("seed", range(6))
def test_random_paths_end_where_small_steps_first_come_too_near(seed):
    rng = np.random.default_rng(seed)
    polygon = " ".join(
        f"{x}in,{y}in" for x, y in [(-40, -60), (60, -40), (20, 0), (70, 60), (-30, 30)]
    )
    driver = Driver.of(open_world(
        f'<polygon points="{polygon}"/><cylinder x="130in" y="30in" radius="20in"/>'
        '<wall x1="-120in" y1="50in" x2="-20in" y2="120in" thickness="6in"/>'
        '<box x="-90in" y="-50in" heading="30" length="40in" width="20in"/>'
        '<robot x="500in" y="500in"/>'
    ))  # fmt: skip
    hits = 0
    for _ in range(25):
        if rng.integers(2):
            ends = rng.uniform(-200, 200, 4)
            found = straight(driver, *ends)
            share = np.linspace(0, 1, 4001)[:, None]
            places = ends[:2] + share * (ends[2:] - ends[:2])
        else:
            begin, end, radius = rng.uniform(-300, 300), rng.uniform(-300, 300), rng.uniform(5, 150)
            x, y = rng.uniform(-150, 150, 2)
            found = arc(driver, (begin, end), radius, (x, y))
            angles = np.radians(np.linspace(begin, begin + np.clip(end - begin, -360, 360), 4001))
            places = np.column_stack([x + radius * np.cos(angles), y + radius * np.sin(angles)])
        rooms = room_in(driver, places)
        if rooms[0] <= 0:
            continue
        first = next((n for n, room in enumerate(rooms) if room < -0.001), None)
        assert (found is None) == (first is None)
        if found is not None:
            hits += 1
            assert math.dist(found[:2], places[first]) < 2 * math.dist(places[0], places[1]) + 0.7
            assert room_in(driver, np.array([found[:2]]))[0] == pytest.approx(0, abs=1e-6)
            touched = np.array(found[:2]) + 8 * np.array(
                [math.cos(math.radians(found[2])), math.sin(math.radians(found[2]))]
            )
            assert room_in(driver, touched[None])[0] == pytest.approx(-8, abs=1e-6)
    assert hits > 3


def room_in(driver: Driver, places: np.ndarray) -> np.ndarray:
    """Return how far a robot at places is from the next solid [in]."""
    from crs_cc.sim.geometry.placement import distance_from_m

    solids = driver.environment.world_now.solids()
    x_m, y_m = (places * INCH).T
    return np.min([distance_from_m(solid, x_m, y_m) for solid in solids], axis=0) / INCH - 8


def test_a_robot_is_stopped_where_the_check_says():
    driver = Driver.of(open_world(ELEMENTS.replace('y="0"/>', 'y="0" heading="14"/>', 1)))
    way = 200 * math.cos(math.radians(14)), 200 * math.sin(math.radians(14))
    x, y, normal = straight(driver, 0, 0, *way)
    driver.ask("VM", 200, 200)
    contact = next(step.contacts for step in driver.run_s(10) if len(step.contacts.robot))
    at = contact.x_m[0] / INCH, contact.y_m[0] / INCH
    touched = x + 8 * math.cos(math.radians(normal)), y + 8 * math.sin(math.radians(normal))
    assert at == pytest.approx(touched, abs=0.2)
    assert driver.state.x_m[0] == pytest.approx(x * INCH, abs=0.001)


NONSENSE = [
    (2, [0, 0, 1000, 0]),
    (-1, [0, 0, 1000, 0]),
    (0, [math.nan, 0, 1000, 0]),
    (0, [0, math.inf, 1000, 0]),
    (0, [0, 0, 1e300, 0]),
    (1, [0, 0, 0, 1, 0, 0, 0]),
    (1, [0, 0, 0, 1, -500, 0, 0]),
    (1, [0, 0, 1, 1, 500, 0, 0]),
    (1, [0, 0, -1e9, 1e9, 1e300, 0, 0]),
]


@pytest.mark.parametrize(("kind", "numbers"), NONSENSE)
def test_what_is_no_path_meets_nothing(kind, numbers):
    assert check(Driver.of(open_world(ELEMENTS)), kind, *numbers) is None


def test_obstacles_that_programs_add_are_met():
    driver = Driver.of(open_world())
    assert straight(driver, 0, 0, 100, 0) is None
    corners = np.array([(300, -50), (400, 0), (300, 50)], "<i4").tobytes()
    driver.post("ADD_OBSTACLE", 3, data=corners)
    assert straight(driver, 0, 0, 100, 0) == pytest.approx((22, 0, 0))
