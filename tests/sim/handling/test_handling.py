"""Random requests to grippers, arms, lamps and speakers are safe, and replay."""

import numpy as np
import pytest

from crs_cc.requests import CODES, MESSAGE
from tests.sim.gripping import GRIPPER, gripping, kinds

DEVICES = (
    GRIPPER,
    '<arm upper="20cm" fore="15cm" shoulder-speed="9rad/s" hand="9cm" max-mass="9kg"/>',
    '<light-sensors number="32" noise="0.1"/>', "<microphones/>", "<lamp/>", "<speaker/>",
)  # fmt: skip
ELEMENTS = (
    '<robot x="-53cm" y="0"/><robot x="53cm" y="0" heading="180"/><robot x="0" y="60cm"/>'
    '<box x="0" y="0" length="60cm" width="5cm" mass="2kg"/>'
    '<cylinder x="33cm" y="60cm" radius="4cm" mass="1kg"/><light x="0" y="0"/><sound x="1m" y="0"/>'
    '<polygon points="60cm,40cm 70cm,40cm 65cm,50cm" mass="1kg"/>'
)
AREA = 'length="2.4m" width="2m" origin="centre"'
NAMES = (
    "GRIPPER", "GET_GRIPPER", "ARM", "GET_ARM", "HAND", "LIGHT", "SOUND", "GET_LIGHT",
    "GET_SOUND", "TAKE_HEAT", "VM", "PR", "PLACE_ROBOT", "LP", "ST",
)  # fmt: skip
EDGES = np.array([-(2**31), -1, 0, 1, 2, 7, 8, 900, 2**31 - 1])


def ask_at_random(driver, random) -> None:
    """Post one request of some robots, with half of its arguments in the usual range."""
    code = CODES[NAMES[random.integers(len(NAMES))]]
    rows = np.flatnonzero(random.random(3) < 0.7)
    messages = np.zeros(len(rows), MESSAGE)
    messages["i"] = random.integers(-400, 400, messages["i"].shape)
    messages["i"][:, 0] = random.choice([0, 1, 100, 300], len(rows))
    if random.random() < 0.3:
        messages["i"] = random.choice(EDGES, messages["i"].shape)
        messages["data"] = random.integers(0, 256, messages["data"].shape)
    if len(rows):
        at_s = np.full(len(rows), driver.environment.time_s)
        driver.environment.serve(code, rows, messages, at_s)


def churn(driver, seed, cycles) -> None:
    """Run cycles with many requests."""
    random = np.random.default_rng(seed)
    for _ in range(cycles):
        for _ in range(3):
            ask_at_random(driver, random)
        driver.run(1)
        bodies = driver.state.bodies
        assert np.isfinite(bodies.position_m).all()
        assert np.abs(bodies.position_m).max() < 1.3


@pytest.mark.parametrize("seed", range(3))
def test_random_requests_are_safe_and_replay_to_the_same_bits(tmp_path, seed):
    driver = gripping(tmp_path, ELEMENTS, AREA, *DEVICES)
    for robot in range(3):
        driver.post("GRIPPER", 1, robot=robot)
    assert "grip" in kinds(driver.run(25))
    churn(driver, seed, 25)
    snapshot, hashes = driver.environment.snapshot(), []
    for _ in range(2):
        driver.environment.restore(snapshot)
        churn(driver, seed + 100, 12)
        hashes.append(driver.environment.hash())
    assert hashes[0] == hashes[1]
