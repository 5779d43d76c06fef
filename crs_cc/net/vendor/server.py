"""The sockets of the vendor's clients: TCP and pseudo terminals, served in one thread.

The vendor's protocols have no token: anyone who can reach a port can drive its robot. So ports are
opened on the loopback interface by default, and connections that do not begin like a client's are
soon closed. Their number is limited.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final, cast

from crs_cc.core.host_system import is_of_another_user, open_terminal
from crs_cc.core.loopback import LOOPBACK, is_loopback
from crs_cc.net.vendor.conversation import (
    Conversation,
    LineConversation,
    NserverConversation,
)

if TYPE_CHECKING:
    from crs_cc.net.vendor.switchboard import Switchboard

MAX_WITHOUT_ROBOT: Final = 32
"""Limit of simultaneous connections without a robot. Chosen by us."""

OPENING_TIMEOUT_S: Final = 10.0
"""Time after which a connection without a robot is closed [s]. Chosen by us."""

_STOP_S: Final = 5.0
_CHUNK: Final = 4096


class Server:
    """Serves clients until it is closed.

    Attributes:
        loop: the event loop, which runs in the clients' thread.
    """

    def __init__(
        self,
        board: Switchboard,
        delay_s: Callable[[float], float] = lambda _at_s: 0.0,
        host: str = LOOPBACK,
    ) -> None:
        """Start to serve; no port is open yet.

        Args:
            board: connects clients to robots.
            delay_s: returns the real time after which a reply of a simulated time is due [s].
            host: the interface on which ports are opened.
        """
        self._board = board
        self._delay_s = delay_s
        self._host = host
        self._connections: set[_TcpConnection] = set()
        self.loop = asyncio.new_event_loop()
        self.loop.set_exception_handler(lambda _loop, _context: None)  # of disconnected clients
        self._thread = threading.Thread(target=self._run, name="vendor clients", daemon=True)
        self._closers: list[Callable[[], None]] = []
        self._thread.start()

    def serve_nserver(self, port: int) -> int:
        """Serve programs that are linked with Nclient; return the port.

        Args:
            port: the port, 0 for any that is free.

        Raises:
            OSError: the port is in use.
        """

        def new_conversation(connection: _TcpConnection) -> Conversation:
            return NserverConversation(self._board, connection, self.loop, connection.port)

        return self._listen(port, new_conversation)

    def serve_line(self, port: int, robot: int) -> int:
        """Serve one program at a time that is linked with Ndirect, over TCP; return the port.

        Args:
            port: the port, 0 for any that is free.
            robot: the number of its robot.

        Raises:
            OSError: the port is in use.
        """

        def new_conversation(connection: _TcpConnection) -> Conversation | None:
            if connection.is_of_another_user() or not self._board.reserve_cabled(robot):
                return None
            return LineConversation(self._board, connection, self.loop, robot, greets=True)

        self._board.set_cabled(robot)
        return self._listen(port, new_conversation)

    def serve_terminal(self, robot: int) -> str:
        """Serve a program that is linked with Ndirect, on a pseudo terminal; return its name.

        Raises:
            OSError: the system has none.
        """
        terminal, name, close = open_terminal()
        self._board.set_cabled(robot)
        self._board.reserve_cabled(robot)
        self._closers.append(close)
        self._run_in_loop(
            lambda: _TerminalConnection(self.loop, terminal).begin(
                self._board, robot, self._delay_s
            )
        )
        return name

    def close(self) -> None:
        """Disconnect all clients, and stop serving."""
        self.loop.call_soon_threadsafe(self.loop.stop)
        self._thread.join(_STOP_S)
        for close in self._closers:
            close()

    def _run(self) -> None:
        asyncio.set_event_loop(self.loop)
        self.loop.run_forever()
        for connection in list(self._connections):
            connection.abort()
        self.loop.run_until_complete(self.loop.shutdown_asyncgens())
        self.loop.close()

    def _run_in_loop(self, work: Callable[[], Any]) -> None:
        """Call a function in the clients' thread, and wait for it."""

        async def job() -> None:
            work()

        asyncio.run_coroutine_threadsafe(job(), self.loop).result(_STOP_S)

    def _listen(
        self, port: int, new_conversation: Callable[[_TcpConnection], Conversation | None]
    ) -> int:
        def connection() -> _TcpConnection:
            return _TcpConnection(self.loop, self._connections, new_conversation, self._delay_s)

        opening = self.loop.create_server(connection, self._host, port)
        server = asyncio.run_coroutine_threadsafe(opening, self.loop).result(_STOP_S)
        return int(server.sockets[0].getsockname()[1])


