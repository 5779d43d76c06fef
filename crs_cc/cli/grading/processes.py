"""Runs jobs in processes of their own, several at a time, so that none can harm another.

Limits of real time are the last resort: they end a process that is still compiling, or running,
after so long that only its end is sure.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Final

from crs_cc.cli.grading.job import GradedRun, Job
from crs_cc.core.errors import InternalError
from crs_cc.core.source import Location
from crs_cc.toolchain.fingerprint import PACKAGE

_MODULE: Final = "crs_cc.cli.grading.worker"
_LAST_RESORT: Final = "a limit of real time, which may not be reached on a faster machine"


def run_all(jobs: Sequence[Job], processes: int, done: Callable[[], None]) -> Iterator[GradedRun]:
    """Yield what becomes of each job, in their order.

    Args:
        jobs: the jobs.
        processes: how many run at a time.
        done: is called, in any thread, when a job has ended.

    Raises:
        InternalError: processes cannot be started.
    """
    workers: list[_Worker] = []
    own = threading.local()

    def run(number: int) -> GradedRun:
        if not hasattr(own, "worker"):
            own.worker = _Worker()
            workers.append(own.worker)
        result: GradedRun = own.worker.run(jobs[number])
        done()
        return result

    pool = ThreadPoolExecutor(max(1, min(processes, len(jobs))))
    try:
        yield from pool.map(run, range(len(jobs)))
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for worker in workers:
            worker.stop()


class _Worker:
    """One process that runs jobs, and is replaced when it has had to be stopped."""

    def __init__(self) -> None:
        self._process: subprocess.Popen[bytes] | None = None

    def run(self, job: Job) -> GradedRun:
        """Return what becomes of a job."""
        process = self._start() if self._process is None else self._process
        self._process = process
        assert process.stdin is not None
        process.stdin.write(json.dumps(job.as_data()).encode() + b"\n")
        process.stdin.flush()
        limit_s, what = job.limits.compile_s, "compiling"
        while True:
            data, is_late = self._next(process, limit_s)
            if is_late:
                text = f"stopped {what} after {limit_s:g} s: {_LAST_RESORT}"
                return GradedRun("time out", text)
            if data is None or "done" in data:
                return GradedRun("crashed", f"the process of the run ended {_how(process, data)}")
            if "result" in data:
                self._next(process, job.limits.wall_s)  # the child's end
                return GradedRun.from_data(data)
            limit_s, what = job.limits.wall_s, "running"

    def stop(self) -> None:
        """Stop the process and its child."""
        process, self._process = self._process, None
        if process is None:
            return
        _kill(process)
        process.communicate()

    def _start(self) -> subprocess.Popen[bytes]:
        """Start a process; no file of a folder that it is started in becomes a part of it."""
        path = os.pathsep.join(filter(None, (str(PACKAGE.parent), os.environ.get("PYTHONPATH"))))
        process = subprocess.Popen(  # noqa: S603 - ourselves
            [sys.executable, "-P", "-m", _MODULE],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env={**os.environ, "PYTHONPATH": path},
            start_new_session=True,
        )
        threading.Thread(target=_end_with, args=(process,), daemon=True).start()
        assert process.stdout is not None
        if not process.stdout.readline():
            raise InternalError.at(Location("crs grade"), "a process to run jobs cannot be started")
        return process

    def _next(
        self, process: subprocess.Popen[bytes], limit_s: float
    ) -> tuple[dict[str, Any] | None, bool]:
        """Return what a process says next, None at its end, and whether it was too late."""
        late = threading.Event()

        def stop() -> None:
            late.set()
            _kill(process)

        timer = threading.Timer(limit_s, stop)
        timer.start()
        try:
            assert process.stdout is not None
            line = process.stdout.readline()
        finally:
            timer.cancel()
        if not line.endswith(b"\n"):
            self.stop()
            return None, late.is_set()
        return json.loads(line), False


def _end_with(process: subprocess.Popen[bytes]) -> None:
    """Wait for the end of a process, and kill its child: it would hold our pipe open."""
    process.wait()
    _kill(process)


def _kill(process: subprocess.Popen[bytes]) -> None:
    """Kill a process and its child."""
    with contextlib.suppress(ProcessLookupError):  # it has ended
        if hasattr(os, "killpg"):
            os.killpg(process.pid, signal.SIGKILL)
        else:
            process.kill()


def _how(process: subprocess.Popen[bytes], data: dict[str, Any] | None) -> str:
    """Return how a process ended: by its return code, or as its parent says."""
    code = process.returncode if data is None else data["done"]
    if code < 0:
        return f"by signal {-code}; perhaps the system had no memory left"
    return "without a result"
