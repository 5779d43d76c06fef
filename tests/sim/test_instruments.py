"""All instruments together: snapshots, repetition, invalid requests, robots without requests."""

import math
import pickle

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crs_cc.requests import CODES, MESSAGE
from crs_cc.sim.devices.compass import compasses
from crs_cc.sim.devices.infrared import rings
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import parse_world
from tests.sim.driver import Driver, world_of

SENSOR_CODES = [
    CODES[name]
    for name in (
        "GET_IR", "GET_CP", "GET_LS", "GET_SG", "CONF_IR", "CONF_CP", "CONF_LS", "CONF_SG",
        "LASER_PAGE", "POS_DATA", "CT", "GS",
    )
]  # fmt: skip
ROOM = (
    '<robot definition="nomad200" x="1.5m" y="2m" setup="noisy"/><robot x="3m" y="1m"/>'
    '<robot definition="nomad150" x="2.5m" y="3m" heading="200" setup="noisy"/>'
    '<robot definition="nomad200" x="4m" y="2m" heading="120"/>'
)


def room():
    text = f'<world version="1"><area length="5m" width="4m"/>{ROOM}</world>'
    return parse_world(text.encode(), "room")


def connected(seed: int = 3) -> Environment:
    environment = Environment(room(), seed)
    everybody, now_s = np.arange(4), np.zeros(4)
    for name, numbers, data in (
        ("CONNECT", (1,), b""),
        ("CONF_LS", (33, 20, 20, 100, 1), b""),
        ("CONF_CP", (1,), b""),
        ("CT", (), bytes([31] + [1] * 43)),
    ):
        messages = np.zeros(4, MESSAGE)
        messages["i"][:, : len(numbers)] = numbers
        messages["size"] = len(data)
        messages["data"][:, : len(data)] = list(data)
        environment.serve(CODES[name], everybody, messages, now_s)
    return environment


def play(environment: Environment, cycles: range) -> list:
    """Request everything; return all that programs would see."""
    seen = []
    for cycle in cycles:
        rng = np.random.default_rng(cycle)
        for code in (int(rng.choice(SENSOR_CODES)), CODES["VM"]):
            robots = np.flatnonzero(rng.random(4) < 0.7)
            messages = np.zeros(len(robots), MESSAGE)
            messages["i"][:, :5] = rng.integers(0, 60, (len(robots), 5))
            if code == CODES["VM"]:
                messages["i"][:, :3] = rng.integers(-200, 200, (len(robots), 3))
            if code == CODES["POS_DATA"]:
                messages["i"][:, 0] = 2 ** rng.integers(0, 5, len(robots))
                messages["i"][:, 1] = 0
            clock_s = environment.time_s + rng.random(len(robots)) * 0.05
            environment.serve(code, robots, messages, clock_s)
            seen.append(messages.tobytes())
        environment.step()
        seen.append(environment.hash())
    return seen


@pytest.mark.parametrize("at", [0, 41])
def test_readings_from_snapshot_are_equal(at):
    environment = connected()
    play(environment, range(at))
    snapshot = environment.snapshot()
    expected = play(environment, range(at, at + 30))
    environment.restore(snapshot)
    assert play(environment, range(at, at + 30)) == expected
    other = Environment(room(), 3)
    other.restore(pickle.loads(pickle.dumps(snapshot)))
    assert play(other, range(at, at + 30)) == expected


def test_noise_depends_only_on_seed():
    assert play(connected(1), range(10)) == play(connected(1), range(10))
    assert play(connected(1), range(10)) != play(connected(2), range(10))


READS = (
    ("GET_IR",), ("GET_LS",), ("GET_CP",), ("SONAR", 1), ("PREDICT", 700, 700, 10, 20),
    ("LASER_PAGE", 0), ("POS_DATA", 1, 0), ("HEAT",),
)  # fmt: skip


def test_readings_of_one_robot_do_not_affect_others():
    def readings(asking: bool) -> bytes:
        driver = Driver(connected())
        seen = b""
        for _ in range(15):
            if asking:
                for name, *arguments in READS:
                    driver.post(name, *arguments, robot=0)
            message, _ = driver.post("GS", robot=2)
            seen += message.tobytes()
            driver.run(1)
        return seen

    assert readings(True) == readings(False)


def test_nothing_is_measured_without_request():
    environment = Environment(room(), 3)
    Driver(environment).run(20)
    state = environment.state
    assert not rings(state).count.any()
    assert not compasses(state).count.any()
    assert not state.devices.laser.readings.count.any()
    assert len(state.pos_data.reported) == 0


def test_scouts_have_no_state_for_missing_devices():
    state = Environment(world_of('<robot x="2m" y="2m"/>' * 1), 0).state
    laser = state.devices.laser.readings.value
    for array in (rings(state).level, compasses(state).reading, laser):
        assert array.size == 0


MESSAGES = st.tuples(
    st.lists(st.integers(-(2**31), 2**31 - 1), min_size=8, max_size=8),
    st.one_of(st.just(44), st.integers(-(2**31), 2**31 - 1)),
    st.binary(max_size=248),
)
_NONSENSE: list[Environment] = []


@settings(max_examples=200, deadline=None)
@given(st.sampled_from(SENSOR_CODES), MESSAGES, st.floats(allow_nan=True))
def test_no_request_breaks_instruments(code, content, clock_s):
    if not _NONSENSE:
        _NONSENSE.append(connected())
    environment = _NONSENSE[0]
    messages = np.zeros(4, MESSAGE)
    messages["i"], messages["size"] = content[:2]
    messages["data"][:, : len(content[2])] = list(content[2])
    goes_on_s = environment.serve(code, np.arange(4), messages, np.full(4, clock_s))
    assert (messages["result"] >= 0).all()
    assert (messages["result"] <= 31).all()
    assert all(map(math.isfinite, goes_on_s))
    environment.step()
    state = environment.state
    assert np.isfinite(rings(state).level).all()
    assert ((compasses(state).reading >= 0) & (compasses(state).reading < 3600)).all()
    assert ((state.devices.laser.wanted >= 1) & (state.devices.laser.wanted <= 482)).all()
