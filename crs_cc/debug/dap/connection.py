"""The outgoing half of a connection: numbered responses and events; thread-safe."""

from __future__ import annotations

import threading
from typing import Any, BinaryIO, Final

from crs_cc.debug.dap.framing import Message, encode
from crs_cc.debug.dap.inbox import ClientRequest

NOBODY = ClientRequest(0, "", {})
"""The sequence number in answers to messages without a valid one."""


LOOKING: Final = frozenset(
    {"completions", "dataBreakpointInfo", "evaluate", "scopes", "stackTrace", "variables"}
)
"""Requests that clients make by themselves; their failures are not shown to the user."""


class ClientDisconnectedError(Exception):
    """The client has closed the connection."""


class Connection:
    """Sends messages to the client."""

    def __init__(self, sink: BinaryIO) -> None:
        self._sink = sink
        self._lock = threading.Lock()
        self._seq = 0

    def respond(self, request: ClientRequest, body: Message | None = None) -> None:
        """Send the response to a request; raises like `event`."""
        self._answer(request, {"success": True, **({"body": body} if body else {})})

    def refuse(self, request: ClientRequest, text: str, word: str = "") -> None:
        """Send an error response to a request; raises like `event`.

        Args:
            request: the request.
            text: the reason, for the user.
            word: the reason, for the client: `cancelled` or `notStopped`.
        """
        shown = request.command not in LOOKING
        error = {"id": 1, "format": "{why}", "variables": {"why": text}, "showUser": shown}
        self._answer(request, {"success": False, "message": word or text, "body": {"error": error}})

    def event(self, name: str, body: Message | None = None) -> None:
        """Send an event; raise ClientGoneError if the client has closed the connection."""
        self._send({"type": "event", "event": name, **({"body": body} if body else {})})

    def _answer(self, request: ClientRequest, answer: dict[str, Any]) -> None:
        head = {"type": "response", "request_seq": request.seq, "command": request.command}
        self._send(head | answer)

    def _send(self, message: Message) -> None:
        with self._lock:
            self._seq += 1
            try:
                self._sink.write(encode({"seq": self._seq, **message}))
                self._sink.flush()
            except (OSError, ValueError):  # the latter of a closed stream
                raise ClientDisconnectedError from None
