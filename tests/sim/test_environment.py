"""The environment as the session uses it: timing, waits, traces, snapshots, invalid requests."""

import math
import pickle
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crs_cc.requests import CODES, MESSAGE, REQUESTS
from crs_cc.sim.devices.vendor_state import CONF_X, MOTOR_STATUS, VEL_RIGHT
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.engine.step import describe_slice
from crs_cc.sim.files import world_xml
from crs_cc.sim.files.world_xml import empty_world, load_world
from crs_cc.sim.model.world import Area, WorldModel
from tests.commands import python
from tests.sim.driver import INCH, Driver, open_world, told, world_of

ROBOT_CODES = sorted(
    code for code, row in REQUESTS.items() if row.server not in ("host", "network")
)
DT = 0.05


def test_exactly_requests_of_robots_have_handlers():
    assert sorted(Environment(empty_world(), 0)._data.handlers) == ROBOT_CODES


def test_negative_seed_is_refused():
    with pytest.raises(ValueError, match="seed"):
        Environment(open_world(), -1)


def test_time_is_counted_in_cycles_not_summed():
    environment = Environment(open_world(timestep="30ms"), 0)
    for cycle in range(1000):
        assert environment.time_s == cycle * 0.03
        environment.step()


def test_commands_take_transmission_time_of_their_bytes():
    environment = Environment(empty_world(), 0)
    bits = 10 / 38400
    assert environment.link_s(CODES["VM"]) == pytest.approx((12 + 48) * bits)
    assert environment.link_s(CODES["GET_BP"]) == pytest.approx((6 + 13) * bits)
    assert environment.link_s(CODES["CONNECT"]) == 0
    assert environment.link_s(12345) == 0


# -- commands in time --------------------------------------------------------------------------


def test_command_takes_effect_at_its_own_time_in_cycle():
    driver = Driver.of(open_world())
    driver.ask("AC", 200, 200)
    driver.ask("VM", 100, 100, at_s=0.02)
    driver.run(1)
    assert driver.state.x_m[0] == pytest.approx(20 * INCH * 0.03**2 / 2)
    told_later = driver.ask("GET_RV", at_s=0.07)
    assert told_later[VEL_RIGHT] == round(200 * 0.05)


def test_commands_in_one_cycle_are_sequential():
    driver = Driver.of(open_world())
    driver.ask("AC", 400, 400)
    driver.ask("VM", 390, 390, at_s=0.01)
    driver.ask("VM", 0, 0, at_s=0.03)
    driver.run(2)
    # Up with 40 in/s^2 for 20 ms, down for 20 ms.
    assert driver.state.x_m[0] == pytest.approx(40 * INCH * 0.02**2)
    assert driver.ask("GS")[MOTOR_STATUS] == 0


def test_clock_of_robot_is_monotonic():
    driver = Driver.of(open_world())
    driver.ask("VM", 300, 300, at_s=0.04)
    for bad_s in (0.01, -5.0, math.nan):
        message, goes_on_s = driver.post("GS", at_s=bad_s)
        assert goes_on_s == 0.04
        assert message["result"] == 1
    _, goes_on_s = driver.post("GS", at_s=99.0)
    assert goes_on_s == 0.05


def test_speeds_and_accelerations_are_clipped_to_limits():
    driver = Driver.of(open_world())
    driver.ask("AC", 10_000, -200)
    driver.ask("SP", 10_000, -50)
    assert driver.state.drive.ramp[0, :2] == pytest.approx([2.0, 20 * INCH])
    assert driver.state.drive.move_speed[0, :2] == pytest.approx([1.0, 5 * INCH])
    driver.ask("VM", 2**31 - 1, -(2**31))
    driver.run_s(5)
    assert driver.state.drive.axes.speed[0].tolist() == [1.0, -1.0, 0.0]
    driver.ask("AC", 0, 0)
    driver.ask("SP", 0, 0)
    assert (driver.state.drive.ramp > 0).all()
    assert (driver.state.drive.move_speed > 0).all()


