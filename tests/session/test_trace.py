"""The request queue as text."""

from __future__ import annotations

import re
from pathlib import Path

from crs_cc.session import trace as trace_module
from crs_cc.session.session import Session
from crs_cc.session.trace import Trace
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files import world_xml
from crs_cc.sim.files.world_xml import empty_world, load_world
from crs_cc.sim.state.events import Event
from tests.session.programs import build

ROBOTS = Path(world_xml.__file__).parents[0] / "robots"

SOURCE = """
#include "Nclient.h"
int main(void) { connect_robot(1); pr(100, 50, 0); ws(1, 1, 0, 20); get_sn(); return 0; }
"""


def test_a_trace_line_shows_command_slice_and_replies(tmp_path: Path) -> None:
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


def test_the_example_in_the_module_is_a_real_line(tmp_path: Path) -> None:
    rows: list[str] = []
    trace = Trace(rows.append, ["robot0"])
    session = Session(empty_world(), [build(tmp_path, EXAMPLE)], trace=trace)
    while session.step():
        pass
    assert trace_module.__doc__
    assert f"    {rows[-1]}\n" in trace_module.__doc__


ASKING = """
#include "Nclient.h"
#include "crs.h"
int main(void) { int x, y; crs_gps(&x, &y); connect_robot(1); get_sn(); return 0; }
"""


def test_device_replies_and_events_are_traced(tmp_path: Path) -> None:
    rows: list[str] = []
    (tmp_path / "own.xml").write_text(
        (ROBOTS / "scout.xml").read_text().replace("<computer-b", "<gps/><computer-b", 1)
    )
    (tmp_path / "world.xml").write_text(
        '<world version="1"><area length="9m" width="9m"/>'
        '<robot id="scout" definition="own.xml" x="100in" y="50in"/>'
        '<degradation robot="scout" device="gps" element="x" bias="1in" id="late"/>'
        '<degradation robot="scout" device="bumper" dead="yes" onset="20ms" duration="5ms"/>'
        "</world>"
    )
    trace = Trace(rows.append, ["scout"])
    world = load_world(tmp_path / "world.xml")
    session = Session(world, [build(tmp_path, ASKING)], trace=trace)
    session.step()
    assert re.search(r"GPS\(\) @0\.0\d\d reply=1010,500  ", rows[0])
    assert rows[1:] == [
        "0.000 scout  degradation: gps x, bias 0.0254m (late began)",
        "0.020 scout  degradation: bumper, dead (degradation1 began)",
        "0.025 scout  degradation: bumper, dead (degradation1 ended)",
    ]


def test_an_event_is_one_line_whatever_its_text() -> None:
    rows: list[str] = []
    step = Environment(empty_world(), seed=1).step()
    events = (Event(0.04, "message", "sent \n\x1b[2J", -1), Event(0.01, "light", "on", 0))
    Trace(rows.append, ["scout"]).step(step._replace(events=events))
    assert rows[1:] == ["0.010 scout  light: on", "0.040 -      message: sent \\n\\x1b[2J"]
