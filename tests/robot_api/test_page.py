"""Writes `docs/robot-api.md` from the table of the vendor's API and the report's beside it.

`--update-goldens` rewrites the page.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

import crs_cc.sim
from crs_cc.requests import CODES
from crs_cc.robot_api import (
    CONSTANTS,
    GROUPS,
    MACROS,
    SMASK,
    SOURCES,
    STATE,
    TYPES,
    VARIABLES,
    Function,
    Name,
)  # fmt: skip
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import empty_world
from tests.robot_api.dialects import section

PAGE = Path(__file__).parents[2] / "docs" / "robot-api.md"
ROBOTS = Path(crs_cc.sim.__file__).parent / "files" / "robots"

INTRODUCTION = """\
<!-- made by tests/robot_api/test_page.py of crs_cc/robot_api; edit there,
     then pytest --update-goldens -->

# The robot's API

A control program for a Nomadic robot includes `Nclient.h` and calls the functions below. They are
the vendor's, of 1999, written anew in C (`crs_cc/runtime/lib/robot`). The vendor had two libraries
of the same functions: Nclient for his simulator, and Ndirect for a robot on a serial line.
`--client ndirect` chooses the second.

**Units.** Lengths are in 0.1 inch, angles in 0.1 degree, counter-clockwise; sonars in inches. On a
Scout the first axis ("trans") is the right wheel, the second ("steer") the left wheel, and the
third means nothing; a Nomad 200 or 150 translates, steers, and turns its turret.

**Results.** A function gives TRUE (1), or FALSE (0) when it was not done, unless the table says
otherwise. Without a connection it prints `Not connected to any robot` and gives FALSE. What a
robot refuses gives FALSE and sets State[STATE_ERROR] to 1; under Ndirect `Nak` is printed, and the
command gives TRUE. Under Ndirect State[STATE_ERROR] is never set, and numbers with a sign go
through sixteen bits of sign and magnitude: 40000 arrives as -7232.

**State** is refreshed where the table says *State* by all that the reply tells, as far as the mask
in use lets it through; a `get_` function refreshes its own part whatever the mask. A loop without
any call reads what it read before.

**Time.** A call takes the time of its bytes on the serial line, one to the simulator that of the
network, 1 ms; the table has it for a Scout at 38400 baud. Calls that change the world come back
when the timestep ends. `--link ideal` takes the line away: a call then costs 20 microseconds of the
host computer, so that a loop without a pause asks 50,000 times a second, and the simulation is
slow; let it sleep. Calls do not wait for what they start, but for those that say so.

**Robots.** A robot is a Scout unless the world file (`definition="nomad200"`) or `--robot nomad200`
says otherwise, whatever model the program passes to `connect_robot`. `--setup noisy`, or `setup=`
in the world, gives sensors and odometry their errors; without, they have none.

**Own definitions.** A program's own `State`, `RIGHT`, `LEFT`, `scout_vm`, `ROTATION_CONSTANT` take
the place of the header's. `scout_pr(trans, steer)`, `scout_ws(seconds)` and `sonarSensorCheck()`
(`get_sn` by another name), which programs for the Scout used to define, are there for those that do
not. Programs without any header link too.

"""

PARAMETERS = (
    ("scout", "body", "mass", "mass"),
    ("scout", "drive", "acceleration-limit", "fastest change of a wheel's speed"),
    ("scout", "drive", "speed", "speed of `pr` before `sp`"),
    ("scout", "drive", "acceleration", "acceleration before `ac`"),
    ("scout", "drive", "timeout", "timeout before `conf_tm`, 0 for never"),
    ("scout", "drive", "force", "force of the motors; they stall against more"),
    ("scout", "drive", "grip", "force that makes the wheels slip"),
    ("scout", "drive", "roll-out", "how limp wheels slow down"),
    ("scout", "drive", "give-up", "stalled motors give up after so long, 0 for never"),
    ("scout", "drive", "ws-timeout-zero", "what `ws` does with a timeout of 0"),
    ("scout", "odometry", "resolution", "way of a wheel for a count of its encoder"),
    ("scout", "bumpers/ring", "switches", "switches of the bumper: switch n is bit n, 0 ahead"),
    ("scout", "heat", "range", "range of the report's heat sensor"),
    ("scout", "computer-battery", "capacity", "energy in the computers' battery"),
    ("scout", "computer-battery", "power", "what the computers use"),
    ("scout", "motor-battery", "capacity", "energy in the motors' battery"),
    ("scout", "motor-battery", "curve", "its voltages from empty to full"),
    ("scout", "motor-battery", "friction", "what a wheel works against"),
    ("scout", "motor-battery", "efficiency", "share of the energy that moves the robot"),
    ("scout", "motor-battery", "stall", "what is used besides while the robot is held back"),
    ("scout", "motor-battery", "cutoff", "voltage below which the motors have no force"),
    ("scout", "motor-battery", "in-status", "whether the motors' status tells the charge"),
    ("scout", "host", "speed", "instructions a second of the host computer"),
    ("nomad200", "body", "mass", "mass"),
    ("nomad200", "drive", "speed", "speed of `pr` before `sp`"),
    ("nomad200", "drive", "force", "force of the motors"),
    ("nomad200", "drive", "grip", "force that makes the wheels slip"),
    ("nomad200", "drive/steering", "speed", "the same of the steering"),
    ("nomad200", "drive/turret", "speed", "and of the turret"),
    ("nomad200", "infrared", "step", "what a reading of 1 stands for"),
    ("nomad200", "infrared", "reflectance", "how much light surfaces reflect"),
    ("nomad200", "infrared", "half-angle", "half the infrared sensors' beam"),
    ("nomad200", "infrared", "rate", "readings a second"),
    ("nomad200", "laser", "field-of-view", "what the laser sees"),
    ("nomad200", "laser", "range", "how far"),
    ("nomad200", "laser", "forward", "where it sits, ahead of the turret's middle"),
    ("nomad200", "compass", "offset", "what it shows of the world's x axis"),
)
"""Attributes of robot definitions whose values nothing tells: definition, element, attribute."""


def cell(text: str) -> str:
    """Gives text that does not end a table's cell."""
    return text.replace("|", "\\|") or "-"


