"""Whatever is wrong, with whatever values: nothing breaks, and all numbers stay numbers."""

import dataclasses

import numpy as np
import pytest

from crs_cc.requests import CODES, MESSAGE, REQUESTS
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.model.degradation import Degradation, degradables, validation_error
from crs_cc.sim.model.world import Robot
from tests.sim.degradation.law import world_with

NUMBERS = (0.0, 1.0, -1.0, 0.3, 1e-300, 5e-324, 1e-9, -1e4, 1e4, 1e3, -1e3, 7.5)
SHARES = (0.0, 1e-300, 0.5, 1.0)
TIMES_S = (0.0, 1e-300, 0.05, 0.1, 0.15, 0.3, 1.0, 60.0, 1e7)


def anything(rng: np.random.Generator, robot: Robot) -> Degradation:
    """Return a degradation by chance, of a device that the robot has."""
    names = [name for name, device in degradables().items() if device.elements(robot.model)]
    device = degradables()[str(rng.choice(names))]
    count = len(device.elements(robot.model))
    chance = rng.random(12) < 0.4

    def one_of(values, usual, place):
        return float(rng.choice(values)) if chance[place] else usual

    return Degradation(
        robot.id,
        device.name,
        int(rng.integers(count)) if chance[0] else None,
        bias=one_of(NUMBERS, 0.0, 1),
        gain=max(min(one_of(NUMBERS, 1.0, 2), 1e3), -1e3),
        noise=abs(one_of(NUMBERS, 0.0, 3)),
        step=abs(one_of(NUMBERS, 0.0, 4)),
        stuck="hold" if chance[5] else one_of(NUMBERS, None, 6),
        delay_s=min(one_of(TIMES_S, 0.0, 7), 60.0),
        dropouts=one_of(SHARES, 0.0, 8),
        dead=bool(rng.random() < 0.1),
        onset_s=one_of(TIMES_S, 0.0, 9),
        duration_s=one_of(TIMES_S, None, 10),
        recovery_s=one_of(TIMES_S, 0.0, 11),
    )


def some(rng: np.random.Generator, world, most: int = 30) -> list[Degradation]:
    tries = (anything(rng, world.robots[rng.integers(2)]) for _ in range(most))
    models = {robot.id: robot.model for robot in world.robots}
    return [each for each in tries if not validation_error(each, models[each.robot])]


@pytest.mark.parametrize("kind", ["scout", "nomad200"])
@pytest.mark.parametrize("seed", range(2))
def test_nothing_breaks(seed, kind):
    """Two robots near a wall; every request, with changes of degradations between the steps."""
    rng = np.random.default_rng(seed)
    bare = parse_world(
        b'<world version="1"><area length="9m" width="4m"/><robot x="1" y="1"/><robot x="6" y="2"/>'
        b'<cylinder x="3" y="1" radius="20cm" mass="1kg" heat="2"/></world>', "hostile", robot=kind,
    )  # fmt: skip
    faults = [dataclasses.replace(each, id=f"fault{n}") for n, each in enumerate(some(rng, bare))]
    environment = Environment(dataclasses.replace(bare, degradations=tuple(faults)), seed)
    codes = [code for code, row in REQUESTS.items() if row.server != "host"]
    ask(environment, CODES["CONNECT"], rng, 0.0)
    for cycle in range(25):
        for code in [*rng.choice(codes, 6), CODES["VM"], CODES["GS"]]:
            if code not in {CODES["DISCONNECT"], CODES["QUIT_SERVER"]}:
                ask(environment, int(code), rng, environment.time_s + 0.049 * rng.random())
        control = environment.degradations
        if cycle % 5 == 4:
            for each in some(rng, bare, 3):
                control.add(each)
            control.remove(str(rng.choice([each.id for each in control.all()])))
            name = str(rng.choice([each.id for each in control.all()]))
            control.change(name, gain=0.5, delay_s=float(rng.choice([0.0, 0.2])))
        step = environment.step()
        assert np.isfinite(step.slices.motion).all()
    state = environment.state
    for array in (state.bodies.position_m, state.heading_rad, state.odometry.x_m,
                  state.odometry.heading_rad, state.drive.axes.travelled):  # fmt: skip
        assert np.isfinite(array).all()
    assert not np.isnan(state.devices.sonar.echo_m).any()
    assert ((state.devices.bumper.pressed >= 0) & (state.devices.bumper.pressed < 2**24)).all()


def ask(environment: Environment, code: int, rng: np.random.Generator, at_s: float) -> None:
    messages = np.zeros(2, MESSAGE)
    messages["i"] = rng.choice([0, 1, 2, 50, 100, -100, 300], messages["i"].shape)
    environment.serve(code, np.arange(2), messages, np.full(2, at_s))


def test_many_faults_of_one_device_work_one_after_the_other():
    faults = [Degradation("robot0", "sonar", bias=0.01) for _ in range(100)]
    environment = Environment(world_with(*faults), seed=1)
    values = environment._data.constants.degradations.alter(
        environment.state, "sonar", np.array([0]), np.array([[1.0]]), np.array([0.0])
    )
    assert values[0, 0] == pytest.approx(2.0)
