"""Degradations that come, change and go while a world runs, and what is told of it."""

import dataclasses
import json
import math

import numpy as np
import pytest

from crs_cc.sim.devices.vendor_state import SONAR_0
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.model.degradation import Degradation
from tests.sim.degradation.law import world_with
from tests.sim.driver import Driver

SONAR = Degradation("robot0", "sonar", element=0, stuck=1.0)


def driver_of(*degradations: Degradation, robots: int = 1) -> Driver:
    return Driver.of(world_with(*degradations, robots=robots))


def told(driver: Driver, robot: int = 0) -> int:
    return int(driver.ask("GET_SN", robot=robot)[SONAR_0])


def events(driver: Driver, cycles: int) -> list[tuple[float, str]]:
    """Return what is told of degradations in some cycles."""
    said = [event for step in driver.run(cycles) for event in step.events]
    assert {event.kind for event in said} <= {"degradation"}
    return [(round(event.time_s, 6), event.text) for event in said]


def test_it_begins_fades_and_is_over_at_its_instants():
    driver = driver_of(Degradation("robot0", "sonar", 3, gain=0.5, onset_s=0.12, duration_s=0.1,
                                   recovery_s=0.05, id="worn"))  # fmt: skip
    control = driver.environment.degradations
    assert events(driver, 2) == []
    assert control.phase("worn") == "waits"
    assert events(driver, 4) == [
        (0.12, "sonar 3, gain 0.5 (worn began)"),
        (0.22, "sonar 3, gain 0.5 (worn began to fade)"),
        (0.27, "sonar 3, gain 0.5 (worn ended)"),
    ]
    assert control.phase("worn") == "over"
    assert not driver.state.degradation.present.any()
    assert events(driver, 20) == []


def test_at_its_very_onset_it_waits_and_what_is_told_of_it_is_told_in_the_next_cycle():
    before = dataclasses.replace(SONAR, element=1, onset_s=1.98)
    driver = driver_of(dataclasses.replace(SONAR, onset_s=2.0), before)
    assert events(driver, 40) == [(1.98, "sonar 1, stuck at 1m (degradation1 began)")]
    assert driver.environment.time_s == 2.0
    assert driver.environment.degradations.phase("degradation0") == "waits"
    assert events(driver, 1) == [(2.0, "sonar 0, stuck at 1m (degradation0 began)")]
    assert driver.environment.degradations.phase("degradation0") == "acts"


def test_what_is_added_begins_now_and_what_is_removed_ends_now():
    driver = driver_of()
    driver.run_s(2)
    assert told(driver) == 255
    control = driver.environment.degradations
    assert control.add(SONAR) == "degradation0"
    assert control.all() == (dataclasses.replace(SONAR, onset_s=2.0, id="degradation0"),)
    said = events(driver, 40)
    assert said == [
        (2.0, "sonar 0, stuck at 1m (degradation0 added)"),
        (2.0, "sonar 0, stuck at 1m (degradation0 began)"),
    ]
    assert told(driver) == round(1 / 0.0254)
    driver.environment.degradations.remove("degradation0")
    assert events(driver, 40) == [(4.0, "sonar 0, stuck at 1m (degradation0 removed)")]
    assert told(driver) == 255


def test_a_change_counts_from_now_on():
    driver = driver_of(SONAR)
    driver.run_s(2)
    changed = driver.environment.degradations.change("degradation0", stuck=2.0)
    assert changed.stuck == 2.0
    assert driver.environment.degradations.all() == (changed,)
    assert events(driver, 40) == [(2.0, "sonar 0, stuck at 2m (degradation0 changed)")]
    assert told(driver) == round(2 / 0.0254)


@pytest.mark.parametrize(
    ("changes", "phase"),
    [({"duration_s": 1.0}, "over"), ({"duration_s": 1.0, "recovery_s": 9.0}, "fades"),
     ({"onset_s": 9.0}, "waits"), ({"onset_s": 0.0}, "waits"), ({"gain": 2.0}, "acts")],
)  # fmt: skip
def test_a_change_of_times_puts_it_where_it_would_be(changes, phase):
    driver = driver_of(SONAR)
    driver.run_s(2)
    control = driver.environment.degradations
    control.change("degradation0", **changes)
    assert control.phase("degradation0") == phase
    driver.run_s(1)
    if changes.get("onset_s") == 0.0:
        assert driver.environment.degradations.phase("degradation0") == "acts"


