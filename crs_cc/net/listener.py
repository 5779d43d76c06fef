"""The single port of an environment, for hosts and for pages that show the run.

The first bytes of a connection distinguish them. Each connection is handled in a thread of its own,
with limits of time and memory, so that a silent or invalid one does not affect others.
"""

from __future__ import annotations

import contextlib
import json
import os
import socket
import threading
import time
from collections.abc import Callable
from typing import Final

from crs_cc.core.loopback import LOOPBACK
from crs_cc.net.access import Access
from crs_cc.net.channel import (
    HANDSHAKE_TIMEOUT_S,
    MAGIC,
    PROTOCOL,
    SWITCHING,
    TIMEOUT_S,
    Channel,
    ConnectionLostError,
    KeepAlive,
    Kind,
)
from crs_cc.net.handshake import Hello, Program, RefusedError
from crs_cc.net.host_registry import Assignment, HostRegistry
from crs_cc.net.local_socket import LocalListener, local_listener_for
from crs_cc.net.tls import Connection

MAX_HANDSHAKES: Final = 512
"""Limit of simultaneous handshakes; further connections are closed. Chosen by us."""

MAX_PAGE_CONNECTIONS: Final = 200
"""Limit of simultaneous connections of pages; further ones are rejected. Chosen by us."""

PROGRAM_TIMEOUT_S: Final = 60.0
"""Timeout for a host that sends or compiles its program [s]."""

MAX_LISTED: Final = 10
"""Limit of the robots listed to a host for which the run waits. Chosen by us."""

_POLL_S: Final = 0.01
_CHUNK: Final = 2**16

_UNAVAILABLE: Final = b"HTTP/1.1 503 Service Unavailable\r\nConnection: close\r\n"
_WAITING: Final = b"""<!doctype html><title>crs</title>
<p>The run has not begun: it waits for the programs of its robots.</p>
<script>setTimeout(() => location.reload(), 1000)</script>
"""

ConnectionHandler = Callable[[Connection], None]
"""Serves a connection that is not a host's, and closes it."""


def bound_socket(host: str, port: int) -> socket.socket:
    """Return a socket that is bound to an address.

    Raises:
        OSError: the port is in use, or there is no such host.
    """
    family, *_, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
    server_socket = socket.socket(family)
    if os.name == "posix":  # elsewhere two processes could listen
        server_socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        server_socket.bind(address)
    except OSError:
        server_socket.close()
        raise
    return server_socket


def reject(connection: Connection) -> None:
    """Close a connection that is rejected."""
    with contextlib.suppress(OSError):
        connection.sendall(_UNAVAILABLE + b"\r\n")
    connection.close()


def serve_waiting_page(connection: Connection) -> None:
    """Answer a page before the run begins; it reloads by itself."""
    with contextlib.suppress(OSError):
        connection.recv(_CHUNK)  # closing with unread data could discard the answer
        connection.sendall(_UNAVAILABLE + b"Content-Type: text/html\r\n\r\n" + _WAITING)
    connection.close()


def forwarder_to(port: int) -> ConnectionHandler:
    """Return a handler that forwards connections to a server on this machine."""

    def handle(connection: Connection) -> None:
        try:
            inner = socket.create_connection((LOOPBACK, port), HANDSHAKE_TIMEOUT_S)
        except OSError:
            reject(connection)
            return
        for each in (connection, inner):
            each.settimeout(None)
        back = threading.Thread(target=_forward, args=(inner, connection), daemon=True)
        back.start()
        _forward(connection, inner)
        back.join()
        for each in (connection, inner):
            each.close()

    return handle


def _forward(source: Connection, target: Connection) -> None:
    """Forward bytes until one side closes."""
    try:
        while part := source.recv(_CHUNK):
            target.sendall(part)
    except OSError:
        pass  # the other direction ends, too
    for each in (source, target):
        with contextlib.suppress(OSError):
            each.shutdown(socket.SHUT_RDWR)


