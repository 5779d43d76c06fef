r"""Packets on the line between the vendor's Ndirect and a robot (vendor source `Ndirect.c` 2.7).

A packet is the byte 1, a length of 16 bits, a type, data, the sum of all bytes before it, and the
byte 92; the length counts type, data and sum. Numbers have the least significant byte first, and
negative ones are sign and magnitude.

>>> encode(7).hex(" "), encode(8).hex(" ")
('01 02 00 07 0a 5c', '01 02 00 08 0b 5c')
>>> reader = LineReader()
>>> reader.add(bytes.fromhex("ff 01 05 00 20 01 02 03"))
[]
>>> reader.add(bytes.fromhex("2c 5c")), reader.bad
([LinePacket(type=32, data=b'\x01\x02\x03')], 1)
>>> s16(-100).hex(" "), number(s16(-100)), number(s16(40000))
('64 80', -100, -7232)
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

_BEGIN, _END = 1, 92
_AROUND: Final = 4
"""Bytes of a packet that its length does not count."""

_MIN_BYTES: Final = 2
_MAX_BYTES: Final = 255
"""The sums of longer packets are wrong: the client counts their length with one byte."""


@dataclass(frozen=True, slots=True)
class LinePacket:
    """A packet: its type and its data."""

    type: int
    data: bytes = b""


class LineReader:
    """Splits the data of the line into packets, and skips invalid ones.

    Attributes:
        bad: how many bytes have been skipped.
    """

    def __init__(self) -> None:
        self.bad = 0
        self._content = bytearray()

    def add(self, content: bytes) -> list[LinePacket]:
        """Add bytes; return the packets that they complete."""
        self._content += content
        found = []
        while (packet := self._next_packet()) is not None:
            found.append(packet)
        return found

    def forget(self) -> None:
        """Discard an incomplete packet."""
        self.bad += len(self._content)
        self._content.clear()

    def _next_packet(self) -> LinePacket | None:
        while self._content:
            size = self._size()
            if size is None or size > len(self._content):
                return None
            packet = self._content[:size]
            if size and packet[-1] == _END and packet[-2] == sum(packet[:-2]) & 255:
                del self._content[:size]
                return LinePacket(packet[3], bytes(packet[4:-2]))
            self.bad += 1
            del self._content[0]
        return None

    def _size(self) -> int | None:
        """Return the size of the packet that begins here, 0 for none; None if it is not known."""
        if self._content[0] != _BEGIN:
            return 0
        if len(self._content) < 3:
            return None
        length = self._content[1] | self._content[2] << 8
        return length + _AROUND if _MIN_BYTES <= length <= _MAX_BYTES else 0


def encode(kind: int, data: bytes = b"") -> bytes:
    """Return a packet as bytes."""
    length = len(data) + _MIN_BYTES
    body = bytes((_BEGIN, length & 255, length >> 8, kind)) + data
    return body + bytes((sum(body) & 255, _END))


def u16(value: int) -> bytes:
    """Return a magnitude."""
    return (abs(value) & 0xFFFF).to_bytes(2, "little")


def s16(value: int) -> bytes:
    """Return a number of two bytes; of a large one the high byte is cut, as the client does it."""
    magnitude = abs(value)
    high = magnitude // 256 + (128 if value < 0 else 0)
    return bytes((magnitude % 256, high & 255))


def number(content: bytes) -> int:
    """Return the number in two bytes."""
    magnitude = content[0] + 256 * (content[1] & 127)
    return -magnitude if content[1] & 128 else magnitude


def s32(value: int) -> bytes:
    """Return a number of four bytes."""
    magnitude = abs(value) & 0x7FFFFFFF
    return (magnitude | (1 << 31 if value < 0 else 0)).to_bytes(4, "little")


def u32(value: int) -> bytes:
    """Return a number of four bytes without a sign."""
    return (value & 0xFFFFFFFF).to_bytes(4, "little")
