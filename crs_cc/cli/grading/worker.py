"""A process that runs graded submissions, see `crs_cc.jobs.worker`."""

from __future__ import annotations

import itertools
import os
from collections.abc import Callable
from typing import Any, Final

from crs_cc.cli.grading import compiler_memory
from crs_cc.cli.grading.graded_run import graded_run
from crs_cc.cli.grading.job import GradedRun, Job
from crs_cc.core.errors import CrsError
from crs_cc.jobs.memory_limit import limit_memory
from crs_cc.jobs.worker import serve

_FEW: Final = 2
"""The number of jobs up to which filling the compiler's memory takes longer than it saves."""

_numbers = itertools.count()


def _load(_job: dict[str, Any]) -> None:
    if next(_numbers) == _FEW:
        compiler_memory.fill()


def _work(data: dict[str, Any], prepared: Callable[[], None]) -> dict[str, Any]:
    job = Job.from_data(data)

    def compiled() -> None:
        limit_memory(None)  # running needs gigabytes of address space that are never used
        prepared()

    try:
        os.chdir(job.folder)
        limit_memory(job.limits.max_memory)
        run = graded_run(job, compiled)
    except CrsError as error:
        run = GradedRun("crashed", str(error).splitlines()[0])
    except Exception as error:  # one submission must not end the grading of others
        run = _failure(error, job)
    limit_memory(None)
    return run.as_data()


def _failure(error: Exception, job: Job) -> GradedRun:
    """Return the outcome of a run that has failed."""
    # The compiler has a thread with a large stack.
    if isinstance(error, MemoryError) or "start new thread" in str(error):
        most = job.limits.max_memory >> 20
        text = f"needed more than {most} MiB to compile: a limit that depends on the machine"
        return GradedRun("limit", text)
    return GradedRun("crashed", f"internal error: {type(error).__name__}: {error}")


if __name__ == "__main__":
    serve(_work, _load)
