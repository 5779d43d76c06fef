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
from pathlib import Path
from typing import Any, Final

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from crs_cc.cli.grading.graded_run import graded_run
from crs_cc.cli.grading.job import GradedRun, Job
from crs_cc.core.errors import CrsError
from crs_cc.frontend import unit as _compiler  # noqa: F401 - imported once, before runs need it
from crs_cc.runtime import link as _linker  # noqa: F401
from crs_cc.runtime.codegen import module as _generator  # noqa: F401
from crs_cc.session.build import build_driver
from crs_cc.session.library import library
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import parse_world

_STATM: Final = Path("/proc/self/statm")
_DATA: Final = 5
"""The field with the pages of data, which is what RLIMIT_DATA limits (proc(5))."""

_NAMES: Final = ("connect_robot", "printf", "ws", "scout_pr", "get_sn")
"""Of what nearly every program uses of the library."""

_WORLD: Final = b"""<world version="1"><area length="3m" width="3m"/>
<box x="2m" y="2m" length="9cm" width="9cm" mass="1kg"/><robot x="1m" y="1m"/>
<goal><no-collision/></goal></world>"""


def main() -> None:
    """Run jobs until standard input ends."""
    _prepare()
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
        _say({"done": os.waitstatus_to_exitcode(status)})


def _prepare() -> None:
    """Load what every run needs, once."""
    for name in _NAMES:
        library().find(name)
    build_driver()
    Environment(parse_world(_WORLD, "world"), seed=0).step()


def _work(job: Job) -> None:
    def compiled() -> None:
        _limit_memory(None)
        _say({"compiled": True})

    try:
        os.chdir(job.folder)
        _limit_memory(job.limits.max_memory)
        run = graded_run(job, compiled)
    except CrsError as error:
        run = GradedRun("crashed", str(error).splitlines()[0])
    except Exception as error:  # one submission must not end the grading of others
        run = _failure(error, job)
    _limit_memory(None)
    _say(run.as_data())


def _failure(error: Exception, job: Job) -> GradedRun:
    """Return what has become of a run that has failed."""
    # The compiler has a thread with a large stack.
    if isinstance(error, MemoryError) or "start new thread" in str(error):
        most = job.limits.max_memory >> 20
        text = f"needed more than {most} MiB to compile: a limit that depends on the machine"
        return GradedRun("limit", text)
    return GradedRun("crashed", f"internal error: {type(error).__name__}: {error}")


def _limit_memory(most: int | None) -> None:
    """Limit the memory that this process may use in addition; None for no limit. Linux only.

    Compiling is limited. Running needs gigabytes of address space that are never used, and the
    memory that programs can use is limited anyway, see `runtime.layout` and `session.files`.
    """
    try:
        import resource
    except ImportError:  # Unix only
        return
    if not _STATM.exists():
        return
    _, hard = resource.getrlimit(resource.RLIMIT_DATA)
    wanted = hard
    if most is not None:
        used = int(_STATM.read_text().split()[_DATA]) * resource.getpagesize()
        wanted = used + most if hard < 0 else min(used + most, hard)
    resource.setrlimit(resource.RLIMIT_DATA, (wanted, hard))


def _say(data: dict[str, Any]) -> None:
    content = memoryview(json.dumps(data).encode() + b"\n")
    while content:
        content = content[os.write(1, content) :]


if __name__ == "__main__":
    main()
