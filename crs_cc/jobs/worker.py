"""A process that runs jobs, in copies of itself.

It reads a job from each line of standard input, and writes lines of JSON to standard output:
`ready` once; for each job `prepared`, when it has been, its result, and `done`. A child is a copy
of this process, with all that a run needs loaded, so that it starts in milliseconds. It does one
job, or some that are alike, and leaves no memory behind. Where processes cannot be copied
(Windows), this one ends after one job, and is started again.
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
from crs_cc.runtime import partner as _partner  # noqa: F401
from crs_cc.runtime.codegen import module as _generator  # noqa: F401
from crs_cc.session.build import build_driver
from crs_cc.session.library import library
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import parse_world

_NAMES: Final = ("connect_robot", "printf", "ws", "scout_pr", "get_sn")
"""Of what nearly every program uses of the library."""

_WORLD: Final = b"""<world version="1"><area length="3m" width="3m"/>
<box x="2m" y="2m" length="9cm" width="9cm" mass="1kg"/><robot x="1m" y="1m" setup="noisy"/>
<goal><no-collision/></goal></world>"""

_MAX_JOBS: Final = 32
"""Jobs that a child does at most: what it has not freed then is little."""

Work = Callable[[dict[str, Any], Callable[[], None]], dict[str, Any]]
"""Does a job; calls the function when it is prepared; returns the result."""

BatchKey = Callable[[dict[str, Any]], str]
"""Returns the batch key of a job: one child runs jobs with the same key, unless it is empty."""


def serve(
    work: Work,
    load: Callable[[dict[str, Any]], None] | None = None,
    batch_key: BatchKey | None = None,
) -> None:
    """Run jobs until standard input ends.

    Args:
        work: does a job, in a child; one with a true `is_last` in its result does no more.
        load: loads for a job, in this process, what later jobs may need as well; trusted, and it
            does not raise.
        batch_key: returns a key of jobs that one child can run in sequence; by default, none can.
    """
    channel = os.dup(1)
    with open(os.devnull, "wb") as nowhere:  # noqa: PTH123 - what jobs print is not ours
        os.dup2(nowhere.fileno(), 1)
    prepare()
    gc.freeze()  # what is shared with children is not touched by their collector
    _report_result(channel, {"ready": True})
    child: _Child | None = None
    for line in sys.stdin.buffer:
        job = json.loads(line)
        key = "" if batch_key is None else batch_key(job)
        if child is not None and not (key and child.key == key):
            child.end()
            child = None
        if child is None:
            if load is not None:
                load(job)
            if not hasattr(os, "fork"):
                _work(channel, work, job)
                return
            child = _Child(partial(_work, channel, work), key)
        code = child.run_job(line)
        if code is not None:
            child = None
        _report_result(channel, {"done": code or 0})
    if child is not None:
        child.end()


class _Child:
    """A fork of this process that executes jobs until it is ended or fails.

    The end of standard input means that the parent has ended, or was killed: nothing
    else would stop a run without an end then.

    Attributes:
        key: what its jobs have in common, empty if it does one only.
    """

    def __init__(self, work: Callable[[dict[str, Any]], dict[str, Any]], key: str) -> None:
        self.key = key
        jobs, self._jobs = os.pipe()
        self._answers, answers = os.pipe()
        self._pid = os.fork()
        if self._pid == 0:
            gc.freeze()  # so is what has been loaded since: a collection would copy its pages
            try:
                os.close(self._jobs)
                os.close(self._answers)
                _run_jobs(work, jobs, answers, _MAX_JOBS if key else 1)
            finally:
                os._exit(0)
        os.close(jobs)
        os.close(answers)  # which the child holds until it ends

    def run_job(self, line: bytes) -> int | None:
        """Run a job in the child; return the exit code if the child has ended."""
        waiting = select.poll()
        waiting.register(self._answers, select.POLLIN)
        waiting.register(sys.stdin.fileno(), 0)  # its end is always reported
        try:
            os.write(self._jobs, line)
        except BrokenPipeError:  # it has been killed
            return self._wait()
        if self._answers not in dict(waiting.poll()):  # there is no parent left
            os.kill(self._pid, signal.SIGKILL)
            return self._wait()
        return None if os.read(self._answers, 1) else self._wait()

    def end(self) -> None:
        """End the child, as there are no more jobs for it."""
        self._wait()

    def _wait(self) -> int:
        os.close(self._jobs)
        os.close(self._answers)
        _, status = os.waitpid(self._pid, 0)
        return os.waitstatus_to_exitcode(status)


def _run_jobs(
    work: Callable[[dict[str, Any]], dict[str, Any]], jobs: int, answers: int, most: int
) -> None:
    """Run jobs as they arrive, and report after each but the last that the next can be sent."""
    with open(jobs, "rb") as lines:
        for number, line in enumerate(lines, 1):
            result = work(json.loads(line))
            if number == most or result.get("is_last"):
                return
            gc.collect()  # what has been frozen is not looked at
            os.write(answers, b"\n")


def prepare() -> None:
    """Load what every run needs, once."""
    Environment(parse_world(_WORLD, "world"), seed=0).step()
    build_driver()
    for name in _NAMES:
        library().find(name)


def _work(channel: int, work: Work, job: dict[str, Any]) -> dict[str, Any]:
    result = work(job, lambda: _report_result(channel, {"prepared": True}))
    _report_result(channel, {"result": result})
    return result


def _report_result(channel: int, data: dict[str, Any]) -> None:
    content = memoryview(json.dumps(data).encode() + b"\n")
    while content:
        content = content[os.write(channel, content) :]
