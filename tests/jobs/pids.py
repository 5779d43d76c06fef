"""Jobs that report their process: `name` is the batch key, `how` the failure."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable
from typing import Any

from crs_cc.jobs.worker import serve


def _work(job: dict[str, Any], prepared: Callable[[], None]) -> dict[str, Any]:
    prepared()
    if job.get("how") == "killed":
        os.kill(os.getpid(), signal.SIGKILL)
    if job.get("how") == "raises":
        raise ValueError
    return {"pid": os.getpid(), "is_last": job.get("how") == "wrong"}


if __name__ == "__main__":
    serve(_work, batch_key=lambda job: str(job["name"]))
