r"""Events of the real network as changes of the run between two timesteps.

Whoever has the sockets of the real network makes these changes, and records them; made again, they
need no network. They can also be made by hand.

>>> unescaped(escaped(b"GET /\r\n \xff")) == b"GET /\r\n \xff", escaped(b"a b\n")
(True, 'a\\x20b\\n')
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

from crs_cc.session.network.addresses import HOST
from crs_cc.session.network.network import FIRST_PORT, PORTS
from crs_cc.session.network.operations import TIMEOUT_S
from crs_cc.session.network.sockets import (
    AF_INET,
    BUFFER,
    OUTSIDE,
    STREAM,
    Key,
    Machine,
    Socket,
)

if TYPE_CHECKING:
    from crs_cc.session.network.network import Network

MAX_MACHINES: Final = 64
MAX_CONNECTIONS: Final = 256
"""Connections of the real network at a time; chosen by us."""

_ESCAPE: Final = re.compile(rb"\\(?:x([0-9A-Fa-f]{2})|(.))")
_LETTERS: Final = {b"n": b"\n", b"r": b"\r", b"t": b"\t"}
_NAME: Final = re.compile(r"[\w.-]{1,60}", re.ASCII)


def add_machine(network: Network, name: str, port: int) -> None:
    """Make a port of a computer of the real network reachable; raise ValueError if it cannot be."""
    machines = network.state.machines
    if not _NAME.fullmatch(name):
        raise ValueError(f"{name[:60]!r} is not a name for a computer")
    if not 0 < port <= 0xFFFF:
        raise ValueError(f"{port} is not a port (1 to 65535)")
    if network.addresses.find(name, OUTSIDE) is not None and name not in network.machine_names:
        raise ValueError(f"a computer {name!r} already exists")
    if Machine(name, port) in machines:
        raise ValueError(f"{name}:{port} is already reachable")
    if len(machines) == MAX_MACHINES:
        raise ValueError(f"too many computers of the real network (maximum: {MAX_MACHINES})")
    network.state.machines = (*machines, Machine(name, port))


def open_connection(network: Network, robot: int, port: int, at_s: float) -> int:
    """Begin a connection from the real network to a robot's port; return its number.

    Raises:
        ValueError: there are too many.
    """
    if len(network.state.owned(OUTSIDE)) >= MAX_CONNECTIONS:
        raise ValueError(f"too many connections (maximum: {MAX_CONNECTIONS})")
    number = network.state.numbers.get(OUTSIDE, 0)
    to = network.addresses.own(robot), port
    origin = HOST, FIRST_PORT + number % PORTS
    until = network.cycle_after(at_s, TIMEOUT_S)
    made = Socket(AF_INET, STREAM, "connecting", origin, to, until=until)
    key = network.add_waiting(OUTSIDE, made)
    network.post(key, "open", None, at_s, to=to, origin=origin)
    return key[1]


def answer(network: Network, number: int, at_s: float, *, accepted: bool) -> None:
    """Accept or refuse a connection to the real network; ValueError if none is pending."""
    key, socket = _connection(network, number)
    if socket.condition != "connecting" or socket.peer is None:
        raise ValueError(f"connection {number} does not wait for an answer")
    if accepted:
        socket.condition = "connected"
        network.post(key, "opened", socket.peer, at_s)
    else:
        network.post(key, "refused", socket.peer, at_s)
        del network.state.sockets[key]


def send(network: Network, number: int, content: bytes, at_s: float) -> None:
    """Send bytes from the real network; raise ValueError if there is no room for them."""
    key, socket = _connection(network, number)
    if socket.condition != "connected" or socket.cannot_send:
        raise ValueError(f"connection {number} cannot send")
    if len(content) > BUFFER - socket.unread:
        raise ValueError(f"connection {number} has room for {BUFFER - socket.unread} bytes only")
    socket.unread += len(content)
    network.post(key, "data", socket.peer, at_s, content=content)


def send_space(network: Network, number: int) -> int:
    """Return the number of bytes that can be sent on a connection now; 0 if it is not open."""
    socket = network.state.sockets.get((OUTSIDE, number))
    if socket is None or socket.condition != "connected" or socket.cannot_send:
        return 0
    return BUFFER - socket.unread


def close(network: Network, number: int, at_s: float, *, at_once: bool) -> None:
    """End the sending side of a connection from the real network, or reset the connection."""
    key, socket = _connection(network, number)
    if socket.peer is not None and socket.condition == "connected" and not socket.cannot_send:
        network.post(key, "reset" if at_once else "end", socket.peer, at_s)
    socket.cannot_send = True
    if at_once or socket.at_end or socket.condition != "connected":
        del network.state.sockets[key]


def _connection(network: Network, number: int) -> tuple[Key, Socket]:
    key = OUTSIDE, number
    if key not in network.state.sockets:
        raise ValueError(f"no connection {number}")
    return key, network.state.sockets[key]


def escaped(content: bytes) -> str:
    """Return bytes as a word."""
    named = {ord("\n"): r"\n", ord("\r"): r"\r", ord("\t"): r"\t", ord("\\"): r"\\"}
    plain = set(range(ord("!"), ord("~") + 1)) - {ord("=")}  # which parts words, too
    return "".join(
        named.get(byte) or (chr(byte) if byte in plain else f"\\x{byte:02x}") for byte in content
    )


def unescaped(text: str) -> bytes:
    r"""Return the bytes of a text with escapes: `\n`, `\r`, `\t`, `\xNN`."""

    def character(match: re.Match[bytes]) -> bytes:
        if match[1] is not None:
            return bytes([int(match[1], 16)])
        return _LETTERS.get(match[2], match[2])

    return _ESCAPE.sub(character, text.encode("utf-8", "surrogateescape"))
