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
from crs_cc.runtime.driver import MOST_SHARDS

if TYPE_CHECKING:
    from concurrent.futures import Future

    from crs_cc.runtime.executable import Executable

Task: TypeAlias = Callable[[], None]

_STACK_BYTES: Final = 8 * 2**20
"""More than `executable.MAX_WASM_STACK`, for which a limited or unlimited `ulimit -s` may give a
thread too little."""


ROBOTS_PER_SHARD: Final = 4
"""By default, a shard has at least so many."""


def default_threads(executables: Sequence[Executable]) -> int:
    """Return how many shards are worth while; programs with marks run one by one."""
    most = min(available_cores(), MOST_SHARDS, len(executables) // ROBOTS_PER_SHARD)
    if most <= 1 or any(
        each.has_marks for each in {id(each): each for each in executables}.values()
    ):
        return 1
    return most


def run_all(tasks: Sequence[Task]) -> None:
    """Run tasks at the same time, the last in this thread; return when all have ended.

    If Ctrl-C is pressed meanwhile, `KeyboardInterrupt` is raised only then.
    """
    futures = _threads(os.getpid()).submit(tasks[:-1])
    try:
        tasks[-1]()
    finally:
        _wait(futures)


def _wait(futures: Sequence[Future[None]]) -> None:
    interrupt: KeyboardInterrupt | None = None
    for future in futures:
        while not future.done():
            try:
                future.exception()
            except KeyboardInterrupt as caught:
                interrupt = caught
    if interrupt is not None:
        raise interrupt
    for future in futures:
        future.result()


class _Threads:
    def __init__(self) -> None:
        self._queue: SimpleQueue[tuple[Task, Future[None]]] = SimpleQueue()
        self._count = 0
        self._lock = threading.Lock()

    def submit(self, tasks: Sequence[Task]) -> list[Future[None]]:
        """Run tasks in as many threads."""
        from concurrent.futures import Future  # slow to import

        self._provide(len(tasks))
        futures: list[Future[None]] = [Future() for _ in tasks]
        for pair in zip(tasks, futures, strict=True):
            self._queue.put(pair)
        return futures

    def _provide(self, count: int) -> None:
        """Start threads until there are `count`."""
        with self._lock:
            if self._count >= count:
                return
            before = threading.stack_size(_STACK_BYTES)
            try:
                while self._count < count:
                    threading.Thread(target=self._work, name="crs-fleet", daemon=True).start()
                    self._count += 1
            finally:
                threading.stack_size(before)

    def _work(self) -> None:
        while True:
            _complete(*self._queue.get())


def _complete(task: Task, future: Future[None]) -> None:
    try:
        task()
    except BaseException as error:  # it is raised where the task is waited for
        future.set_exception(error)
    else:
        future.set_result(None)


@functools.cache
def _threads(_process: int) -> _Threads:
    """Return the threads of this process; a forked child has none of its parent's."""
    return _Threads()
