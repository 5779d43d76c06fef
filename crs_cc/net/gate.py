"""The single port of an environment, for hosts and for pages that show the run.

The first bytes of a connection tell them apart. Each connection is handled in a thread of its own,
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
    GREETING_S,
    MAGIC,
    MOVES,
    PROTOCOL,
    SILENCE_S,
    Channel,
    ConnectionLostError,
    Kind,
    Pulse,
)
from crs_cc.net.handshake import Hello, Program, RefusedError
from crs_cc.net.local_way import Offer, offered
from crs_cc.net.roster import Roster, Seat
from crs_cc.net.tls import Connection

MAX_MEETING: Final = 512
"""Limit of simultaneous handshakes; further connections are closed. Chosen by us."""

MAX_VISITORS: Final = 200
"""Limit of simultaneous connections of pages; further ones are rejected. Chosen by us."""

PROGRAM_S: Final = 60.0
"""Timeout for a host that sends or compiles its program [s]."""

MAX_SHOWN: Final = 10
"""Limit of the robots listed to a host for which the run waits. Chosen by us."""

_LOOK_S: Final = 0.01
_PART: Final = 2**16

_UNAVAILABLE: Final = b"HTTP/1.1 503 Service Unavailable\r\nConnection: close\r\n"
_WAITING: Final = b"""<!doctype html><title>crs</title>
<p>The run has not begun: it waits for the programs of its robots.</p>
<script>setTimeout(() => location.reload(), 1000)</script>
"""

Visitor = Callable[[Connection], None]
"""Serves a connection that is not a host's, and closes it."""


def bound(host: str, port: int) -> socket.socket:
    """Return a socket that is bound to an address.

    Raises:
        OSError: the port is in use, or there is no such host.
    """
    family, *_, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
    listener = socket.socket(family)
    if os.name == "posix":  # elsewhere two processes could listen
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind(address)
    except OSError:
        listener.close()
        raise
    return listener


def turn_away(connection: Connection) -> None:
    """Close a connection that is rejected."""
    with contextlib.suppress(OSError):
        connection.sendall(_UNAVAILABLE + b"\r\n")
    connection.close()


def tell_to_wait(connection: Connection) -> None:
    """Answer a page before the run begins; it reloads by itself."""
    with contextlib.suppress(OSError):
        connection.recv(_PART)  # or else closing might take the answer back
        connection.sendall(_UNAVAILABLE + b"Content-Type: text/html\r\n\r\n" + _WAITING)
    connection.close()


def led_to(port: int) -> Visitor:
    """Return what forwards connections to a server on this machine."""

    def lead(connection: Connection) -> None:
        try:
            inner = socket.create_connection((LOOPBACK, port), GREETING_S)
        except OSError:
            turn_away(connection)
            return
        for each in (connection, inner):
            each.settimeout(None)
        back = threading.Thread(target=_carry, args=(inner, connection), daemon=True)
        back.start()
        _carry(connection, inner)
        back.join()
        for each in (connection, inner):
            each.close()

    return lead


def _carry(source: Connection, target: Connection) -> None:
    """Forward bytes until one side closes."""
    try:
        while part := source.recv(_PART):
            target.sendall(part)
    except OSError:
        pass  # the other direction ends, too
    for each in (source, target):
        with contextlib.suppress(OSError):
            each.shutdown(socket.SHUT_RDWR)


