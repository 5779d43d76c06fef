"""Pheromone fields: what robots deposit, how it evaporates and diffuses, and that runs repeat."""

from __future__ import annotations

import math
import pickle
from collections.abc import Callable
from dataclasses import replace
from decimal import Decimal, getcontext
from pathlib import Path

import numpy as np
import pytest

from crs_cc.api.session import Session
from crs_cc.debug.errors import DebugError
from crs_cc.debug.world.edits import edit
from crs_cc.requests import CODES, MESSAGE
from crs_cc.sim.devices.antennae import Antennae
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import load_world, parse_world
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.world import Pose, WorldModel
from tests.device.robot import scout_with
from tests.sim.driver import Driver

DT_S = 0.05
UNIT = 2.0**-16
MakeWorld = Callable[..., WorldModel]
PLAIN = '<field name="trail" cell="10cm"/>'


@pytest.fixture
def world(tmp_path) -> MakeWorld:
    """Return a function that returns a world of Scouts with a gland and antennae."""
    robot = scout_with(tmp_path, '<gland most="100000"/>', "<antennae/>")

    def make(fields: str = PLAIN, robots: str = '<robot x="2m" y="2m"/>') -> WorldModel:
        area = '<area length="6m" width="4m"/>'
        text = f'<world version="1">{area}{fields}{robots}</world>'
        return parse_world(text.encode(), "test", "", robot)

    return make


def post(driver: Driver, name: str, amount: float = 0.0, *, field: int = 0, robot: int = 0):
    """Post a request with an amount; return the reply."""
    message = np.zeros(1, MESSAGE)
    message["i"][0, 0], message["f"][0, 0] = field, amount
    at_s = np.array([driver.environment.time_s])
    driver.environment.serve(CODES[name], np.array([robot]), message, at_s)
    return message[0]


def amounts(environment: Environment, field: str = "trail") -> np.ndarray:
    """Return the amounts that are not 0."""
    found = environment.field(field)
    return found[found > 0.0]


def test_deposit_lies_in_the_cell_under_the_robot_from_the_next_timestep_on(world):
    driver = Driver.of(world(robots='<robot x="2.34m" y="1.07m"/>'))
    assert post(driver, "DEPOSIT", 12.5)["result"] == 1
    assert not amounts(driver.environment).size
    driver.run(1)
    found = driver.environment.field("trail")
    assert found.shape == (40, 60)
    assert found[10, 23] == found.sum() == 12.5


def test_evaporation_is_that_of_decimal_arithmetic_over_many_bases(world):
    """The base changes each 40 timesteps; that rounds to half a unit, and so do deposits."""
    driver = Driver.of(world('<field name="trail" cell="10cm" evaporation="0.5s"/>'))
    getcontext().prec = 40
    exact, left = Decimal(0), (-Decimal("0.05") / Decimal("0.5")).exp()
    random = np.random.default_rng(5)
    for step in range(333):
        exact *= left
        if step % 3 == 0:
            amount = float(random.uniform(0, 100))
            post(driver, "DEPOSIT", amount)
            exact += Decimal(amount)
        driver.run(1)
        (found,) = amounts(driver.environment)
        assert abs(Decimal(float(found)) - exact) < 3 * Decimal(UNIT)


def test_what_has_evaporated_takes_no_memory(world):
    driver = Driver.of(world('<field name="trail" cell="10cm" evaporation="100ms"/>'))
    post(driver, "DEPOSIT", 1000.0)
    driver.run(1)
    assert driver.state.fields.used == 2
    driver.run(60)
    assert not amounts(driver.environment).size
    assert (driver.state.fields.used, driver.state.fields.amount.nbytes) == (1, 512)


def test_cells_hold_no_more_than_the_saturation(world):
    robots = '<robot x="2m" y="2m"/><robot x="3m" y="2m"/>'
    driver = Driver.of(world('<field name="a" saturation="5" cell="6m"/>', robots))
    for amount in (3.0, 1.0, 4.0):
        for robot in (0, 1):
            post(driver, "DEPOSIT", amount, robot=robot)
    driver.run(1)
    assert amounts(driver.environment, "a").tolist() == [5.0]