def test_mv_commands_each_wheel_in_its_own_mode():
    driver = Driver.of(open_world())
    driver.ask("MV", 4, 100, 5, 50, 0, 0)  # MV_AC right, MV_SP left
    assert driver.state.drive.ramp[0, :2] == pytest.approx([10 * INCH, 20 * INCH])
    assert driver.state.drive.move_speed[0, :2] == pytest.approx([10 * INCH, 5 * INCH])
    driver.ask("MV", 1, 100, 2, 30, 0, 0)  # MV_VM right, MV_PR left
    steps = driver.run_s(3)
    assert driver.state.drive.axes.speed[0] == pytest.approx([10 * INCH, 0, 0])
    assert sum(step.slices.motion[0, 1] for step in steps) == pytest.approx(3 * INCH)
    driver.ask("MV", 3, 0, 0, 0, 0, 0)  # MV_LP right
    driver.run_s(2)
    assert driver.ask("GS")[MOTOR_STATUS] == 0


@pytest.mark.parametrize(
    ("modes", "remembered"),
    [((1, 0, 0), "MV"), ((0, 2, 0), "MV"), ((2, 2, 0), "MV"), ((0, 3, 0), "MV"), ((4, 5, 0), "PR")],
)
def test_mv_becomes_current_command_if_it_moves_an_axis(modes, remembered):
    driver = Driver.of(open_world())
    driver.ask("PR", 10, 10)
    driver.run_s(3)
    driver.ask("MV", modes[0], 100, modes[1], 100, modes[2], 0)
    assert driver.state.drive.command[0] == CODES[remembered]


@pytest.mark.parametrize("modes", [(6, 0, 0), (0, -1, 0), (0, 0, 8), (1, 2**31 - 1, 0)])
def test_mv_with_unknown_mode_is_refused_without_effect(modes):
    driver = Driver.of(open_world())
    message, _ = driver.post("MV", modes[0], 100, modes[1], 100, modes[2], 0)
    assert message["result"] == 0
    driver.run(10)
    assert driver.state.distance_m[0] == 0


def test_unconnected_robot_refuses_all_but_connect():
    driver = Driver(Environment(open_world(), 0))
    assert driver.post("VM", 100, 100)[0]["result"] == 0
    assert driver.post("WS", 1, 1, 0, 9)[1] == 0.0
    driver.run(10)
    assert driver.state.distance_m[0] == 0
    assert driver.post("CONNECT", 1)[0]["result"] == 1
    assert driver.post("VM", 100, 100)[0]["result"] == 1
    driver.ask("DISCONNECT", 1)
    driver.run(10)
    assert driver.state.distance_m[0] > 0  # the wheels go on
    assert driver.post("ST")[0]["result"] == 0


@pytest.mark.parametrize("name", ["SONAR", "PREDICT"])
def test_refused_request_measures_nothing(name):
    environment = Environment(world_of('<robot x="2m" y="5m"/><robot x="2m" y="7m"/>'), 0)
    driver = Driver(environment)
    driver.ask("CONNECT", robot=1)
    driver.ask("GS")  # what is due at the start has fired
    before = environment.state.devices.sonar.count[0]
    messages = np.zeros(2, MESSAGE)
    messages["i"][:, 0] = 1
    environment.serve(CODES[name], np.arange(2), messages, np.zeros(2))
    assert messages["result"].tolist() == [0, 1]
    assert messages["size"][0] == 0
    assert not messages["data"][0].any()
    assert messages["data"][1].any()
    assert environment.state.devices.sonar.count[0] == before


# -- conf_tm -----------------------------------------------------------------------------------


def test_wheels_stop_after_command_timeout():
    driver = Driver.of(open_world())
    driver.ask("AC", 100, 100)
    driver.ask("CONF_TM", 1)
    driver.ask("VM", 100, 100, at_s=0.02)
    steps = driver.run_s(4)
    # 1 s up, at 1.02 s the wheels brake for 1 s: 2 x 5 in.
    assert driver.state.x_m[0] == pytest.approx(10 * INCH)
    assert describe_slice(steps[-1], 0).command == ""
    assert describe_slice(steps[25], 0).command == "CONF_TM"


def test_any_command_restarts_command_timeout():
    driver = Driver.of(open_world())
    driver.ask("CONF_TM", 1)
    driver.ask("VM", 100, 100)
    for _ in range(10):
        driver.run_s(0.9)
        assert driver.ask("GET_RV")[VEL_RIGHT] == 100
    driver.ask("CONF_TM", 0)
    driver.run_s(20)
    assert driver.ask("GET_RV")[VEL_RIGHT] == 100


