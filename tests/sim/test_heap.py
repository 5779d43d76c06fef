"""Fifty robots push fifty boxes into a heap, partly on slopes: snapshots continue bitwise equal.

r b r b ...      every other place of a grid of 10 by 10 has a robot; all drive towards the
b r b r ...      middle, where a plateau stands with a ramp on each of two sides; on the ramp
...              in the corner boxes slide
"""

import math
import pickle
import subprocess

import pytest

from crs_cc.sim.engine.environment import Environment
from tests.commands import python
from tests.sim.driver import Driver, world_of

SPACING_M = 0.6
LAST = 130  # cycles
SAVED = {61: 85, 99: LAST, 100: 115, 118: LAST}
"""Cycles before which a snapshot is taken, and those up to which it is continued."""
SURFACE = (
    "<surface>"
    '<plateau x="3.5m" y="3.5m" length="1m" width="1m" height="20cm"/>'
    '<ramp x="2.25m" y="3.5m" length="1.5m" width="1m" to="20cm"/>'
    '<ramp x="3.5m" y="4.6m" heading="270" length="1.2m" width="1m" to="20cm"/>'
    '<ramp x="1.5m" y="1.2m" heading="200deg" length="1.6m" width="2m" to="80cm"/>'
    "</surface>"
)


def heap():
    """Return the world."""
    elements = []
    for number in range(100):
        row, column = divmod(number, 10)
        x_m, y_m = 0.8 + SPACING_M * column, 0.8 + SPACING_M * row
        if (row + column) % 2:
            size = f'length="{25 + number % 7 * 3}cm" width="30cm" heading="{number * 11 % 90}"'
            elements.append(f'<box x="{x_m}" y="{y_m}" {size} mass="{2 + number % 5}kg"/>')
        else:
            heading = math.degrees(math.atan2(3.5 - y_m, 3.5 - x_m))
            elements.append(f'<robot x="{x_m}" y="{y_m}" heading="{heading:.3f}"/>')
    return world_of(SURFACE + "".join(elements), 'length="7m" width="7m"')


@pytest.fixture(scope="module")
def driven():
    """Return the heap at the end, snapshots before it, and hashes by cycle."""
    driver, snapshots, hashes = Driver.of(heap()), {}, {}
    for cycle in range(LAST):
        if cycle in SAVED:
            snapshots[cycle] = driver.environment.snapshot()
        drive_on(driver)
        hashes[cycle + 1] = driver.environment.hash()
    return driver, snapshots, hashes


def drive_on(driver: Driver) -> None:
    """Run a cycle; at intervals each robot gets a new command."""
    cycle = driver.state.cycle
    for robot in range(50 if cycle % 40 == 0 else 0):
        if (robot + cycle) % 7 == 0:
            driver.ask("LP", robot=robot)
        else:
            driver.ask("VM", 250 + robot, 260 - robot, robot=robot)
    driver.run(1)


def finish(environment: Environment, last: int = LAST) -> str:
    """Continue as the first run did, up to a cycle; return the hash."""
    driver = Driver(environment)
    while driver.state.cycle < last:
        drive_on(driver)
    return environment.hash()


def test_objects_form_a_heap(driven):
    driver, *_ = driven
    assert len(driver.environment.world.robots) == 50
    touching = {int(key) for step in driver.steps for key in step.contacts.robot}
    assert len(touching) > 45
    assert len(driver.state.contacts_before) > 40
    heights_m = driver.environment._data.constants.inclines.terrain.height_m(
        *driver.state.bodies.position_m.T
    )
    assert (heights_m > 0.01).sum() > 5


def test_run_from_every_snapshot_is_bitwise_equal(driven):
    driver, snapshots, hashes = driven
    fresh = Environment(driver.environment.world, seed=1)
    for cycle in reversed(SAVED):
        fresh.restore(snapshots[cycle])
        assert finish(fresh, SAVED[cycle]) == hashes[SAVED[cycle]]


def test_run_from_snapshot_in_another_process_is_bitwise_equal(driven, tmp_path):
    driver, snapshots, _ = driven
    (tmp_path / "heap").write_bytes(pickle.dumps((driver.environment.world, snapshots[max(SAVED)])))
    program = (
        "import pickle, sys; from pathlib import Path; from tests.sim.test_heap import *;"
        "world, snapshot = pickle.loads(Path(sys.argv[1]).read_bytes());"
        "environment = Environment(world, seed=1); environment.restore(snapshot);"
        "print(finish(environment))"
    )
    command = python("-c", program, tmp_path / "heap")
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == driver.environment.hash()
