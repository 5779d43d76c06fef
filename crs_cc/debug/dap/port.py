"""Serves editors on a port: each connection in a thread of its own, so that none blocks the next.

Only a client that knows the token gets further than the first requests, see `gate`; others are
disconnected, as are those that stop in the middle of a message, or belong to another user.
"""

from __future__ import annotations

import contextlib
import io
import os
import socket
import threading
import time
from collections.abc import Callable
from functools import partial
from typing import Final

from crs_cc.core import loopback
from crs_cc.core.host_system import is_of_another_user
from crs_cc.debug.dap.framing import MAX_MESSAGE_BYTES, Message, read_message
from crs_cc.debug.dap.gate import Gate
from crs_cc.debug.dap.serve import serve
from crs_cc.debug.dap.session import OpenRun

MAX_CLIENTS: Final = 16  # connections at a time; chosen by us
_FIRST_MESSAGES: Final = 64 * 2**10  # bytes of a message before the token is shown; chosen by us
_ENDING_S: Final = 10.0


def serve_port(port: int, open_run: OpenRun, token: str, announce: Callable[[str], None]) -> None:
    """Serve editors, one at a time, on a port of the loopback interface until interrupted.

    Args:
        port: its number; 0 for any that is free.
        open_run: makes a debugger from a command line of `crs debug`.
        token: what clients have to know.
        announce: receives the address to connect to.

    Raises:
        OSError: the port is in use.
    """
    with loopback.listen(port) as listener:
        announce(f"{loopback.LOOPBACK}:{listener.getsockname()[1]}")
        clients = Clients(open_run, token)
        try:
            while True:
                with contextlib.suppress(ConnectionError):  # the client was gone before
                    clients.start(listener.accept()[0])
        finally:
            clients.close()


class Clients:
    """The connections of a server."""

    def __init__(self, open_run: OpenRun, token: str) -> None:
        self._open_run = open_run
        self._token = token
        self._seat = threading.Lock()
        self._folder = os.getcwd()  # noqa: PTH109
        self._threads: dict[threading.Thread, socket.socket] = {}

    def start(self, client: socket.socket) -> None:
        """Serve a client in a new thread, unless there are too many."""
        self._threads = {one: its for one, its in self._threads.items() if one.is_alive()}
        if len(self._threads) >= MAX_CLIENTS:
            client.close()
            return
        thread = threading.Thread(target=self._serve, args=(client,), name="editor", daemon=True)
        self._threads[thread] = client
        thread.start()

    def close(self) -> None:
        """End all sessions."""
        for client in self._threads.values():
            _hang_up(client)
        for thread in self._threads:
            thread.join(_ENDING_S)

    def _serve(self, client: socket.socket) -> None:
        gate = Gate(self._token, self._seat)
        with contextlib.suppress(OSError), client:
            if is_of_another_user(client):
                return
            stream = loopback.BoundedStream(client)
            receive = partial(_receive, stream, io.BufferedReader(stream), gate)
            try:
                with client.makefile("wb") as sink:
                    hang_up = partial(_hang_up, client)
                    serve(
                        receive, sink, self._open_run, hang_up,
                        admit=gate.admit, folder=self._folder,
                    )  # fmt: skip
            finally:
                if gate.is_open:
                    os.chdir(self._folder)
                gate.close()


def _receive(
    stream: loopback.BoundedStream, buffered: io.BufferedReader, gate: Gate
) -> Message | None:
    """Return a client's next message, which must come soon if it has not shown the token."""
    if not gate.is_open:
        stream.deadline_s = time.monotonic() + loopback.STALL_S
        return read_message(buffered, _FIRST_MESSAGES)
    stream.deadline_s = None
    if not buffered.peek(1):
        return None
    stream.deadline_s = time.monotonic() + loopback.MESSAGE_S
    return read_message(buffered, MAX_MESSAGE_BYTES)


def _hang_up(client: socket.socket) -> None:
    with contextlib.suppress(OSError):  # the client was first
        client.shutdown(socket.SHUT_RDWR)