def test_command_timeout_can_expire_in_cycle_of_next_command():
    driver = Driver.of(open_world())
    driver.ask("AC", 390, 390)
    driver.ask("CONF_TM", 1)
    driver.ask("VM", 100, 100, at_s=0.01)
    driver.run_s(1.0)
    told_s = driver.ask("GET_RV", at_s=1.03)
    assert told_s[VEL_RIGHT] == round(100 - 390 * 0.02)


def test_conf_tm_takes_effect_at_its_own_time():
    driver = Driver.of(open_world())
    driver.ask("VM", 100, 100)
    driver.run_s(2)
    for timeout, deadline_s in ((3, 5.02), (1, 3.03), (0, math.inf)):
        driver.ask("CONF_TM", timeout, at_s=deadline_s - timeout if timeout else 2.04)
        assert driver.state.drive.deadline_s[0] == pytest.approx(deadline_s)


# -- ws ----------------------------------------------------------------------------------------

# A move of 10 in at 10 in/s with 20 in/s^2 takes 0.5 + 0.5 + 0.5 s.
MOVE_S = 1.5


def wait_for(driver: Driver, steps: int = 2000):
    """Run until the wait of robot 0 ends; return the time and the reply."""
    for _ in range(steps):
        (step,) = driver.run(1)
        if len(step.robots):
            assert step.robots.tolist() == [0]
            at_s = float(step.at_s[0])
            assert driver.environment.time_s <= at_s < driver.environment.end_s
            return at_s, step.messages[0]
    return math.inf, None


@pytest.mark.parametrize("timestep", ["1ms", "30ms", "50ms", "100ms"])
@pytest.mark.parametrize("at_s", [0.0, 0.0007])
def test_ws_ends_exactly_when_wheels_are_at_rest(timestep, at_s):
    driver = Driver.of(open_world(timestep=timestep))
    driver.ask("PR", 100, 100, at_s=at_s)
    _, goes_on_s = driver.post("WS", 1, 1, 0, 255, at_s=at_s)
    assert math.isinf(goes_on_s)
    end_s, message = wait_for(driver)
    assert end_s == pytest.approx(at_s + MOVE_S, abs=1e-9)
    assert message["result"] == 1
    assert told(message)[[CONF_X, MOTOR_STATUS]].tolist() == [100, 0]


def test_ws_ending_in_same_cycle_is_answered_at_once():
    driver = Driver.of(open_world())
    driver.ask("PR", 100, 100, at_s=0.04)
    driver.run(30)
    message, goes_on_s = driver.post("WS", 1, 1, 0, 255)
    assert goes_on_s == pytest.approx(1.54)
    assert told(message)[CONF_X] == 100


def test_ws_without_motion_returns_at_once():
    driver = Driver.of(open_world())
    assert driver.post("WS", 1, 1, 0, 255, at_s=0.01)[1] == 0.01
    driver.ask("VM", 100, 100)
    assert driver.post("WS", 0, 0, 1, 255, at_s=0.02)[1] == 0.02
    assert driver.post("WS", 1, 1, 0, 0, at_s=0.03)[1] == 0.03


def test_ws_times_out_without_stopping_wheels():
    driver = Driver.of(open_world())
    driver.ask("VM", 100, 100)
    driver.post("WS", 1, 1, 0, 3, at_s=0.013)
    end_s, message = wait_for(driver)
    assert end_s == pytest.approx(3.013)
    assert told(message)[VEL_RIGHT] == 100


def test_ws_waits_for_selected_wheel_only():
    driver = Driver.of(open_world())
    driver.ask("PR", 100, 300)
    driver.post("WS", 1, 0, 0, 255)
    assert wait_for(driver)[0] == pytest.approx(MOVE_S)
    driver.post("WS", 0, 1, 0, 255)
    assert wait_for(driver)[0] == pytest.approx(MOVE_S + 2)


def test_ws_ends_when_command_timeout_stops_wheels():
    driver = Driver.of(open_world())
    driver.ask("CONF_TM", 2)
    driver.ask("VM", 100, 100)
    driver.post("WS", 1, 1, 0, 255)
    assert wait_for(driver)[0] == pytest.approx(2.5)  # 10 in/s are gone after half a second


