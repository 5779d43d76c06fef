"""Several clients, for several robots; clients that vanish, and those that are none."""

from __future__ import annotations

import random
import socket
import struct
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from crs_cc.net.vendor.server import Server
from crs_cc.net.vendor.switchboard import Configuration
from crs_cc.sim.files.world_xml import load_world
from tests.net.vendor.nclient import Nclient
from tests.net.vendor.ndirect import over_tcp
from tests.net.vendor.served import served

PAIR = load_world(Path(__file__).parents[3] / "worlds" / "pair.xml")


def connected(port: int, robot: int = 1) -> Nclient:
    client = Nclient(port)
    assert client.connect_robot(robot) == port
    return client


def test_each_client_drives_its_robot_and_a_third_is_rejected() -> None:
    with served(PAIR) as run:
        port = run.server.serve_nserver(0)
        second, first = connected(port, 2), connected(port, 1)
        third = Nclient(port)
        third._socket = socket.create_connection(("127.0.0.1", port), timeout=30)
        assert third.exchange(102, 1, 1) == 82
        assert third.received == [0]
        assert third.exchange(16, *[0] * 7) == 91  # Nclient 2.6.11 goes on and waits for it
        first.state_call(13, 100, 100, 0)
        assert second.state_call(39, 1, 1, 1, 2)
        assert first.state_call(39, 1, 1, 1, 9)
        assert first.state[34] == 100
        assert second.state[34] == 0
        second.disconnect_robot()
        third.vanish()
        fourth = connected(port)
        assert fourth.get_rpx()
        assert fourth.received[0] == 2
        assert fourth.received[1] == 394 + 100


def test_a_client_that_connects_while_the_port_is_opened_is_served(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    listen, clients = Server._listen, []

    def slow(server: Server, *arguments: Any) -> int:
        port = listen(server, *arguments)
        clients.append(connected(port))
        return port

    monkeypatch.setattr(Server, "_listen", slow)
    with served(PAIR) as run:
        run.server.serve_nserver(0)
        assert clients[0].state_call(15)


def test_spoken_text_is_the_robots_output() -> None:
    with served(PAIR) as run:
        client = connected(run.server.serve_nserver(0))
        assert client.tk("it is warm")
        assert client.tk("\x1b[2J\rGr\xfc\xdfe")
    assert run.output == [b"it is warm\n", b"?[2J?Gr\xfc\xdfe\n"]


def test_masked_elements_do_not_change() -> None:
    with served(PAIR) as run:
        client = connected(run.server.serve_nserver(0))
        before = client.state
        assert any(before[17:33])
        client.mask[17:33] = [0] * 16
        client.ct()
        client.state_call(13, 300, -300, 0)
        client.state_call(39, 1, 1, 1, 9)
        assert client.state[17:33] == before[17:33]
        assert client.state[36] != before[36]
        client.group(28, 17, 32, 2)
        assert client.state[17:33] != before[17:33]


class User:
    """Points at a place, sooner or later."""

    def __init__(self) -> None:
        self.asked = threading.Event()
        self.forgotten: list[int] = []
        self.answer: Callable[[Configuration], None] = lambda _found: None

    def ask(self, _robot: int, answer: Callable[[Configuration], None]) -> None:
        self.answer = answer
        self.asked.set()

    def forget(self, robot: int) -> None:
        self.forgotten.append(robot)


def test_the_user_is_asked_for_a_configuration() -> None:
    with served(PAIR) as run:
        user = run.board.pointing = User()
        port = run.server.serve_nserver(0)
        client, other = connected(port), connected(port, 2)
        client.send(200)
        assert user.asked.wait(30)
        assert other.state_call(15)  # who is not held up
        user.answer((10, -20, 900, 900))
        assert client._receive(20) == client.packet(88, 10, -20, 900, 900)
        user.asked.clear()
        client.send(200)
        assert user.asked.wait(30)
        client.vanish()
        again = connected(port)
        assert again.state_call(15)
        assert user.forgotten == [0]
        again.send(200)
        again.vanish()  # perhaps before he is asked
        assert connected(port).state_call(15)


def test_the_robot_of_a_disconnected_client_goes_to_the_next_one() -> None:
    with served(PAIR) as run:
        port = run.server.serve_nserver(0)
        others = connected(port, 2)
        for _ in range(3):
            client = connected(port)
            client.state_call(12, 50, 50, 0)
            client.send(39, 1, 1, 1, 5)  # it waits for a robot that does not stop
            client.vanish()
            assert others.state_call(39, 1, 1, 1, 1)
            others.state_call(26, 0)
        assert not run.failed


def test_invalid_connections_do_not_affect_clients() -> None:
    noise = random.Random(7)
    with served(PAIR) as run:
        port = run.server.serve_nserver(0)
        client = connected(port)
        strangers = []
        for number in range(150):
            stranger = socket.create_connection(("127.0.0.1", port), timeout=5)
            if number % 3:
                stranger.sendall(noise.randbytes(noise.randrange(1, 60)))
            strangers.append(stranger)
        assert client.state_call(15)
        for stranger in strangers:
            stranger.close()
        again = Nclient(port)
        deadline_s = time.monotonic() + 10.0
        while not again_connects(again) and time.monotonic() < deadline_s:
            pass
        assert again.state_call(15)
        assert not run.failed


def again_connects(client: Nclient) -> bool:
    """Return whether a client is served; while other connections are open it may not be."""
    try:
        return bool(client.connect_robot(2))
    except (OSError, IndexError):
        return False


def test_arbitrary_packets_are_answered_and_harmless() -> None:
    noise = random.Random(11)
    with served(PAIR) as run:
        client = connected(run.server.serve_nserver(0))
        for _ in range(300):
            kind = noise.choice([*range(10, 63), 71, 74, 75, 150, 159, 200, 300, 400, 65535])
            count = noise.choice([0, 1, 2, 3, 4, 5, 6, 7, 8, 17, 21, 300])
            elements = [
                noise.choice([0, 1, 5, -1, 2**31 - 1, -(2**31), 1000]) for _ in range(count)
            ]
            if kind in (20, 39):
                continue  # they wait
            assert client.exchange(kind, *elements) is not None
        assert client.exchange(15) == 80
        assert not run.failed


def test_a_flood_is_answered_packet_by_packet() -> None:
    with served(PAIR) as run:
        port = run.server.serve_nserver(0)
        client, other = connected(port), connected(port, 2)
        assert client._socket is not None
        client._socket.sendall(client.packet(29) * 500)
        assert other.state_call(15)
        replies = client._receive(500 * (4 + 16))
        assert [struct.unpack_from(">HH", replies, at) for at in range(0, len(replies), 20)] == [
            (88, 4)
        ] * 500


def test_noise_on_a_line_is_skipped() -> None:
    noise = random.Random(3)
    with served(PAIR) as run:
        client = over_tcp(run.server.serve_line(0, 1), model=2)
        for _ in range(20):
            client.write(noise.randbytes(40).replace(b"\x01", b"\x02"))
            assert client.state_call(7)
        client.send(17, bytes(6))  # a Scout has no laser
        assert client.receive() == (8, b"")
        client.send(12, bytes(3))
        assert client.receive() == (8, b"")
