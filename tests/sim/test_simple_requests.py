"""What kernels answer in one call is what the handlers answer."""

from __future__ import annotations

import random
from pathlib import Path
from unittest.mock import patch

import numpy as np
import pytest

from crs_cc.requests import CODES, MESSAGE
from crs_cc.sim.engine import dispatch
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.engine.simple_requests import answer_simple_requests
from crs_cc.sim.kernels.program import Kernels
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state import robot_rows
from crs_cc.sim.state.mask import NUM_MASK
from tests.sim.driver import own_world, world_of

LASER = (
    '<laser points="482" field-of-view="60deg" range="3m" forward="0.2m" rate="30Hz" noise="0mm"'
    '\n         mode="0"/>'
)

WORLDS = {
    "walls and a push": """
        <robot x="1m" y="1m"/><robot x="1.5m" y="1m" heading="90deg"/><robot x="9.7m" y="5m"/>
        <robot x="5m" y="5m"/><box x="2.5m" y="1m" length="40cm" width="40cm" mass="1kg"/>""",
    "failing wheels": """
        <robot x="1m" y="1m"/><robot x="5m" y="5m"/>
        <degradation robot="robot0" device="drive" noise="2in/s"/>""",
    "failing sensors": """
        <robot x="1m" y="1m"/><robot x="5m" y="5m"/>
        <degradation robot="robot0" device="sonar" noise="2in"/>
        <degradation robot="robot1" device="battery" noise="1V"/>""",
    "other robots": """
        <robot definition="nomad200" x="1m" y="1m"/><robot x="8m" y="8m"/>
        <robot definition="pioneer2dx" x="5m" y="5m"/>""",
}
ASKED = (
    "VM",
    "VM",
    "GS",
    "GET_SN",
    "GET_BP",
    "GET_RC",
    "GET_RV",
    "TK",
    "LP",
    "CONF_TM",
    "ST",
    "PR",
)


def posted(
    dice: random.Random, robots: int, asked: tuple[str, ...]
) -> list[tuple[int, np.ndarray, np.ndarray, np.ndarray]]:
    """Return requests of a cycle: codes, robots, messages, and times in it as shares."""
    found = []
    for _ in range(dice.randrange(4)):
        rows = np.array(sorted(dice.sample(range(robots), dice.randint(1, robots))))
        messages = np.zeros(len(rows), MESSAGE)
        name = dice.choice(asked)
        most = 2 if name == "CONF_TM" else 400
        messages["i"][:, :3] = [[dice.randint(-most, most) for _ in range(3)] for _ in rows]
        if name == "CT":
            messages["size"] = NUM_MASK
            messages["data"][:, 1:NUM_MASK] = np.array([[dice.randint(0, 1)] for _ in rows])
        share = np.array([dice.random() * 1.1 for _ in rows])
        found.append((CODES[name], rows, messages, share))
    if dice.random() < 0.03:
        rows = np.array([dice.randrange(robots)])
        name = dice.choice(["DISCONNECT", "CONNECT"])
        found.append((CODES[name], rows, np.zeros(1, MESSAGE), np.zeros(1)))
    return found


def outcome(world: WorldModel, seed: int, asked: tuple[str, ...] = ASKED) -> list[object]:
    """Return all replies, and hashes, of a random run."""
    environment, dice = Environment(world, seed), random.Random(seed)
    robots, told = len(environment.world.robots), list[object]()
    everybody = np.arange(robots)
    environment.serve(CODES["CONNECT"], everybody, np.zeros(robots, MESSAGE), np.zeros(robots))
    for _ in range(120):
        for code, rows, messages, share in posted(dice, robots, asked):
            at_s = environment.time_s + share * environment.timestep_s
            goes_on_s = environment.serve(code, rows, messages, at_s)
            told.append((code, messages.tobytes(), goes_on_s.tolist()))
        step = environment.step()
        told += [
            (each.code, each.robots.tolist(), each.clock_s.tolist(), each.arguments.tolist(),
             each.results.tolist(), None if each.states is None else each.states.tolist())
            for each in step.served
        ]  # fmt: skip
        told.append(environment.hash())
    return told


@pytest.mark.parametrize("name", WORLDS)
@pytest.mark.parametrize("seed", range(3))
def test_replies_and_states_are_those_of_the_handlers(name: str, seed: int) -> None:
    shares = compare(world_of(WORLDS[name]), seed)
    assert any(shares) == (name == "walls and a push")
    assert not all(shares)


@pytest.mark.parametrize("timer", ["", 'period="0.2s"'])
def test_instruments_measure_for_replies_of_kernels(timer: str, tmp_path: Path) -> None:
    ring = 'half-angle="5deg" reflectance="1" rate="20Hz" noise="0in"'
    compass = 'calibration="180s" rate="10Hz" noise="0deg" on="no"'
    world = own_world(
        tmp_path, (LASER, ""), (ring, f'{ring.replace("0in", "2in")} history="3" {timer}'),
        (compass, compass.replace("0deg", "3deg").replace('"no"', '"yes"')),
        elements='''<robot x="1m" y="1m"/><robot x="1.6m" y="1m" heading="90deg"/>
        <degradation robot="robot0" device="infrared" bias="2in" onset="2s"/>
        <box x="2.5m" y="1m" length="40cm" width="40cm" mass="1kg"/>''', robot="nomad200",
    )  # fmt: skip
    shares = compare(world, 4, (*ASKED, "GET_IR", "GET_IR", "GET_CP", "CONF_IR", "CT"))
    assert 0.4 < np.mean(shares) < 1.0


def compare(world: WorldModel, seed: int, asked: tuple[str, ...] = ASKED) -> list[bool]:
    """Compare what kernels and handlers answer; return which requests kernels have answered.

    All seeds are run by kernels that check their accesses, even ones by those of users, too.
    """
    simply: list[bool] = []

    def counted(*arguments: object) -> object:
        found = answer_simple_requests(*arguments)  # type: ignore[arg-type]
        simply.append(found is not None)
        return found

    with patch.object(dispatch, "answer_simple_requests", lambda *_: None):
        told = outcome(world, seed, asked)
    checked = Kernels(holds_world=True, checked=True)
    with (
        patch.object(robot_rows, "Kernels", lambda **_: checked),
        patch.object(dispatch, "answer_simple_requests", counted),
    ):
        assert outcome(world, seed, asked) == told
    if seed % 2 == 0:
        assert outcome(world, seed, asked) == told
    return simply