@pytest.mark.parametrize("timeout", [-1, 256, 2**31 - 1, -(2**31)])
def test_ws_clips_timeout_to_byte(timeout):
    driver = Driver.of(open_world(timestep="100ms"))
    driver.ask("VM", 100, 100)
    driver.post("WS", 1, 1, 0, timeout)
    assert driver.state.waits.until_s[0] in {0.0, 255.0}


def test_ws_with_timeout_0_waits_forever_if_defined(tmp_path):
    change = 'ws-timeout-zero="return"', 'ws-timeout-zero="forever"'
    driver = Driver.of(scout_file(tmp_path, change))  # robot 1
    ends_s = []
    for robot in range(2):
        driver.ask("PR", 100, 100, robot=robot)
        ends_s.append(driver.post("WS", 1, 1, 0, 0, robot=robot)[1])
    assert ends_s == [0.0, math.inf]
    ended = [float(step.at_s[0]) for step in driver.run_s(3) if len(step.at_s)]
    assert ended == [pytest.approx(MOVE_S)]


@pytest.mark.parametrize("restored", [False, True])
def test_reply_to_wait_overwrites_request(restored):
    driver = Driver.of(open_world('<robot x="0" y="0"/><robot x="0" y="3"/>'))
    driver.ask("PR", 100, 100)
    messages = np.zeros(2, MESSAGE)
    messages["i"][:] = [[1, 1, 0, 20, 5, 6, 7, 8], [1, 1, 0, 30, 9, 8, 7, 6]]
    messages["f"][:, 2] = 0.5, 1.5
    asked = messages.copy()
    both = np.array([0, 1])
    goes_on_s = driver.environment.serve(CODES["WS"], both, messages, np.zeros(2))
    assert goes_on_s.tolist() == [math.inf, 0.0]  # robot 1 stands already
    if restored:
        world, snapshot = driver.environment.world, driver.environment.snapshot()
        driver.environment = Environment(world, 1)
        driver.environment.restore(pickle.loads(pickle.dumps(snapshot)))
    messages[0] = wait_for(driver)[1]
    for place, results in (("i", 3), ("f", 1)):
        assert (messages[place][:, results:] == asked[place][:, results:]).all()
    assert messages["result"].tolist() == [1, 1]


def test_immediate_wait_gives_same_answer_as_later_one(monkeypatch):
    def fail(context) -> np.ndarray:
        return np.zeros(len(context), dtype=np.bool_)

    driver = Driver.of(open_world('<robot x="0" y="0"/><robot x="0" y="3"/>'))
    driver.ask("PR", 100, 100)
    messages = np.zeros(2, MESSAGE)
    messages["i"][:, :4] = 1, 1, 0, 20
    waits = driver.environment._data.waits
    monkeypatch.setitem(waits, CODES["WS"], replace(waits[CODES["WS"]], finish=fail))
    goes_on_s = driver.environment.serve(CODES["WS"], np.arange(2), messages, np.zeros(2))
    assert goes_on_s.tolist() == [math.inf, 0.0]
    assert messages["result"][1] == 0
    assert wait_for(driver)[1]["result"] == 0


def test_waits_of_robots_end_independently():
    driver = Driver.of(open_world('<robot x="0" y="0"/><robot x="0" y="3"/>'))
    messages = np.zeros(2, MESSAGE)
    messages["i"][:, 0] = messages["i"][:, 1] = 100, 300
    both, now_s = np.array([0, 1]), np.zeros(2)
    driver.environment.serve(CODES["PR"], both, messages, now_s)
    messages["i"][:, :4] = 1, 1, 0, 255
    driver.environment.serve(CODES["WS"], both, messages, now_s)
    ends = {
        int(robot): float(at_s)
        for step in driver.run_s(4)
        for robot, at_s in zip(step.robots, step.at_s, strict=True)
    }
    assert ends == {0: pytest.approx(1.5), 1: pytest.approx(3.5)}


# -- the contents of a step --------------------------------------------------------------------


