"""The examples in `docs/teaching.md` work as described."""

from __future__ import annotations

import re
import shlex
import subprocess
from pathlib import Path

import pytest

from crs_cc.cli.grading.job import RESULTS
from crs_cc.cli.main import main

ROOT = Path(__file__).parents[3]
PAGE = (ROOT / "docs" / "teaching.md").read_text("utf-8")
COURSE = ROOT / "samples" / "teaching" / "course"


def test_all_commands_run_and_the_grades_are_those_of_the_page(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    shown = {}
    for line in "".join(re.findall(r"```sh\n(.*?)```", PAGE, re.DOTALL)).splitlines():
        if line.startswith("crs "):
            assert main(shlex.split(line)[1:]) == 0, line
            shown[line] = capfd.readouterr()
        else:
            subprocess.run(shlex.split(line), check=True)
    graded = next(out for line, (out, _) in shown.items() if "--html" in line)
    assert f"```\n{graded}```\n" in PAGE
    summary = next(err for line, (_, err) in shown.items() if "--summary" in line)
    assert "10 of 10" in summary
    assert Path("runs/002-ben_c-course.svg").exists()
    assert "All three flags visited" in Path("grades.html").read_text("utf-8")


def test_the_page_shows_the_goals_of_the_course_and_all_results() -> None:
    (goals,) = re.findall(r"```xml\n(.*?)```", PAGE, re.DOTALL)
    course = re.sub(r"^  ", "", (COURSE / "course.xml").read_text("utf-8"), flags=re.MULTILINE)
    assert goals in course
    rows = re.findall(r"^\| ([a-z][a-z -]+) \| ", PAGE, re.MULTILINE)
    assert sorted(rows) == sorted(["result", *RESULTS])


def test_the_hand_out_agrees_with_the_world() -> None:
    text = (COURSE / "assignment.md").read_text("utf-8")
    world = (COURSE / "course.xml").read_text("utf-8")
    for x_m, y_m in re.findall(r'<place x="(.*?)m" y="(.*?)m"', world):
        assert f"({x_m} m, {y_m} m)" in text
    points = [int(each) for each in re.findall(r'points="(\d+)"', world)]
    assert [int(each) for each in re.findall(r"\| (\d+) \|$", text, re.MULTILINE)] == points
