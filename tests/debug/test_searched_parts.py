"""On the way back only what may have a reason to stop is run again, and it finds the same."""

from __future__ import annotations

import random

import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.debug.timeline.history import INTERVAL
from crs_cc.debug.timeline.passed_sites import STRETCH, PassedSites
from crs_cc.debug.timeline.position import Position
from tests.debug.debuggers import debugger_of

DRIVE = """\
#include <stdlib.h>
#include "Nclient.h"
static int turns, seldom;
static int often(int n) { return n + 1; }
static void now_and_then(void) { seldom++; }
int main(void)
{
    connect_robot(1);
    for (;;) {
        gs();
        turns = often(turns);
        if (turns % (40 + 7 * (State[STATE_CONF_X] & 1)) == 0)
            now_and_then();
        vm(150, 20, 0);
        if (turns == END)
            exit(0);
    }
}
"""


@pytest.fixture(name="debugger")
def debugger_() -> Debugger:
    sources = [f"#define END {end}\n{DRIVE}" for end in (0, 170)]
    return debugger_of(*sources, world="pair.xml")


def stops_back(debugger: Debugger, most: int = 4) -> list[tuple[Position, str, str]]:
    """Go back so many times; return where and why it stopped."""
    stops = [debugger.resume(backward=True) for _ in range(most)]
    return [(each.position, each.reason, each.text) for each in stops]


def rounds_of(debugger: Debugger, monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Return a list to which the timestep of each round is added in which programs run."""
    session, timesteps = debugger.session, list[int]()
    run = session.run_programs

    def counted() -> None:
        timesteps.append(session.timesteps)
        run()

    monkeypatch.setattr(session, "run_programs", counted)
    return timesteps


@pytest.mark.parametrize("seed", range(4))
def test_what_is_known_of_the_past_changes_no_stop(
    debugger: Debugger, seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    chance, points = random.Random(seed), debugger.stop_points
    points.add_breakpoint("now_and_then", robot=chance.choice([None, 0, 1]))
    places = [lambda: points.add_catchpoint("exit"), lambda: points.add_breakpoint("vm", robot=1)]
    places += [lambda: points.add_breakpoint("often", condition="n % 50 == 3")]
    places += [lambda: points.add_watchpoint("seldom", robot=0)]
    chance.choice(places)()
    for _ in range(3):  # forward with stops, steps and jumps: some stretches are known
        debugger.resume()
        debugger.step()
    debugger.goto_timestep(12 * STRETCH + chance.randint(0, 20))
    debugger.edit_world("turn robot0 to 90")
    debugger.goto_timestep(16 * STRETCH + chance.randint(0, 20))
    for _ in range(4):
        debugger.goto_timestep(chance.randint(0, 17 * STRETCH))
        start = debugger.position
        known = stops_back(debugger)
        with monkeypatch.context() as without:
            without.setattr(PassedSites, "passed", lambda *_: None)
            debugger.goto(start)
            assert stops_back(debugger) == known


def test_only_the_stretch_of_the_last_hit_is_run_again(
    debugger: Debugger, monkeypatch: pytest.MonkeyPatch
) -> None:
    debugger.goto_timestep(19 * STRETCH)
    debugger.stop_points.add_breakpoint("now_and_then")
    rounds = rounds_of(debugger, monkeypatch)
    hit = debugger.resume(backward=True).position.timestep
    assert 1 < hit // STRETCH < 18
    assert {each // STRETCH for each in rounds} <= {hit // STRETCH, hit // STRETCH - 1}
    assert hit - min(rounds) < STRETCH + INTERVAL


def test_where_no_program_was_no_program_runs_again(
    debugger: Debugger, monkeypatch: pytest.MonkeyPatch
) -> None:
    debugger.goto_timestep(12 * STRETCH)
    debugger.stop_points.add_breakpoint("main", robot=0, condition="turns > 0")
    rounds = rounds_of(debugger, monkeypatch)
    assert debugger.resume(backward=True).reason == "beginning"
    assert set(rounds) <= set(range(STRETCH))


def test_stretches_in_which_a_program_was_stepping_are_not_known(debugger: Debugger) -> None:
    passed, sites = debugger.run.passed_sites, {0: [0]}
    debugger.goto_timestep(STRETCH + 3)
    debugger.step()
    debugger.goto_timestep(4 * STRETCH)
    known = [passed.passed(each * STRETCH, sites) is not None for each in range(4)]
    assert known == [True, False, True, True]
    debugger.goto_timestep(2 * STRETCH + 1)
    debugger.edit_world("turn robot0 to 90")
    known = [passed.passed(each * STRETCH, sites) is not None for each in range(4)]
    assert known == [True, False, False, False]


def test_the_oldest_stretches_are_forgotten_first(debugger: Debugger) -> None:
    passed = PassedSites(1500)
    fleet, sites = debugger.session.fleet, [10, 10]
    for timestep in range(0, 10 * STRETCH, STRETCH):
        passed.begin_stretch(timestep, fleet, sites)
    known = [passed.passed(each * STRETCH, {0: [0]}) is not None for each in range(10)]
    assert known == [False] * 6 + [True] * 3 + [False]