def test_slices_are_numbered_and_add_up_to_command():
    driver = Driver.of(open_world())
    driver.ask("PR", 100, -50, at_s=0.02)
    parts = [describe_slice(step, 0) for step in driver.run_s(2)]
    runs = [part for part in parts if part.command]
    assert {part.command for part in runs} == {"PR"}
    assert [part.number for part in runs] == list(range(1, 32))  # 1.5 s from 0.02 s: 31 cycles
    assert {part.count for part in runs} == {31}
    for axis, way_m in enumerate((10 * INCH, -5 * INCH)):
        assert sum(part.axes[axis].motion for part in runs) == pytest.approx(way_m, abs=1e-12)
        assert runs[-1].axes[axis].travelled == runs[-1].axes[axis].total == pytest.approx(way_m)
        assert all(part.axes[axis].motion == 0 for part in parts[31:])


def test_endless_command_has_slices_without_count():
    driver = Driver.of(open_world())
    driver.ask("VM", 100, 100)
    part = describe_slice(driver.run(7)[-1], 0)
    assert (part.command, part.number, part.count) == ("VM", 7, None)
    assert [(axis.name, axis.total) for axis in part.axes] == [("right", None), ("left", None)]


def test_step_contains_answered_requests_with_replies():
    driver = Driver.of(world_of('<robot x="2m" y="5m"/><robot x="2m" y="7m"/>'))
    driver.run(1)
    driver.ask("GET_RC", robot=1, at_s=0.06)
    driver.ask("VM", 10, 20, 30, robot=1, at_s=0.07)
    sonar = driver.ask("GET_SN", robot=1, at_s=0.08)[17:33]
    (step,) = driver.run(1)
    assert describe_slice(step, 0).answers == ()
    answers = describe_slice(step, 1).answers
    assert [answer.name for answer in answers] == ["GET_RC", "VM", "GET_SN"]
    assert [answer.clock_s for answer in answers] == [0.06, 0.07, 0.08]
    assert answers[0].values == {"pose": (0, 0, 0)}
    assert answers[1].arguments == (10, 20, 30)
    assert answers[2].values == {"sonar_in": tuple(sonar.tolist())}
    assert describe_slice(driver.run(1)[0], 1).answers == ()


def test_step_contains_new_contacts():
    driver = Driver.of(world_of('<robot id="r" x="9m" y="5m"/>'))
    driver.ask("VM", 200, 200)
    began = [
        (step.names[robot], step.names[other], float(x), float(y))
        for step in driver.run_s(5)
        for robot, other, x, y in zip(
            step.contacts.robot, step.contacts.other, step.contacts.x_m, step.contacts.y_m,
            strict=True,
        )
    ]  # fmt: skip
    assert began == [("r", "edge-east", pytest.approx(10, abs=0.01), pytest.approx(5, abs=0.01))]
    assert driver.state.collisions[0] == 1


def test_distance_driven_and_commands_are_counted():
    driver = Driver.of(open_world())
    driver.ask("PR", 100, 100)
    driver.run_s(2)
    driver.ask("PR", -100, -100)
    driver.run_s(2)
    assert driver.state.distance_m[0] == pytest.approx(20 * INCH)
    assert driver.state.commands[0] == 3  # with the connection


# -- snapshots and repetition ------------------------------------------------------------------

BUSY = (
    '<box x="2.5m" y="2.3m" length="40cm" width="30cm" mass="2kg"/>'
    '<box x="3.2m" y="2.3m" length="40cm" width="30cm" mass="1kg"/>'
    '<cylinder x="1.6m" y="2.3m" radius="15cm" mass="1kg"/>'
) + "".join(
    f'<robot x="{1 + 0.8 * (n % 5)}m" y="{1 + 0.8 * (n // 5)}m" heading="{60 + 7 * n}"/>'
    for n in range(10)
)


def busy_world():
    return world_of(BUSY, 'length="5m" width="4m"')


