"""A conversation with one client over any transport: a reply to each packet, in order.

A client that sends more before it has its answer waits; one that does not read its answers gets no
more; one that goes leaves its robot to the next.
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

MAX_WAITING: Final = 64
"""Packets of a client that may wait for their answers; chosen by us."""

TRY_S: Final = 0.02
TRIES: Final = 50
"""How often, and in what intervals, a client's request for a robot is tried; chosen by us."""

SILENCE_S: Final = 1.0
"""After what silence a packet on a line is given up: as long as the client waits for a byte
(vendor source `Ndirect.c` 2.7)."""

_REFUSED: Final = Packet(82, (0,))


class Wire(Protocol):
    """What a conversation needs of the client's connection."""

    def send(self, content: bytes) -> None:
        """Send bytes to the client."""

    def pause(self, *, paused: bool) -> None:
        """Pause or resume reading from the client."""

    def is_foreign(self) -> bool:
        """Return whether the client is another user of this machine."""

    def close(self) -> None:
        """End the connection when all has been sent."""


class Conversation:
    """What both protocols have in common: one packet is answered at a time.

    Attributes:
        robot: the robot's number; None until the client has one.
    """

    def __init__(self, board: Switchboard, wire: Wire, loop: asyncio.AbstractEventLoop) -> None:
        self.robot: int | None = None
        self.delay_s: Callable[[float], float] = lambda _at_s: 0.0
        self._board, self._wire, self._loop = board, wire, loop
        self._packets: deque[Any] = deque()
        self._is_busy = self._is_full = self._has_gone = False

    def add(self, packets: list[Any]) -> None:
        """Answer packets, each after those before it."""
        self._packets += packets
        self._go_on()

    def hold(self, *, is_full: bool) -> None:
        """Send no answers while the client does not read them."""
        self._is_full = is_full
        self._go_on()

    def _go_on(self) -> None:
        while self._packets and not (self._is_busy or self._is_full or self._has_gone):
            self._begin(self._packets.popleft())
        self._wire.pause(paused=len(self._packets) > MAX_WAITING)

    def _begin(self, packet: Any) -> None:
        raise NotImplementedError

    def _ask(self, exchange: Exchange[Any], then: Callable[[Any], None]) -> None:
        """Have an exchange with the robot, and do something with the result at its time."""
        assert self.robot is not None
        self._is_busy = True

        def done(value: Any, at_s: float) -> None:
            self._loop.call_soon_threadsafe(later, value, at_s)

        def later(value: Any, at_s: float) -> None:
            self._loop.call_later(self.delay_s(at_s), finish, value)

        def finish(value: Any) -> None:
            self._is_busy = False
            if not self._has_gone:
                then(value)
                self._go_on()

        self._board.ask(self.robot, exchange, done)

    def gone(self) -> None:
        """Leave the robot: the client has gone."""
        self._has_gone = True
        self._packets.clear()
        if self.robot is not None:
            self._board.release(self.robot)
            self.robot = None


class NserverConversation(Conversation):
    """A conversation with a program that is linked with Nclient."""

    def __init__(
        self, board: Switchboard, wire: Wire, loop: asyncio.AbstractEventLoop, port: int
    ) -> None:
        super().__init__(board, wire, loop)
        self._reader = PacketReader()
        self._client = NserverClient(port)

    def receive(self, content: bytes) -> None:
        """Answer what has come; close the connection if it is no packet."""
        try:
            self.add(self._reader.add(content))
        except BadPacketError:
            self._wire.close()

    def _begin(self, packet: Packet) -> None:
        if self.robot is None:
            if packet.type in (CONNECT, CREATE):
                self._take(packet, TRIES)
            else:
                self._send(refusal())
        elif packet.type == DISCONNECT:
            self.gone()
            self._wire.close()
        else:
            self._ask(self._client.answer(packet), self._answered)

    def _take(self, packet: Packet, tries: int) -> None:
        """Take a robot, and answer the packet that asks for it.

        Whoever had the robot before may just be leaving it, or it still does what he has asked for.
        """
        if self._has_gone:
            return
        self.robot = self._board.take(packet.elements[0])
        self._is_busy = self.robot is None and (tries > 0 or self._board.is_one_left)
        if self._is_busy:
            self._loop.call_later(TRY_S, self._take, packet, tries - 1)
        elif self.robot is None:
            self._send(_REFUSED)
            self._go_on()
        elif self._wire.is_foreign():
            self.gone()
            self._wire.close()
        else:
            self._ask(self._client.answer(packet), self._answered)

    def _answered(self, reply: Packet) -> None:
        self._send(reply)
        if self._client.has_quit and self.robot is not None:
            self._board.release(self.robot, connected=False, ends=True)
            self.robot = None
            self._has_gone = True
            self._wire.close()

    def _send(self, reply: Packet) -> None:
        self._wire.send(encode(reply, is_wide=self._reader.is_wide))


class LineConversation(Conversation):
    """A conversation over a robot's line, with a program that is linked with Ndirect."""

    def __init__(
        self,
        board: Switchboard,
        wire: Wire,
        loop: asyncio.AbstractEventLoop,
        robot: int,
        *,
        greets: bool,
    ) -> None:
        """Open the line.

        Args:
            board: joins it with the robot's relay.
            wire: the client's connection.
            loop: the loop that serves it.
            robot: the robot, which has been taken.
            greets: whether the robot speaks first, as over TCP.
        """
        super().__init__(board, wire, loop)
        self.robot = robot
        self._reader = LineReader()
        self._line = LineRobot()
        self._greets = greets
        self._silence: asyncio.TimerHandle | None = None
        self._ask(self._line.open(), self._opened)

    def receive(self, content: bytes) -> None:
        """Answer the received packets; invalid or incomplete ones are skipped."""
        if self._silence is not None:
            self._silence.cancel()
        self._silence = self._loop.call_later(SILENCE_S, self._reader.forget)
        self.add(self._reader.add(content))

    def _opened(self, _value: object) -> None:
        if self._greets:
            self._wire.send(self._line.greeting())

    def _begin(self, packet: LinePacket) -> None:
        self._ask(self._line.answer(packet), self._wire.send)