def link_ms(function: Function) -> str:
    """Gives how long a function's requests take on a Scout's line."""
    environment = Environment(empty_world(), 0)
    ms = sum(environment.link_s(CODES[name]) for name in function.posts) * 1000
    return f"{ms:.1f}" if ms else "-"


def functions() -> Iterator[str]:
    """Gives a table for each group of functions."""
    yield "## Functions\n"
    for group in GROUPS:
        yield f"### {group.title}\n"
        yield "| function | units | does | refreshes | ms | under Ndirect | source |"
        yield "| --- | --- | --- | --- | --- | --- | --- |"
        for each in group.functions:
            does = f"{each.does}; waits {each.waits}" if each.waits else each.does
            columns = (
                f"`{each.prototype}`", each.units, does, each.refreshes, link_ms(each),
                each.under_ndirect or "the same", ", ".join(each.source),
            )  # fmt: skip
            yield f"| {' | '.join(map(cell, columns))} |"
        yield ""


def names() -> Iterator[str]:
    """Gives the tables of everything else."""
    for title, rows in (
        ("State", STATE), ("Smask", SMASK), ("Constants", CONSTANTS), ("Macros", MACROS),
        ("Variables", VARIABLES), ("Types", TYPES),
    ):  # fmt: skip
        yield f"## {title}\n"
        yield "| name | value | meaning |" if rows is not VARIABLES else "| name | type | meaning |"
        yield "| --- | --- | --- |"
        yield from (name_row(row) for row in rows)
        yield ""


def name_row(row: Name) -> str:
    """Gives a line of a table of names."""
    return f"| `{row.name}` | {cell(row.value)} | {cell(row.meaning)} |"


def parameter(definition: str, element: str, attribute: str) -> str | None:
    """Gives an attribute of a robot definition."""
    found = ET.parse(ROBOTS / f"{definition}.xml").getroot().find(element)
    return None if found is None else found.get(attribute)


def chosen() -> Iterator[str]:
    """Gives what we chose."""
    yield "## Chosen by us\n"
    yield "Where nothing tells what the vendor's library or robot did:\n"
    for group in GROUPS:
        for each in group.functions:
            if each.chosen:
                yield f"- `{each.name}`: {each.chosen}"
    yield ""
    yield (
        "Numbers that nothing tells are in the robot definitions (`crs_cc/sim/files/robots`), each"
        " with its reason, to be changed by a definition of one's own:\n"
    )
    yield "| robot | parameter | value | what it is |"
    yield "| --- | --- | --- | --- |"
    for definition, element, attribute, meaning in PARAMETERS:
        value = parameter(definition, element, attribute)
        yield f"| {definition} | `<{element} {attribute}>` | {value} | {meaning} |"
    yield ""
    yield "## Sources\n"
    yield from (f"- *{tag}*: {source}" for tag, source in SOURCES.items())


def page() -> str:
    """Gives the text of the page."""
    parts = [*functions(), *names(), *section(), "", *chosen()]
    return INTRODUCTION + "\n".join(parts).rstrip("\n") + "\n"


def test_the_page_of_the_api_is_up_to_date(check_golden: Callable[[Path, bytes], None]) -> None:
    check_golden(PAGE, page().encode())


@pytest.mark.parametrize("row", PARAMETERS, ids=lambda row: f"{row[0]}-{row[1]}-{row[2]}")
def test_every_parameter_is_in_its_definition(row: tuple[str, str, str, str]) -> None:
    assert parameter(*row[:3]) is not None
