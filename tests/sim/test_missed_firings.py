"""Firings executed at once, long after their time, are those that would have been in turn."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crs_cc.sim.devices.sonar import SonarRing
from crs_cc.sim.devices.sonar.state import sonar_state
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.model.world import WorldModel
from tests.sim.driver import Driver, world_of

BOX = '<box x="4m" y="4.5m" length="0.7m" width="0.4m" heading="20deg"/>'
WORLDS = {
    setup: world_of(
        BOX
        + f'<robot x="2m" y="4m" {attributes}/>'
        + f'<robot x="5m" y="5m" heading="190deg" {attributes}/>'
        + '<robot x="7m" y="2m" heading="77deg"/>'
    )
    for setup, attributes in {
        "ideal": "",
        "noisy": 'setup="noisy"',
        "pioneer": 'definition="pioneer2dx" setup="noisy"',
    }.items()
}
EARTH = world_of('<robot x="5m" y="5m"/>', 'length="60m" width="60m"')


def ring_of(driver: Driver) -> SonarRing:
    return driver.environment._data.devices.sonars


def advance(driver: Driver, to_s: float, *, at_once: bool) -> str:
    """Advance the sonars alone, and return the hash of the state."""
    data = driver.environment._data
    rows = np.arange(len(data.world.robots))
    ring = data.devices.sonars
    until_s = np.full(len(rows), to_s)
    do = ring.catch_up if at_once else ring.advance
    do(data.state, data.constants, data.rays, rows, until_s)
    if not at_once:  # which turns the axes, too
        data.state.drive.clock_s[:] = 0.0
    return driver.environment.hash()


@settings(max_examples=30, deadline=None)
@given(
    name=st.sampled_from(sorted(WORLDS)),
    rate=st.integers(0, 60),
    order=st.lists(st.integers(0, 15), max_size=16, unique=True),
    times_s=st.lists(st.floats(0.0, 8.0), min_size=1, max_size=4).map(sorted),
)
def test_firings_at_once_are_the_firings_in_turn(
    name: str, rate: int, order: list[int], times_s: list[float]
) -> None:
    world: WorldModel = WORLDS[name]
    in_turn, at_once = (Driver(Environment(world, 3)) for _ in range(2))
    for driver in (in_turn, at_once):
        for robot in range(3):
            driver.ask("CONNECT", robot=robot)
        present = set(np.flatnonzero(ring_of(driver)._has[0]).tolist())
        chosen = [sonar for sonar in order if sonar in present]
        driver.post("CONF_SN", rate, data=bytes(chosen))
        driver.state.drive.clock_s[:] = 0.0
    for time_s in times_s:
        assert advance(in_turn, time_s, at_once=False) == advance(at_once, time_s, at_once=True)


@pytest.mark.parametrize("rate", [1, 15, 16])
def test_timeouts_that_the_next_firing_cuts_off_are_the_same(rate: int) -> None:
    """Whether such a timeout counts depends on the last bit of the times."""
    in_turn, at_once = (Driver.of(EARTH) for _ in range(2))
    for driver in (in_turn, at_once):
        driver.post("CONF_SN", rate, data=bytes([1, 5, 9]))
        driver.state.drive.clock_s[:] = 0.0
    for time_s in (0.3, 7.77, 7.78, 50.0):
        assert advance(in_turn, time_s, at_once=False) == advance(at_once, time_s, at_once=True)


def test_long_quiet_time_costs_a_round_of_firings(monkeypatch: pytest.MonkeyPatch) -> None:
    driver, fired = Driver.of(WORLDS["noisy"]), []
    echoes = SonarRing._echoes

    def counting(self, state, constants, rays, firings):
        fired.append(len(firings.rows))
        return echoes(self, state, constants, rays, firings)

    monkeypatch.setattr(SonarRing, "_echoes", counting)
    advance(driver, 3600.0, at_once=True)
    assert sonar_state(driver.state).count.min() > 30_000
    assert sum(fired) <= 3 * 2 * 16 * 2
