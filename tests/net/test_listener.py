"""Connections to the port of an environment: hosts, pages, and invalid ones."""

from __future__ import annotations

import json
import random
import socket
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import pytest

from crs_cc.net import environment_connection as connection_module
from crs_cc.net import host_registry as registry_module
from crs_cc.net import listener as listener_module
from crs_cc.net.access import Access
from crs_cc.net.channel import MAGIC, Channel, ConnectionLostError, KeepAlive, Kind
from crs_cc.net.environment_connection import EnvironmentConnection, connect
from crs_cc.net.handshake import Hello, Program, RefusedError, devices_digest
from crs_cc.net.host_registry import HostRegistry
from crs_cc.net.listener import Listener, bound_socket
from tests.session.programs import HALL

TOKEN = "0123456789abcdef"
PROGRAM = Program("a.c", "a", sources=("/a.c",), files={"/a.c": ""})


class Open:
    """A listener with a registry of hosts."""

    def __init__(self, awaited: Sequence[str] = ()) -> None:
        self.registry = HostRegistry(HALL.robots, awaited)
        tokens = (TOKEN,)
        access = Access({"robot": tokens, "view": ("v" * 16,), "control": ("c" * 16,)})
        self.listener = Listener(bound_socket("127.0.0.1", 0), access, self.registry)
        self.keep_alive = KeepAlive()

    @property
    def address(self) -> tuple[str, int]:
        return "127.0.0.1", self.listener.port

    def connect(self) -> socket.socket:
        return socket.create_connection(self.address, 5.0)

    def join(
        self,
        *robots: str,
        host: str = "one",
        program: Program = PROGRAM,
        secure: Callable[[socket.socket], socket.socket] = lambda connection: connection,
    ) -> EnvironmentConnection:
        content = program.content()
        hello = Hello(TOKEN, host, robots, program.digest, devices=devices_digest())
        return connect(self.address, hello, content, self.keep_alive, secure)


@pytest.fixture
def opened() -> Iterator[Open]:
    made = Open()
    with made.keep_alive:
        yield made
    made.listener.close()


class Slow(socket.socket):
    """A socket that stalls for some time after the first bytes."""

    def __init__(self, fileno: int, silent_s: float) -> None:
        super().__init__(fileno=fileno)
        self._silent_s = silent_s

    def send(self, *given: Any) -> int:
        if self._silent_s:
            time.sleep(self._silent_s)
            self._silent_s = 0.0
        return super().send(*given)


def wait_until_ready(opened: Open, *names: str) -> None:
    while set(names) & set(opened.registry.missing()):
        opened.registry.wait()


def refusal(opened: Open, content: bytes) -> str:
    """Return the reason why a first message is rejected."""
    connection = opened.connect()
    connection.sendall(MAGIC)
    channel = Channel(connection)
    channel.send(Kind.HELLO, content)
    said = channel.receive(Kind.REFUSED).content.decode()
    channel.close()
    return said


def test_hosts_claim_robots_and_others_are_rejected(opened: Open) -> None:
    first = opened.join("left")
    assert first.robots == ("left",)
    wait_until_ready(opened, "left")
    with pytest.raises(RefusedError, match=r"left has a host already \(without one: right\)"):
        opened.join("left", host="two")
    with pytest.raises(RefusedError, match="unknown robot 'middle'"):
        opened.join("middle", host="two")
    assert opened.join(host="two").robots == ("right",)
    wait_until_ready(opened, "right")
    with pytest.raises(RefusedError, match="every robot has a host"):
        opened.join(host="three")


def test_a_host_that_disconnects_before_the_run_is_replaced(opened: Open) -> None:
    opened.join("left").channel.close()
    wait_until_ready(opened, "left")
    other = Program("b.c", "b", sources=("/b.c",), files={"/b.c": ""})
    opened.join("left", host="two", program=other)
    wait_until_ready(opened, "left")
    assignments = opened.registry.begin()
    assert [assignment.program for assignment in assignments] == [other]


def test_a_lost_host_is_replaced_by_one_with_the_same_program(opened: Open) -> None:
    opened.join("left", "right")
    wait_until_ready(opened, "left", "right")
    assignment = opened.registry.begin()[0]
    channel = opened.registry.wait_for_channel(assignment, lambda: False)
    assert channel
    channel.close()
    opened.registry.mark_lost(assignment)
    with pytest.raises(RefusedError, match="lost together"):
        opened.join("left", host="two")
    with pytest.raises(RefusedError, match=r"the program of left and right is a\.c \(\w+\); the"):
        opened.join("left", "right", host="two", program=replace(PROGRAM, checked=False))
    elsewhere = replace(PROGRAM, sources=("/b/a.c",), files={"/b/a.c": ""})
    assert opened.join(host="two", program=elsewhere).robots == ("left", "right")
    assert opened.registry.wait_for_channel(assignment, lambda: False)


def test_a_host_that_notices_a_loss_first_reconnects(opened: Open) -> None:
    opened.join()
    wait_until_ready(opened, "left", "right")
    assignment = opened.registry.begin()[0]
    first = opened.registry.wait_for_channel(assignment, lambda: False)
    assert opened.join().robots == ("left", "right")
    assert opened.registry.wait_for_channel(assignment, lambda: False) is not first
    with pytest.raises(RefusedError, match="every robot has a host already"):
        opened.join(host="two")


