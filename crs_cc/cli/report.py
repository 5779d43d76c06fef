"""The report of a program stopped by a run-time error, as text and as data for JSON.

The first lines are those of every diagnostic: location, message, and the source line with what
failed underlined. Below are the values of variables, what is known of the object, and the call
stack, innermost first (`in`, then `from`).
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Final

import click

from crs_cc.cli.messages import is_coloured, printable, render, say
from crs_cc.core.source import Diagnostic, Location
from crs_cc.ir.names import plain_name

if TYPE_CHECKING:
    from crs_cc.runtime.diagnosis.active_call import ActiveCall
    from crs_cc.runtime.diagnosis.objects import Object
    from crs_cc.runtime.diagnosis.report import ErrorReport
    from crs_cc.runtime.sites import CallSite
    from crs_cc.session.result import RobotResult

_ALIKE: Final = 3


def show_reports(robots: Sequence[RobotResult]) -> None:
    """Write reports to stderr; of many identical failures the first few."""
    alike: dict[tuple[str, Location], list[RobotResult]] = {}
    for robot in robots:
        if robot.error is not None:
            alike.setdefault((robot.error.kind, robot.error.location), []).append(robot)
    for same in alike.values():
        for robot in same[:_ALIKE]:
            assert robot.error is not None
            name = robot.id if len(robots) > 1 else ""
            say(render_report(robot.error, name, coloured=is_coloured(sys.stderr)))
        if len(same) > _ALIKE:
            say(f"... and {len(same) - _ALIKE} more robots were stopped at the same place")


def render_report(report: ErrorReport, robot: str = "", *, coloured: bool = False) -> str:
    """Return a report as text, with the name of a robot if given."""
    text = f"[{robot}] {report.text}" if robot else report.text
    head = Diagnostic("error", report.location, text, report.source_line)
    rows = []
    if report.values:
        rows.append(", ".join(f"{name} = {value}" for name, value in report.values))
    rows += report.notes
    rows = [printable(row) for row in rows]
    from crs_cc.frontend.check.scope import ENTRIES  # rarely needed

    is_obvious = len(report.stack) == 1 and report.stack[0].function in ENTRIES
    innermost = next((call for call in report.stack if call.location is not None), None)
    for number, call in enumerate(() if is_obvious else report.stack):
        word = "..." if call.count > 1 else "from" if number else "in"
        is_told = call.location is None or call is innermost
        place = "" if is_told else f" at {printable(str(call.location))}"
        rows.append(f"{word:4} {_call(call, coloured=coloured)}{place}")
    return "\n".join([render(head, coloured=coloured), *(f"    {row}" for row in rows)])


def report_data(report: ErrorReport) -> dict[str, Any]:
    """Return a report as plain data."""
    return {
        "kind": report.kind,
        "text": report.text,
        **_place(report.location),
        "values": dict(report.values),
        "notes": list(report.notes),
        "object": _object(report.object) if report.object else None,
        "stack": [call_data(call) for call in report.stack],
    }


def _call(call: ActiveCall, *, coloured: bool) -> str:
    text, name = printable(str(call)), call.function
    is_one = coloured and call.count == 1
    return click.style(name, bold=True) + text.removeprefix(name) if is_one else text


def _place(place: Location | None) -> dict[str, Any]:
    if place is None:
        return {"file": None, "line": None, "column": None}
    return {"file": place.file, "line": place.line, "column": place.column}


def call_data(call: ActiveCall) -> dict[str, Any]:
    """Return an active call as plain data."""
    return {
        "function": call.function,
        "arguments": dict(call.arguments),
        **_place(call.location),
        "count": call.count,
    }


def _object(found: Object) -> dict[str, Any]:
    return {
        "kind": found.kind,
        "name": found.name,
        "address": found.address,
        "size": found.size,
        "state": found.state,
        "declared": _place(found.location) if found.location else None,
        "allocated": [call_site_data(each) for each in found.allocated],
        "freed": [call_site_data(each) for each in found.freed],
    }


def call_site_data(site: CallSite) -> dict[str, Any]:
    """Return a call site as plain data."""
    return {"function": plain_name(site.function), **_place(site.location)}
