"""Tables of `docs/robot-api.md`, from the tables of the vendor's API and the report's dialect."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Final
from xml.etree import ElementTree as ET

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
)
from crs_cc.robot_api.report import CHOICES, COMMANDS, REPORT_STATE
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import empty_world
from docs.generate import Fillers, cell, table

ROBOTS: Final = Path(crs_cc.sim.__file__).parent / "files" / "robots"


def functions() -> str:
    """Return a section with a table for each group of functions."""
    titles = ("function", "units", "description", "updates", "ms", "under Ndirect", "source")
    return "\n\n".join(
        f"### {group.title}\n\n{table(titles, [_function(each) for each in group.functions])}"
        for group in GROUPS
    )


def _function(each: Function) -> tuple[str, ...]:
    does = f"{each.does}; waits {each.waits}" if each.waits else each.does
    columns = (
        f"`{each.prototype}`",
        each.units,
        does,
        each.refreshes,
        _link_ms(each),
        each.under_ndirect or "the same",
        ", ".join(each.source),
    )
    return tuple(cell(column) or "-" for column in columns)


@cache
def _environment() -> Environment:
    return Environment(empty_world(), 0)


def _link_ms(function: Function) -> str:
    """Return how long a function's requests take on a Scout's serial line."""
    ms = sum(_environment().link_s(CODES[name]) for name in function.posts) * 1000
    return f"{ms:.1f}" if ms else "-"


def names() -> str:
    """Return a section with a table for each kind of name that is no function."""
    groups = {
        "State": STATE, "Smask": SMASK, "Constants": CONSTANTS, "Macros": MACROS,
        "Variables": VARIABLES, "Types": TYPES,
    }  # fmt: skip
    return "\n\n".join(f"## {title}\n\n{_names(rows)}" for title, rows in groups.items())


def _names(rows: tuple[Name, ...]) -> str:
    titles = ("name", "type" if rows is VARIABLES else "value", "meaning")
    return table(
        titles, [(f"`{row.name}`", cell(row.value) or "-", cell(row.meaning)) for row in rows]
    )


def dialect_functions() -> str:
    """Return the table of the functions of the report's dialect."""
    same = {"": "the same", "-": "none"}
    return table(
        ("function", "units", "in the report's dialect", "vendor's dialect", "report section"),
        [
            (
                f"`{each.prototype}`",
                each.units or "-",
                each.meaning,
                same.get(each.vendors, each.vendors),
                each.source,
            )
            for each in COMMANDS
        ],
    )


def dialect_state() -> str:
    """Return the table of the `State` entries that differ between the dialects."""
    return table(
        ("State entry", "vendor's dialect", "report's dialect"),
        [(f"`{index}`", vendors, reports) for index, vendors, reports in REPORT_STATE],
    )


def dialect_choices() -> str:
    """Return the decisions about the report's dialect that no source settles."""
    return CHOICES.rstrip("\n")


def choices() -> str:
    """Return the decisions about functions that no source settles."""
    functions = (each for group in GROUPS for each in group.functions if each.chosen)
    return "\n".join(f"- `{each.name}`: {each.chosen}" for each in functions)


def parameter(definition: str, element: str, attribute: str) -> str:
    """Return the name and the value of an attribute of a robot definition."""
    path = ROBOTS / f"{definition}.xml"
    found = ET.parse(path).getroot().find(element)  # noqa: S314 - one of our own files
    assert found is not None, element
    return f"`<{element} {attribute}>` | {found.attrib[attribute]}"


def sources() -> str:
    """Return what the tags in the tables' source column stand for."""
    return "\n".join(f"- *{tag}*: {source}" for tag, source in SOURCES.items())


FILLERS: Fillers = {
    "functions": functions,
    "names": names,
    "dialect_functions": dialect_functions,
    "dialect_state": dialect_state,
    "dialect_choices": dialect_choices,
    "choices": choices,
    "parameter": parameter,
    "sources": sources,
}