@pytest.mark.parametrize("way", ["killed", "cut off"])
def test_a_host_that_is_lost_while_idle_is_replaced(
    opened: Open, way: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As in a paused run, when its keep-alive messages are not received."""
    monkeypatch.setattr(registry_module, "TIMEOUT_S", 0.1)
    lost = opened.join("left", "right").channel
    wait_until_ready(opened, "left", "right")
    assignment = opened.registry.begin()[0]
    assert opened.registry.wait_for_channel(assignment, lambda: False)
    lost.send(Kind.KEEP_ALIVE)
    if way == "killed":
        lost.close()
    else:
        opened.keep_alive.remove(lost)
    assert opened.join("left", "right", host="two").robots == ("left", "right")
    assert opened.registry.wait_for_channel(assignment, lambda: False)


def test_hosts_that_connect_during_the_run_must_have_the_same_program(opened: Open) -> None:
    opened.join("left")
    wait_until_ready(opened, "left")
    assert [assignment.names for assignment in opened.registry.begin()] == [("left",)]
    with pytest.raises(RefusedError, match=r"the program of left is a\.c \(\w+\); the host has"):
        opened.join("right", host="two", program=replace(PROGRAM, checked=False))
    assert opened.registry.new_assignments() == []
    opened.join(host="two")
    wait_until_ready(opened, "right")
    assert [assignment.names for assignment in opened.registry.new_assignments()] == [("right",)]
    assert opened.registry.new_assignments() == []


def test_versions_tokens_and_fields_are_checked(opened: Open) -> None:
    hello = Hello(TOKEN, "one", (), "digest", devices=devices_digest())
    said = refusal(opened, replace(hello, version="0.0").content())
    assert "has version" in said
    assert "0.0" in said
    assert "no valid token" in refusal(opened, replace(hello, token="v" * 16).content())
    assert "device libraries" in refusal(opened, replace(hello, devices="x").content())
    for wrong in (b"", b"[]", b"\xff", b"[" * 10_000):
        assert "invalid" in refusal(opened, wrong)
    values = json.loads(hello.content())
    for name, value in (("robots", "left"), ("robots", [1]), ("host", None), ("program", 1)):
        assert f"no valid {name}" in refusal(opened, json.dumps(values | {name: value}).encode())


def test_a_program_must_be_the_one_that_was_announced(opened: Open) -> None:
    hello = Hello(TOKEN, "one", (), "digest", devices=devices_digest())
    try:
        found = connect(opened.address, hello, PROGRAM.content(), opened.keep_alive)
        said = found.channel.receive(Kind.REFUSED).content.decode()
    except RefusedError as error:  # it has come before all was sent
        said = str(error)
    assert "a program other than the announced one" in said
    assert opened.registry.missing() == ["left", "right"]


def test_other_data_does_not_affect_hosts(opened: Open) -> None:
    random_ = random.Random(1)
    kept = []
    for number in range(150):
        connection = opened.connect()
        noise = random_.randbytes(random_.randrange(100))
        start = (b"", MAGIC, MAGIC[:4], b"GET / HTTP/1.1\r\n", MAGIC + bytes(4))[number % 5]
        connection.sendall(start + noise)
        kept.append(connection)
    opened.join("left")
    wait_until_ready(opened, "left")
    for connection in kept:
        connection.close()
    assert opened.registry.missing() == ["right"]


def test_a_page_that_connects_before_the_run_reloads(opened: Open) -> None:
    with opened.connect() as connection:
        connection.sendall(b"GET / HTTP/1.1\r\nHost: x\r\n\r\n")
        with connection.makefile() as answer:
            text = answer.read()
    assert text.startswith("HTTP/1.1 503")
    assert "location.reload()" in text


def test_page_connections_are_forwarded_in_both_directions(opened: Open) -> None:
    from crs_cc.net.listener import forwarder_to

    with socket.create_server(("127.0.0.1", 0)) as inner:

        def echo() -> None:
            connection, _ = inner.accept()
            connection.sendall(connection.recv(100).upper())
            connection.close()

        thread = threading.Thread(target=echo)
        thread.start()
        opened.listener.page_handler = forwarder_to(inner.getsockname()[1])
        with opened.connect() as connection:
            connection.sendall(b"hello, page")
            assert connection.recv(100) == b"HELLO, PAGE"
            assert connection.recv(100) == b""
        thread.join()


def test_connections_after_the_end_are_rejected(opened: Open) -> None:
    opened.registry.end()
    with pytest.raises(RefusedError, match="has ended"):
        opened.join("left")
    opened.listener.close()
    with pytest.raises(ConnectionLostError):
        opened.join("left")


def test_the_handshake_timeout_is_longer_than_the_receive_timeout(
    opened: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in (listener_module, connection_module):
        monkeypatch.setattr(module, "TIMEOUT_S", 0.1)
    found = opened.join("left", secure=lambda connection: Slow(connection.detach(), 0.5))
    wait_until_ready(opened, "left")
    with pytest.raises(ConnectionLostError, match=r"no message for 0\.1 s"):
        found.channel.receive(Kind.RESTORE)  # from now on, silence is a loss


def test_a_host_receives_the_robots_that_the_run_waits_for() -> None:
    opened = Open(["left", "right"])
    with opened.keep_alive:
        assert opened.join("left").awaited == ("right",)
        wait_until_ready(opened, "left")
        assert opened.join("right", host="two").awaited == ()
        wait_until_ready(opened, "right")
        opened.registry.begin()
        assert opened.join("left").awaited == ()
    opened.listener.close()