class _TcpConnection(asyncio.Protocol):
    """One connection over TCP."""

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        connections: set[_TcpConnection],
        new_conversation: Callable[[_TcpConnection], Conversation | None],
        delay_s: Callable[[float], float],
    ) -> None:
        self._loop, self._connections, self._new_conversation, self._delay_s = (
            loop,
            connections,
            new_conversation,
            delay_s,
        )
        self._conversation: Any = None
        self._transport: asyncio.Transport

    @property
    def _has_no_robot(self) -> bool:
        return self._conversation is None or self._conversation.robot is None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Start a conversation, unless too many connections have no robot yet."""
        self._transport = cast("asyncio.Transport", transport)
        waiting = sum(connection._has_no_robot for connection in self._connections)
        if waiting < MAX_WITHOUT_ROBOT:
            self._conversation = self._new_conversation(self)
        if self._conversation is None:
            self._transport.abort()
            return
        self._conversation.delay_s = self._delay_s
        self._connections.add(self)
        self._loop.call_later(OPENING_TIMEOUT_S, self._close_without_robot)

    @property
    def port(self) -> int:
        """The port that the client has reached."""
        return int(self._transport.get_extra_info("sockname")[1])

    def is_of_another_user(self) -> bool:
        """Return whether another user of this machine is at the other end."""
        client = self._transport.get_extra_info("socket")
        return is_loopback(client) and is_of_another_user(client)

    def data_received(self, data: bytes) -> None:
        """Answer received data."""
        if self._conversation is not None:
            self._conversation.receive(data)

    def pause_writing(self) -> None:
        """Stop sending answers: the client does not read them."""
        self._conversation.throttle(is_full=True)

    def resume_writing(self) -> None:
        """Resume sending answers."""
        self._conversation.throttle(is_full=False)

    def connection_lost(self, _error: Exception | None) -> None:
        """Release the robot."""
        self._connections.discard(self)
        if self._conversation is not None:
            self._conversation.disconnect()

    def send(self, content: bytes) -> None:
        """Send bytes to the client."""
        self._transport.write(content)

    def pause(self, *, paused: bool) -> None:
        """Pause or resume reading from the client."""
        if paused == self._transport.is_reading() and not self._transport.is_closing():
            (self._transport.pause_reading if paused else self._transport.resume_reading)()

    def close(self) -> None:
        """Close the connection when all data has been sent."""
        self._transport.close()

    def abort(self) -> None:
        """Close the connection immediately."""
        self._transport.abort()

    def _close_without_robot(self) -> None:
        if self._has_no_robot:
            self._transport.abort()


class _TerminalConnection:
    """The robot's end of a pseudo terminal; whether a program has opened it is unknown."""

    def __init__(self, loop: asyncio.AbstractEventLoop, terminal: int) -> None:
        self._loop, self._terminal = loop, terminal
        self._conversation: LineConversation

    def begin(self, board: Switchboard, robot: int, delay_s: Callable[[float], float]) -> None:
        """Open the line to a robot."""
        self._conversation = LineConversation(board, self, self._loop, robot, greets=False)
        self._conversation.delay_s = delay_s
        os.set_blocking(self._terminal, False)
        self._loop.add_reader(self._terminal, self._read)

    def _read(self) -> None:
        with contextlib.suppress(OSError):
            self._conversation.receive(os.read(self._terminal, _CHUNK))

    def send(self, content: bytes) -> None:
        """Send bytes to the client; drop those that it does not read."""
        with contextlib.suppress(OSError):
            os.write(self._terminal, content)

    def pause(self, *, paused: bool) -> None:
        """Pause or resume reading from the client."""
        if paused:
            self._loop.remove_reader(self._terminal)
        else:
            self._loop.add_reader(self._terminal, self._read)

    def is_of_another_user(self) -> bool:
        """Return False: the terminal belongs to its user."""
        return False

    def close(self) -> None:
        """Do nothing: the terminal stays open."""
