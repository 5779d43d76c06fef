"""A process that runs jobs, each in a child of its own.

It reads a job from each line of standard input, and writes lines of JSON to standard output:
`ready` once; for each job `compiled`, when its program has been compiled, and its result. A child
is a copy of this process, with all that a run needs loaded, so that it starts in milliseconds.
Where processes cannot be copied (Windows), it ends after one job, and is started anew.
"""

from __future__ import annotations

import gc
import json
import os
import sys
from typing import Any, Final

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from crs_cc.cli.grading.graded_run import graded_run
from crs_cc.cli.grading.job import GradedRun, Job
from crs_cc.core.errors import CrsError
from crs_cc.frontend import unit as _compiler  # noqa: F401 - what a run loads otherwise
from crs_cc.runtime import link as _linker  # noqa: F401
from crs_cc.runtime.codegen import module as _generator  # noqa: F401
from crs_cc.session.library import library
from crs_cc.sim.files import world_xml as _world_reader  # noqa: F401

_NAMES: Final = ("connect_robot", "printf", "main", "ws", "scout_pr", "get_sn")
"""Of what nearly every program uses of the library."""


def main() -> None:
    """Run jobs until standard input ends."""
    for name in _NAMES:
        library().find(name)
    gc.freeze()  # what is shared with children is not touched by their collector
    _say({"ready": True})
    for line in sys.stdin.buffer:
        job = Job.from_data(json.loads(line))
        if not hasattr(os, "fork"):
            _work(job)
            return
        child = os.fork()
        if child == 0:
            try:
                _work(job)
            finally:
                os._exit(0)
        _, status = os.waitpid(child, 0)
        _say({"done": status})


def _work(job: Job) -> None:
    def compiled() -> None:
        _limit_memory(None)
        _say({"compiled": True})

    try:
        os.chdir(job.folder)
        _limit_memory(job.limits.max_memory)
        run = graded_run(job, compiled)
    except MemoryError:
        text = f"needed more than {job.limits.max_memory >> 20} MiB of memory to compile"
        run = GradedRun("limit", text)
    except CrsError as error:
        run = GradedRun("crashed", str(error).splitlines()[0])
    except Exception as error:  # one submission must not end the grading of others
        run = GradedRun("crashed", f"internal error: {type(error).__name__}: {error}")
    _limit_memory(None)
    _say(run.as_data())


def _limit_memory(most: int | None) -> None:
    """Limit the memory of this process, as far as the system can; None for no limit.

    Compiling is limited. Running needs gigabytes of address space that are never used, and the
    memory that programs can use is limited anyway, see `runtime.layout` and `session.files`.
    """
    try:
        import resource
    except ImportError:
        return
    _, hard = resource.getrlimit(resource.RLIMIT_DATA)
    wanted = hard if most is None else most if hard < 0 else min(most, hard)
    resource.setrlimit(resource.RLIMIT_DATA, (wanted, hard))


def _say(data: dict[str, Any]) -> None:
    content = memoryview(json.dumps(data).encode() + b"\n")
    while content:
        content = content[os.write(1, content) :]


if __name__ == "__main__":
    main()
