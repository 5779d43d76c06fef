"""Messages over a connection: bounded, numbered and checked.

A message has a kind, a number that rises by one, a checksum, and a content whose size depends on
its kind. So what is cut, lost, damaged, doubled or in the wrong order on the way ends the
connection, and never becomes part of a run. Each side says that it is alive while it has nothing to
say; whoever hears nothing for `SILENCE_S` gives the other up.
"""

from __future__ import annotations

import contextlib
import errno
import selectors
import socket
import struct
import threading
import time
import zlib
from enum import IntEnum
from typing import Final, NamedTuple, Self

from crs_cc.core.host_system import limit_waits
from crs_cc.net.tls import Connection

SILENCE_S: Final = 1.5
"""How long a side may say nothing [s]; with `ALIVE_S`, a loss is noticed in two seconds."""

GREETING_S: Final = 5.0
"""How long it may say nothing until it is known who it is [s]: it may be far away, or behind a slow
connection, whose first packets are lost and sent again after seconds."""

ALIVE_S: Final = 0.4
"""How often a side says that it is alive [s]."""

MAGIC: Final = b"CRS slots\r\n\x1a"
"""The first bytes of a connection: no request of HTTP and no greeting of TLS begins so."""

PROTOCOL: Final = 6
"""The version of what is said here."""


class Kind(IntEnum):
    """The kinds of messages."""

    HELLO = 1  # a host, first: who it is, as JSON
    WELCOME = 2  # the environment: the robots, as JSON
    REFUSED = 3  # the environment: why not, as text
    PROGRAM = 4  # a host: its program's files, as JSON
    RESTORE = 5  # the environment: where the programs stand, see `memories`
    GRANT = 6  # the environment: until when programs may run, with answers
    RAN = 7  # a host: rounds, and what the programs ask for
    ALIVE = 8  # either
    SAVE = 9  # the environment: asks for memories
    SAVED = 10  # a host: memories
    FAILED = 11  # a host: what a robot's program did wrong, as JSON
    READ = 12  # the environment: asks for standard input
    INPUT = 13  # a host: standard input
    END = 14  # the environment: the run has ended for these programs, as JSON
    STARTED = 15  # a host: it can run its programs
    MOVED = 16  # either: what follows goes another way, see `local_way`; or that it does not


_KINDS: Final = {int(kind): kind for kind in Kind}
_ALIVE: Final = Kind.ALIVE
"""A member of a class of names is looked up in Python: not for each message."""

_SMALL, _LARGE = 64 * 2**10, 256 * 2**20
_MOST: Final = {
    Kind.GRANT: _LARGE,
    Kind.RAN: _LARGE,
    Kind.SAVED: _LARGE,
    Kind.RESTORE: _LARGE,
    Kind.PROGRAM: 64 * 2**20,
    Kind.FAILED: 2**20,
    Kind.END: 2**20,
}
"""The largest content of a kind [bytes]; others are small. Chosen by us."""

MOVES: Final = b"moves"
"""The content of `Kind.MOVED` of a side that moves; else it stays."""

_HEAD: Final = struct.Struct("<IIIII")
"""Kind, size, number, and CRC-32 of the content; then the CRC-32 of these, so that nobody waits for
the rest of a message whose size is damaged. On a way on which nothing is, both are 0."""

_NO_SUMS: Final = 0, 0

HEAD_BYTES: Final = _HEAD.size
_CHECKED: Final = struct.Struct("<IIII")
_CHECKSUM: Final = struct.Struct("<I")
GONE: Final = "the other side has closed the connection"
_DAMAGED: Final = "a message is missing, doubled or damaged"
_NUMBERS: Final = 0xFFFFFFFF
_LEAST, _CHUNK = 2**14, 2**20

_LEAST_PROGRESS: Final = 2**10
"""What comes in `SILENCE_S` of a message that has begun [bytes], at least: more than a side sends
that only says that it is alive, as where a part of the message was lost. Chosen by us."""


class ConnectionLostError(ConnectionError):
    """The other side is gone, is silent, or does not keep to the protocol."""


class Message(NamedTuple):
    """A message that has arrived."""

    kind: Kind
    content: bytes


class Way(NamedTuple):
    """A way between two processes of one machine: a connection for each direction.

    With one connection for both, whoever waits for an answer is also woken when its question is
    read, because it might wait for room to send more.

    Attributes:
        into: the connection on which to receive.
        out: the connection on which to send.
    """

    into: socket.socket
    out: socket.socket

    def close(self) -> None:
        """Close both connections."""
        for each in self:
            each.close()


