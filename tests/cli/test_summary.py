"""The results of a run: table, JSON and exit status."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import pytest

from crs_cc.cli import summary_table
from crs_cc.cli.summary import Run, as_json, exit_status
from crs_cc.cli.summary_table import MAX_ROWS, print_summary
from crs_cc.core.source import Location
from crs_cc.runtime.diagnosis.active_call import ActiveCall
from crs_cc.runtime.diagnosis.lost_blocks import LostBlocks
from crs_cc.runtime.diagnosis.report import ErrorReport
from crs_cc.runtime.sites import CallSite
from crs_cc.session.result import RobotResult, RunResult

FAILURE = ErrorReport("null pointer", Location("wander.c", 7, 3), "null pointer: 'p' is null")


def robot(name: str = "robot0", **changes: Any) -> RobotResult:
    figures: dict[str, Any] = {
        "id": name,
        "program": "wander.c",
        "outcome": "exited",
        "exit_status": 0,
        "error": None,
        "time_s": 12.5,
        "odometry": (1.0, 2.0, 0.5),
        "pose": (1.1, 2.1, 6.5),
        "distance_m": 3.25,
        "collisions": 2,
        "commands": 17,
        "fuel": 1234567,
        "robot_call_s": 12.25,
    }
    return RobotResult(**{**figures, **changes})


def run_of(*robots: RobotResult, interrupted: bool = False, call: ActiveCall | None = None) -> Run:
    """Return a run; running programs are in `call`."""
    result = RunResult(tuple(robots), 250, 12.5, "0123456789abcdef" * 4)
    calls = tuple(call if robot.outcome == "running" else None for robot in robots)
    return Run(result, "room.xml", 7, wall_s=0.5, interrupted=interrupted, calls=calls)


RUNNING = robot(outcome="running", exit_status=None)
FAILED = robot(outcome="failed", exit_status=None, error=FAILURE)


@pytest.mark.parametrize(
    ("run", "status"),
    [
        (run_of(robot()), 0),
        (run_of(robot(exit_status=3)), 3),
        (run_of(robot(exit_status=-1)), 255),
        (run_of(robot(exit_status=256)), 0),
        (run_of(RUNNING), 0),
        (run_of(FAILED), 123),
        (run_of(robot(), RUNNING), 0),
        (run_of(robot(), robot(exit_status=3)), 1),
        (run_of(robot(), FAILED), 1),
        (run_of(robot(exit_status=3), interrupted=True), 130),
    ],
)
def test_exit_status(run: Run, status: int) -> None:
    assert exit_status(run) == status


def test_json_contains_all_results_of_every_robot() -> None:
    data = json.loads(as_json(run_of(robot(), FAILED), []))
    assert data["world"] == "room.xml"
    assert data["seed"] == 7
    assert data["timesteps"] == 250
    assert data["simulated_s"] == 12.5
    assert data["timing"] == {"wall_s": 0.5, "real_time_factor": 25.0}
    assert data["exit_status"] == 1
    first, second = data["robots"]
    assert first["pose"] == {"x_m": 1.1, "y_m": 2.1, "heading_rad": 6.5}
    assert first["exit_status"] == 0
    assert first["error"] is None
    assert second["outcome"] == "failed"
    assert second["error"]["text"] == "null pointer: 'p' is null"
    assert second["error"]["line"] == 7
    assert set(first) == {*RobotResult.__slots__, "stands_in", "lost_blocks"}


def test_the_summary_of_one_robot(capsys: pytest.CaptureFixture[str]) -> None:
    print_summary(run_of(robot()))
    shown = capsys.readouterr()
    assert shown.out == ""
    for figure in (
        "robot0  wander.c",
        "exit 0 at 12.50 s",
        "1.00 2.00 m 29°",
        "1.10 2.10 m 12°",  # the heading within half a turn
        "3.25 m",
        "1,234,567",
        "250 timesteps, 12.50 s simulated in 0.50 s (25.0 x real time), seed 7",
    ):
        assert figure in shown.err


def test_the_table_of_many_robots_is_cut_with_a_count(capsys: pytest.CaptureFixture[str]) -> None:
    robots = [robot(f"r[{n}]", outcome="running" if n % 2 else "exited") for n in range(100)]
    print_summary(run_of(*robots))
    shown = capsys.readouterr().err
    assert shown.count("r[") == MAX_ROWS
    assert "in all 50 exited, 50 running" in shown


TURN = ActiveCall("turn", (("angle", "90"),), Location("wander.c", 31, 5))


def test_a_running_program_shows_its_location(
    capsys: pytest.CaptureFixture[str],
) -> None:
    print_summary(run_of(RUNNING, call=TURN))
    assert "\nrobot0 is in turn(angle=90) at wander.c:31:5\n" in capsys.readouterr().err
    data = json.loads(as_json(run_of(RUNNING, FAILED, call=TURN), []))
    assert data["robots"][0]["stands_in"]["arguments"] == {"angle": "90"}
    assert data["robots"][0]["stands_in"]["line"] == 31
    assert data["robots"][1]["stands_in"] is None


def test_robots_at_the_same_location_share_a_line(
    capsys: pytest.CaptureFixture[str],
) -> None:
    robots = [robot(f"r{n}", outcome="running", robot_call_s=None) for n in range(7)]
    print_summary(run_of(*robots, call=TURN))
    shown = capsys.readouterr().err
    assert "\nr0, r1, r2 and 4 more are in turn() at wander.c:31:5, no robot call so far" in shown


@pytest.mark.parametrize(
    ("called_s", "told"),
    [(12.5, ""), (8.0, ""), (3.25, "no robot call since 3.25 s"), (None, "so far")],
)
def test_a_robot_without_calls_for_long_is_reported(
    called_s: float | None, told: str, capsys: pytest.CaptureFixture[str]
) -> None:
    quiet = robot(outcome="running", robot_call_s=called_s)
    print_summary(run_of(quiet, call=TURN))
    shown = capsys.readouterr().err
    assert told in shown
    assert ("no robot call" in shown) == bool(told)


@pytest.mark.parametrize("columns", [40, 80, 200])
def test_the_summary_is_no_wider_than_the_terminal(
    columns: int, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(summary_table, "is_terminal", lambda _stream: True)
    monkeypatch.setenv("COLUMNS", str(columns))
    robots = [robot(f"robot{n}", odometry=(-12.5, -13.25, 3.1), fuel=10**9) for n in range(3)]
    for run in (run_of(robots[0]), run_of(*robots), run_of(RUNNING, call=TURN)):
        print_summary(run)
        lines = capsys.readouterr().err.splitlines()
        assert max(map(len, lines)) <= columns
    print_summary(run_of(*robots))
    shown = capsys.readouterr().err
    assert ("fuel" in shown) == (columns > 80)
    assert len(shown.splitlines()) <= 6 or columns < 80


def test_lost_heap_blocks_are_named_with_where_they_were_allocated(
    capsys: pytest.CaptureFixture[str],
) -> None:
    site = CallSite("wander.c:load", Location("wander.c", 30, 9))
    lost = (LostBlocks((20, 30), (site,)), LostBlocks((8,), ()))
    run = replace(run_of(robot("a"), robot("b"), robot("c")), lost=(lost, lost[:1], ()))
    print_summary(run)
    printed = capsys.readouterr().err
    assert (
        "a, b: lost 2 heap blocks of 50 bytes, allocated at wander.c:30:9 in load: neither"
        in printed
    )
    assert "a: lost 1 heap block of 8 bytes: neither freed nor pointed to" in printed
    data = [each["lost_blocks"] for each in json.loads(as_json(run, []))["robots"]]
    place = {"function": "load", "file": "wander.c", "line": 30, "column": 9}
    assert data[1] == [{"blocks": 2, "bytes": 50, "allocated": [place]}]
    assert data[2] == []
