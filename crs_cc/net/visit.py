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
"""Timeout for the environment's answer [s]."""


@dataclass(frozen=True, slots=True)
class Visit:
    """A connection to an environment that has accepted this host.

    Attributes:
        channel: the connection.
        robots: the robots whose programs run here.
        awaited: some of the other robots for which the run waits before it begins.
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
        hello: the identity of this host.
        program: its program, see `Program.content`.
        pulse: sends keep-alive messages.
        secure: encrypts a connection, after the first bytes have been sent.

    Raises:
        ConnectionLostError: the connection fails.
        RefusedError: the environment rejects this host, or has another certificate.
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
    """Switch to the local socket that an environment offers, or tell it that this is impossible."""
    way = take(offer)
    if way is None:
        channel.send(Kind.MOVED)
    else:
        channel.move(way, is_told=False)


def _welcome(channel: Channel) -> tuple[tuple[str, ...], tuple[str, ...], bool, str]:
    """Receive the environment's answer to a greeting.

    Return our robots, those for which the run waits, whether it needs our program, and the name of
    a local socket, if it offers one.
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
