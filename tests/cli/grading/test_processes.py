"""Runs in processes of their own: what goes wrong with one is its own grade."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from crs_cc.cli.grading.job import Job, Limits
from crs_cc.cli.grading.processes import run_all
from tests.cli.grading.handed_in import WORLD


@pytest.fixture
def job(tmp_path: Path) -> Job:
    """Return a job whose program never ends."""
    (tmp_path / "task.xml").write_text(WORLD)
    (tmp_path / "loop.c").write_text("int main(void) { for (;;) ; }\n")
    limits = Limits(max_time_s=1e6, max_fuel=10**15)
    return Job(str(tmp_path), ("loop.c",), str(tmp_path / "task.xml"), None, limits, ())


def test_what_goes_wrong_with_a_run_is_its_own_grade(job: Job, tmp_path: Path) -> None:
    running = replace(job, limits=replace(job.limits, wall_s=0.3))
    missing = replace(job, folder=str(tmp_path / "nowhere"))
    hungry = replace(job, limits=replace(job.limits, max_memory=150 * 2**20))
    small = replace(job, limits=Limits(max_fuel=1000))
    ended: list[None] = []
    jobs = [hungry, running, missing, small]
    found = list(run_all(jobs, 1, lambda: ended.append(None)))
    assert [run.result for run in found] == ["limit", "time out", "crashed", "limit"]
    assert len(ended) == len(jobs)
    assert found[0].message == (
        "needed more than 150 MiB to compile: a limit that depends on the machine"
    )
    last_resort = "a limit of real time, which may not be reached on a faster machine"
    assert found[1].message == f"stopped running after 0.3 s: {last_resort}"
    assert "FileNotFoundError" in found[2].message
    assert [run.earned for run in found] == [0.0] * len(jobs)