def test_invalid_amounts_and_fields_are_refused(world):
    driver = Driver.of(world())
    for name in ("DEPOSIT", "LAY_TRAIL"):
        for amount, field in ((-1.0, 0), (np.nan, 0), (1.0, 1), (1.0, -1)):
            assert post(driver, name, amount, field=field)["result"] == 0
        assert post(driver, name, np.inf)["result"] == 1  # as much as the gland gives


def test_one_timestep_of_diffusion_moves_a_quarter_of_the_difference_to_each_neighbour(world):
    """0.05 m2/s * 0.05 s / (0.1 m)^2 = 1/4, the limit of stability."""
    field = '<field name="trail" cell="10cm" diffusion="0.05m2/s"/>'
    driver = Driver.of(world(field, '<robot x="0.85m" y="2m"/>'))  # a corner of a tile
    post(driver, "DEPOSIT", 64.0)
    driver.run(1)
    found = driver.environment.field("trail")
    assert (found[20, 8], found[20, 7], found[20, 9], found[19, 8], found[21, 8]) == (0, *[16] * 4)
    driver.run(1)
    found = driver.environment.field("trail")
    assert (found[20, 8], found[20, 6], found[19, 7], found.sum()) == (16, 4, 8, 64)


def test_diffusion_is_that_of_a_plain_loop_and_loses_nothing(world):
    """In the corner of the area, across tiles, against integers in one array."""
    field = '<field name="trail" cell="13cm" diffusion="700cm2/s"/>'
    driver = Driver.of(world(field, '<robot x="5.7m" y="3.7m"/>'))
    post(driver, "DEPOSIT", 98765.4)
    plain = np.zeros((31, 47), dtype=np.int64)
    plain[28, 43] = round(98765.4 / UNIT)
    share = 0.07 * DT_S / (0.13 * 0.13)
    for _ in range(25):
        along = (np.diff(plain, axis=1) * -share).astype(np.int64)
        across = (np.diff(plain, axis=0) * -share).astype(np.int64)
        plain[:, :-1] -= along
        plain[:, 1:] += along
        plain[:-1] -= across
        plain[1:] += across
    driver.run(25)
    found = driver.environment.field("trail") / UNIT
    assert (found == plain).all()
    assert found.sum() == round(98765.4 / UNIT)
    assert (found > 0).sum() > 300


def test_trail_is_laid_by_the_metre_and_not_while_standing(world):
    """10 per metre over 1 m from x = 2 m: in cells of 10 cm, 1 in each."""
    driver = Driver.of(world())
    post(driver, "LAY_TRAIL", 10.0)
    driver.run(5)
    assert not amounts(driver.environment).size
    driver.ask("PR", 394, 394)  # 39.4 in: 1.00076 m
    driver.run_s(5)
    found = driver.environment.field("trail")[20]
    assert found.sum() == pytest.approx(10 * float(driver.state.distance_m[0]), abs=0.01)
    assert found[21:29] == pytest.approx(1.0, abs=0.15)
    assert not found[:20].any()
    assert not found[31:].any()


def test_carried_robot_leaves_no_trail_between(world):
    driver = Driver.of(world())
    post(driver, "LAY_TRAIL", 10.0)
    driver.ask("PR", 100, 100)
    driver.run(6)
    driver.environment.teleport("robot0", Pose(4.0, 1.0, 0.0))
    driver.run_s(2)
    found = driver.environment.field("trail")
    assert not found[:, 24:40].any()
    assert found.sum() == pytest.approx(2.54, abs=0.01)