class Gate:
    """Listens on a port until it is closed.

    Attributes:
        port: the port.
        visitor: serves connections that are not a host's, such as those of pages.
    """

    def __init__(
        self,
        listener: socket.socket,
        access: Access,
        roster: Roster,
        secure: Callable[[socket.socket], Connection] = lambda connection: connection,
        *,
        only_tcp: bool = False,
    ) -> None:
        """Start to listen.

        Args:
            listener: a socket that is bound to an address.
            access: the tokens.
            roster: the robots.
            secure: encrypts a connection, after the first bytes of a host have been read.
            only_tcp: whether hosts on this machine use TCP, too, see `local_way`.
        """
        listener.listen()
        self.port = int(listener.getsockname()[1])
        self.visitor: Visitor = tell_to_wait
        self._listener, self._access, self._roster = listener, access, roster
        self._secure, self._offers = secure, not only_tcp
        self._meeting = threading.Semaphore(MAX_MEETING)
        self._visiting = threading.Semaphore(MAX_VISITORS)
        self._pulse = Pulse()
        self._pulse.__enter__()
        self._thread = threading.Thread(target=self._listen, name="crs-gate", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Stop listening."""
        with contextlib.suppress(OSError):
            self._listener.shutdown(socket.SHUT_RDWR)
        self._listener.close()
        self._pulse.__exit__()

    def _listen(self) -> None:
        while True:
            try:
                connection, _ = self._listener.accept()
            except OSError:
                if self._listener.fileno() < 0:
                    return
                time.sleep(_LOOK_S)  # no descriptors left: one may be closed soon
                continue
            if not self._meeting.acquire(blocking=False):
                connection.close()
                continue
            thread = threading.Thread(target=self._meet, args=(connection,), daemon=True)
            thread.start()

    def _meet(self, connection: socket.socket) -> None:
        """Handle a connection, in a thread."""
        try:
            connection.settimeout(GREETING_S)
            if self._is_host(connection):
                self._meet_host(self._secure(connection))
                return
            visitor = self._secure(connection)
        except (OSError, ValueError):
            connection.close()
            return
        finally:
            self._meeting.release()
        if not self._visiting.acquire(blocking=False):
            turn_away(visitor)
            return
        try:
            self.visitor(visitor)
        finally:
            self._visiting.release()

    def _is_host(self, connection: socket.socket) -> bool:
        """Return whether the first bytes are those of a host, which are then read."""
        end_s = time.monotonic() + GREETING_S
        while time.monotonic() < end_s:
            found = connection.recv(len(MAGIC), socket.MSG_PEEK)
            if not found:
                raise ConnectionLostError("nothing said")
            if found == MAGIC:
                connection.recv(len(MAGIC))
                return True
            if not MAGIC.startswith(found):
                return False
            time.sleep(_LOOK_S)
        raise ConnectionLostError("too slow")

    def _meet_host(self, connection: Connection) -> None:
        """Accept a host, or reject it with a reason."""
        channel = Channel(connection, GREETING_S)
        seat: Seat | None = None
        self._pulse.add(channel)
        try:
            hello = Hello.of(channel.receive(Kind.HELLO, within_s=GREETING_S).content)
            self._access.require("robot", hello.token)
            seat = self._roster.claim(hello)
            is_known = seat.program is not None
            offer = offered(connection, hello.ends) if self._offers else None
            with offer or contextlib.nullcontext():
                self._welcome(channel, seat, offer, send_program=not is_known)
            program = None
            if not is_known:
                content = channel.receive(Kind.PROGRAM, within_s=PROGRAM_S).content
                program = Program.of(content, hello.program)
            channel.receive(Kind.STARTED, within_s=PROGRAM_S)
            channel.limit_silence(SILENCE_S)
            self._roster.offer(seat, channel, program)
        except RefusedError as error:
            with contextlib.suppress(ConnectionLostError):
                channel.send(Kind.REFUSED, str(error).encode())
            self._part(seat, channel)
        except (ConnectionLostError, OSError):
            self._part(seat, channel)

    def _welcome(
        self, channel: Channel, seat: Seat, offer: Offer | None, *, send_program: bool
    ) -> None:
        """Send a host its robots, and switch to the local socket if the host accepts it."""
        answer = {
            "robots": seat.names,
            "send_program": send_program,
            "awaited": self._roster.awaited(seat)[:MAX_SHOWN],
            "protocol": PROTOCOL,
            "offer": offer.name if offer else "",
        }
        channel.send(Kind.WELCOME, json.dumps(answer).encode())
        if offer and channel.receive(Kind.MOVED, within_s=GREETING_S).content == MOVES:
            channel.move(offer.taken(), is_told=True)

    def _part(self, seat: Seat | None, channel: Channel) -> None:
        if seat is not None:
            self._roster.withdraw(seat, channel)
        self._pulse.remove(channel)
        channel.close()
