"""Encrypted connections, and certificates that are not those expected."""

from __future__ import annotations

import contextlib
import shutil
import socket
import threading
from collections.abc import Iterator

import pytest

from crs_cc.net import tls
from crs_cc.net.access import Access
from crs_cc.net.channel import HEAD_BYTES, MAGIC, Channel, ConnectionLostError, KeepAlive, Kind
from crs_cc.net.environment_connection import EnvironmentConnection, connect
from crs_cc.net.handshake import Hello, Program, RefusedError, devices_digest
from crs_cc.net.host_registry import HostRegistry
from crs_cc.net.listener import Listener, bound_socket, forwarder_to
from tests.session.programs import HALL

pytestmark = pytest.mark.skipif(shutil.which("openssl") is None, reason="there is no openssl")
TOKEN = "0123456789abcdef"


@pytest.fixture(scope="module")
def server() -> tls.Server:
    return tls.self_made()


@pytest.fixture
def listener(server: tls.Server) -> Iterator[Listener]:
    tokens = (TOKEN,)
    access = Access({"robot": tokens, "view": tokens, "control": tokens})
    made = Listener(bound_socket("127.0.0.1", 0), access, HostRegistry(HALL.robots), server.secure)
    yield made
    made.close()


def come(
    listener: Listener, client: tls.Client | None, keep_alive: KeepAlive
) -> EnvironmentConnection:
    program = Program("a.c", "a", sources=("/a.c",), files={"/a.c": ""})
    content = program.content()
    hello = Hello(TOKEN, "one", (), program.digest, devices=devices_digest())
    address = "127.0.0.1", listener.port
    if client is None:
        return connect(address, hello, content, keep_alive)
    return connect(address, hello, content, keep_alive, client.secure)


def test_a_host_that_knows_the_fingerprint_is_accepted(
    listener: Listener, server: tls.Server
) -> None:
    with KeepAlive() as keep_alive:
        spelled = server.fingerprint.upper()
        found = come(listener, tls.Client("127.0.0.1", f"{spelled[:2]}:{spelled[2:]}"), keep_alive)
        assert found.robots == ("left", "right")
        found.channel.poll()
        assert not found.channel.is_closed
        found.channel.close()


def test_another_certificate_is_not_trusted(listener: Listener) -> None:
    with KeepAlive() as keep_alive:
        with pytest.raises(RefusedError, match="not the given one"):
            come(listener, tls.Client("127.0.0.1", "00" * 32), keep_alive)
        with pytest.raises(RefusedError, match="not trusted"):
            come(listener, tls.Client("127.0.0.1"), keep_alive)


def test_nothing_is_sent_without_encryption(listener: Listener) -> None:
    with (
        KeepAlive() as keep_alive,
        pytest.raises(ConnectionLostError, match="--tls, give --fingerprint"),
    ):
        come(listener, None, keep_alive)
    for text in (b"GET / HTTP/1.1\r\n\r\n", MAGIC + b"GET / HTTP/1.1\r\n\r\n"):
        with socket.create_connection(("127.0.0.1", listener.port), 5.0) as connection:
            connection.sendall(text)
            with contextlib.suppress(ConnectionResetError):
                assert b"HTTP" not in connection.recv(100)


def test_messages_of_rounds_are_encrypted(server: tls.Server) -> None:
    plain = socket.socketpair()
    made: list[tls.Connection] = []
    thread = threading.Thread(target=lambda: made.append(server.secure(plain[0])))
    thread.start()
    client = tls.Client("127.0.0.1", server.fingerprint).secure(plain[1])
    thread.join()
    sender, receiver, buffer = Channel(client), Channel(made[0]), memoryview(bytearray(500))
    frame = bytearray(HEAD_BYTES) + b"content"
    for _ in range(3):
        sender.send_frame(Kind.RAN, memoryview(frame))
        assert receiver.receive_frame(Kind.RAN, buffer) == len(frame)
        assert buffer[: len(frame)] == frame
    receiver.set_timeout(0.05)
    with pytest.raises(ConnectionLostError, match="no message for"):
        receiver.receive_frame(Kind.RAN, buffer)
    sender.close()
    receiver.close()


def test_pages_are_encrypted_in_both_directions(listener: Listener, server: tls.Server) -> None:
    size = 300_000
    with socket.create_server(("127.0.0.1", 0)) as inner:

        def answer() -> None:
            connection, _ = inner.accept()
            connection.sendall(connection.recv(10) * (size // 10))
            connection.close()

        thread = threading.Thread(target=answer)
        thread.start()
        listener.page_handler = forwarder_to(inner.getsockname()[1])
        client = tls.Client("127.0.0.1", server.fingerprint)
        connection = client.secure(socket.create_connection(("127.0.0.1", listener.port), 5.0))
        connection.sendall(b"0123456789")
        found = b""
        while part := connection.recv(10_000):
            found += part
            if len(found) >= size:
                break
        assert found == b"0123456789" * (size // 10)
        connection.close()
        thread.join()
