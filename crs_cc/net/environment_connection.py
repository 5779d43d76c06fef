"""A host's connection to an environment: connect, authenticate, and claim robots."""

from __future__ import annotations

import json
import socket
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Final

from crs_cc.net.channel import (
    CLOSED_BY_PEER,
    HANDSHAKE_TIMEOUT_S,
    MAGIC,
    TIMEOUT_S,
    Channel,
    ConnectionLostError,
    KeepAlive,
    Kind,
)
from crs_cc.net.handshake import Hello, RefusedError
from crs_cc.net.local_socket import connect_local, endpoints
from crs_cc.net.tls import Connection, UntrustedError

WELCOME_TIMEOUT_S: Final = 60.0
"""Timeout for the environment's answer [s]."""


@dataclass(frozen=True, slots=True)
class EnvironmentConnection:
    """A connection to an environment that has accepted this host.

    Attributes:
        channel: the connection.
        robots: the robots whose programs run here.
        awaited: some of the other robots for which the run waits before it begins.
    """

    channel: Channel
    robots: tuple[str, ...]
    awaited: tuple[str, ...] = ()


def connect(
    address: tuple[str, int],
    hello: Hello,
    program: bytes,
    keep_alive: KeepAlive,
    secure: Callable[[socket.socket], Connection] = lambda connection: connection,
) -> EnvironmentConnection:
    """Connect to an environment.

    Args:
        address: its host and port.
        hello: the identity of this host.
        program: its program, see `Program.content`.
        keep_alive: sends keep-alive messages.
        secure: encrypts a connection, after the first bytes have been sent.

    Raises:
        ConnectionLostError: the connection fails.
        RefusedError: the environment rejects this host, or has another certificate.
    """
    try:
        connection = socket.create_connection(address, HANDSHAKE_TIMEOUT_S)
        connection.sendall(MAGIC)
        secured = secure(connection)
        channel = Channel(secured, HANDSHAKE_TIMEOUT_S)
    except UntrustedError as error:
        raise RefusedError(str(error)) from None
    except OSError as error:
        raise ConnectionLostError(error.strerror or str(error)) from None
    keep_alive.add(channel)
    try:
        channel.send(Kind.HELLO, replace(hello, ends=endpoints(secured)).content())
        robots, awaited, wants_program, offer = _receive_welcome(channel)
        if offer:
            _switch_to_local(channel, offer)
        try:
            if wants_program:
                channel.send(Kind.PROGRAM, program)
            channel.send(Kind.STARTED)
        except ConnectionLostError:
            _receive_welcome(channel)  # raises the refusal that has come, if any
            raise
        channel.set_timeout(TIMEOUT_S)
    except (ConnectionLostError, RefusedError) as error:
        keep_alive.remove(channel)
        channel.close()
        if secured is connection and str(error) == CLOSED_BY_PEER:
            text = f"{CLOSED_BY_PEER}; if it is served with --tls, give --fingerprint"
            raise ConnectionLostError(text) from None
        raise
    return EnvironmentConnection(channel, robots, awaited)


def _switch_to_local(channel: Channel, offer: str) -> None:
    """Switch to the local socket that an environment offers, or report that this is impossible."""
    pair = connect_local(offer)
    if pair is None:
        channel.send(Kind.SWITCHED)
    else:
        channel.switch_to(pair, is_announced=False)


def _receive_welcome(channel: Channel) -> tuple[tuple[str, ...], tuple[str, ...], bool, str]:
    """Receive the environment's answer to our identity.

    Return our robots, those for which the run waits, whether it needs our program, and the name of
    a local socket, if it offers one.
    """
    kind, content = channel.receive(Kind.WELCOME, Kind.REFUSED, timeout_s=WELCOME_TIMEOUT_S)
    if kind == Kind.REFUSED:
        raise RefusedError(content.decode("utf-8", "replace"))
    try:
        values = json.loads(content)
        robots, awaited = (tuple(map(str, values[each])) for each in ("robots", "awaited"))
        return robots, awaited, bool(values["send_program"]), str(values["offer"])
    except (ValueError, KeyError, TypeError, RecursionError):
        raise ConnectionLostError("invalid message from the environment") from None
