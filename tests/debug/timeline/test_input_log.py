"""Programs that run again without the world do what they did."""

from __future__ import annotations

import numpy as np

from crs_cc.debug.engine import Debugger
from crs_cc.debug.timeline.input_log import InputLog
from crs_cc.debug.timeline.position import Position
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
        input_log.note(Position(timestep, 0), np.array([10 + timestep, 0]), clock_s, fleet)
        input_log.end(timestep, 1)


def test_the_oldest_rounds_are_dropped_at_the_memory_limit() -> None:
    input_log = InputLog(most_bytes=8000)
    noted(input_log, range(3000))
    assert not input_log.knows(Position(0, 0), Position(3000, 0))
    assert input_log.knows(Position(2500, 0), Position(3000, 0))
    input_log.forget(Position(2600, 0))
    assert input_log.knows(Position(2500, 0), Position(2600, 0))
    assert not input_log.knows(Position(2500, 0), Position(2601, 0))


def test_rounds_are_given_as_they_were_noted_wherever_they_are() -> None:
    input_log = InputLog()
    noted(input_log, range(1000, 2000))
    noted(input_log, range(500))
    noted(input_log, range(400, 700))  # in part known, and then up to where it is not
    assert input_log.knows(Position(0, 0), Position(700, 0))
    assert not input_log.knows(Position(0, 0), Position(701, 0))
    assert input_log.knows(Position(1000, 0), Position(2000, 0))
    fleet = Fleet([counting_program()] * 2)
    for timestep in (0, 450, 699, 1000, 1999):
        found = input_log.round_at(Position(timestep, 0))
        assert found is not None
        clock_s, pending = np.array([0.0, 5.0]), np.array([0, 7])
        found.give(fleet, clock_s, pending)
        assert found.robots.tolist() == [0]
        assert clock_s.tolist() == [0.1 * timestep, 5.0]
        assert pending.tolist() == [10 + timestep, 0]
        assert fleet.slots["fuel"][0] == 10 + timestep
