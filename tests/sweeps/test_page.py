"""What `docs/experiments.md` shows works."""

from __future__ import annotations

import csv
import re
import shlex
from pathlib import Path

import pytest

import crs_cc
from crs_cc.cli.main import main
from tests.sweeps.trials import inline

PAGE = (Path(__file__).parents[2] / "docs" / "experiments.md").read_text()


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", PAGE, re.DOTALL)


def test_the_example_of_the_page_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("crs_cc.jobs.pool.Pool.run", lambda _pool, *some: inline(*some))
    Path("hall.xml").write_text(blocks("xml")[0])
    Path("drive.c").write_text(blocks("c")[0])
    Path("measures.py").write_text(blocks("python")[0])
    Path("speeds.toml").write_text('measures = "measures.py"\n' + blocks("toml")[0])
    for command in blocks("sh"):
        for line in command.splitlines():
            assert main(shlex.split(line)[1:]) == 0
    exec(blocks("python")[1], {"crs_cc": crs_cc})
    with Path("speeds/runs.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 20
    for column in re.findall(r"^\| (`.*?) \|", PAGE, re.MULTILINE):
        if "goal.clean" in column:
            assert all(name in rows[0] for name in re.findall(r"`([^`]+)`", column))
    assert {row["goal.clean"] for row in rows if row["define.SPEED"] == "60"} == {"holds"}