@pytest.mark.parametrize(
    ("changes", "phase", "turn"),
    [({"onset_s": 2.0}, "waits", "began"), ({"duration_s": 1.0, "recovery_s": 9.0}, "acts",
     "began to fade"), ({"duration_s": 0.5, "recovery_s": 0.5}, "fades", "ended")],
)  # fmt: skip
def test_a_turn_at_the_very_instant_of_a_change_is_still_to_come(changes, phase, turn):
    """The degradation is changed at 2 s so that it begins, or fades, or is over at 2 s."""
    driver = driver_of(dataclasses.replace(SONAR, onset_s=1.0))
    driver.run_s(2)
    control = driver.environment.degradations
    control.change("degradation0", **changes)
    assert control.phase("degradation0") == phase
    assert events(driver, 1) == [
        (2.0, "sonar 0, stuck at 1m (degradation0 changed)"),
        (2.0, f"sonar 0, stuck at 1m (degradation0 {turn})"),
    ]


def test_a_change_and_a_removal_leave_what_the_others_remember():
    held = Degradation("robot0", "sonar", 0, stuck="hold")
    later = [dataclasses.replace(held, element=n, delay_s=1.0, stuck=None) for n in (1, 2)]
    driver = driver_of(held, *later, held)
    state = driver.state.degradation
    driver.run_s(2)
    parts = {name: memory(state, name) for name in ("degradation1", "degradation2")}
    driver.environment.degradations.change("degradation0", delay_s=3.0)
    for name, part in parts.items():
        assert np.array_equal(memory(state, name), part, equal_nan=True)
    driver.environment.degradations.remove("degradation1")
    assert np.array_equal(memory(state, "degradation2"), parts["degradation2"], equal_nan=True)
    assert [each.id[-1] for each in driver.environment.degradations.all()] == ["0", "2", "3"]


def memory(state, name: str) -> np.ndarray:
    begins = [*state.table["begin"].tolist(), len(state.memory)]
    place = state.table["id"].tolist().index(name)
    return state.memory[begins[place] : begins[place + 1]].copy()


@pytest.mark.parametrize(
    ("degradation", "why"),
    [
        (Degradation(7, "sonar", dead=True), "unknown robot '7'"),
        (Degradation("robot9", "sonar", dead=True), "unknown robot 'robot9'"),
        (Degradation("robot0", "radar", dead=True), "unknown device 'radar'"),
        (Degradation("robot0", "compass", dead=True), "the robot has no compass"),
        (Degradation("robot0", "sonar", -1, dead=True), "unknown element -1"),
        (Degradation("robot0", "sonar", gain=math.nan), "gain must be a number"),
        (Degradation("robot0", "sonar", bias=math.inf), "bias must be a number"),
        (Degradation("robot0", "sonar", stuck=math.nan), "or it must be a number"),
        (
            Degradation("robot0", "sonar", stuck="up"),
            "'hold', or it must be a number",
        ),
        (Degradation("robot0", "sonar", gain="2"), "gain must be a number"),
        (Degradation("robot0", "sonar", True, dead=True), "unknown element True"),
        (Degradation("robot0", "sonar", 0.5, dead=True), "unknown element 0.5"),
        (Degradation("robot0", "sonar", dead=True, duration_s=math.inf), "duration must be"),
        (Degradation("robot0", "sonar", delay_s=1e9), "delay must be"),
        (Degradation("robot0", "sonar", gain=10**400), "gain must be a number"),
        (Degradation("robot0", "sonar", gain=True), "gain must be a number"),
        (Degradation("robot0", "sonar", dead=1), "dead must be True or False"),
        (Degradation("robot0", ["sonar"], dead=True), "must be strings"),
        (Degradation("robot0", "sonar", dead=True, id=[1]), "must be a string"),
        (Degradation("robot0", "sonar", dead=True, id=5), "must be a string"),
        (Degradation("robot0", "sonar"), "no fault given"),
        (Degradation("robot0", "sonar", dead=True, id="x" * 65), "at most 64"),
        (Degradation("robot0", "sonar", dead=True, id="degradation0"), "duplicate degradation"),
    ],
)
def test_what_cannot_be_is_refused_and_changes_nothing(degradation, why):
    driver = driver_of(SONAR)
    before = driver.environment.hash()
    with pytest.raises(ValueError, match=why):
        driver.environment.degradations.add(degradation)
    assert driver.environment.hash() == before
    assert driver.run(1)[0].events[1:] == ()


