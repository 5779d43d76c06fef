"""Messages over a connection: of limited size, numbered, and with checksums.

A message has a kind, a sequence number, a checksum and a content, whose maximum size depends on the
kind. Truncated, lost, corrupted, duplicated or reordered data ends the connection and never becomes
part of a run. An idle side sends keep-alive messages; a side that receives nothing for `SILENCE_S`
considers the other one lost.
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
"""Receive timeout [s]; with `ALIVE_S`, a loss is detected within two seconds."""

GREETING_S: Final = 5.0
"""Receive timeout during the handshake [s]: the other side may be behind a slow connection, whose
first packets are lost and sent again seconds later."""

ALIVE_S: Final = 0.4
"""Interval between keep-alive messages [s], at most."""

MAGIC: Final = b"CRS slots\r\n\x1a"
"""The first bytes of a host's connection; neither HTTP nor TLS begins with them."""

PROTOCOL: Final = 6
"""The protocol version."""


class Kind(IntEnum):
    """The kinds of messages."""

    HELLO = 1  # host, first message: its identity, as JSON
    WELCOME = 2  # environment: the host's robots, as JSON
    REFUSED = 3  # environment: the reason, as text
    PROGRAM = 4  # host: its program's files, as JSON
    RESTORE = 5  # environment: the state of the programs, see `memories`
    GRANT = 6  # environment: answers, and the time up to which programs may run
    RAN = 7  # host: the number of rounds, and the programs' requests
    ALIVE = 8  # either: keep-alive
    SAVE = 9  # environment: requests the programs' memories
    SAVED = 10  # host: the memories
    FAILED = 11  # host: the run-time error of a program, as JSON
    READ = 12  # environment: requests standard input
    INPUT = 13  # host: standard input
    END = 14  # environment: the result of the programs, as JSON; the run has ended for them
    STARTED = 15  # host: it is ready to run its programs
    MOVED = 16  # either: switches to a local socket, or does not, see `local_way`


_KINDS: Final = {int(kind): kind for kind in Kind}
_ALIVE: Final = Kind.ALIVE
"""Looked up once, because access to a member of an enumeration runs Python code."""

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
"""The maximum size of a content by kind [bytes], else `_SMALL`. Chosen by us."""

MOVES: Final = b"moves"
"""The content of `Kind.MOVED` if the sender switches; otherwise it is empty."""

_HEAD: Final = struct.Struct("<IIIII")
"""Kind, size, sequence number and CRC-32 of the content; then the CRC-32 of these fields, so that a
corrupted size is detected before the content is received. On local sockets, both are 0."""

_NO_SUMS: Final = 0, 0

HEAD_BYTES: Final = _HEAD.size
_CHECKED: Final = struct.Struct("<IIII")
_CHECKSUM: Final = struct.Struct("<I")
GONE: Final = "the other side has closed the connection"
_DAMAGED: Final = "a message is missing, doubled or damaged"
_NUMBERS: Final = 0xFFFFFFFF
_LEAST, _CHUNK = 2**14, 2**20

_LEAST_PROGRESS: Final = 2**10
"""The part of an incomplete message that must arrive within `SILENCE_S` [bytes]: more than
keep-alive messages have, which are all that arrives if a part was lost. Chosen by us."""


class ConnectionLostError(ConnectionError):
    """The connection is closed or silent, or the other side violated the protocol."""


class Message(NamedTuple):
    """A received message."""

    kind: Kind
    content: bytes


class Way(NamedTuple):
    """A local link between two processes: a connection for each direction.

    With a single connection, a process that waits for an answer is also woken when its question is
    read, because it might be waiting for buffer space.

    Attributes:
        into: the connection to receive from.
        out: the connection to send to.
    """

    into: socket.socket
    out: socket.socket

    def close(self) -> None:
        """Close both connections."""
        for each in self:
            each.close()


class Channel:
    """A connection that carries messages; any thread may send, and one may receive.

    Attributes:
        is_closed: whether it has been closed on this side.
        heard: how many times data was received.
    """

    def __init__(self, connection: Connection, silence_s: float | None = None) -> None:
        """Store a connection.

        Args:
            connection: a socket, perhaps encrypted.
            silence_s: the receive timeout [s]; `SILENCE_S` if None.
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
        """Whether it has switched to a local socket, see `move`."""
        return not self._expects_sums

    def limit_silence(self, silence_s: float) -> None:
        """Set the receive timeout [s].

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
        """Send a message in place: its content follows `HEAD_BYTES` of space for the header.

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
        """Send a keep-alive message if nothing was sent since the last call."""
        before, self._sent_before = self._sent_before, self._sent
        if before != self._sent or self._sending.locked():
            return
        with contextlib.suppress(
            ConnectionLostError, OSError, ValueError
        ):  # who receives finds out
            if _is_ready(self._sender, selectors.EVENT_WRITE):
                self.send(Kind.ALIVE)

    def receive_frame(self, kind: Kind, room: memoryview) -> int:
        """Receive a message of a kind in place, if it arrives in one part and nothing else does.

        Args:
            kind: the kind.
            room: the buffer for the message, with its header.

        Returns:
            the size of the message; 0 if anything else has arrived, which is left to `receive`.

        Raises:
            ConnectionLostError: nothing arrives.
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
        """Receive a message.

        Args:
            allowed: the permitted kinds.
            within_s: timeout for the whole message [s]; None for no limit while the other side is
                alive.

        Raises:
            ConnectionLostError: no valid message arrives.
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
        """Check a header, and return its kind, size and checksum of the content."""
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
        """Receive all parts of a message, and return it."""
        rest = self._rest
        self._await(HEAD_BYTES, end_s)
        end = HEAD_BYTES + self._head(rest, allowed)[1]
        self._await(end, end_s)
        message = bytes(rest[:end])
        del rest[:end]
        return message

    def _await(self, size: int, end_s: float | None) -> None:
        """Receive until a number of bytes is buffered; memory is allocated as they arrive."""
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
        """Receive some of the requested bytes."""
        try:
            part = self._connection.recv(min(max(size, _LEAST), _CHUNK))
        except OSError as error:
            raise self._lost(error) from None
        if not part:
            raise ConnectionLostError(GONE)
        self.heard += 1
        return part

    def _lost(self, error: OSError) -> ConnectionLostError:
        """Return the exception to raise for an error while receiving."""
        if isinstance(error, TimeoutError | BlockingIOError):  # by Python, or by the system
            return ConnectionLostError(f"no message for {self._silence_s:g} s")
        return ConnectionLostError(_reason(error))

    def listen(self) -> None:
        """Buffer the data that has arrived, without waiting; close a closed connection.

        Any thread may do this while no other one receives; the next call that receives reads the
        buffered data.
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
        """Switch to a local link, which corrupts nothing, so messages have no checksums there.

        The last message of each side on the old connection announces the switch, so that nothing is
        lost or duplicated even if another thread is sending.

        Args:
            way: the local link, which is closed with this channel.
            is_told: whether the other side has already announced the switch.

        Raises:
            ConnectionLostError: the other side does not switch.
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
    """A thread that sends keep-alive messages on channels, for use in a `with` block."""

    def __init__(self) -> None:
        self._channels: list[Channel] = []
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._beat, name="crs-pulse", daemon=True)

    def add(self, channel: Channel) -> None:
        """Send keep-alive messages on a channel from now on."""
        self._channels.append(channel)

    def remove(self, channel: Channel) -> None:
        """Stop sending them on a channel."""
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
