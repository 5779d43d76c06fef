"""A conversation with one client over any transport: a reply to each packet, in order.

Packets that a client sends before it has an answer are queued. Nothing is sent to a client that
does not read its answers. The robot of a disconnected client is free for the next one.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final, Protocol

from crs_cc.net.vendor.line_packets import LinePacket, LineReader
from crs_cc.net.vendor.line_robot import LineRobot
from crs_cc.net.vendor.nserver import NserverClient, refusal
from crs_cc.net.vendor.nserver_packets import (
    CONNECT,
    CREATE,
    DISCONNECT,
    BadPacketError,
    Packet,
    PacketReader,
    encode,
)

if TYPE_CHECKING:
    import asyncio

    from crs_cc.net.vendor.exchange import Exchange
    from crs_cc.net.vendor.switchboard import Switchboard

MAX_QUEUED: Final = 64
"""Limit of the queued packets of a client. Chosen by us."""

RETRY_S: Final = 0.02
MAX_TRIES: Final = 50
"""Interval [s] and number of attempts to assign a robot to a client. Chosen by us."""

PACKET_TIMEOUT_S: Final = 1.0
"""Time without data after which an incomplete packet on a serial line is discarded [s]: as long as
the client waits for a byte (vendor source `Ndirect.c` 2.7)."""

_REFUSED: Final = Packet(82, (0,))


class ClientConnection(Protocol):
    """The interface of a client's connection."""

    def send(self, content: bytes) -> None:
        """Send bytes to the client."""

    def pause(self, *, paused: bool) -> None:
        """Pause or resume reading from the client."""

    def is_of_another_user(self) -> bool:
        """Return whether the client is another user of this machine."""

    def close(self) -> None:
        """Close the connection when all data has been sent."""


class Conversation:
    """The base of both protocols: one packet is answered at a time.

    Attributes:
        robot: the robot's number; None until the client has one.
    """

    def __init__(
        self, board: Switchboard, connection: ClientConnection, loop: asyncio.AbstractEventLoop
    ) -> None:
        self.robot: int | None = None
        self.delay_s: Callable[[float], float] = lambda _at_s: 0.0
        self._board, self._connection, self._loop = board, connection, loop
        self._packets: deque[Any] = deque()
        self._is_busy = self._is_full = self._is_disconnected = False

    def add(self, packets: list[Any]) -> None:
        """Answer packets in order."""
        self._packets += packets
        self._process()

    def throttle(self, *, is_full: bool) -> None:
        """Stop sending answers while the client does not read them."""
        self._is_full = is_full
        self._process()

    def _process(self) -> None:
        while self._packets and not (self._is_busy or self._is_full or self._is_disconnected):
            self._handle(self._packets.popleft())
        self._connection.pause(paused=len(self._packets) > MAX_QUEUED)

    def _handle(self, packet: Any) -> None:
        raise NotImplementedError

    def _ask(self, exchange: Exchange[Any], then: Callable[[Any], None]) -> None:
        """Start an exchange with the robot; call a function with the result when it is due."""
        assert self.robot is not None
        self._is_busy = True

        def done(value: Any, at_s: float) -> None:
            self._loop.call_soon_threadsafe(later, value, at_s)

        def later(value: Any, at_s: float) -> None:
            self._loop.call_later(self.delay_s(at_s), finish, value)

        def finish(value: Any) -> None:
            self._is_busy = False
            if not self._is_disconnected:
                then(value)
                self._process()

        self._board.ask(self.robot, exchange, done)

    def disconnect(self) -> None:
        """Release the robot of a client that has disconnected."""
        self._is_disconnected = True
        self._packets.clear()
        if self.robot is not None:
            self._board.release(self.robot)
            self.robot = None


class NserverConversation(Conversation):
    """A conversation with a program that is linked with Nclient."""

    def __init__(
        self,
        board: Switchboard,
        connection: ClientConnection,
        loop: asyncio.AbstractEventLoop,
        port: int,
    ) -> None:
        super().__init__(board, connection, loop)
        self._reader = PacketReader()
        self._client = NserverClient(port)

    def receive(self, content: bytes) -> None:
        """Answer received packets; close the connection if the data is invalid."""
        try:
            self.add(self._reader.add(content))
        except BadPacketError:
            self._connection.close()

    def _handle(self, packet: Packet) -> None:
        if self.robot is None:
            if packet.type in (CONNECT, CREATE):
                self._reserve(packet, MAX_TRIES)
            else:
                self._send(refusal())
        elif packet.type == DISCONNECT:
            self.disconnect()
            self._connection.close()
        else:
            self._ask(self._client.answer(packet), self._answered)

    def _reserve(self, packet: Packet, tries: int) -> None:
        """Reserve a robot, and answer the packet that requests it.

        Its last client may just be disconnecting, or one of its requests may still be executed.
        """
        if self._is_disconnected:
            return
        self.robot = self._board.reserve(packet.elements[0])
        self._is_busy = self.robot is None and (tries > 0 or self._board.has_leaving_client)
        if self._is_busy:
            self._loop.call_later(RETRY_S, self._reserve, packet, tries - 1)
        elif self.robot is None:
            self._send(_REFUSED)
            self._process()
        elif self._connection.is_of_another_user():
            self.disconnect()
            self._connection.close()
        else:
            self._ask(self._client.answer(packet), self._answered)

    def _answered(self, reply: Packet) -> None:
        self._send(reply)
        if self._client.has_quit and self.robot is not None:
            self._board.release(self.robot, connected=False, ends=True)
            self.robot = None
            self._is_disconnected = True
            self._connection.close()

    def _send(self, reply: Packet) -> None:
        self._connection.send(encode(reply, is_wide=self._reader.is_wide))


class LineConversation(Conversation):
    """A conversation over a robot's line, with a program that is linked with Ndirect."""

    def __init__(
        self,
        board: Switchboard,
        connection: ClientConnection,
        loop: asyncio.AbstractEventLoop,
        robot: int,
        *,
        greets: bool,
    ) -> None:
        """Open the line.

        Args:
            board: connects it to the robot's relay.
            connection: the client's connection.
            loop: the event loop that serves it.
            robot: the robot, which has been reserved.
            greets: whether the robot sends the first packet, as over TCP.
        """
        super().__init__(board, connection, loop)
        self.robot = robot
        self._reader = LineReader()
        self._line = LineRobot()
        self._greets = greets
        self._timeout: asyncio.TimerHandle | None = None
        self._ask(self._line.open(), self._opened)

    def receive(self, content: bytes) -> None:
        """Answer the received packets; invalid or incomplete ones are skipped."""
        if self._timeout is not None:
            self._timeout.cancel()
        self._timeout = self._loop.call_later(PACKET_TIMEOUT_S, self._reader.forget)
        self.add(self._reader.add(content))

    def _opened(self, _value: object) -> None:
        if self._greets:
            self._connection.send(self._line.greeting())

    def _handle(self, packet: LinePacket) -> None:
        self._ask(self._line.answer(packet), self._connection.send)
