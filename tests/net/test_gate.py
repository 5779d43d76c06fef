"""Who comes to the port of an environment, and what becomes of those who misbehave."""

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

from crs_cc.net import gate as gate_module
from crs_cc.net import roster as roster_module
from crs_cc.net import visit as visit_module
from crs_cc.net.access import Access
from crs_cc.net.channel import MAGIC, Channel, ConnectionLostError, Kind, Pulse
from crs_cc.net.gate import Gate, bound
from crs_cc.net.handshake import Hello, Program, RefusedError, devices_digest
from crs_cc.net.roster import Roster
from crs_cc.net.visit import Visit, visit
from tests.session.programs import HALL

TOKEN = "0123456789abcdef"
PROGRAM = Program("a.c", "a", sources=("/a.c",), files={"/a.c": ""})


class Open:
    """A gate with a roster."""

    def __init__(self, awaited: Sequence[str] = ()) -> None:
        self.roster = Roster(HALL.robots, awaited)
        tokens = (TOKEN,)
        access = Access({"robot": tokens, "view": ("v" * 16,), "control": ("c" * 16,)})
        self.gate = Gate(bound("127.0.0.1", 0), access, self.roster)
        self.pulse = Pulse()

    @property
    def address(self) -> tuple[str, int]:
        return "127.0.0.1", self.gate.port

    def connect(self) -> socket.socket:
        return socket.create_connection(self.address, 5.0)

    def visit(
        self,
        *robots: str,
        host: str = "one",
        program: Program = PROGRAM,
        secure: Callable[[socket.socket], socket.socket] = lambda connection: connection,
    ) -> Visit:
        content = program.content()
        hello = Hello(TOKEN, host, robots, program.digest, devices=devices_digest())
        return visit(self.address, hello, content, self.pulse, secure)


@pytest.fixture
def opened() -> Iterator[Open]:
    made = Open()
    with made.pulse:
        yield made
    made.gate.close()


class Slow(socket.socket):
    """A socket on a way that carries nothing for some time after the first bytes."""

    def __init__(self, fileno: int, silent_s: float) -> None:
        super().__init__(fileno=fileno)
        self._silent_s = silent_s

    def send(self, *given: Any) -> int:
        if self._silent_s:
            time.sleep(self._silent_s)
            self._silent_s = 0.0
        return super().send(*given)


def wait_until_ready(opened: Open, *names: str) -> None:
    while set(names) & set(opened.roster.missing()):
        opened.roster.wait()


def refusal(opened: Open, content: bytes) -> str:
    """Return why a first message is refused."""
    connection = opened.connect()
    connection.sendall(MAGIC)
    channel = Channel(connection)
    channel.send(Kind.HELLO, content)
    said = channel.receive(Kind.REFUSED).content.decode()
    channel.close()
    return said


def test_hosts_claim_robots_and_others_are_refused(opened: Open) -> None:
    first = opened.visit("left")
    assert first.robots == ("left",)
    wait_until_ready(opened, "left")
    with pytest.raises(RefusedError, match=r"left has a host already \(without one: right\)"):
        opened.visit("left", host="two")
    with pytest.raises(RefusedError, match="unknown robot 'middle'"):
        opened.visit("middle", host="two")
    assert opened.visit(host="two").robots == ("right",)
    wait_until_ready(opened, "right")
    with pytest.raises(RefusedError, match="every robot has a host"):
        opened.visit(host="three")


def test_a_host_that_has_gone_before_the_run_is_replaced(opened: Open) -> None:
    opened.visit("left").channel.close()
    wait_until_ready(opened, "left")
    other = Program("b.c", "b", sources=("/b.c",), files={"/b.c": ""})
    opened.visit("left", host="two", program=other)
    wait_until_ready(opened, "left")
    seats = opened.roster.begin()
    assert [seat.program for seat in seats] == [other]


def test_a_lost_host_is_replaced_by_one_with_the_same_program(opened: Open) -> None:
    opened.visit("left", "right")
    wait_until_ready(opened, "left", "right")
    seat = opened.roster.begin()[0]
    channel = opened.roster.take(seat, lambda: False)
    assert channel
    channel.close()
    opened.roster.lose(seat)
    with pytest.raises(RefusedError, match="lost together"):
        opened.visit("left", host="two")
    with pytest.raises(RefusedError, match=r"the program of left and right is a\.c \(\w+\); the"):
        opened.visit("left", "right", host="two", program=replace(PROGRAM, checked=False))
    elsewhere = replace(PROGRAM, sources=("/b/a.c",), files={"/b/a.c": ""})
    assert opened.visit(host="two", program=elsewhere).robots == ("left", "right")
    assert opened.roster.take(seat, lambda: False)


