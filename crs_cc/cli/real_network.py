"""The connections between a run and the real network.

Connections are looked at between two timesteps. Whatever comes from outside is made a change of the
run, as `network 0 send hello`, and recorded as such; what programs send goes out.
"""

from __future__ import annotations

import select
import socket
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

import click

from crs_cc.core.loopback import LOOPBACK
from crs_cc.core.suggest import unknown
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.change import Change
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.world.run_edits import edit_run
from crs_cc.session.network import outside
from crs_cc.session.network.sockets import OUTSIDE

if TYPE_CHECKING:
    from crs_cc.cli.network_options import Forward, ReachableMachine
    from crs_cc.session.network.network import OutsideEvent
    from crs_cc.session.session import Session

PIECE: Final = 4096
"""The most bytes that one change brings."""

MAX_UNSENT: Final = 2**20
"""Limit of the unsent bytes of a connection to the real network; beyond it, it is closed."""

MAX_CONNECTIONS: Final = 64
_LAST_WORDS_S: Final = 1.0  # for what programs have sent before they ended


@dataclass(slots=True)
class _Connection:
    """A connection of the real network.

    Attributes:
        real: its socket, which never blocks.
        unsent: what a program has sent and is not on its way yet.
        is_made: whether it is connected, not only wanted.
        at_end: whether the program sends no more.
        is_read: whether the other end sends no more.
    """

    real: socket.socket
    unsent: bytearray = field(default_factory=bytearray)
    is_made: bool = True
    at_end: bool = False
    is_read: bool = False


