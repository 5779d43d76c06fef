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


def test_the_oldest_rounds_are_dropped_at_the_memory_limit() -> None:
    fleet = Fleet([counting_program()] * 2)
    input_log = InputLog(most_bytes=800)
    for timestep in range(4):
        input_log.note(Position(timestep, 0), np.array([10, 0]), fleet)
        input_log.end(timestep, 1)
    assert not input_log.knows(Position(0, 0), Position(4, 0))
    assert input_log.knows(Position(2, 0), Position(4, 0))
    input_log.forget(Position(3, 0))
    assert input_log.knows(Position(2, 0), Position(3, 0))
    assert not input_log.knows(Position(2, 0), Position(4, 0))
