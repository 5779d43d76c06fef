"""Jobs that compute in a copy of their process: `how` selects what happens there."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from crs_cc.jobs.forked import run_forked
from crs_cc.jobs.worker import serve

_kept: list[int] = []


def _in_copy(job: dict[str, Any]) -> dict[str, Any]:
    _kept.append(1)
    if job["how"] == "killed":
        os.kill(os.getpid(), signal.SIGKILL)
    if job["how"] == "exits":
        raise SystemExit(3)
    if job["how"] == "endless":
        Path(job["pid"]).write_text(str(os.getpid()))
        time.sleep(600.0)
    return {"kept": len(_kept), "copy": os.getpid(), "text": "x" * job.get("size", 0)}


def _work(job: dict[str, Any], prepared: Callable[[], None]) -> dict[str, Any]:
    prepared()
    return {"process": os.getpid(), **run_forked(lambda: _in_copy(job))}


if __name__ == "__main__":
    serve(_work, batch_key=lambda _: "a")
