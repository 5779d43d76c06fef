"""Waiting for other processes to reach a certain state."""

from __future__ import annotations

import subprocess
import time
from pathlib import Path

TIMEOUT_S = 60.0


def wait_until_it_waits(process: int) -> None:
    """Return when a process runs no longer, but waits: for its input, say."""
    end_s = time.monotonic() + TIMEOUT_S
    while not state_of(process).startswith("S"):
        assert time.monotonic() < end_s, "the process does not wait"
        time.sleep(0.005)


def state_of(process: int) -> str:
    """Return the state of a process as `ps` has it: R while it runs, S while it waits."""
    status = Path(f"/proc/{process}/stat")
    if status.exists():
        return status.read_text().rpartition(")")[2].split()[0]
    command = ["ps", "-o", "stat=", "-p", str(process)]
    return subprocess.run(command, check=False, capture_output=True, text=True).stdout.strip()