def test_new_evaporation_time_keeps_what_lies_there(world):
    driver = Driver.of(world('<field name="trail" cell="10cm" evaporation="2s"/>'))
    post(driver, "DEPOSIT", 100.0)
    driver.run(31)
    (before,) = amounts(driver.environment)
    driver.environment.set_evaporation("trail", 0.5)
    assert amounts(driver.environment)[0] == pytest.approx(before, abs=2 * UNIT)
    driver.run(10)
    assert amounts(driver.environment)[0] == pytest.approx(before * np.exp(-1.0), abs=4 * UNIT)


def test_evaporation_time_is_changed_by_a_command(world):
    environment = Driver.of(world()).environment
    assert edit(environment, "evaporate trail 500ms") == "field trail now evaporates in 500ms"
    assert environment.state.fields.evaporation_s.tolist() == [0.5]
    edit(environment, "evaporate trail never")
    assert environment.state.fields.evaporation_s.tolist() == [np.inf]
    for text in ("evaporate trail 50ms", "evaporate scent 1s", "evaporate trail"):
        with pytest.raises(DebugError):
            edit(environment, text)


def swarm() -> str:
    places = ((1 + n % 6 * 0.7, 1 + n // 6) for n in range(12))
    return "".join(f'<robot id="r{n}" x="{x}m" y="{y}m"/>' for n, (x, y) in enumerate(places))


def roam(environment: Environment, cycles: int) -> None:
    """Drive, lay trails, deposit and smell, each robot by its name."""
    driver = Driver(environment)
    for _ in range(cycles):
        for robot, one in enumerate(environment.world.robots):
            number = int(one.id[1:])
            if environment.cycle % 20 == number:
                driver.ask("VM", 60 - 10 * number, 40, robot=robot)
                post(driver, "LAY_TRAIL", 3.7 * number, field=number % 2, robot=robot)
            if environment.cycle % 7 == number % 7:
                post(driver, "DEPOSIT", 0.1 * number, field=number % 2, robot=robot)
        environment.step()


FIELDS = (
    '<field name="trail" cell="5cm" evaporation="1s" saturation="4"/>'
    '<field name="scent" cell="20cm" evaporation="3s" diffusion="50cm2/s"/>'
)


def test_fields_do_not_depend_on_the_order_of_robots(world):
    first = world(FIELDS, swarm())
    second = replace(first, robots=first.robots[::-1])
    one, other = Environment(first, 1), Environment(second, 1)
    for environment in (one, other):
        for robot in range(12):
            Driver(environment).ask("CONNECT", robot=robot)
        roam(environment, 60)
    assert amounts(one).size > 15
    for name in ("trail", "scent"):
        assert (one.field(name) == other.field(name)).all()


def test_a_run_goes_on_from_a_snapshot_in_another_environment(world):
    """The snapshot is taken within a timestep, with deposits that are not added yet."""
    driver = Driver.of(world(FIELDS, swarm()))
    environment = driver.environment
    roam(environment, 50)
    post(driver, "DEPOSIT", 7.0)
    snapshot = pickle.loads(pickle.dumps(environment.snapshot()))
    roam(environment, 50)
    fresh = Environment(environment.world, 1)
    fresh.restore(snapshot)
    roam(fresh, 50)
    assert fresh.hash() == environment.hash()
    environment.restore(snapshot)
    roam(environment, 50)
    assert fresh.hash() == environment.hash()


def test_quiet_time_is_skipped_with_the_same_fields(world):
    """Evaporation and diffusion go on while nothing moves."""
    hashes = []
    for skips in (True, False):
        driver = Driver.of(world(FIELDS))
        environment = driver.environment
        post(driver, "DEPOSIT", 50.0)
        post(driver, "DEPOSIT", 50.0, field=1)
        driver.run(5)
        assert environment.quiet_until() > 1000
        if skips:
            environment.skip(400)
        else:
            driver.run(400)
        driver.run(1)
        hashes.append(environment.hash())
        assert not amounts(environment).size
        assert amounts(environment, "scent").size
    assert hashes[0] == hashes[1]


def test_fields_are_read_and_changed_from_python(world):
    session = Session(world(FIELDS))
    post(Driver(session.inner.environment), "DEPOSIT", 2.0)
    session.step()
    assert session.field("trail").sum() == pytest.approx(2.0, abs=UNIT)
    session.set_evaporation("trail", 100.0)
    session.step(20)
    assert session.field("trail").sum() == pytest.approx(2.0 * np.exp(-0.01), abs=4 * UNIT)
    with pytest.raises(ValueError, match=r"unknown field 'smell' \(known: trail, scent\)"):
        session.field("smell")
    with pytest.raises(ValueError, match="invalid evaporation time 0 "):
        session.set_evaporation("trail", 0)


@pytest.mark.parametrize("most", [1, 7, 60, 1000])
def test_a_sketch_has_the_largest_amount_of_each_square(world, most: int):
    robots = '<robot x="2m" y="2m"/><robot x="5.7m" y="3.7m"/><robot x="2.6m" y="2.1m"/>'
    driver = Driver.of(world(robots=robots))
    for robot, amount in enumerate((3.0, 2.0, 5.0)):
        post(driver, "DEPOSIT", amount, robot=robot)
    driver.run(2)
    whole = driver.environment.field("trail")
    sketch, side_m = driver.environment.field_sketch("trail", most)
    cells = round(side_m / 0.1)
    assert cells == -(-60 // most)
    assert sketch.shape == (-(-40 // cells), -(-60 // cells))
    for row, column in np.ndindex(sketch.shape):
        square = whole[row * cells : (row + 1) * cells, column * cells : (column + 1) * cells]
        assert sketch[row, column] == square.max()


def test_a_sketch_is_that_of_now_though_quiet_time_was_skipped(world):
    """Fields have another base each 40 timesteps, which are not executed here."""
    driver = Driver.of(world('<field name="trail" cell="10cm" evaporation="0.5s"/>'))
    post(driver, "DEPOSIT", 100.0)
    driver.run(2)
    environment = driver.environment
    assert environment.is_quiet
    environment.skip(60)
    expected = 100.0 * np.exp(-61 * DT_S / 0.5)
    assert environment.field_sketch("trail", 60)[0].max() == pytest.approx(expected, abs=2 * UNIT)


def test_robots_with_different_antennae_smell_at_their_own_ends(tmp_path):
    kinds = ({"number": 3, "reach_m": 0.4}, {"number": 2, "reach_m": 0.25}, {"number": 1})
    antennae = [Antennae(**each) for each in kinds]
    robots = ""
    for number, each in enumerate(antennae):
        own = f'<antennae number="{each.number}" reach="{each.reach_m}m"/>'
        file = Path(scout_with(tmp_path, "<gland/>", own))
        file.rename(tmp_path / f"scout{number}.xml")
        robots += (
            f'<robot definition="scout{number}.xml" x="{1 + 2 * number}m" y="2m"'
            f' heading="{50 * number}deg"/>'
        )
    field = '<field name="trail" cell="10cm" diffusion="0.04"/>'
    text = f'<world version="1"><area length="6m" width="4m"/>{field}{robots}</world>'
    (tmp_path / "world.xml").write_text(text)
    driver = Driver.of(load_world(tmp_path / "world.xml"))
    for robot in range(3):
        post(driver, "DEPOSIT", 1000.0, robot=robot)
    driver.run(60)
    found = driver.environment.field("trail")
    for robot, each in enumerate(antennae):
        ahead = exact.turn(math.radians(50 * robot))
        for antenna, (x_m, y_m) in enumerate(each.ends_m()):
            end = complex(1 + 2 * robot, 2) + ahead * complex(x_m, y_m)
            expected = found[int(end.imag / 0.1), int(end.real / 0.1)]
            reply, _ = driver.post("SMELL", 0, antenna, robot=robot)
            assert reply["f"][0] == pytest.approx(expected, rel=1e-12)
            assert expected > 0.0
        assert driver.post("SMELL", 0, each.number, robot=robot)[0]["result"] == 0
