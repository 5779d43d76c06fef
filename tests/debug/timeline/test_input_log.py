"""Programs that run again without the world do what they did."""

from __future__ import annotations

import numpy as np
import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.debug.timeline.input_log import InputLog, RoundInput
from crs_cc.debug.timeline.position import Position
from crs_cc.requests import MESSAGE
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.testing import counting_program
from tests.debug.debuggers import ROOT, debugger_at

PLATOON = ROOT / "samples" / "scout_c" / "platoon.c"


def hits_back(debugger: Debugger) -> list[tuple[Position, int, float]]:
    found = []
    while (stop := debugger.resume(backward=True)).reason == "breakpoint":
        found.append((stop.position, stop.robot, stop.time_s))
    return found


def test_replay_without_the_world_finds_the_same() -> None:
    debugger = debugger_at([PLATOON], "platoon.xml")
    debugger.stop_points.add_breakpoint("crs_receive")
    debugger.stop_points.add_breakpoint("follow", robot=2)
    debugger.goto_timestep(12)
    end = debugger.position
    without = hits_back(debugger)
    debugger.goto(end)
    debugger.run.input_log = InputLog()
    assert hits_back(debugger) == without
    assert len(without) > 5


def noted(input_log: InputLog, timesteps: range) -> None:
    """Note a round of one of two programs for each timestep."""
    fleet = Fleet([counting_program()] * 2)
    for timestep in timesteps:
        clock_s = np.array([0.1 * timestep, 0.0])
        input_log.record_round(Position(timestep, 0), np.array([10 + timestep, 0]), clock_s, fleet)
        input_log.end(timestep, 1)


def test_the_oldest_rounds_are_dropped_at_the_memory_limit() -> None:
    input_log = InputLog(most_bytes=8000)
    noted(input_log, range(3000))
    assert not input_log.covers(Position(0, 0), Position(3000, 0))
    assert input_log.covers(Position(2500, 0), Position(3000, 0))
    input_log.truncate(Position(2600, 0))
    assert input_log.covers(Position(2500, 0), Position(2600, 0))
    assert not input_log.covers(Position(2500, 0), Position(2601, 0))


def test_rounds_are_given_as_they_were_noted_wherever_they_are() -> None:
    input_log = InputLog()
    noted(input_log, range(1000, 2000))
    noted(input_log, range(500))
    noted(input_log, range(400, 700))  # in part known, and then up to where it is not
    assert input_log.covers(Position(0, 0), Position(700, 0))
    assert not input_log.covers(Position(0, 0), Position(701, 0))
    assert input_log.covers(Position(1000, 0), Position(2000, 0))
    fleet = Fleet([counting_program()] * 2)
    for timestep in (0, 450, 699, 1000, 1999):
        found = input_log.round_at(Position(timestep, 0))
        assert found is not None
        clock_s, pending = np.array([0.0, 5.0]), np.array([0, 7])
        found.feed(fleet, clock_s, pending, None)
        assert found.robots.tolist() == [0]
        assert clock_s.tolist() == [0.1 * timestep, 5.0]
        assert pending.tolist() == [10 + timestep, 0]
        assert fleet.slots["fuel"][0] == 10 + timestep


@pytest.mark.parametrize("chosen", [[], [5], [0, 19], list(range(0, 20, 3)), list(range(20))])
def test_a_part_of_the_programs_is_given_what_it_had(chosen: list[int]) -> None:
    random, fleet = np.random.default_rng(3), Fleet([counting_program()] * 20)
    robots = np.array([0, 1, 2, 5, 6, 9, 12, 18, 19])
    given = random.integers(-2, 3, (len(robots), MESSAGE.itemsize)).clip(0).astype(np.uint8)
    fleet.reply(robots, given.view(MESSAGE).reshape(-1))
    pending, clock_s = np.zeros(20, np.int64), random.random(20)
    pending[robots] = random.integers(1, 99, len(robots))
    round_ = RoundInput.of(pending, clock_s, fleet)
    which, again_s, fuel = np.isin(np.arange(20), chosen), np.zeros(20), np.full(20, 7)
    other = Fleet([counting_program()] * 20)
    ran = round_.feed(other, again_s, fuel, which)
    assert ran.tolist() == [each for each in robots.tolist() if each in chosen]
    assert other.messages(ran).tobytes() == fleet.messages(ran).tobytes()
    assert fuel.tolist() == np.where(which, pending, 0).tolist()
    assert again_s[ran].tolist() == clock_s[ran].tolist()
    assert other.slots["run"].nonzero()[0].tolist() == ran.tolist()
