r"""Packets of the vendor's Nclient and Nserver (vendor source `Nclient.c` 2.6.11 and 2.7).

A packet is its type and the number of its elements, both of 16 bits, and the elements of 32 bits,
all big-endian. There is no length in bytes, no checksum, and no version.

A client compiled for 64 bits sends each element as eight bytes, of which the first four are the
number; the header is then followed by four zeros, and the last element lacks its second half. It
shows in its first packet, where the word behind the header is the robot's number for others.

>>> encode(Packet(82, (7019,))).hex(" ")
'00 52 00 01 00 00 1b 6b'
>>> encode(Packet(82, (7019,)), is_wide=True).hex(" ")
'00 52 00 01 00 00 1b 6b 00 00 00 00'
>>> reader = PacketReader()
>>> reader.add(bytes.fromhex("0066 0002 00000001 000018ae 000f 0000"))
[Packet(type=102, elements=(1, 6318)), Packet(type=15, elements=())]
>>> reader.is_wide
False
"""

from __future__ import annotations

import struct
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

CREATE, CONNECT, DISCONNECT = 101, 102, 103

_HEADER: Final = struct.Struct(">HH")
_OPENING: Final = 2
"""Elements of the packet that opens a connection."""


@dataclass(frozen=True, slots=True)
class Packet:
    """A packet: its type and its elements, signed."""

    type: int
    elements: tuple[int, ...] = ()


class BadPacketError(ValueError):
    """What a client sends is no packet of this protocol."""


class PacketReader:
    """Splits a client's data into packets.

    Attributes:
        is_wide: whether the client was compiled for 64 bits.
    """

    def __init__(self) -> None:
        self.is_wide = False
        self._is_open = False
        self._content = bytearray()

    def add(self, content: bytes) -> list[Packet]:
        """Add bytes; return the packets that they complete.

        Raises:
            BadPacketError: the first packet does not open a connection.
        """
        self._content += content
        found = []
        while (packet := self._next_packet()) is not None:
            found.append(packet)
        return found

    def _next_packet(self) -> Packet | None:
        """Remove a packet from the received data, and return it; None if it is incomplete."""
        if len(self._content) < _HEADER.size:
            return None
        kind, count = _HEADER.unpack_from(self._content)
        if not self._is_open and not self._opens(kind, count):
            return None
        begin = _HEADER.size
        stride = 8 if self.is_wide else 4
        size = stride * count
        padding = 4 if self.is_wide and count else 0
        # The padding is the missing half of the last element.
        if len(self._content) < begin + size:
            return None
        places = range(begin + padding, begin + size, stride)
        elements = tuple(struct.unpack_from(">i", self._content, place)[0] for place in places)
        del self._content[: begin + size]
        return Packet(kind, elements)

    def _opens(self, kind: int, count: int) -> bool:
        """Return whether enough data has arrived to know the size of the client's integers."""
        if kind not in (CREATE, CONNECT) or count != _OPENING:
            raise BadPacketError("not an opening packet")
        if len(self._content) < _HEADER.size + 4:
            return False
        self.is_wide = not any(self._content[_HEADER.size : _HEADER.size + 4])
        self._is_open = True
        return True


def encode(packet: Packet, *, is_wide: bool = False) -> bytes:
    """Return a reply as bytes; numbers beyond 32 bits lose their upper ones."""
    return _HEADER.pack(packet.type, len(packet.elements)) + _words(packet.elements, is_wide)


def _words(elements: Iterable[int], is_wide: bool) -> bytes:
    pad = bytes(4) if is_wide else b""
    return b"".join((each & 0xFFFFFFFF).to_bytes(4, "big") + pad for each in elements)
