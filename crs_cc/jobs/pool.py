"""Runs jobs in separate processes, several at a time, so that none can affect another.

A job is plain data, and so is its result. Limits of real time are the last resort: they end a
process that is still preparing, or running, after so long that only its end is sure.
"""

from __future__ import annotations

import contextlib
import json
import os
import queue
import signal
import subprocess
import sys
import threading
from collections.abc import Generator, Iterable
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Final, Literal, Self

from crs_cc.core.errors import InternalError
from crs_cc.core.source import Location
from crs_cc.toolchain.fingerprint import PACKAGE

Data = dict[str, Any]

_STOP_S: Final = 0.05
"""Real time after which a process is stopped again: it may just have been started."""

_LAST_RESORT: Final = "a limit of real time, which may not be reached on a faster machine"


def python(*words: str) -> list[str]:
    """Return the command line of this Python with these arguments."""
    return [sys.executable, *words]


@dataclass(frozen=True, slots=True)
class Task:
    """What one process does.

    Attributes:
        job: what to do, plain data for JSON.
        prepare_s: real time until the job has been prepared, such as compiled.
        run_s: real time for the rest.
        preparing: what it does until then, for messages.
    """

    job: Data
    prepare_s: float
    run_s: float
    preparing: str = "preparing"


@dataclass(frozen=True, slots=True)
class Outcome:
    """The outcome of a task.

    Attributes:
        number: its place among all tasks, from 0.
        result: its result; None if its process had to be stopped, or ended without one.
        kind: how it went.
        text: why there is no result.
    """

    number: int
    result: Data | None
    kind: Literal["done", "time out", "crashed"] = "done"
    text: str = ""


class Pool:
    """Processes that run tasks, started when they are needed, and kept for more."""

    def __init__(self, module: str, processes: int) -> None:
        """Set up a pool.

        Args:
            module: the module that a process runs, see `crs_cc.jobs.worker.serve`.
            processes: how many run at a time.
        """
        self._workers = [Worker(module) for _ in range(processes)]

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _error: BaseException | None,
        _where: TracebackType | None,
    ) -> None:
        for worker in self._workers:
            worker.stop()

    def run(self, tasks: Iterable[Task], retries: int = 0) -> Generator[Outcome, None, None]:
        """Yield the outcomes of tasks, in the order in which they end.

        Tasks are taken from their iterator when a process is free. Processes are stopped when the
        generator is closed before its end, or raises.

        Args:
            tasks: the tasks.
            retries: how often a task is tried again whose process crashed.

        Raises:
            InternalError: processes cannot be started.
        """
        queued = _Queue(tasks, retries)
        threads = [
            threading.Thread(target=queued.work, args=(worker,), daemon=True)
            for worker in self._workers
        ]
        for thread in threads:
            thread.start()
        try:
            for _ in threads:
                while (found := queued.done.get()) is not None:
                    if isinstance(found, BaseException):
                        raise found
                    yield found
        finally:
            queued.is_closed.set()
            for thread, worker in zip(threads, self._workers, strict=True):
                while thread.is_alive():
                    worker.stop()
                    thread.join(_STOP_S)


class _Queue:
    """Tasks that threads execute, each with its own worker, and their outcomes.

    Attributes:
        done: outcomes; errors, which end everything; and None from each thread at its end.
        is_closed: whether no more tasks are wanted.
    """

    def __init__(self, tasks: Iterable[Task], retries: int) -> None:
        self._todo, self._lock = enumerate(tasks), threading.Lock()
        self._retries = retries
        self.done: queue.SimpleQueue[Outcome | BaseException | None] = queue.SimpleQueue()
        self.is_closed = threading.Event()

    def work(self, worker: Worker) -> None:
        """Run tasks until there are none."""
        try:
            while (taken := self._next_task()) is not None:
                self.done.put(self._persist(worker, *taken))
        except BaseException as error:  # raised again by the generator
            self.done.put(error)
        else:
            self.done.put(None)

    def _next_task(self) -> tuple[int, Task] | None:
        with self._lock:
            return None if self.is_closed.is_set() else next(self._todo, None)

    def _persist(self, worker: Worker, number: int, task: Task) -> Outcome:
        """Return the outcome of a task, which is retried if its process crashes."""
        for _ in range(self._retries):
            found = worker.run(number, task)
            if found.kind != "crashed" or self.is_closed.is_set():
                return found
        return worker.run(number, task)


class Worker:
    """One process that runs tasks, and is replaced when it has had to be stopped."""

    def __init__(self, module: str) -> None:
        self._module = module
        self._process: subprocess.Popen[bytes] | None = None

    def run(self, number: int, task: Task) -> Outcome:
        """Return the outcome of a task."""
        process = self._start() if self._process is None else self._process
        self._process = process
        assert process.stdin is not None
        with contextlib.suppress(BrokenPipeError):  # it has been killed: reading reports it
            process.stdin.write(json.dumps(task.job).encode() + b"\n")
            process.stdin.flush()
        limit_s, what = task.prepare_s, task.preparing
        while True:
            data, is_late = self._next(process, limit_s)
            if is_late:
                text = f"stopped {what} after {limit_s:g} s: {_LAST_RESORT}"
                return Outcome(number, None, "time out", text)
            if data is None or "done" in data:
                text = f"the process of the run ended {_exit_reason(process, data)}"
                return Outcome(number, None, "crashed", text)
            if "result" in data:
                self._next(process, task.run_s)  # the child's end
                return Outcome(number, data["result"])
            limit_s, what = task.run_s, "running"

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
            python("-P", "-m", self._module),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env={**os.environ, "PYTHONPATH": path},
            start_new_session=True,
        )
        self._process = process  # so that it can be stopped before it is ready
        threading.Thread(target=_end_with, args=(process,), daemon=True).start()
        if not _line_of(process):
            raise InternalError.at(Location("crs"), "a process to run jobs cannot be started")
        return process

    def _next(self, process: subprocess.Popen[bytes], limit_s: float) -> tuple[Data | None, bool]:
        """Return the next message of a process, None at its end, and whether it has timed out."""
        late = threading.Event()

        def stop() -> None:
            late.set()
            _kill(process)

        timer = threading.Timer(limit_s, stop)
        timer.start()
        try:
            line = _line_of(process)
        finally:
            timer.cancel()
        if not line.endswith(b"\n"):
            self.stop()
            return None, late.is_set()
        data: Data = json.loads(line)
        return data, False


def _line_of(process: subprocess.Popen[bytes]) -> bytes:
    """Return the next line that a process writes, empty at its end or if it has been stopped."""
    assert process.stdout is not None
    try:
        return process.stdout.readline()
    except ValueError:  # closed when it was stopped
        return b""


def _end_with(process: subprocess.Popen[bytes]) -> None:
    """Wait for the end of a process, and kill its child, which would keep the pipe open."""
    process.wait()
    _kill(process)


def _kill(process: subprocess.Popen[bytes]) -> None:
    """Kill a process and its child."""
    with contextlib.suppress(ProcessLookupError):  # it has ended
        if hasattr(os, "killpg"):
            os.killpg(process.pid, signal.SIGKILL)
        else:
            process.kill()


def _exit_reason(process: subprocess.Popen[bytes], data: Data | None) -> str:
    """Return how a process ended: by its return code, or as its parent reports."""
    code = process.wait() if data is None else data["done"]
    if code < 0:
        return f"by signal {-code}; perhaps the system had no memory left"
    return "without a result"