def test_changes_of_what_cannot_change_are_refused():
    control = driver_of(SONAR).environment.degradations
    with pytest.raises(ValueError, match="cannot change device, robot"):
        control.change("degradation0", robot="robot1", device="laser")
    with pytest.raises(ValueError, match="unknown attribute of a degradation: colour"):
        control.change("degradation0", colour="red")
    with pytest.raises(ValueError, match="no fault given"):
        control.change("degradation0", stuck=None)
    for missing in (control.remove, control.change, control.phase):
        with pytest.raises(ValueError, match=r"unknown degradation 'x' \(known: degradation0"):
            missing("x")


def test_what_comes_out_is_plain_data():
    driver = driver_of(SONAR, Degradation("robot0", "drive", 1, gain=0.5, duration_s=2.0))
    for each in driver.environment.degradations.all():
        data = json.loads(json.dumps(dataclasses.asdict(each)))
        assert Degradation(**data) == each


FAULTS = (
    Degradation("robot0", "sonar", noise=0.3, dropouts=0.2, delay_s=0.5),
    Degradation("robot0", "sonar", 2, stuck="hold", onset_s=1.0, duration_s=1.0, recovery_s=2.0),
    Degradation("robot0", "drive", noise=0.1, delay_s=0.4, dropouts=0.1, onset_s=0.7),
    Degradation("robot0", "wheels", 0, gain=0.8, step=0.01),
    Degradation("robot0", "odometry", 1, stuck="hold", onset_s=1.5, duration_s=2.0),
    Degradation("robot1", "sonar", noise=0.3),
)


def drive_on(environment: Environment, cycles: int) -> list[str]:
    driver, hashes = Driver(environment), []
    for _ in range(cycles):
        cycle = environment.state.cycle
        if cycle % 10 == 0:
            driver.ask("VM", 100 - cycle, cycle)
        driver.ask("GS")
        driver.run(1)
        hashes.append(environment.hash())
    return hashes


def test_from_a_snapshot_all_goes_on_as_it_did():
    driver = driver_of(*FAULTS, robots=2)
    environment = driver.environment
    drive_on(environment, 25)
    snapshot = environment.snapshot()
    went = drive_on(environment, 40)
    environment.degradations.remove("degradation2")
    drive_on(environment, 5)
    environment.restore(snapshot)
    assert drive_on(environment, 40) == went
    fresh = driver_of(*FAULTS, robots=2).environment
    fresh.restore(snapshot)
    assert drive_on(fresh, 40) == went


def test_the_same_seed_gives_the_same_faults_and_another_one_others():
    runs = []
    for seed in (1, 1, 2):
        driver = Driver.of(world_with(*FAULTS, robots=2), seed)
        drive_on(driver.environment, 30)
        runs.append(driver.environment.hash())
    assert runs[0] == runs[1] != runs[2]


def test_what_is_wrong_with_one_robot_changes_nothing_for_another():
    def of_robot_1(*degradations: Degradation) -> list[list[int]]:
        driver, rows = driver_of(*degradations, robots=2), []
        for cycle in range(60):
            driver.ask("VM", 100, cycle, robot=0)
            driver.ask("VM", 100, 50, robot=1)
            rows.append(driver.ask("GS", robot=1).tolist())
            driver.run(1)
        return rows

    mine = [each for each in FAULTS if each.robot == "robot1"]
    assert of_robot_1(*FAULTS) == of_robot_1(*mine)


def test_what_comes_later_does_not_change_the_noise_of_what_was_there():
    alone, other = driver_of(FAULTS[0]), driver_of(FAULTS[0])
    seen: tuple[list[int], list[int]] = ([], [])
    for cycle in range(60):
        if cycle == 10:
            other.environment.degradations.add(Degradation("robot0", "bumper", noise=0.1))
        for driver, rows in zip((alone, other), seen, strict=True):
            rows.append(told(driver))
            driver.run(1)
    assert seen[0] == seen[1]
