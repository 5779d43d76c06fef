"""Runs in processes of their own: what goes wrong with one is its own grade."""

from __future__ import annotations

import os
import platform
import signal
import subprocess
import threading
import weakref
from dataclasses import replace
from pathlib import Path

import pytest

from crs_cc.cli.grading.graded_run import graded_run
from crs_cc.cli.grading.job import GradedRun, Job, Limits
from crs_cc.cli.grading.processes import run_all
from crs_cc.jobs.pool import Worker
from crs_cc.runtime.fleet import Fleet
from tests.cli.grading.handed_in import WORLD
from tests.commands import python


@pytest.fixture
def job(tmp_path: Path) -> Job:
    """Return a job whose program never ends."""
    (tmp_path / "task.xml").write_text(WORLD)
    (tmp_path / "loop.c").write_text("int main(void) { for (;;) ; }\n")
    limits = Limits(max_time_s=1e6, max_fuel=10**15, wall_s=60.0)
    return Job("loop", str(tmp_path), ("loop.c",), str(tmp_path / "task.xml"), None, limits, ())


def test_a_graded_run_frees_its_programs_when_it_ends(
    job: Job, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, fleets: list[weakref.ref[Fleet]]
) -> None:
    monkeypatch.chdir(tmp_path)
    small = replace(job, limits=Limits(max_fuel=1000), record=str(tmp_path / "run.mcap"))
    assert graded_run(small, lambda: None).result == "limit"
    assert [each() for each in fleets] == [None]


def test_errors_of_a_run_affect_only_its_own_grade(
    job: Job, tmp_path: Path, users_workers: None
) -> None:
    running = replace(job, limits=replace(job.limits, wall_s=0.3))
    missing = replace(job, folder=str(tmp_path / "nowhere"))
    hungry = replace(job, limits=replace(job.limits, max_memory=150 * 2**20))
    small = replace(job, limits=Limits(max_fuel=1000))
    ended: list[None] = []
    jobs = [hungry, running, missing, small]
    found = run_all(jobs, 1, lambda: ended.append(None))
    assert [run.result for run in found] == ["limit", "time out", "crashed", "limit"]
    assert len(ended) == len(jobs)
    assert found[0].message == (
        "needed more than 150 MiB to compile: a limit that depends on the machine"
    )
    last_resort = "a limit of real time, which may not be reached on a faster machine"
    assert found[1].message == f"stopped running after 0.3 s: {last_resort}"
    assert "FileNotFoundError" in found[2].message
    assert [run.earned for run in found] == [0.0] * len(jobs)


def children(process: int) -> list[int]:
    lists = Path(f"/proc/{process}/task").glob("*/children")  # of each thread
    return [int(each) for path in lists for each in path.read_text().split()]


@pytest.fixture
def started(monkeypatch: pytest.MonkeyPatch, users_workers: None) -> list[int]:
    """The processes that were started to run jobs."""
    found: list[int] = []
    start = Worker._start

    def noting(worker: Worker) -> object:
        process = start(worker)
        found.append(process.pid)
        return process

    monkeypatch.setattr(Worker, "_start", noting)
    return found


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs processes that are copied")
def test_an_endless_run_ends_with_its_parent_process() -> None:
    """It went on to its limits when `crs grade` was killed."""
    program = (
        "import time; from crs_cc.jobs.worker import serve;"
        "serve(lambda job, prepared: (prepared(), time.sleep(300)))"
    )
    with subprocess.Popen(
        python("-c", program), stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as worker:
        assert worker.stdin is not None
        assert worker.stdout is not None
        assert worker.stdout.readline() == b'{"ready": true}\n'
        worker.stdin.write(b"{}\n")
        worker.stdin.flush()
        assert worker.stdout.readline() == b'{"prepared": true}\n'
        worker.stdin.close()
        assert worker.stdout.readline() == b'{"done": -9}\n'  # and then its pipe is closed
        assert worker.stdout.read() == b""


@pytest.mark.skipif(not Path("/proc/self").exists(), reason="needs /proc to find the processes")
@pytest.mark.parametrize("whose", ["run", "worker"])
def test_a_killed_process_is_the_grade_of_its_run_only(
    whose: str, job: Job, started: list[int]
) -> None:
    ended = threading.Event()

    def kill() -> None:
        while not ended.wait(0.005):
            for worker in started[:1]:
                for run in children(worker):
                    os.kill(run if whose == "run" else worker, signal.SIGKILL)
                    return

    killer = threading.Thread(target=kill)
    killer.start()
    small = replace(job, limits=Limits(max_fuel=1000))
    try:
        found = run_all([job, small], 1, lambda: None)
    finally:
        ended.set()
        killer.join()
    assert [run.result for run in found] == ["crashed", "limit"]
    assert found[0].message == (
        "the process of the run ended by signal 9; perhaps the system had no memory left"
    )
    assert len(started) == (1 if whose == "run" else 2)


def test_without_fork_each_run_has_a_new_process(
    job: Job, started: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    without_unix = Path(__file__).parents[2] / "without_unix"
    monkeypatch.setenv("PYTHONPATH", str(without_unix))
    monkeypatch.setenv("PROCESSOR_ARCHITECTURE", platform.machine())  # as Windows does
    small = replace(job, limits=Limits(max_fuel=1000))
    late = replace(job, limits=replace(job.limits, wall_s=0.3))
    found: list[GradedRun] = run_all([late, small], 1, lambda: None)
    assert [run.result for run in found] == ["time out", "limit"]
    assert len(started) == len(set(started)) == 2