class Listener:
    """Listens on a port until it is closed.

    Attributes:
        port: the port.
        page_handler: serves connections that are not a host's, such as those of pages.
    """

    def __init__(
        self,
        server_socket: socket.socket,
        access: Access,
        registry: HostRegistry,
        secure: Callable[[socket.socket], Connection] = lambda connection: connection,
        *,
        only_tcp: bool = False,
    ) -> None:
        """Start to listen.

        Args:
            server_socket: a socket that is bound to an address.
            access: the tokens.
            registry: the robots.
            secure: encrypts a connection, after the first bytes of a host have been read.
            only_tcp: whether hosts on this machine use TCP, too, see `local_socket`.
        """
        server_socket.listen()
        self.port = int(server_socket.getsockname()[1])
        self.page_handler: ConnectionHandler = serve_waiting_page
        self._server_socket, self._access, self._registry = server_socket, access, registry
        self._secure, self._offers = secure, not only_tcp
        self._handshakes = threading.Semaphore(MAX_HANDSHAKES)
        self._page_connections = threading.Semaphore(MAX_PAGE_CONNECTIONS)
        self._keep_alive = KeepAlive()
        self._keep_alive.__enter__()
        self._thread = threading.Thread(target=self._listen, name="crs-listener", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Stop listening."""
        with contextlib.suppress(OSError):
            self._server_socket.shutdown(socket.SHUT_RDWR)
        self._server_socket.close()
        self._keep_alive.__exit__()

    def _listen(self) -> None:
        while True:
            try:
                connection, _ = self._server_socket.accept()
            except OSError:
                if self._server_socket.fileno() < 0:
                    return
                time.sleep(_POLL_S)  # no descriptors left: one may be closed soon
                continue
            if not self._handshakes.acquire(blocking=False):
                connection.close()
                continue
            thread = threading.Thread(target=self._handle, args=(connection,), daemon=True)
            thread.start()

    def _handle(self, connection: socket.socket) -> None:
        """Handle a connection, in a thread."""
        try:
            connection.settimeout(HANDSHAKE_TIMEOUT_S)
            if self._is_host(connection):
                self._handle_host(self._secure(connection))
                return
            page_handler = self._secure(connection)
        except (OSError, ValueError):
            connection.close()
            return
        finally:
            self._handshakes.release()
        if not self._page_connections.acquire(blocking=False):
            reject(page_handler)
            return
        try:
            self.page_handler(page_handler)
        finally:
            self._page_connections.release()

    def _is_host(self, connection: socket.socket) -> bool:
        """Return whether the first bytes are those of a host, which are then read."""
        end_s = time.monotonic() + HANDSHAKE_TIMEOUT_S
        while time.monotonic() < end_s:
            found = connection.recv(len(MAGIC), socket.MSG_PEEK)
            if not found:
                raise ConnectionLostError("closed before any data")
            if found == MAGIC:
                connection.recv(len(MAGIC))
                return True
            if not MAGIC.startswith(found):
                return False
            time.sleep(_POLL_S)
        raise ConnectionLostError("too slow")

    def _handle_host(self, connection: Connection) -> None:
        """Accept a host, or reject it with a reason."""
        channel = Channel(connection, HANDSHAKE_TIMEOUT_S)
        assignment: Assignment | None = None
        self._keep_alive.add(channel)
        try:
            hello = Hello.of(channel.receive(Kind.HELLO, timeout_s=HANDSHAKE_TIMEOUT_S).content)
            self._access.require("robot", hello.token)
            assignment = self._registry.claim(hello)
            is_known = assignment.program is not None
            offer = local_listener_for(connection, hello.ends) if self._offers else None
            with offer or contextlib.nullcontext():
                self._welcome(channel, assignment, offer, send_program=not is_known)
            program = None
            if not is_known:
                content = channel.receive(Kind.PROGRAM, timeout_s=PROGRAM_TIMEOUT_S).content
                program = Program.of(content, hello.program)
            channel.receive(Kind.STARTED, timeout_s=PROGRAM_TIMEOUT_S)
            channel.set_timeout(TIMEOUT_S)
            self._registry.offer(assignment, channel, program)
        except RefusedError as error:
            with contextlib.suppress(ConnectionLostError):
                channel.send(Kind.REFUSED, str(error).encode())
            self._disconnect(assignment, channel)
        except (ConnectionLostError, OSError):
            self._disconnect(assignment, channel)

    def _welcome(
        self,
        channel: Channel,
        assignment: Assignment,
        offer: LocalListener | None,
        *,
        send_program: bool,
    ) -> None:
        """Send a host its robots, and switch to the local socket if the host accepts it."""
        answer = {
            "robots": assignment.names,
            "send_program": send_program,
            "awaited": self._registry.awaited(assignment)[:MAX_LISTED],
            "protocol": PROTOCOL,
            "offer": offer.name if offer else "",
        }
        channel.send(Kind.WELCOME, json.dumps(answer).encode())
        if (
            offer
            and channel.receive(Kind.SWITCHED, timeout_s=HANDSHAKE_TIMEOUT_S).content == SWITCHING
        ):
            channel.switch_to(offer.accept(), is_announced=True)

    def _disconnect(self, assignment: Assignment | None, channel: Channel) -> None:
        if assignment is not None:
            self._registry.withdraw(assignment, channel)
        self._keep_alive.remove(channel)
        channel.close()
