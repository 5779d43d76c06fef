"""Progress of long moves: shown by the client while programs run, with a button to stop them.

It is reported from a separate thread, as the engine's is busy. Nothing in the run depends on it.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Final

from crs_cc.debug.dap.connection import ClientDisconnectedError, Connection

DELAY_S: Final = 1.0
"""Shorter moves are not reported; also the interval between two reports [s]."""


class Progress:
    """Progress events for the moves of one session."""

    def __init__(self, connection: Connection, *, wanted: bool, delay_s: float = DELAY_S) -> None:
        """Store the connection, and whether the client shows progress."""
        self._connection = connection
        self._wanted = wanted
        self._delay_s = delay_s
        self._number = 0

    @contextmanager
    def of(self, title: str, describe: Callable[[], str]) -> Iterator[None]:
        """Report a move if it takes long.

        Args:
            title: what is done.
            describe: returns the progress; called by another thread.
        """
        if not self._wanted:
            yield
            return
        self._number += 1
        over = threading.Event()
        work = threading.Thread(target=self._report, args=(title, describe, over), daemon=True)
        work.start()
        try:
            yield
        finally:
            over.set()
            work.join()

    def _report(self, title: str, describe: Callable[[], str], over: threading.Event) -> None:
        """Report the progress of a move until it is over."""
        key = {"progressId": f"move-{self._number}"}
        if over.wait(self._delay_s):
            return
        try:
            start = {**key, "title": title, "message": describe(), "cancellable": True}
            self._connection.event("progressStart", start)
            while not over.wait(self._delay_s):
                self._connection.event("progressUpdate", {**key, "message": describe()})
            self._connection.event("progressEnd", {**key})
        except ClientDisconnectedError:
            return
