"""Samples of robots over time."""

from __future__ import annotations

import numpy as np
import pytest

from crs_cc.sim.engine.environment import Environment
from crs_cc.workbench.quantities import QUANTITIES, unit_of
from crs_cc.workbench.trace import Trace, thinned
from tests.sim.driver import open_world


@pytest.fixture
def environment() -> Environment:
    return Environment(open_world(), seed=1)


def drive(environment: Environment, trace: Trace, timesteps: int) -> None:
    environment.drive(np.array([0]), np.array([[0.3, 0.1, 0.0]]))
    trace.add(environment)
    for _ in range(timesteps):
        environment.step()
        trace.add(environment)


def test_samples_are_the_quantities_of_each_timestep(environment: Environment) -> None:
    trace = Trace()
    drive(environment, trace, 30)
    for name in ("pose.x", "pose.heading", "speed", "turn"):
        times_s, values = trace.samples(0, name, 0.0, 10.0, 1000) or ([], [])
        assert times_s[-1] == pytest.approx(environment.time_s)
        assert len(times_s) == 31
        assert values[-1] == pytest.approx(QUANTITIES[name].of(environment, 0), abs=1e-4)
    assert trace.samples(0, "i", 0.0, 10.0, 1000) is None
    assert [unit_of(environment, 0, name) for name in ("speed", "sonar.3", "i")] == ["m/s", "m", ""]


def test_continuing_after_a_change_discards_later_data(environment: Environment) -> None:
    trace = Trace()
    before = environment.snapshot()
    drive(environment, trace, 10)
    trace.truncate(environment.timestep_s * 3.5)
    assert len((trace.samples(0, "speed", 0.0, 10.0, 100) or ([], []))[0]) == 4
    environment.restore(before)
    drive(environment, trace, 10)
    assert len((trace.samples(0, "speed", 0.0, 10.0, 100) or ([], []))[0]) == 11


def test_old_samples_are_thinned_within_the_bound(environment: Environment) -> None:
    trace = Trace(most_numbers=400)
    drive(environment, trace, 100)
    times_s, _ = trace.samples(0, "speed", 0.0, 100.0, 1000) or ([], [])
    assert len(times_s) * 21 <= 400
    assert times_s[0] == 0.0
    assert times_s[-1] == pytest.approx(environment.time_s)


def test_a_short_dip_is_kept_when_samples_are_thinned() -> None:
    values = np.ones(10_000)
    values[5_003] = 0.1
    times_s, found = thinned(np.arange(10_000.0).tolist(), values, 100)
    assert len(found) <= 100
    assert 0.1 in found
    assert times_s[found.index(0.1)] == 5_003.0
