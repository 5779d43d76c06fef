"""Running the jobs of a grading in separate processes: a failure affects one grade only."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final

from crs_cc.cli.grading.job import GradedRun, Job
from crs_cc.jobs import pool

_MODULE: Final = "crs_cc.cli.grading.worker"


def run_all(jobs: Sequence[Job], processes: int, done: Callable[[], None]) -> list[GradedRun]:
    """Return the outcome of each job, in order.

    Args:
        jobs: the jobs.
        processes: how many run at a time.
        done: is called when a job has ended.

    Raises:
        InternalError: processes cannot be started.
    """
    tasks = [
        pool.Task(job.as_data(), job.limits.compile_s, job.limits.wall_s, "compiling")
        for job in jobs
    ]
    found: dict[int, GradedRun] = {}
    with pool.Pool(_MODULE, min(processes, len(jobs))) as workers:
        for outcome in workers.run(tasks):
            found[outcome.number] = _graded(outcome)
            done()
    return [found[number] for number in range(len(jobs))]


def _graded(outcome: pool.Outcome) -> GradedRun:
    if outcome.result is not None:
        return GradedRun.from_data(outcome.result)
    assert outcome.kind != "done"
    return GradedRun(outcome.kind, outcome.text)
