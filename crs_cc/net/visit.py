"""A host's connection to an environment: connect, authenticate, and claim robots."""

from __future__ import annotations

import json
import socket
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Final

from crs_cc.net.channel import (
    GONE,
    GREETING_S,
    MAGIC,
    SILENCE_S,
    Channel,
    ConnectionLostError,
    Kind,
    Pulse,
)
from crs_cc.net.handshake import Hello, RefusedError
from crs_cc.net.local_way import ends, take
from crs_cc.net.tls import Connection, UntrustedError

ANSWER_S: Final = 60.0
"""How long an environment may take to answer [s]."""


@dataclass(frozen=True, slots=True)
class Visit:
    """A connection to an environment that has taken this host.

    Attributes:
        channel: the connection.
        robots: the robots whose programs run here.
        awaited: others whom the run waits for before it begins, some of them if they are many.
    """

    channel: Channel
    robots: tuple[str, ...]
    awaited: tuple[str, ...] = ()


def visit(
    address: tuple[str, int],
    hello: Hello,
    program: bytes,
    pulse: Pulse,
    secure: Callable[[socket.socket], Connection] = lambda connection: connection,
) -> Visit:
    """Connect to an environment.

    Args:
        address: its host and port.
        hello: who this host is.
        program: its program, see `Program.content`.
        pulse: keeps the connection alive.
        secure: makes a connection secure, where the first bytes have been sent.

    Raises:
        ConnectionLostError: there is none, or it is gone.
        RefusedError: it does not take this host, or is not who it should be.
    """
    try:
        connection = socket.create_connection(address, GREETING_S)
        connection.sendall(MAGIC)
        secured = secure(connection)
        channel = Channel(secured, GREETING_S)
    except UntrustedError as error:
        raise RefusedError(str(error)) from None
    except OSError as error:
        raise ConnectionLostError(error.strerror or str(error)) from None
    pulse.add(channel)
    try:
        channel.send(Kind.HELLO, replace(hello, ends=ends(secured)).content())
        robots, awaited, wants_program, offer = _welcome(channel)
        if offer:
            _move(channel, offer)
        try:
            if wants_program:
                channel.send(Kind.PROGRAM, program)
            channel.send(Kind.STARTED)
        except ConnectionLostError:
            _welcome(channel)  # raises the refusal that has come, if any
            raise
        channel.limit_silence(SILENCE_S)
    except (ConnectionLostError, RefusedError) as error:
        pulse.remove(channel)
        channel.close()
        if secured is connection and str(error) == GONE:
            text = f"{GONE}; if it is served with --tls, give --fingerprint"
            raise ConnectionLostError(text) from None
        raise
    return Visit(channel, robots, awaited)


def _move(channel: Channel, offer: str) -> None:
    """Switch to the local socket that an environment offers, or report that this is impossible."""
    way = take(offer)
    if way is None:
        channel.send(Kind.MOVED)
    else:
        channel.move(way, is_told=False)


def _welcome(channel: Channel) -> tuple[tuple[str, ...], tuple[str, ...], bool, str]:
    """Return the reply of an environment: our robots, awaited ones, whether it needs our program.

    And the name of another way, if it offers one.
    """
    kind, content = channel.receive(Kind.WELCOME, Kind.REFUSED, within_s=ANSWER_S)
    if kind == Kind.REFUSED:
        raise RefusedError(content.decode("utf-8", "replace"))
    try:
        values = json.loads(content)
        robots, awaited = (tuple(map(str, values[each])) for each in ("robots", "awaited"))
        return robots, awaited, bool(values["send_program"]), str(values["offer"])
    except (ValueError, KeyError, TypeError, RecursionError):
        raise ConnectionLostError("invalid message from the environment") from None
