"""Computing in a fork of this process, of which only the result remains."""

from __future__ import annotations

import gc
import json
import os
import signal
import threading
from collections.abc import Callable
from typing import Final, TypeVar

_T = TypeVar("_T")

CAN_FORK: Final = hasattr(os, "fork")
"""Whether processes can be copied here."""


def run_forked(compute: Callable[[], _T]) -> _T:
    """Return the result of a function, plain data, computed in a fork of this process.

    Whatever else the function changes, in any module, ends with the copy. If the copy ends without
    a result, so does this process, in the same way; if this process is killed, the copy ends, too.
    Where processes cannot be copied (Windows), the function is just called.
    """
    if not CAN_FORK:
        return compute()
    results, our_results = os.pipe()
    life, our_life = os.pipe()
    pid = os.fork()
    if pid == 0:
        os.close(results)
        os.close(our_life)
        _answer(compute, our_results, life)
    os.close(our_results)
    os.close(life)
    with open(results, "rb") as answer:  # noqa: PTH123 - a descriptor
        content = answer.read()
    _, status = os.waitpid(pid, 0)
    os.close(our_life)
    if not content.endswith(b"\n"):
        _end_like(os.waitstatus_to_exitcode(status))
    result: _T = json.loads(content)
    return result


def _answer(compute: Callable[[], object], results: int, life: int) -> None:
    """Write the result of the function, and exit."""
    gc.freeze()  # a collection would copy the pages of everything there is
    threading.Thread(target=_end_with, args=(life,), daemon=True).start()
    try:
        content = memoryview(json.dumps(compute()).encode() + b"\n")
        while content:
            content = content[os.write(results, content) :]
    finally:
        os._exit(0)


def _end_with(life: int) -> None:
    """Wait for the end of the process of which this is a copy, and end."""
    os.read(life, 1)
    os.kill(os.getpid(), signal.SIGKILL)


def _end_like(code: int) -> None:
    """End as a process with an exit code, negative for a signal, has ended."""
    if code < 0:
        os.kill(os.getpid(), -code)
    os._exit(code)
