"""The request queue as text."""

from __future__ import annotations

from pathlib import Path

from crs_cc.session import trace as trace_module
from crs_cc.session.session import Session
from crs_cc.session.trace import Trace
from crs_cc.sim.world_xml import empty_world
from tests.session.programs import build

SOURCE = """
#include "Nclient.h"
int main(void) { connect_robot(1); pr(100, 50, 0); ws(1, 1, 0, 20); get_sn(); return 0; }
"""


def test_each_timestep_says_command_slice_and_answers(tmp_path: Path) -> None:
    rows: list[str] = []
    trace = Trace(rows.append, ["scout"])
    session = Session(empty_world(), [build(tmp_path, SOURCE)], trace=trace)
    while session.step():
        pass
    assert len(rows) == session.timesteps
    assert rows[0].startswith("0.000 scout  PR 1/")
    assert "PR(100,50,0) @0.0" in rows[0]
    moving = [row for row in rows if " PR " in row]
    assert all("of 0.2540,0.1270 m" in row for row in moving)
    assert "waits" in moving[3]
    assert "WS(1,1,0,20) @" in " ".join(rows)
    assert "done 0.2540,0.1270 of" in moving[-1]
    assert "sonar_in=255,255" in " ".join(rows[-2:])


EXAMPLE = """
#include <unistd.h>
#include "Nclient.h"
int main(void) { connect_robot(1); vm(100, 100, 0); usleep(200000); get_rc(); return 0; }
"""


def test_the_example_of_the_module_is_a_real_line(tmp_path: Path) -> None:
    rows: list[str] = []
    trace = Trace(rows.append, ["robot0"])
    session = Session(empty_world(), [build(tmp_path, EXAMPLE)], trace=trace)
    while session.step():
        pass
    assert trace_module.__doc__
    assert f"    {rows[-1]}\n" in trace_module.__doc__
