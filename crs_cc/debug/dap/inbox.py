"""Requests that wait for their turn, put in by the thread that reads and taken by the engine's.

While programs run, nobody takes anything; then `put` calls what the engine's thread left with
`watched`, which lets the run be interrupted.

>>> inbox = Inbox()
>>> inbox.put(ClientRequest(1, "threads", {}))
>>> inbox.close()
>>> inbox.take().command, inbox.take()
('threads', None)
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Final

from crs_cc.debug.dap.arguments import RefusalError

MAX: Final = 1000  # requests that wait; chosen by us


@dataclass(frozen=True, slots=True)
class ClientRequest:
    """What a client wants.

    Attributes:
        seq: the client's number of it.
        command: its name.
        arguments: what it says, as it came.
    """

    seq: int
    command: str
    arguments: Any


class Inbox:
    """A queue of bounded length, with an end."""

    def __init__(self) -> None:
        self._requests: deque[ClientRequest] = deque()
        self._changed = threading.Condition()
        self._closed = False
        self._interrupt: Callable[[ClientRequest | None], None] | None = None

    def put(self, request: ClientRequest) -> None:
        """Put in a request.

        Raises:
            RefusalError: too many wait already.
        """
        with self._changed:
            if len(self._requests) >= MAX:
                raise RefusalError(f"{MAX} requests are already pending")
            self._requests.append(request)
            self._changed.notify()
            if self._interrupt is not None:
                self._interrupt(request)

    def close(self) -> None:
        """Return that nothing more will come."""
        with self._changed:
            self._closed = True
            self._changed.notify()
            if self._interrupt is not None:
                self._interrupt(None)

    def take(self, *, wait: bool = True) -> ClientRequest | None:
        """Return the next request; None when none will come, or none is there to be waited for."""
        with self._changed:
            while wait and not self._requests and not self._closed:
                self._changed.wait()
            return self._requests.popleft() if self._requests else None

    def withdraw(self, seq: int) -> ClientRequest | None:
        """Take out the request with a number, if it still waits."""
        with self._changed:
            found = next((each for each in self._requests if each.seq == seq), None)
            if found is not None:
                self._requests.remove(found)
            return found

    @property
    def closed(self) -> bool:
        """Return whether all has been taken that will ever come."""
        with self._changed:
            return self._closed and not self._requests

    @contextmanager
    def watched(self, interrupt: Callable[[ClientRequest | None], None]) -> Iterator[None]:
        """Call `interrupt` for what waits now, and whatever comes before the block ends.

        Args:
            interrupt: takes the request, None for the end; is called by the reading thread, too.
        """
        with self._changed:
            for request in self._requests:
                interrupt(request)
            if self._closed:
                interrupt(None)
            self._interrupt = interrupt
        try:
            yield
        finally:
            with self._changed:
                self._interrupt = None
