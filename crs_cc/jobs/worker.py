"""A process that runs jobs, each in a child of its own.

It reads a job from each line of standard input, and writes lines of JSON to standard output:
`ready` once; for each job `prepared`, when it has been, and its result. A child is a copy of this
process, with all that a run needs loaded, so that it starts in milliseconds and leaves no memory
behind. Where processes cannot be copied (Windows), it ends after one job, and is started anew.
"""

from __future__ import annotations

import gc
import json
import os
import select
import signal
import sys
from collections.abc import Callable
from functools import partial
from typing import Any, Final

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from crs_cc.frontend import unit as _compiler  # noqa: F401 - imported once, before runs need it
from crs_cc.runtime import link as _linker  # noqa: F401
from crs_cc.runtime.codegen import module as _generator  # noqa: F401
from crs_cc.session.build import build_driver
from crs_cc.session.library import library
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import parse_world

_NAMES: Final = ("connect_robot", "printf", "ws", "scout_pr", "get_sn")
"""Of what nearly every program uses of the library."""

_WORLD: Final = b"""<world version="1"><area length="3m" width="3m"/>
<box x="2m" y="2m" length="9cm" width="9cm" mass="1kg"/><robot x="1m" y="1m"/>
<goal><no-collision/></goal></world>"""

Work = Callable[[dict[str, Any], Callable[[], None]], dict[str, Any]]
"""Does a job; calls the function when it is prepared; returns the result."""


def serve(work: Work, load: Callable[[dict[str, Any]], None] | None = None) -> None:
    """Run jobs until standard input ends.

    Args:
        work: does a job, in the child.
        load: loads for a job, in this process, what later jobs may need as well; trusted, and it
            does not raise.
    """
    channel = os.dup(1)
    with open(os.devnull, "wb") as nowhere:  # noqa: PTH123 - what jobs print is not ours
        os.dup2(nowhere.fileno(), 1)
    _prepare()
    gc.freeze()  # what is shared with children is not touched by their collector
    _say(channel, {"ready": True})
    for line in sys.stdin.buffer:
        job = json.loads(line)
        if load is not None:
            load(job)
        if not hasattr(os, "fork"):
            _work(channel, work, job)
            return
        _say(channel, {"done": _in_a_child(partial(_work, channel, work, job))})


def _in_a_child(work: Callable[[], None]) -> int:
    """Do something in a child; return its exit code, or end with it if nobody is left to tell.

    The end of standard input says that whoever gave the job has ended, perhaps killed: nothing else
    would stop a run without an end then.
    """
    its_end, held = os.pipe()
    child = os.fork()
    if child == 0:
        gc.freeze()  # so is what has been loaded since: a collection would copy its pages
        try:
            work()
        finally:
            os._exit(0)
    os.close(held)  # which the child holds until it ends
    waiting = select.poll()
    waiting.register(its_end, select.POLLIN)
    waiting.register(sys.stdin.fileno(), 0)  # its end is always told
    if its_end not in dict(waiting.poll()):
        os.kill(child, signal.SIGKILL)
    os.close(its_end)
    _, status = os.waitpid(child, 0)
    return os.waitstatus_to_exitcode(status)


def _prepare() -> None:
    """Load what every run needs, once."""
    for name in _NAMES:
        library().find(name)
    build_driver()
    Environment(parse_world(_WORLD, "world"), seed=0).step()


def _work(channel: int, work: Work, job: dict[str, Any]) -> None:
    result = work(job, lambda: _say(channel, {"prepared": True}))
    _say(channel, {"result": result})


def _say(channel: int, data: dict[str, Any]) -> None:
    content = memoryview(json.dumps(data).encode() + b"\n")
    while content:
        content = content[os.write(channel, content) :]
