"""Tasks run at the same time, and are waited for whatever happens."""

from __future__ import annotations

import threading
import time
import weakref

import pytest

from crs_cc.runtime.workers import run_all


def test_tasks_run_at_the_same_time() -> None:
    barrier = threading.Barrier(4, timeout=30)
    run_all([barrier.wait] * 4)
    run_all([barrier.wait] * 4)
    assert not barrier.broken


def test_calls_from_several_threads_do_not_wait_for_each_other() -> None:
    barrier = threading.Barrier(4, timeout=30)
    calls = [threading.Thread(target=run_all, args=([barrier.wait] * 2,)) for _ in range(2)]
    for call in calls:
        call.start()
    for call in calls:
        call.join()
    assert not barrier.broken


def test_an_exception_of_a_task_is_raised_by_the_call() -> None:
    with pytest.raises(ZeroDivisionError):
        run_all([lambda: print(1 / 0), lambda: None])
    run_all([lambda: None] * 2)


def test_other_tasks_are_waited_for_after_ctrl_c() -> None:
    ended = []

    def slow() -> None:
        time.sleep(0.05)
        ended.append(True)

    def interrupted() -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_all([slow, interrupted])
    assert ended


def test_idle_threads_keep_nothing_alive() -> None:
    class Task:
        def __call__(self) -> None:
            pass

    task = Task()
    known = weakref.ref(task)
    run_all([task, lambda: None])
    del task
    for _ in range(100):
        if known() is None:
            break
        time.sleep(0.01)
    assert known() is None
