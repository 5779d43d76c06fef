"""Connections that lose, duplicate, reorder or corrupt data are closed."""

from __future__ import annotations

import random
import socket
import struct
import threading
import time
import zlib
from collections.abc import Iterator

import pytest

from crs_cc.net import channel as channel_module
from crs_cc.net.channel import HEAD_BYTES, Channel, ConnectionLostError, KeepAlive, Kind


@pytest.fixture
def ends() -> Iterator[tuple[Channel, socket.socket]]:
    here, there = socket.socketpair()
    made = Channel(here)
    yield made, there
    made.close()
    there.close()


def frames(*contents: bytes) -> list[bytes]:
    """Return the bytes of messages as they are sent."""
    here, there = socket.socketpair()
    sender, found = Channel(here), []
    for content in contents:
        sender.send(Kind.RAN, content)
        found.append(there.recv(10_000))
    sender.close()
    there.close()
    return found


def test_messages_arrive_in_order(ends: tuple[Channel, socket.socket]) -> None:
    receiver, there = ends
    there.sendall(b"".join(frames(b"one", b"two")))
    assert [receiver.receive(Kind.RAN).content for _ in range(2)] == [b"one", b"two"]


@pytest.mark.parametrize(
    "order", [(0, 0), (1,), (0, 2), (2, 1, 0)], ids=["duplicated", "lost", "gap", "reordered"]
)
def test_messages_in_another_order_end_the_connection(
    ends: tuple[Channel, socket.socket], order: tuple[int, ...]
) -> None:
    receiver, there = ends
    parts = frames(b"a", b"b", b"c")
    there.sendall(b"".join(parts[number] for number in order))
    for _ in range(len(order) - 1 if order[0] == 0 else 0):
        receiver.receive(Kind.RAN)
    with pytest.raises(ConnectionLostError, match="missing, duplicated or corrupted"):
        receiver.receive(Kind.RAN)


def test_a_corrupted_message_ends_the_connection(ends: tuple[Channel, socket.socket]) -> None:
    receiver, there = ends
    part = bytearray(frames(b"content")[0])
    part[-1] ^= 1
    there.sendall(part)
    with pytest.raises(ConnectionLostError, match="corrupted"):
        receiver.receive(Kind.RAN)


def receive_framed(receiver: Channel, buffer: memoryview) -> bytes:
    """Return the content of the next message, which may be received into a buffer."""
    if size := receiver.receive_frame(Kind.RAN, buffer):
        return bytes(buffer[HEAD_BYTES:size])
    return receiver.receive(Kind.RAN).content


@pytest.mark.parametrize("size", [0, HEAD_BYTES, 100, 10_000])
def test_messages_arrive_in_order_for_any_buffer_size_and_fragmentation(
    ends: tuple[Channel, socket.socket], size: int
) -> None:
    receiver, there = ends
    contents = [bytes([number]) * (37 * number) for number in range(9)]
    said, random_ = b"".join(frames(*contents)), random.Random(size)
    buffer = memoryview(bytearray(max(size, 1)))

    def say() -> None:
        at = 0
        while at < len(said):
            end = at + random_.choice((1, HEAD_BYTES, 60, 400))
            there.sendall(said[at:end])
            at = end
            time.sleep(0.001)

    thread = threading.Thread(target=say)
    thread.start()
    assert [receive_framed(receiver, buffer) for _ in contents] == contents
    thread.join()


def test_a_message_that_is_received_into_a_buffer_is_not_copied(
    ends: tuple[Channel, socket.socket],
) -> None:
    receiver, there = ends
    buffer = memoryview(bytearray(100))
    there.sendall(frames(b"content")[0])
    assert receiver.receive_frame(Kind.RAN, buffer) == HEAD_BYTES + 7
    assert bytes(buffer[HEAD_BYTES:][:7]) == b"content"


@pytest.mark.parametrize("wrong", ["corrupted", "number", "kind", "head"])
def test_an_invalid_message_in_a_buffer_ends_the_connection(
    ends: tuple[Channel, socket.socket], wrong: str
) -> None:
    receiver, there = ends
    part = bytearray(frames(b"a", b"content")[wrong == "number"])
    if wrong == "corrupted":
        part[-1] ^= 1
    if wrong == "head":
        part[5] ^= 1
    there.sendall(part)
    buffer, kind = memoryview(bytearray(100)), Kind.GRANT if wrong == "kind" else Kind.RAN
    assert receiver.receive_frame(kind, buffer) == 0
    with pytest.raises(ConnectionLostError, match=r"corrupted|unexpected"):
        receiver.receive(kind)


