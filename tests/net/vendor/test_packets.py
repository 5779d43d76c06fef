"""Packets are found in a stream however it is cut, and nothing else is taken for one."""

from __future__ import annotations

import random

import pytest

from crs_cc.net.vendor.line_packets import LinePacket, LineReader, encode
from crs_cc.net.vendor.nserver_packets import BadPacketError, Packet, PacketReader
from tests.net.vendor.nclient import Nclient

SENT = (
    Packet(102, (1, 4711)),
    Packet(16, (255, 255, 255, 255, 255, 14, 0)),
    Packet(12, (-10, 2**31 - 1, -(2**31))),
    Packet(15),
    Packet(300, tuple(range(256))),
    Packet(103, (1, 4711)),
)


@pytest.mark.parametrize("is_wide", [False, True], ids=["32 bit", "64 bit"])
@pytest.mark.parametrize("size", [1, 3, 4, 7, 10_000])
def test_packets_do_not_depend_on_fragmentation(*, is_wide: bool, size: int) -> None:
    client, reader = Nclient(0, is_wide=is_wide), PacketReader()
    stream = b"".join(client.packet(each.type, *each.elements) for each in SENT)
    found: list[Packet] = []
    for at in range(0, len(stream), size):
        found += reader.add(stream[at : at + size])
    assert tuple(found) == SENT
    assert reader.is_wide == is_wide


@pytest.mark.parametrize("stream", [b"GET / HTTP/1.1", bytes(8), bytes.fromhex("00660003") * 9])
def test_invalid_opening_packets_are_rejected(stream: bytes) -> None:
    with pytest.raises(BadPacketError):
        PacketReader().add(stream)


def test_packets_on_a_serial_line_are_found_between_noise() -> None:
    packets = [LinePacket(kind, bytes(range(kind))) for kind in (0, 1, 7, 92, 200)]
    noise = random.Random(4)
    stream = bytearray()
    for each in packets:
        stream += bytes(noise.choice((0, 2, 92, 255)) for _ in range(noise.randrange(5)))
        stream += encode(each.type, each.data)
    reader, found = LineReader(), []
    for byte in stream:
        found += reader.add(bytes((byte,)))
    assert found == packets
    reader.add(b"\x01\xf0\x00")
    reader.forget()
    assert reader.add(encode(7)) == [LinePacket(7)]


def test_a_corrupted_packet_is_skipped() -> None:
    good, reader = encode(12, b"\x01\x02\x03\x04"), LineReader()
    for place in range(len(good)):
        bad = bytearray(good)
        bad[place] ^= 0x10
        reader.add(bytes(bad))
        reader.forget()
    assert reader.add(good) == [LinePacket(12, b"\x01\x02\x03\x04")]
