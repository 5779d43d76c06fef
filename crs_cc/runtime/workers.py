"""Threads that run the shards of fleets.

They belong to the process, not to a fleet, and are started when they are first needed. A forked
child does not have its parent's threads, and starts its own.
"""

from __future__ import annotations

import functools
import os
import threading
from collections.abc import Callable, Sequence
from queue import SimpleQueue
from typing import TYPE_CHECKING, Final, TypeAlias

from crs_cc.core.host_system import available_cores
from crs_cc.runtime.driver import MAX_SHARDS

if TYPE_CHECKING:
    from crs_cc.runtime.executable import Executable

Task: TypeAlias = Callable[[], None]

_STACK_BYTES: Final = 8 * 2**20
"""More than `executable.MAX_WASM_STACK`, for which a limited or unlimited `ulimit -s` may give a
thread too little."""


ROBOTS_PER_SHARD: Final = 4
"""By default, a shard has at least so many."""


def default_threads(executables: Sequence[Executable]) -> int:
    """Return how many shards are worth while; programs with marks run one by one."""
    most = min(available_cores(), MAX_SHARDS, len(executables) // ROBOTS_PER_SHARD)
    if most <= 1 or any(
        each.has_marks for each in {id(each): each for each in executables}.values()
    ):
        return 1
    return most


def run_all(tasks: Sequence[Task]) -> None:
    """Run tasks at the same time, the last in this thread; return when all have ended.

    If Ctrl-C is pressed meanwhile, `KeyboardInterrupt` is raised only then.
    """
    items = _threads(os.getpid()).submit(tasks[:-1])
    try:
        tasks[-1]()
    finally:
        _wait(items)


def _wait(items: Sequence[_WorkItem]) -> None:
    interrupt: KeyboardInterrupt | None = None
    for item in items:
        while not item.has_ended:
            try:
                item.wait()
            except KeyboardInterrupt as caught:
                interrupt = caught
    if interrupt is not None:
        raise interrupt
    for item in items:
        if item.error is not None:
            raise item.error


class _WorkItem:
    """A task for another thread: a `Future` takes ten times as long.

    Attributes:
        has_ended: whether the task has.
        error: what it has raised.
    """

    __slots__ = ("_lock", "_task", "error", "has_ended")

    def __init__(self, task: Task) -> None:
        self._task, self._lock = task, threading.Lock()
        self._lock.acquire()
        self.has_ended = False
        self.error: BaseException | None = None

    def run(self) -> None:
        try:
            self._task()
        except BaseException as error:  # it is raised where the task is waited for
            self.error = error
        finally:
            self.has_ended = True
            self._lock.release()

    def wait(self) -> None:
        """Wait for the end, once; it may have been waited for if Ctrl-C was pressed then."""
        self._lock.acquire()


class _Threads:
    def __init__(self) -> None:
        self._queue: SimpleQueue[_WorkItem] = SimpleQueue()
        self._count = 0
        self._lock = threading.Lock()

    def submit(self, tasks: Sequence[Task]) -> list[_WorkItem]:
        """Run tasks in as many threads."""
        self._ensure_threads(len(tasks))
        items = [_WorkItem(task) for task in tasks]
        for item in items:
            self._queue.put(item)
        return items

    def _ensure_threads(self, count: int) -> None:
        """Start threads until there are `count`."""
        if self._count >= count:
            return
        with self._lock:
            before = threading.stack_size(_STACK_BYTES)
            try:
                while self._count < count:
                    threading.Thread(target=self._work, name="crs-fleet", daemon=True).start()
                    self._count += 1
            finally:
                threading.stack_size(before)

    def _work(self) -> None:
        while True:
            self._queue.get().run()


@functools.cache
def _threads(_process: int) -> _Threads:
    """Return the threads of this process; a forked child has none of its parent's."""
    return _Threads()
