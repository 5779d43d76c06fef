"""The format of error reports on a terminal and elsewhere, and as data."""

from __future__ import annotations

import json

import click
import pytest

from crs_cc.cli.report import render_report, report_data, show_reports
from crs_cc.core.source import Location
from crs_cc.runtime.diagnosis.active_call import ActiveCall
from crs_cc.runtime.diagnosis.objects import Object
from crs_cc.runtime.diagnosis.report import ErrorReport
from crs_cc.runtime.sites import CallSite
from tests.cli.test_summary import robot

PLACE = Location("wander.c", 12, 14, last=21)
BLOCK = Object("heap block", 4096, 16, allocated=(CallSite("main", Location("wander.c", 30, 9)),))
REPORT = ErrorReport(
    "out of bounds",
    PLACE,
    "out of bounds: reads 4 bytes right after the end of a heap block of 16 bytes",
    "    total += order[i];",
    (("order", "0x1000"), ("i", "4")),
    ("allocated at wander.c:30:9 in main",),
    (
        ActiveCall("sum", (("count", "5"), ("...", "")), PLACE),
        ActiveCall("turn", (), None),
        ActiveCall("fib", count=1204),
        ActiveCall("main", (), Location("wander.c", 31, 5)),
    ),
    BLOCK,
)
SHOWN = """\
wander.c:12:14: error: out of bounds: reads 4 bytes right after the end of a heap block of 16 bytes
        total += order[i];
                 ^~~~~~~~
    order = 0x1000, i = 4
    allocated at wander.c:30:9 in main
    in   sum(count=5, ...)
    from turn()
    ...  1,204 more calls to fib
    from main() at wander.c:31:5"""


def test_a_report_shows_error_values_and_call_stack() -> None:
    assert render_report(REPORT) == SHOWN
    assert render_report(REPORT, "robot7").startswith("wander.c:12:14: error: [robot7] out of")


def test_colours_change_nothing_but_the_colours() -> None:
    painted = render_report(REPORT, coloured=True)
    assert "\x1b[" in painted
    assert click.unstyle(painted) == SHOWN


def test_a_program_cannot_send_escape_codes_in_its_variables() -> None:
    evil = "\x1b[2J\n\x07\u202e"
    calls = (ActiveCall(evil, ((evil, evil),), Location(evil)),) * 2
    report = ErrorReport("out of bounds", PLACE, evil, evil, ((evil, evil),), (evil,), calls)
    shown = render_report(report, evil)
    assert not set(shown) & set("\x1b\x07\u202e")


def test_a_report_as_data_has_the_same_contents() -> None:
    data = json.loads(json.dumps(report_data(REPORT)))
    assert (data["kind"], data["file"], data["line"]) == ("out of bounds", "wander.c", 12)
    assert data["values"] == {"order": "0x1000", "i": "4"}
    assert data["object"]["allocated"] == [
        {"function": "main", "file": "wander.c", "line": 30, "column": 9}
    ]
    assert [call["function"] for call in data["stack"]] == ["sum", "turn", "fib", "main"]
    assert data["stack"][2]["count"] == 1204
    assert data["stack"][1]["file"] is None


def test_of_many_identical_failures_the_first_are_shown(
    capsys: pytest.CaptureFixture[str],
) -> None:
    robots = [robot(f"robot{n}", outcome="failed", error=REPORT) for n in range(50)]
    show_reports(robots)
    shown = capsys.readouterr().err
    assert [f"[robot{n}]" in shown for n in range(4)] == [True, True, True, False]
    assert shown.endswith("... and 47 more robots were stopped at the same place\n")
