"""Messages over a connection: of limited size, numbered, and with checksums.

A message has a kind, a sequence number, a checksum and a content, whose maximum size depends on the
kind. Truncated, lost, corrupted, duplicated or reordered data ends the connection and never becomes
part of a run. An idle side sends keep-alive messages; a side that receives nothing for `TIMEOUT_S`
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

TIMEOUT_S: Final = 1.5
"""Receive timeout [s]; with `KEEP_ALIVE_S`, a loss is detected within two seconds."""

HANDSHAKE_TIMEOUT_S: Final = 5.0
"""Receive timeout during the handshake [s]: the other side may be behind a slow connection, whose
first packets are lost and sent again seconds later."""

KEEP_ALIVE_S: Final = 0.4
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
    KEEP_ALIVE = 8  # either: keep-alive
    SAVE = 9  # environment: requests the programs' memories
    SAVED = 10  # host: the memories
    FAILED = 11  # host: the run-time error of a program, as JSON
    READ = 12  # environment: requests standard input
    INPUT = 13  # host: standard input
    END = 14  # environment: the result of the programs, as JSON; the run has ended for them
    STARTED = 15  # host: it is ready to run its programs
    SWITCHED = 16  # either: switches to a local socket, or does not, see `local_socket`


_KINDS: Final = {int(kind): kind for kind in Kind}
_KEEP_ALIVE: Final = Kind.KEEP_ALIVE
"""Looked up once, because access to a member of an enumeration runs Python code."""

_SMALL, _LARGE = 64 * 2**10, 256 * 2**20
_MAX_BYTES: Final = {
    Kind.GRANT: _LARGE,
    Kind.RAN: _LARGE,
    Kind.SAVED: _LARGE,
    Kind.RESTORE: _LARGE,
    Kind.PROGRAM: 64 * 2**20,
    Kind.FAILED: 2**20,
    Kind.END: 2**20,
}
"""The maximum size of a content by kind [bytes], else `_SMALL`. Chosen by us."""

SWITCHING: Final = b"moves"
"""The content of `Kind.SWITCHED` if the sender switches; otherwise it is empty."""

_HEAD: Final = struct.Struct("<IIIII")
"""Kind, size, sequence number and CRC-32 of the content; then the CRC-32 of these fields, so that a
corrupted size is detected before the content is received. On local sockets, both are 0."""

_NO_SUMS: Final = 0, 0

HEAD_BYTES: Final = _HEAD.size
_CHECKED: Final = struct.Struct("<IIII")
_CHECKSUM: Final = struct.Struct("<I")
CLOSED_BY_PEER: Final = "the other side has closed the connection"
_CORRUPTED: Final = "a message is missing, duplicated or corrupted"
_NUMBER_MASK: Final = 0xFFFFFFFF
_MIN_RECEIVE, _MAX_RECEIVE = 2**14, 2**20

_MIN_PROGRESS: Final = 2**10
"""The part of an incomplete message that must arrive within `TIMEOUT_S` [bytes]: more than
keep-alive messages have, which are all that arrives if a part was lost. Chosen by us."""


class ConnectionLostError(ConnectionError):
    """The connection is closed or silent, or the other side violated the protocol."""


class Message(NamedTuple):
    """A received message."""

    kind: Kind
    content: bytes


class SocketPair(NamedTuple):
    """A local link between two processes: a connection for each direction.

    With a single connection, a process that waits for an answer is also woken when its question is
    read, because it might be waiting for buffer space.

    Attributes:
        receiver: the connection to receive from.
        sender: the connection to send to.
    """

    receiver: socket.socket
    sender: socket.socket

    def close(self) -> None:
        """Close both connections."""
        for each in self:
            each.close()


class Channel:
    """A connection that carries messages; any thread may send, and one may receive.

    Attributes:
        is_closed: whether it has been closed on this side.
        receive_count: how many times data was received.
    """

    def __init__(self, connection: Connection, timeout_s: float | None = None) -> None:
        """Store a connection.

        Args:
            connection: a socket, perhaps encrypted.
            timeout_s: the receive timeout [s]; `TIMEOUT_S` if None.
        """
        with contextlib.suppress(OSError):  # a socket of another family
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.is_closed = False
        self._connection = self._sender = connection  # two once it has moved
        self._sends_sums = self._expects_sums = True
        self.set_timeout(TIMEOUT_S if timeout_s is None else timeout_s)
        self._sending, self._receiving = threading.Lock(), threading.Lock()
        self._unread = bytearray()  # received, but not yet parsed
        self._sent = self._received = 0
        self._sent_before, self.receive_count = -1, 0

    @property
    def is_local(self) -> bool:
        """Whether it has switched to a local socket, see `switch_to`."""
        return not self._expects_sums

    def set_timeout(self, timeout_s: float) -> None:
        """Set the receive timeout [s].

        Raises:
            ConnectionLostError: the connection has been closed.
        """
        self._timeout_s = timeout_s
        try:
            for each in {self._connection, self._sender}:
                limit_waits(each, timeout_s)
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
        self._sent = (number + 1) & _NUMBER_MASK
        try:
            sent = self._sender.send(frame)
            while sent < size:  # while the peer accepts data, however slowly
                sent += self._sender.send(frame[sent:])
        except OSError as error:
            raise ConnectionLostError(_reason(error)) from None

    def send_keep_alive(self) -> None:
        """Send a keep-alive message if nothing was sent since the last call."""
        before, self._sent_before = self._sent_before, self._sent
        if before != self._sent or self._sending.locked():
            return
        with contextlib.suppress(
            ConnectionLostError, OSError, ValueError
        ):  # the receiving thread reports it
            if _is_ready(self._sender, selectors.EVENT_WRITE):
                self.send(Kind.KEEP_ALIVE)

    def receive_frame(self, kind: Kind, buffer: memoryview) -> int:
        """Receive a message of a kind in place, if it arrives in one part and nothing else does.

        Args:
            kind: the kind.
            buffer: the buffer for the message, with its header.

        Returns:
            the size of the message; 0 if anything else has arrived, which is left to `receive`.

        Raises:
            ConnectionLostError: nothing arrives.
        """
        with self._receiving:
            if self._unread:  # another thread has polled meanwhile
                return 0
            try:
                size = self._connection.recv_into(buffer)
            except OSError as error:
                raise self._lost(error) from None
            if not size:
                raise ConnectionLostError(CLOSED_BY_PEER)
            self.receive_count += 1
            if size >= HEAD_BYTES:
                number = self._received
                sums = _sums(buffer[:size]) if self._expects_sums else _NO_SUMS
                if _HEAD.unpack_from(buffer) == (kind, size - HEAD_BYTES, number, *sums):
                    self._received = (number + 1) & _NUMBER_MASK
                    return size
            self._unread += buffer[:size]
            return 0

    def receive(self, *allowed: Kind, timeout_s: float | None = None) -> Message:
        """Receive a message.

        Args:
            allowed: the permitted kinds.
            timeout_s: timeout for the whole message [s]; None for no limit while the other side is
                alive.

        Raises:
            ConnectionLostError: no valid message arrives.
        """
        end_s = None if timeout_s is None else time.monotonic() + timeout_s
        while True:
            message = self._assembled(allowed, end_s)
            kind, _, checksum = self._head(message, allowed)
            content = message[HEAD_BYTES:]
            if self._expects_sums and zlib.crc32(content) != checksum:
                raise ConnectionLostError(_CORRUPTED)
            self._received = (self._received + 1) & _NUMBER_MASK
            if kind != _KEEP_ALIVE:
                return Message(_KINDS[kind], content)

    def _head(self, message: bytes | bytearray, allowed: tuple[Kind, ...]) -> tuple[int, int, int]:
        """Check a header, and return its kind, size and checksum of the content."""
        kind, size, number, content_checksum, checksum = _HEAD.unpack_from(message)
        is_sound = not self._expects_sums or zlib.crc32(message[: _CHECKED.size]) == checksum
        if not is_sound or number != self._received:
            raise ConnectionLostError(_CORRUPTED)
        if kind not in allowed and kind != _KEEP_ALIVE:
            raise ConnectionLostError(f"unexpected message of kind {kind}")
        if size > _MAX_BYTES.get(kind, _SMALL):
            raise ConnectionLostError(f"message of {size} bytes is too long")
        return kind, size, content_checksum

    def _assembled(self, allowed: tuple[Kind, ...], end_s: float | None) -> bytes:
        """Receive all parts of a message, and return it."""
        rest = self._unread
        self._await(HEAD_BYTES, end_s)
        end = HEAD_BYTES + self._head(rest, allowed)[1]
        self._await(end, end_s)
        message = bytes(rest[:end])
        del rest[:end]
        return message

    def _await(self, size: int, end_s: float | None) -> None:
        """Receive until a number of bytes is buffered; memory is allocated as they arrive."""
        rest = self._unread
        check_s, least = 0.0, 0  # when to check that so many bytes have arrived
        while len(rest) < size:
            if end_s is not None and time.monotonic() > end_s:
                raise ConnectionLostError("too slow")
            with self._receiving:
                if len(rest) < size:  # unless another thread has polled meanwhile
                    rest += self._receive_some(size - len(rest))
            if (now_s := time.monotonic()) > check_s:
                if len(rest) < min(size, least):
                    raise ConnectionLostError("too slow")
                check_s, least = now_s + self._timeout_s, len(rest) + _MIN_PROGRESS

    def _receive_some(self, size: int) -> bytes:
        """Receive some of the requested bytes."""
        try:
            part = self._connection.recv(min(max(size, _MIN_RECEIVE), _MAX_RECEIVE))
        except OSError as error:
            raise self._lost(error) from None
        if not part:
            raise ConnectionLostError(CLOSED_BY_PEER)
        self.receive_count += 1
        return part

    def _lost(self, error: OSError) -> ConnectionLostError:
        """Return the exception to raise for an error while receiving."""
        if isinstance(error, TimeoutError | BlockingIOError):  # by Python, or by the system
            return ConnectionLostError(f"no message for {self._timeout_s:g} s")
        return ConnectionLostError(_reason(error))

    def poll(self) -> None:
        """Buffer the data that has arrived, without waiting; close a closed connection.

        Any thread may do this while no other one receives; the next call that receives reads the
        buffered data.
        """
        if not self._receiving.acquire(blocking=False):
            return  # the receiving thread reports it
        try:
            while len(self._unread) < _MAX_RECEIVE and _is_ready(
                self._connection, selectors.EVENT_READ
            ):
                self._unread += self._receive_some(_MAX_RECEIVE)
        except (OSError, ValueError):  # or it has been closed here
            self.close()
        finally:
            self._receiving.release()

    def switch_to(self, pair: SocketPair, *, is_announced: bool) -> None:
        """Switch to a local link, which corrupts nothing, so messages have no checksums there.

        The last message of each side on the old connection announces the switch, so that nothing is
        lost or duplicated even if another thread is sending.

        Args:
            pair: the local link, which is closed with this channel.
            is_announced: whether the other side has already announced the switch.

        Raises:
            ConnectionLostError: the other side does not switch.
        """
        with self._sending:
            self._send(Kind.SWITCHED, memoryview(bytearray(HEAD_BYTES) + SWITCHING))
            self._sender, self._sends_sums = pair.sender, False
        if (
            not is_announced
            and self.receive(Kind.SWITCHED, timeout_s=HANDSHAKE_TIMEOUT_S).content != SWITCHING
        ):
            raise ConnectionLostError("no progress")
        with self._receiving:
            if self._unread:
                raise ConnectionLostError(_CORRUPTED)
            self._connection, old = pair.receiver, self._connection
            self._expects_sums = False
        self.set_timeout(self._timeout_s)
        old.close()

    def close(self) -> None:
        """Close the connection; waiting threads are notified."""
        self.is_closed = True
        for each in {self._connection, self._sender}:
            with contextlib.suppress(OSError):
                each.shutdown(socket.SHUT_RDWR)
            with contextlib.suppress(OSError):
                each.close()


class KeepAlive:
    """A thread that sends keep-alive messages on channels, for use in a `with` block."""

    def __init__(self) -> None:
        self._channels: list[Channel] = []
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name="crs-keep-alive", daemon=True)

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

    def _run(self) -> None:
        while not self._ended.wait(KEEP_ALIVE_S / 2):
            for channel in tuple(self._channels):
                if channel.is_closed:
                    self.remove(channel)
                else:
                    channel.send_keep_alive()


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
        return CLOSED_BY_PEER
    if error.errno == errno.EBADF:  # closed on this side, after a timeout
        return "the connection is closed"
    return error.strerror or str(error) or "the connection is closed"