class Channel:
    """A connection, over which any thread may send and one may receive.

    Attributes:
        is_closed: whether it has been closed on this side.
        heard: how often something has come from the other side.
    """

    def __init__(self, connection: Connection, silence_s: float | None = None) -> None:
        """Store a connection.

        Args:
            connection: a socket, perhaps encrypted.
            silence_s: how long the other side may say nothing [s]; `SILENCE_S` if None.
        """
        with contextlib.suppress(OSError):  # a socket of another family
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.is_closed = False
        self._connection = self._sender = connection  # two once it has moved
        self._sends_sums = self._expects_sums = True
        self.limit_silence(SILENCE_S if silence_s is None else silence_s)
        self._sending, self._receiving = threading.Lock(), threading.Lock()
        self._rest = bytearray()  # received, and not read
        self._sent = self._received = 0
        self._sent_before, self.heard = -1, 0

    @property
    def is_local(self) -> bool:
        """Whether it has moved to another way on this machine, see `move`."""
        return not self._expects_sums

    def limit_silence(self, silence_s: float) -> None:
        """Set how long the other side may say nothing [s].

        Raises:
            ConnectionLostError: the connection has been closed.
        """
        self._silence_s = silence_s
        try:
            for each in {self._connection, self._sender}:
                limit_waits(each, silence_s)
        except OSError as error:
            raise ConnectionLostError(_reason(error)) from None

    def send(self, kind: Kind, content: bytes = b"") -> None:
        """Send a message.

        Raises:
            ConnectionLostError: it cannot be sent.
        """
        self.send_frame(kind, memoryview(bytearray(HEAD_BYTES) + content))

    def send_frame(self, kind: Kind, frame: memoryview) -> None:
        """Send a message whose content stands behind `HEAD_BYTES` of room.

        Raises:
            ConnectionLostError: it cannot be sent.
        """
        with self._sending:
            self._send(kind, frame)

    def _send(self, kind: Kind, frame: memoryview) -> None:
        size, number = len(frame), self._sent
        if self._sends_sums:
            checksum = zlib.crc32(frame[HEAD_BYTES:])
            _CHECKED.pack_into(frame, 0, kind, size - HEAD_BYTES, number, checksum)
            _CHECKSUM.pack_into(frame, _CHECKED.size, zlib.crc32(frame[: _CHECKED.size]))
        else:
            _HEAD.pack_into(frame, 0, kind, size - HEAD_BYTES, number, 0, 0)
        self._sent = (number + 1) & _NUMBERS
        try:
            sent = self._sender.send(frame)
            while sent < size:  # as long as something is taken, however slowly
                sent += self._sender.send(frame[sent:])
        except OSError as error:
            raise ConnectionLostError(_reason(error)) from None

    def stay_alive(self) -> None:
        """Say that this side is alive, if it has said nothing since this was last called."""
        before, self._sent_before = self._sent_before, self._sent
        if before != self._sent or self._sending.locked():
            return
        with contextlib.suppress(
            ConnectionLostError, OSError, ValueError
        ):  # who receives finds out
            if _is_ready(self._sender, selectors.EVENT_WRITE):
                self.send(Kind.ALIVE)

    def receive_frame(self, kind: Kind, room: memoryview) -> int:
        """Wait for something: as a rule a whole message of a kind, which is not copied then.

        Args:
            kind: the kind.
            room: where it is put, with its head.

        Returns:
            the size of the message; 0 if anything else has come, which `receive` takes.

        Raises:
            ConnectionLostError: nothing comes.
        """
        with self._receiving:
            if self._rest:  # somebody has listened meanwhile
                return 0
            try:
                size = self._connection.recv_into(room)
            except OSError as error:
                raise self._lost(error) from None
            if not size:
                raise ConnectionLostError(GONE)
            self.heard += 1
            if size >= HEAD_BYTES:
                number = self._received
                sums = _sums(room[:size]) if self._expects_sums else _NO_SUMS
                if _HEAD.unpack_from(room) == (kind, size - HEAD_BYTES, number, *sums):
                    self._received = (number + 1) & _NUMBERS
                    return size
            self._rest += room[:size]
            return 0

    def receive(self, *allowed: Kind, within_s: float | None = None) -> Message:
        """Wait for a message.

        Args:
            allowed: the kinds that are expected.
            within_s: how long it may take in all; for ever if the other side is alive.

        Raises:
            ConnectionLostError: it does not come, or is not valid.
        """
        end_s = None if within_s is None else time.monotonic() + within_s
        while True:
            message = self._assembled(allowed, end_s)
            kind, _, checksum = self._head(message, allowed)
            content = message[HEAD_BYTES:]
            if self._expects_sums and zlib.crc32(content) != checksum:
                raise ConnectionLostError(_DAMAGED)
            self._received = (self._received + 1) & _NUMBERS
            if kind != _ALIVE:
                return Message(_KINDS[kind], content)

    def _head(self, message: bytes | bytearray, allowed: tuple[Kind, ...]) -> tuple[int, int, int]:
        """Return kind, size and checksum of what begins with a head, which is checked."""
        kind, size, number, content_checksum, checksum = _HEAD.unpack_from(message)
        is_sound = not self._expects_sums or zlib.crc32(message[: _CHECKED.size]) == checksum
        if not is_sound or number != self._received:
            raise ConnectionLostError(_DAMAGED)
        if kind not in allowed and kind != _ALIVE:
            raise ConnectionLostError(f"unexpected message of kind {kind}")
        if size > _MOST.get(kind, _SMALL):
            raise ConnectionLostError(f"message of {size} bytes is too long")
        return kind, size, content_checksum

    def _assembled(self, allowed: tuple[Kind, ...], end_s: float | None) -> bytes:
        """Wait for the parts of a message, and return it."""
        rest = self._rest
        self._await(HEAD_BYTES, end_s)
        end = HEAD_BYTES + self._head(rest, allowed)[1]
        self._await(end, end_s)
        message = bytes(rest[:end])
        del rest[:end]
        return message

    def _await(self, size: int, end_s: float | None) -> None:
        """Wait for a number of unread bytes; memory is allocated as they arrive."""
        rest = self._rest
        look_s, least = 0.0, 0  # when to look whether so many bytes have come
        while len(rest) < size:
            if end_s is not None and time.monotonic() > end_s:
                raise ConnectionLostError("too slow")
            with self._receiving:
                if len(rest) < size:  # or else somebody has listened meanwhile
                    rest += self._part(size - len(rest))
            if (now_s := time.monotonic()) > look_s:
                if len(rest) < min(size, least):
                    raise ConnectionLostError("too slow")
                look_s, least = now_s + self._silence_s, len(rest) + _LEAST_PROGRESS

    def _part(self, size: int) -> bytes:
        """Return some of the requested bytes."""
        try:
            part = self._connection.recv(min(max(size, _LEAST), _CHUNK))
        except OSError as error:
            raise self._lost(error) from None
        if not part:
            raise ConnectionLostError(GONE)
        self.heard += 1
        return part

    def _lost(self, error: OSError) -> ConnectionLostError:
        """Return what is to be raised where receiving fails."""
        if isinstance(error, TimeoutError | BlockingIOError):  # by Python, or by the system
            return ConnectionLostError(f"no message for {self._silence_s:g} s")
        return ConnectionLostError(_reason(error))

    def listen(self) -> None:
        """Note what has come, and close the connection if the other side has; do not wait.

        Any thread may do so while nobody receives: what has come is kept for who receives next.
        """
        if not self._receiving.acquire(blocking=False):
            return  # who receives finds out
        try:
            while len(self._rest) < _CHUNK and _is_ready(self._connection, selectors.EVENT_READ):
                self._rest += self._part(_CHUNK)
        except (OSError, ValueError):  # or it has been closed here
            self.close()
        finally:
            self._receiving.release()

    def move(self, way: Way, *, is_told: bool) -> None:
        """Go another way, between two processes of one machine, on which nothing is damaged.

        What each side says last on the old way is that it moves; so nothing is lost or doubled,
        though another thread may be sending. On the new way, contents have no checksums.

        Args:
            way: the other way, which is closed with this channel.
            is_told: whether the other side has said already that it moves.

        Raises:
            ConnectionLostError: the other side does not move.
        """
        with self._sending:
            self._send(Kind.MOVED, memoryview(bytearray(HEAD_BYTES) + MOVES))
            self._sender, self._sends_sums = way.out, False
        if not is_told and self.receive(Kind.MOVED, within_s=GREETING_S).content != MOVES:
            raise ConnectionLostError("no progress")
        with self._receiving:
            if self._rest:
                raise ConnectionLostError(_DAMAGED)
            self._connection, old = way.into, self._connection
            self._expects_sums = False
        self.limit_silence(self._silence_s)
        old.close()

    def close(self) -> None:
        """Close the connection; waiting threads are notified."""
        self.is_closed = True
        for each in {self._connection, self._sender}:
            with contextlib.suppress(OSError):
                each.shutdown(socket.SHUT_RDWR)
            with contextlib.suppress(OSError):
                each.close()