def play(environment: Environment, cycles: range) -> list:
    """Post requests of all kinds; return all that programs would see."""
    seen = []
    for cycle in cycles:
        rng = np.random.default_rng(cycle)  # the same requests in the same cycle, always
        for _ in range(2):
            code = int(rng.choice(ROBOT_CODES)) if rng.random() < 0.6 else CODES["VM"]
            robots = np.flatnonzero(rng.random(10) < 0.6)
            robots = robots[environment.state.waits.code[robots] == 0]
            messages = np.zeros(len(robots), MESSAGE)
            messages["i"][:, :6] = rng.integers(-200, 390, (len(robots), 6))
            if code == CODES["VM"]:  # mostly straight on
                messages["i"][:, 1] = messages["i"][:, 0] + rng.integers(-40, 40, len(robots))
            if code == CODES["MV"]:
                messages["i"][:, [0, 2, 4]] = rng.integers(0, 4, (len(robots), 3))
            if code == CODES["WS"]:
                messages["i"][:, :4] = 1, 1, 0, 2
            if code == CODES["RECEIVE"]:
                messages["i"][:, 0] = 100
            if REQUESTS[code].name in {"AC", "DISCONNECT", "CONF_SN", "QUIT_SERVER", "NEW_WORLD"}:
                code = CODES["VM"]
            if code == CODES["VM"]:  # mostly ahead, into the objects
                messages["i"][:, 1] = messages["i"][:, 0] - 30
            clock_s = environment.time_s + rng.random(len(robots)) * DT
            goes_on_s = environment.serve(code, robots, messages, clock_s)
            seen += [messages.tobytes(), goes_on_s.tobytes()]
        step = environment.step()
        seen += [step.robots.tobytes(), step.at_s.tobytes(), step.messages.tobytes()]
        seen += [step.contacts.x_m.tobytes(), environment.hash()]
    return seen


def connected() -> Environment:
    environment = Environment(busy_world(), 5)
    messages = np.zeros(10, MESSAGE)
    environment.serve(CODES["CONNECT"], np.arange(10), messages, np.zeros(10))
    return environment


@pytest.mark.parametrize("at", [1, 63])
def test_run_from_snapshot_is_bitwise_equal(at):
    environment = connected()
    play(environment, range(at))
    snapshot = environment.snapshot()
    before = environment.hash()
    start_m = Environment(busy_world(), 5).state.bodies.position_m[10:].tolist()
    expected = play(environment, range(at, at + 120))
    assert environment.state.collisions.sum() >= 5
    assert environment.state.bodies.position_m[10:].tolist() != start_m
    environment.restore(snapshot)
    assert environment.hash() == before
    assert play(environment, range(at, at + 120)) == expected
    other = Environment(busy_world(), 5)
    other.restore(pickle.loads(pickle.dumps(snapshot)))
    assert play(other, range(at, at + 120)) == expected


def test_snapshot_within_cycle_keeps_its_answers():
    driver = Driver.of(open_world())
    driver.ask("PR", 100, 100, at_s=0.02)
    snapshot = driver.environment.snapshot()
    (expected,) = driver.run(1)
    driver.environment.restore(snapshot)
    (again,) = driver.run(1)
    assert describe_slice(again, 0) == describe_slice(expected, 0)
    assert [answer.name for answer in describe_slice(again, 0).answers] == ["CONNECT", "PR"]


PROGRAM = """
from tests.sim.test_environment import connected, play
environment = connected()
play(environment, range(80))
print(environment.hash())
"""


def test_two_processes_reach_same_state():
    hashes = {
        subprocess.run([*command, PROGRAM], capture_output=True, text=True, check=True).stdout
        for command in ([sys.executable, "-c"], python("-c"))
    }
    environment = connected()
    play(environment, range(80))
    assert hashes == {environment.hash() + "\n"}


def test_hash_detects_small_differences():
    one, other = Environment(open_world(), 1), Environment(open_world(), 1)
    assert one.hash() == other.hash()
    other.state.bodies.position_m[0, 0] = 1e-300
    assert one.hash() != other.hash()


# -- invalid requests --------------------------------------------------------------------------

MESSAGES = st.tuples(
    st.lists(st.integers(-(2**31), 2**31 - 1), min_size=8, max_size=8),
    st.lists(st.floats(width=64), min_size=4, max_size=4),
    st.integers(-(2**31), 2**31 - 1),
    st.binary(max_size=248),
)


