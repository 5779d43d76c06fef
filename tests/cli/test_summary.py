"""What came of a run, in its three forms."""

from __future__ import annotations

import json
from typing import Any

import pytest

from crs_cc.cli.summary import Run, as_json, exit_status
from crs_cc.cli.table import MAX_ROWS, print_summary
from crs_cc.runtime.diagnosis.report import ErrorReport
from crs_cc.session.result import RobotResult, RunResult
from crs_cc.source import Location

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
    }
    return RobotResult(**{**figures, **changes})


def run_of(*robots: RobotResult, interrupted: bool = False) -> Run:
    result = RunResult(tuple(robots), 250, 12.5, "0123456789abcdef" * 4)
    return Run(result, "room.xml", seed=7, wall_s=0.5, interrupted=interrupted)


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


def test_json_holds_every_figure_of_every_robot() -> None:
    data = json.loads(as_json(run_of(robot(), FAILED)))
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
    assert set(first) == set(RobotResult.__slots__)


def test_the_card_of_one_robot(capsys: pytest.CaptureFixture[str]) -> None:
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