def test_a_host_of_all_robots_that_notices_a_loss_first_comes_back(opened: Open) -> None:
    opened.visit()
    wait_until_ready(opened, "left", "right")
    seat = opened.roster.begin()[0]
    first = opened.roster.take(seat, lambda: False)
    assert opened.visit().robots == ("left", "right")
    assert opened.roster.take(seat, lambda: False) is not first
    with pytest.raises(RefusedError, match="every robot has a host already"):
        opened.visit(host="two")


@pytest.mark.parametrize("way", ["killed", "cut off"])
def test_a_host_that_is_lost_while_it_has_nothing_to_run_is_replaced(
    opened: Open, way: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As while the run is paused, when nobody receives the signs of life that it has sent."""
    monkeypatch.setattr(roster_module, "SILENCE_S", 0.1)
    lost = opened.visit("left", "right").channel
    wait_until_ready(opened, "left", "right")
    seat = opened.roster.begin()[0]
    assert opened.roster.take(seat, lambda: False)
    lost.send(Kind.ALIVE)
    if way == "killed":
        lost.close()
    else:
        opened.pulse.remove(lost)
    assert opened.visit("left", "right", host="two").robots == ("left", "right")
    assert opened.roster.take(seat, lambda: False)


def test_hosts_that_come_after_the_run_has_begun_have_the_same_program(opened: Open) -> None:
    opened.visit("left")
    wait_until_ready(opened, "left")
    assert [seat.names for seat in opened.roster.begin()] == [("left",)]
    with pytest.raises(RefusedError, match=r"the program of left is a\.c \(\w+\); the host has"):
        opened.visit("right", host="two", program=replace(PROGRAM, checked=False))
    assert opened.roster.newcomers() == []
    opened.visit(host="two")
    wait_until_ready(opened, "right")
    assert [seat.names for seat in opened.roster.newcomers()] == [("right",)]
    assert opened.roster.newcomers() == []


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
        found = visit(opened.address, hello, PROGRAM.content(), opened.pulse)
        said = found.channel.receive(Kind.REFUSED).content.decode()
    except RefusedError as error:  # it has come before all was sent
        said = str(error)
    assert "a program other than the announced one" in said
    assert opened.roster.missing() == ["left", "right"]


def test_who_says_anything_else_disturbs_nobody(opened: Open) -> None:
    random_ = random.Random(1)
    kept = []
    for number in range(150):
        connection = opened.connect()
        noise = random_.randbytes(random_.randrange(100))
        start = (b"", MAGIC, MAGIC[:4], b"GET / HTTP/1.1\r\n", MAGIC + bytes(4))[number % 5]
        connection.sendall(start + noise)
        kept.append(connection)
    opened.visit("left")
    wait_until_ready(opened, "left")
    for connection in kept:
        connection.close()
    assert opened.roster.missing() == ["right"]


def test_a_page_that_comes_before_there_is_something_to_see_tries_again(opened: Open) -> None:
    with opened.connect() as connection:
        connection.sendall(b"GET / HTTP/1.1\r\nHost: x\r\n\r\n")
        with connection.makefile() as answer:
            text = answer.read()
    assert text.startswith("HTTP/1.1 503")
    assert "location.reload()" in text


def test_visitors_are_led_on_in_both_directions(opened: Open) -> None:
    from crs_cc.net.gate import led_to

    with socket.create_server(("127.0.0.1", 0)) as inner:

        def echo() -> None:
            connection, _ = inner.accept()
            connection.sendall(connection.recv(100).upper())
            connection.close()

        thread = threading.Thread(target=echo)
        thread.start()
        opened.gate.visitor = led_to(inner.getsockname()[1])
        with opened.connect() as connection:
            connection.sendall(b"hello, page")
            assert connection.recv(100) == b"HELLO, PAGE"
            assert connection.recv(100) == b""
        thread.join()


def test_nobody_comes_in_after_the_end(opened: Open) -> None:
    opened.roster.end()
    with pytest.raises(RefusedError, match="has ended"):
        opened.visit("left")
    opened.gate.close()
    with pytest.raises(ConnectionLostError):
        opened.visit("left")


def test_a_greeting_may_take_longer_than_a_host_may_be_silent(
    opened: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in (gate_module, visit_module):
        monkeypatch.setattr(module, "SILENCE_S", 0.1)
    found = opened.visit("left", secure=lambda connection: Slow(connection.detach(), 0.5))
    wait_until_ready(opened, "left")
    with pytest.raises(ConnectionLostError, match=r"no message for 0\.1 s"):
        found.channel.receive(Kind.RESTORE)  # from now on, silence is a loss


def test_a_host_is_told_whom_the_run_waits_for() -> None:
    opened = Open(["left", "right"])
    with opened.pulse:
        assert opened.visit("left").awaited == ("right",)
        wait_until_ready(opened, "left")
        assert opened.visit("right", host="two").awaited == ()
        wait_until_ready(opened, "right")
        opened.roster.begin()
        assert opened.visit("left").awaited == ()
    opened.gate.close()