def test_keep_alive_messages_are_not_received_into_a_buffer(
    ends: tuple[Channel, socket.socket],
) -> None:
    receiver, there = ends
    sender, buffer = Channel(there), memoryview(bytearray(100))
    sender.send(Kind.KEEP_ALIVE)
    assert receiver.receive_frame(Kind.RAN, buffer) == 0
    sender.send(Kind.RAN, b"one")
    assert receiver.receive(Kind.RAN).content == b"one"
    sender.send_frame(Kind.RAN, memoryview(bytearray(HEAD_BYTES) + b"two"))
    assert receive_framed(receiver, buffer) == b"two"


def test_a_message_that_is_too_long_is_rejected_before_it_arrives(
    ends: tuple[Channel, socket.socket],
) -> None:
    receiver, there = ends
    head = struct.pack("<IIII", Kind.HELLO, 2**31, 0, 0)
    there.sendall(head + struct.pack("<I", zlib.crc32(head)))
    with pytest.raises(ConnectionLostError, match="too long"):
        receiver.receive(Kind.HELLO)


def test_a_message_with_a_corrupted_size_is_not_waited_for(
    ends: tuple[Channel, socket.socket],
) -> None:
    receiver, there = ends
    part = bytearray(frames(b"content")[0])
    part[5] ^= 1
    there.sendall(part)
    with pytest.raises(ConnectionLostError, match="corrupted"):
        receiver.receive(Kind.RAN)


def test_keep_alive_messages_do_not_replace_the_lost_part_of_a_message(
    ends: tuple[Channel, socket.socket],
) -> None:
    receiver, there = ends
    receiver.set_timeout(0.1)
    here, other = socket.socketpair()
    Channel(here).send(Kind.RAN, bytes(5_000))
    there.sendall(other.recv(10_000)[:2_000])
    done = threading.Event()

    def trickle() -> None:
        while not done.wait(0.02):
            there.sendall(bytes(20))

    thread = threading.Thread(target=trickle)
    thread.start()
    with pytest.raises(ConnectionLostError, match="too slow"):
        receiver.receive(Kind.RAN)
    done.set()
    thread.join()
    here.close()
    other.close()


def test_an_unexpected_kind_ends_the_connection(ends: tuple[Channel, socket.socket]) -> None:
    receiver, there = ends
    there.sendall(frames(b"")[0])
    with pytest.raises(ConnectionLostError, match="unexpected"):
        receiver.receive(Kind.HELLO)


def test_a_peer_that_closes_or_is_silent_is_considered_lost(
    ends: tuple[Channel, socket.socket], monkeypatch: pytest.MonkeyPatch
) -> None:
    receiver, there = ends
    there.sendall(b"x")
    with pytest.raises(ConnectionLostError, match="too slow"):
        receiver.receive(Kind.RAN, timeout_s=-1.0)
    monkeypatch.setattr(channel_module, "TIMEOUT_S", 0.05)
    here, other = socket.socketpair()
    with pytest.raises(ConnectionLostError, match="no message for"):
        Channel(here).receive(Kind.RAN)
    other.close()
    there.close()
    with pytest.raises(ConnectionLostError, match="closed the connection"):
        receiver.receive(Kind.RAN)
    with pytest.raises(ConnectionLostError, match="the other side has closed the connection"):
        receiver.send(Kind.RAN)
    receiver.close()
    with pytest.raises(ConnectionLostError, match="the connection is closed"):
        receiver.send(Kind.RAN)


def test_polling_takes_no_data_from_the_receiving_thread(
    ends: tuple[Channel, socket.socket],
) -> None:
    receiver, there = ends
    parts = frames(b"one", b"two")
    for part in (parts[0], parts[1][:7], parts[1][7:]):
        there.sendall(part)
        receiver.poll()
    assert [receiver.receive(Kind.RAN).content for _ in range(2)] == [b"one", b"two"]
    assert not receiver.is_closed
    there.sendall(parts[0])  # which does not hide that the other side is gone
    there.close()
    receiver.poll()
    assert receiver.is_closed


def test_an_idle_peer_sends_keep_alive_messages(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(channel_module, "TIMEOUT_S", 0.2)
    monkeypatch.setattr(channel_module, "KEEP_ALIVE_S", 0.02)
    here, there = socket.socketpair()
    receiver, sender = Channel(here), Channel(there)
    with KeepAlive() as keep_alive:
        keep_alive.add(sender)
        with pytest.raises(ConnectionLostError, match="too slow"):
            receiver.receive(Kind.RAN, timeout_s=0.4)
        sender.send(Kind.RAN, b"at last")
        assert receiver.receive(Kind.RAN).content == b"at last"
        began_s = time.monotonic()
    assert time.monotonic() - began_s < 1.0
    receiver.close()
    sender.close()
