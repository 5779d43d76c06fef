"""The queue of requests from the reading thread to the engine's thread.

While programs run nothing is taken; then `put` calls the function that the engine's thread passed
to `watched`, which can interrupt the run.

>>> inbox = Inbox()
>>> inbox.put(ClientRequest(1, "threads", {}))
>>> inbox.close()
>>> inbox.get().command, inbox.get()
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
    """A request of the client.

    Attributes:
        seq: the client's number of it.
        command: its name.
        arguments: its arguments, not validated.
    """

    seq: int
    command: str
    arguments: Any


class Inbox:
    """A bounded queue that can be closed."""

    def __init__(self) -> None:
        self._requests: deque[ClientRequest] = deque()
        self._changed = threading.Condition()
        self._closed = False
        self._interrupt: Callable[[ClientRequest | None], None] | None = None

    def put(self, request: ClientRequest) -> None:
        """Append a request; raise RefusalError if too many are pending."""
        with self._changed:
            if len(self._requests) >= MAX:
                raise RefusalError(f"{MAX} requests are already pending")
            self._requests.append(request)
            self._changed.notify()
            if self._interrupt is not None:
                self._interrupt(request)

    def close(self) -> None:
        """Mark the end of the requests."""
        with self._changed:
            self._closed = True
            self._changed.notify()
            if self._interrupt is not None:
                self._interrupt(None)

    def get(self, *, wait: bool = True) -> ClientRequest | None:
        """Return the next request; None at the end, or if there is none and `wait` is false."""
        with self._changed:
            while wait and not self._requests and not self._closed:
                self._changed.wait()
            return self._requests.popleft() if self._requests else None

    def cancel(self, seq: int) -> ClientRequest | None:
        """Remove a pending request by number."""
        with self._changed:
            found = next((each for each in self._requests if each.seq == seq), None)
            if found is not None:
                self._requests.remove(found)
            return found

    @property
    def closed(self) -> bool:
        """Return whether the queue is closed and empty."""
        with self._changed:
            return self._closed and not self._requests

    @contextmanager
    def watched(self, interrupt: Callable[[ClientRequest | None], None]) -> Iterator[None]:
        """Call `interrupt` for pending requests and those that arrive during the block.

        Args:
            interrupt: receives the request, None for the end; called by the reading thread, too.
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