@pytest.mark.parametrize("robot", ["scout", "nomad200"])
@settings(max_examples=150, deadline=None)
@given(
    code=st.sampled_from([*ROBOT_CODES, 0, -1, 99, 10**6]),
    content=MESSAGES,
    clock_s=st.floats(allow_nan=True),
)
def test_no_request_can_break_the_environment(robot, code, content, clock_s):
    driver = nonsense(robot)
    message = np.zeros(1, MESSAGE)
    message["i"], message["f"], message["size"] = content[:3]
    message["data"][0, : len(content[3])] = list(content[3])
    goes_on_s = driver.environment.serve(code, np.array([0]), message, np.array([clock_s]))
    assert 0 <= message["result"][0] <= 31 or goes_on_s[0] == math.inf  # of a laser's page
    if code in ROBOT_CODES and goes_on_s[0] != math.inf:
        assert driver.environment.time_s <= goes_on_s[0] <= driver.environment.end_s
    driver.run(3)
    state = driver.state
    driver.state.waits.code[:] = 0
    assert np.isfinite(state.bodies.position_m).all()
    assert np.isfinite([state.odometry.x_m, state.odometry.y_m, state.odometry.heading_rad]).all()
    assert np.isfinite(state.drive.axes.speed).all()


_NONSENSE: dict[str, Driver] = {}


def nonsense(robot: str) -> Driver:
    """Return one environment for all examples: invalid requests must not accumulate either."""
    if robot not in _NONSENSE:
        elements = f'<robot definition="{robot}" x="5m" y="5m"/>'
        _NONSENSE[robot] = Driver.of(world_of(elements))
    driver = _NONSENSE[robot]
    driver.state.connected[:] = True
    return driver


def test_request_without_robots_does_nothing():
    environment = Environment(open_world(), 1)
    nobody = np.zeros(0, np.intp)
    for code in [*ROBOT_CODES, 7]:
        assert len(environment.serve(code, nobody, np.zeros(0, MESSAGE), np.zeros(0))) == 0


def scout_file(folder, *changes: tuple[str, str]):
    """Write a changed Scout definition; return a world file next to it."""
    text = (Path(world_xml.__file__).parents[0] / "robots" / "scout.xml").read_text()
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    (folder / "other.xml").write_text(text)
    path = folder / "w.xml"
    path.write_text(
        '<world version="1"><area length="5m" width="5m"/><robot x="1m" y="1m"/>'
        '<robot x="3m" y="3m" definition="other.xml"/><robot x="1m" y="4m"/></world>'
    )
    return load_world(path)


def test_robots_of_different_models_share_world(tmp_path):
    small = ('radius="8in"', 'radius="9in"'), ("<range>255in", "<range>50in")
    driver = Driver.of(scout_file(tmp_path, ('switches="8"', 'switches="4"'), *small))
    readings = [driver.ask("GET_SN", robot=robot)[17:33] for robot in range(3)]
    assert readings[1][readings[1] < 255].max(initial=0) <= 50
    assert readings[0].max() > 50
    together = Driver.of(driver.environment.world)
    messages = np.zeros(3, MESSAGE)
    together.environment.serve(CODES["GET_SN"], np.arange(3), messages, np.zeros(3))
    assert [told(message)[17:33].tolist() for message in messages] == [
        row.tolist() for row in readings
    ]


def test_sonar_noise_varies_by_cycle_and_depends_only_on_seed(tmp_path):
    world = scout_file(tmp_path, ('noise="0in"', 'noise="5in"'))

    def errors(seed):
        driver, exact = Driver.of(world, seed), Driver.of(world, seed).ask("GET_SN")[17:33]
        found = []
        for _ in range(30):
            reading = driver.ask("GET_SN", robot=1)[17:33]
            assert (driver.ask("GS", robot=1)[17:33] == reading).all()  # once in a cycle
            found.append(reading)
            driver.run(1)
        assert (driver.ask("GET_SN", robot=0)[17:33] == exact).all()
        return np.array(found)

    found = errors(3)
    assert (errors(3) == found).all()
    assert (errors(4) != found).any()
    assert 2 < (found - np.median(found, axis=0))[found < 255].std() < 7


def test_time_advances_in_world_without_robots():
    environment = Environment(WorldModel("nobody", Area(0, 0, 5, 5)), 0)
    step = environment.step()
    assert (environment.time_s, len(step.robots)) == (DT, 0)


def test_uncountably_long_motion_is_endless(tmp_path):
    driver = Driver.of(scout_file(tmp_path, ('speed="10in/s"', 'speed="1e-300m/s"')))
    driver.post("PR", 100, 100, robot=1)
    with np.errstate(invalid="raise"):
        driver.run(1)
        step = driver.environment.step()
    assert describe_slice(step, 1).count is None
