"""Programs in the dialect of the CRS report, whose functions have names of their own in the IR."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.debug.engine import Debugger
from crs_cc.debug.program import DebugProgram
from crs_cc.debug.world.state_rows import vendor_state_rows
from crs_cc.requests import REQUESTS
from crs_cc.session.build import build_executable
from crs_cc.session.library import library_options
from crs_cc.sim.files.world_xml import empty_world, load_world

ROOT = Path(__file__).parents[2]
TABLE_2 = ROOT / "samples" / "scout_c" / "report_table2.c"


@pytest.fixture(scope="module")
def program() -> DebugProgram:
    executable = build_executable([TABLE_2], Diagnostics(), dialect="report", debug=True)
    return DebugProgram(executable, [TABLE_2], replace(library_options(), dialect="report"))


@pytest.mark.parametrize("name", ["vm", "sonarSensorCheck"])
def test_breakpoints_on_functions_of_the_report_dialect(program, name) -> None:
    debugger = Debugger(load_world(ROOT / "worlds" / "stove.xml"), [program])
    debugger.start()
    debugger.stop_points.add_breakpoint(name)
    stop = debugger.resume()
    assert stop.breakpoints == (1,)
    place = debugger.view.location()
    assert place is not None
    assert name in TABLE_2.read_text().splitlines()[place.line - 1]
    assert not any(frame.function.startswith("__report") for frame in debugger.view.frames())


def test_a_function_breakpoint_stops_at_its_own_requests_only(tmp_path: Path) -> None:
    """The first command greets the robot before it; that is no call of the command."""
    source = tmp_path / "two.c"
    source.write_text('#include "Nclient.h"\nint main(void)\n{\n    vm(10);\n    vm(20);\n}\n')
    executable = build_executable([source], Diagnostics(), dialect="report", debug=True)
    options = replace(library_options(), dialect="report")
    debugger = Debugger(empty_world(), [DebugProgram(executable, [source], options)])
    debugger.stop_points.add_breakpoint("vm")
    posted = []
    while debugger.resume().reason == "breakpoint":
        location = debugger.view.location()
        assert location is not None
        code = int(debugger.session.fleet.slots["code"][0])
        posted.append((location.line, REQUESTS[code].name))
    assert posted == [(4, "VM"), (5, "VM")]


def test_state_has_the_units_of_the_report_dialect(program) -> None:
    debugger = Debugger(load_world(ROOT / "worlds" / "stove.xml"), [program])
    debugger.resume()
    rows = {row.name.split()[1]: row.text for row in vendor_state_rows(debugger.view, 0)}
    assert rows["STATE_HEAT"] == "1"
    assert rows["STATE_SONAR_2"] == "no echo"
    assert rows["STATE_SONAR_0"].split()[1] == "0.1in"