class RealNetwork:
    """The connections of one run to the real network."""

    def __init__(
        self, session: Session, machines: Sequence[ReachableMachine], forwards: Sequence[Forward],
        noted: Callable[[Change], None],
    ) -> None:  # fmt: skip
        """Open the ports, and make the computers known to the run.

        Args:
            session: the run, before its first timestep.
            machines: what programs can reach.
            forwards: what leads to programs.
            noted: is called with each change that is made.

        Raises:
            click.UsageError: a name is unknown or taken.
            OSError: a port cannot be opened.
        """
        self._session = session
        self._noted = noted
        self._machines = {f"{machine.name}:{machine.port}": machine for machine in machines}
        self._events: list[tuple[int, OutsideEvent]] = []
        self._connections: dict[int, _Connection] = {}
        self._listeners: list[tuple[socket.socket, Forward]] = []
        session.network.network.on_outside_event = lambda number, event: self._events.append(
            (number, event)
        )
        names = [robot.id for robot in session.environment.world.robots]
        try:
            for machine in machines:
                self._change(f"network reach {machine.name} {machine.port}")
        except DebugError as error:
            raise click.UsageError(f"--connect: {error}.") from None
        for forward in forwards:
            if forward.robot and forward.robot not in names:
                raise click.UsageError(f"--forward: {unknown('robot', forward.robot, names)}.")
            self._listeners.append((_listen(forward.port), forward))

    def exchange(self) -> None:
        """Carry over what has come from either side, between two timesteps."""
        events, self._events = self._events, []
        for number, event in events:
            self._handle_event(number, *event)
        self._accept()
        for number, connection in list(self._connections.items()):
            if not connection.is_made:
                self._finish_connecting(number, connection)
            if connection.is_made and number in self._connections:
                self._receive(number, connection)
                self._send(number, connection)

    def close(self) -> None:
        """Send what programs have left to be sent, and close everything."""
        for number, (kind, content) in self._events:
            if kind == "data" and number in self._connections:
                self._connections[number].unsent += content
        for segment in self._session.network.network.state.segments.values():
            connection = self._connections.get((segment.target or (0, -1))[1])
            if segment.target is not None and segment.target[0] == OUTSIDE and connection:
                connection.unsent += segment.content
        for connection in self._connections.values():
            with suppress(OSError):
                connection.real.settimeout(_LAST_WORDS_S)
                connection.real.sendall(connection.unsent)
            connection.real.close()
        for listener, _ in self._listeners:
            listener.close()

    # -- from the run --------------------------------------------------------------------------

    def _handle_event(self, number: int, kind: str, content: bytes) -> None:
        """Apply a program's operation to a connection."""
        if kind == "open":
            self._open(number, content.decode())
            return
        connection = self._connections.get(number)
        if connection is None:
            return
        if kind == "data":
            connection.unsent += content
            if len(connection.unsent) > MAX_UNSENT:
                self._drop(number, "reset")
        elif kind == "end":
            connection.at_end = True
        elif kind in ("refused", "reset"):
            self._drop(number)

    def _open(self, number: int, machine: str) -> None:
        wanted = self._machines.get(machine)
        if wanted is None:  # made known by hand
            return
        try:
            found = socket.getaddrinfo(wanted.host, wanted.real_port, type=socket.SOCK_STREAM)
            real = socket.socket(*found[0][:3])
            real.setblocking(False)
            self._connections[number] = _Connection(real, is_made=False)
            with suppress(BlockingIOError):
                real.connect(found[0][4])
        except OSError:
            self._drop(number, "refuse")

    # -- from the real network -----------------------------------------------------------------

    def _accept(self) -> None:
        for listener, forward in self._listeners:
            with suppress(BlockingIOError):
                real, _ = listener.accept()
                real.setblocking(False)
                if len(self._connections) >= MAX_CONNECTIONS:
                    real.close()
                    continue
                robots = self._session.environment.world.robots
                number = self._session.network.network.state.numbers.get(OUTSIDE, 0)
                self._change(f"network call {forward.robot or robots[0].id} {forward.port}")
                self._connections[number] = _Connection(real)

    def _finish_connecting(self, number: int, connection: _Connection) -> None:
        _, writable, failed = select.select([], [connection.real], [connection.real], 0.0)
        if not writable and not failed:
            return
        if connection.real.getsockopt(socket.SOL_SOCKET, socket.SO_ERROR):
            self._drop(number, "refuse")
            return
        connection.is_made = True
        self._change_connection(number, "accept")

    def _receive(self, number: int, connection: _Connection) -> None:
        room = outside.send_space(self._session.network.network, number)
        if connection.is_read or not room:
            return
        try:
            content = connection.real.recv(min(room, PIECE))
        except BlockingIOError:
            return
        except OSError:
            self._drop(number, "reset")
            return
        if content:
            self._change_connection(number, f"send {outside.escaped(content)}")
        else:
            connection.is_read = True
            self._change_connection(number, "end")

    def _send(self, number: int, connection: _Connection) -> None:
        try:
            if connection.unsent:
                del connection.unsent[: connection.real.send(connection.unsent)]
        except BlockingIOError:
            return
        except OSError:
            self._drop(number, "reset")
            return
        if connection.at_end and not connection.unsent:
            with suppress(OSError):
                connection.real.shutdown(socket.SHUT_WR)
            if connection.is_read:
                self._drop(number)

    def _drop(self, number: int, action: str = "") -> None:
        """Close a connection, and do an action to its other end."""
        connection = self._connections.pop(number, None)
        if connection is not None:
            connection.real.close()
        if action:
            self._change_connection(number, action)

    def _change_connection(self, number: int, action: str) -> None:
        """Change a connection of the run, unless it is over there."""
        if (OUTSIDE, number) in self._session.network.network.state.sockets:
            self._change(f"network {number} {action}")

    def _change(self, text: str) -> None:
        edit_run(self._session, text)
        self._noted(Change(Position(self._session.timesteps, 0), text))


def _listen(port: int) -> socket.socket:
    listener = socket.socket()
    try:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind((LOOPBACK, port))
        listener.listen(MAX_CONNECTIONS)
        listener.setblocking(False)
    except OSError as error:
        listener.close()
        raise OSError(error.errno, f"port {port}: {error.strerror}") from None
    return listener
