"""Processes that run jobs: batches in one process, and processes that end."""

from __future__ import annotations

import contextlib
import os
import signal
import threading
import time
from typing import Any

import pytest

from crs_cc.core.errors import InternalError
from crs_cc.jobs import worker
from crs_cc.jobs.pool import Outcome, Pool, Task, Worker

MODULE = "tests.jobs.pids"

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="one job a process elsewhere")


def done(*jobs: dict[str, Any], retries: int = 0) -> list[Outcome]:
    """Return the outcomes of jobs, run in sequence."""
    with Pool(MODULE, 1) as pool:
        return list(pool.run((Task(job, 60.0, 60.0) for job in jobs), retries))


def pids(outcomes: list[Outcome]) -> list[int | None]:
    return [each.result["pid"] if each.result else None for each in outcomes]


def test_one_process_runs_the_jobs_of_a_batch() -> None:
    names = ["a", "a", "b", "a", "a", "", ""]
    found = pids(done(*({"name": name} for name in names)))
    assert found[0] == found[1]
    assert found[3] == found[4]
    assert len({*found}) == 5


def test_a_process_runs_a_limited_number_of_jobs() -> None:
    found = pids(done(*[{"name": "a"}] * (worker._MAX_JOBS + 1)))
    assert len({*found[:-1]}) == 1
    assert found[-1] != found[0]


def test_a_process_is_not_reused_after_a_failure() -> None:
    found = pids(done({"name": "a"}, {"name": "a", "how": "wrong"}, {"name": "a"}))
    assert found[0] == found[1] != found[2]


@pytest.mark.parametrize("how", ["killed", "raises"])
def test_a_job_that_ends_its_process_does_not_affect_others(how: str) -> None:
    outcomes = done({"name": "a"}, {"name": "a", "how": how}, {"name": "a"}, retries=1)
    assert [each.kind for each in outcomes] == ["done", "crashed", "done"]
    assert ("by signal 9" if how == "killed" else "without a result") in outcomes[1].text


def test_a_process_that_is_killed_between_jobs_is_replaced() -> None:
    def tasks():
        yield Task({"name": "a"}, 60.0, 60.0)
        yield Task({"name": "a"}, 60.0, 60.0)

    found: list[Outcome] = []
    with Pool(MODULE, 1) as pool:
        wanted = tasks()
        first = pool.run([next(wanted)])
        found += first
        assert found[0].result
        os.kill(found[0].result["pid"], signal.SIGKILL)
        found += pool.run(wanted, retries=1)
    assert [each.kind for each in found] == ["done", "done"]
    assert len({*pids(found)}) == 2


def test_a_process_that_is_still_starting_can_be_stopped() -> None:
    starting = Worker("tests.jobs.never_ready")

    def run() -> None:
        with contextlib.suppress(InternalError):
            starting.run(0, Task({}, 60.0, 60.0))

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    while starting._process is None:
        time.sleep(0.01)
    starting.stop()
    thread.join(60.0)
    assert not thread.is_alive()