class Pulse:
    """A thread in which channels say that they are alive, for use in a `with` block."""

    def __init__(self) -> None:
        self._channels: list[Channel] = []
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._beat, name="crs-pulse", daemon=True)

    def add(self, channel: Channel) -> None:
        """Keep a channel alive."""
        self._channels.append(channel)

    def remove(self, channel: Channel) -> None:
        """Forget a channel."""
        with contextlib.suppress(ValueError):
            self._channels.remove(channel)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()
        self._thread.join()

    def _beat(self) -> None:
        while not self._ended.wait(ALIVE_S / 2):
            for channel in tuple(self._channels):
                if channel.is_closed:
                    self.remove(channel)
                else:
                    channel.stay_alive()


def _sums(frame: memoryview) -> tuple[int, int]:
    """Return the checksums of a message: of its content, and of its head."""
    return zlib.crc32(frame[HEAD_BYTES:]), zlib.crc32(frame[: _CHECKED.size])


def _is_ready(connection: Connection, event: int) -> bool:
    """Return whether receiving, or sending a short message, does not have to wait."""
    with selectors.DefaultSelector() as selector:
        selector.register(connection, event)
        return bool(selector.select(0.0))


def _reason(error: OSError) -> str:
    if isinstance(error, BlockingIOError):
        return "timed out"
    if isinstance(error, BrokenPipeError | ConnectionResetError):
        return GONE
    if error.errno == errno.EBADF:  # closed here, as nothing was heard
        return "the connection is closed"
    return error.strerror or str(error) or "the connection is closed"
