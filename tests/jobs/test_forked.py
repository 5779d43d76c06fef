"""Computing in a copy of a process: its results, and the end of either process."""

from __future__ import annotations

import os
import signal
import threading
import time
from pathlib import Path
from typing import Any

import pytest

from crs_cc.jobs.pool import Outcome, Pool, Task

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="processes are not copied")


def done(*jobs: dict[str, Any], run_s: float = 60.0) -> list[Outcome]:
    """Return the outcomes of jobs, run in sequence."""
    with Pool("tests.jobs.copies", 1) as pool:
        return list(pool.run(Task({"how": "", **job}, 60.0, run_s) for job in jobs))


def has_ended(pid: int) -> bool:
    """Return whether a process ends within a minute."""
    deadline = time.monotonic() + 60.0
    while time.monotonic() < deadline:
        try:
            os.kill(pid, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.01)
    return False


def test_a_forked_computation_leaves_only_its_result() -> None:
    first, second = (each.result or {} for each in done({}, {"size": 300_000}))
    assert first["process"] == second["process"]
    assert len({first["process"], first["copy"], second["copy"]}) == 3
    assert first["kept"] == second["kept"] == 1
    assert len(second["text"]) == 300_000


@pytest.mark.parametrize(
    ("how", "told"), [("killed", "by signal 9"), ("exits", "without a result")]
)
def test_a_process_ends_like_its_copy_if_there_is_no_result(how: str, told: str) -> None:
    before, ended, after = done({}, {"how": how}, {})
    assert [each.kind for each in (before, ended, after)] == ["done", "crashed", "done"]
    assert told in ended.text


def test_a_copy_ends_with_its_process(tmp_path: Path) -> None:
    path = tmp_path / "pid"
    (late,) = done({"how": "endless", "pid": str(path)}, run_s=2.0)
    assert late.kind == "time out"
    assert has_ended(int(path.read_text()))


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="/proc says which it is")
def test_a_copy_ends_if_only_its_process_is_killed(tmp_path: Path) -> None:
    path = tmp_path / "pid"

    def kill_child() -> None:
        while not path.exists() or not path.read_text():
            time.sleep(0.01)
        parent = int(Path(f"/proc/{path.read_text()}/stat").read_text().split()[3])
        os.kill(parent, signal.SIGKILL)

    with Pool("tests.jobs.copies", 1) as pool:
        outcomes = pool.run([Task({"how": "endless", "pid": str(path)}, 60.0, 60.0)])
        killer = threading.Thread(target=kill_child)
        killer.start()
        (ended,) = outcomes
        killer.join()
        assert ended.kind == "crashed"
        assert has_ended(int(path.read_text()))
