"""The sockets of the vendor's clients: TCP and pseudo terminals, served in one thread.

The vendor's protocols have no token: whoever reaches a port drives its robot. So ports are opened
on the loopback interface, unless the user insists on another, and connections that do not begin
as a client's are closed soon. Only as many of them are open as there may be clients.
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

MAX_STRANGERS: Final = 32
"""Connections without a robot that may be open at once; chosen by us."""

OPENING_S: Final = 10.0
"""How long a connection may be without a robot; chosen by us."""

_STOP_S: Final = 5.0
_CHUNK: Final = 4096


class Server:
    """Serves clients until it is closed.

    Attributes:
        loop: runs in the clients' thread.
    """

    def __init__(
        self,
        board: Switchboard,
        delay_s: Callable[[float], float] = lambda _at_s: 0.0,
        host: str = LOOPBACK,
    ) -> None:
        """Start to serve; no port is open yet.

        Args:
            board: joins clients with robots.
            delay_s: returns in what real time a reply of some simulated time is due [s].
            host: the interface on which ports are opened.
        """
        self._board = board
        self._delay_s = delay_s
        self._host = host
        self._wires: set[_TcpWire] = set()
        self.loop = asyncio.new_event_loop()
        self.loop.set_exception_handler(lambda _loop, _context: None)  # of clients that have gone
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

        def talk(wire: _TcpWire) -> Conversation:
            return NserverConversation(self._board, wire, self.loop, wire.port)

        return self._listen(port, talk)

    def serve_line(self, port: int, robot: int) -> int:
        """Serve one program at a time that is linked with Ndirect, over TCP; return the port.

        Args:
            port: the port, 0 for any that is free.
            robot: the number of its robot.

        Raises:
            OSError: the port is in use.
        """

        def talk(wire: _TcpWire) -> Conversation | None:
            if wire.is_foreign() or not self._board.take_cabled(robot):
                return None
            return LineConversation(self._board, wire, self.loop, robot, greets=True)

        self._board.cable(robot)
        return self._listen(port, talk)

    def serve_terminal(self, robot: int) -> str:
        """Serve a program that is linked with Ndirect, on a pseudo terminal; return its name.

        Raises:
            OSError: the system has none.
        """
        terminal, name, close = open_terminal()
        self._board.cable(robot)
        self._board.take_cabled(robot)
        self._closers.append(close)
        self._do(
            lambda: _TerminalWire(self.loop, terminal).begin(self._board, robot, self._delay_s)
        )
        return name

    def close(self) -> None:
        """Say good-bye to all clients."""
        self.loop.call_soon_threadsafe(self.loop.stop)
        self._thread.join(_STOP_S)
        for close in self._closers:
            close()

    def _run(self) -> None:
        asyncio.set_event_loop(self.loop)
        self.loop.run_forever()
        for wire in list(self._wires):
            wire.abort()
        self.loop.run_until_complete(self.loop.shutdown_asyncgens())
        self.loop.close()

    def _do(self, work: Callable[[], Any]) -> None:
        """Do something in the clients' thread, and wait for it."""

        async def job() -> None:
            work()

        asyncio.run_coroutine_threadsafe(job(), self.loop).result(_STOP_S)

    def _listen(self, port: int, talk: Callable[[_TcpWire], Conversation | None]) -> int:
        def wire() -> _TcpWire:
            return _TcpWire(self.loop, self._wires, talk, self._delay_s)

        opening = self.loop.create_server(wire, self._host, port)
        server = asyncio.run_coroutine_threadsafe(opening, self.loop).result(_STOP_S)
        return int(server.sockets[0].getsockname()[1])


class _TcpWire(asyncio.Protocol):
    """One connection over TCP."""

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        wires: set[_TcpWire],
        talk: Callable[[_TcpWire], Conversation | None],
        delay_s: Callable[[float], float],
    ) -> None:
        self._loop, self._wires, self._talk, self._delay_s = loop, wires, talk, delay_s
        self._conversation: Any = None
        self._transport: asyncio.Transport

    @property
    def _is_stranger(self) -> bool:
        return self._conversation is None or self._conversation.robot is None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Begin a conversation, unless too many others have not begun theirs."""
        self._transport = cast("asyncio.Transport", transport)
        strangers = sum(wire._is_stranger for wire in self._wires)
        if strangers < MAX_STRANGERS:
            self._conversation = self._talk(self)
        if self._conversation is None:
            self._transport.abort()
            return
        self._conversation.delay_s = self._delay_s
        self._wires.add(self)
        self._loop.call_later(OPENING_S, self._end_if_stranger)

    @property
    def port(self) -> int:
        """The port that the client has reached."""
        return int(self._transport.get_extra_info("sockname")[1])

    def is_foreign(self) -> bool:
        """Return whether another user of this machine is at the other end."""
        client = self._transport.get_extra_info("socket")
        return is_loopback(client) and is_of_another_user(client)

    def data_received(self, data: bytes) -> None:
        """Answer what has come."""
        if self._conversation is not None:
            self._conversation.receive(data)

    def pause_writing(self) -> None:
        """Send no more answers: the client does not read them."""
        self._conversation.hold(is_full=True)

    def resume_writing(self) -> None:
        """Go on sending answers."""
        self._conversation.hold(is_full=False)

    def connection_lost(self, _error: Exception | None) -> None:
        """Leave the robot."""
        self._wires.discard(self)
        if self._conversation is not None:
            self._conversation.gone()

    def send(self, content: bytes) -> None:
        """Send bytes to the client."""
        self._transport.write(content)

    def pause(self, *, paused: bool) -> None:
        """Pause or resume reading from the client."""
        if paused == self._transport.is_reading() and not self._transport.is_closing():
            (self._transport.pause_reading if paused else self._transport.resume_reading)()

    def close(self) -> None:
        """End the connection when all has been sent."""
        self._transport.close()

    def abort(self) -> None:
        """End the connection at once."""
        self._transport.abort()

    def _end_if_stranger(self) -> None:
        if self._is_stranger:
            self._transport.abort()


class _TerminalWire:
    """The robot's end of a pseudo terminal; it is unknown whether a program has it open."""

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

    def is_foreign(self) -> bool:
        """Return False: the system gives the terminal to its user."""
        return False

    def close(self) -> None:
        """Do nothing: a line stays."""
