"""`crs` as a process: it starts and exits faster than as a library.

Python's garbage collector would scan what starting creates again and again, and OpenBLAS would
start threads that nothing here uses. The end of the interpreter would free every object one by
one; `os._exit` leaves that to the system, once the streams are flushed and exit handlers have run.
"""

from __future__ import annotations

import atexit
import gc
import os
import sys
import threading
from typing import Final

_NEW_OBJECTS: Final = 100_000
"""New objects for one garbage collection; starting makes fewer, and hardly any of it is garbage."""


def start() -> None:
    """Run `crs` with the arguments of this process, and end the process."""
    gc.set_threshold(_NEW_OBJECTS)
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    from crs_cc.cli.main import main

    exit_process(main())


def exit_process(status: int) -> None:
    """End this process with an exit status.

    The usual, slow end is left to Python if the streams cannot be flushed, which it reports; if
    other threads have to end first; or if a profiler or debugger waits for it.
    """
    if not (_is_watched() or _has_other_threads()) and _are_flushed():
        atexit._run_exitfuncs()
        if _are_flushed():
            os._exit(status & 0xFF)
    sys.exit(status)


def _is_watched() -> bool:
    return sys.gettrace() is not None or sys.getprofile() is not None


def _has_other_threads() -> bool:
    threads = threading.enumerate()
    return any(not each.daemon for each in threads if each is not threading.main_thread())


def _are_flushed() -> bool:
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    except (OSError, ValueError):
        return False
    return True
