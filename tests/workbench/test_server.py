"""Connections to the server of the page: permissions, and invalid clients."""

from __future__ import annotations

import asyncio
import http.client
import json
import os
import socket
import time
from collections.abc import Iterator
from contextlib import ExitStack
from itertools import islice
from socket import SHUT_RDWR
from typing import Any

import numpy as np
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import ClientConnection, connect

from crs_cc.core import host_system
from crs_cc.recording.frames import FrameDecoder
from crs_cc.workbench.clients import Client
from crs_cc.workbench.messages import MAX_BYTES, answer
from crs_cc.workbench.server import MAX_CLIENTS, Server
from tests.workbench.channel_frames import frame_in


class Echo:
    """Answers each command with itself."""

    def greet(self, client: Client) -> None:
        client.put(f"hello {client.role}")

    def receive(self, client: Client, command: dict[str, Any]) -> None:
        client.put(answer(command["id"], command["command"]))


@pytest.fixture(scope="module")
def server() -> Iterator[Server]:
    made = Server(Echo())
    yield made
    made.close()


def opened(server: Server, token: str = "", **options: Any) -> ClientConnection:
    words = ["crs.1", f"token.{token or server.tokens['control']}"]
    url = f"ws://127.0.0.1:{server.port}/channel"
    return connect(url, subprotocols=words, proxy=None, compression=None, **options)  # type: ignore[arg-type]


def got(server: Server, path: str, host: str = "") -> tuple[int, dict[str, str]]:
    line = http.client.HTTPConnection("127.0.0.1", server.port, timeout=10)
    line.putrequest("GET", path, skip_host=True)
    line.putheader("Host", host or f"127.0.0.1:{server.port}")
    line.endheaders()
    response = line.getresponse()
    response.read()
    line.close()
    return response.status, {name.lower(): value for name, value in response.getheaders()}


def test_the_page_loads_only_its_own_files(server: Server) -> None:
    status, headers = got(server, "/")
    assert (status, headers["content-type"]) == (200, "text/html; charset=utf-8")
    assert "default-src 'none'" in headers["content-security-policy"]
    assert "unsafe" not in headers["content-security-policy"]
    assert got(server, "/static/app.js")[1]["content-type"] == "text/javascript; charset=utf-8"
    assert got(server, "/static/three/three.module.js")[0] == 200


@pytest.mark.parametrize(
    "path",
    [
        "/static/../server.py",
        "/static/%2e%2e/server.py",
        "/static//etc/passwd",
        "//etc/passwd",
        "/static/panels",
        "/static/page.html",
        "/static/three/LICENSE/..%2f..%2f",
    ],
)
def test_paths_outside_the_page_are_rejected(server: Server, path: str) -> None:
    assert got(server, path)[0] == 404


def test_a_rebound_host_name_is_rejected(server: Server) -> None:
    assert got(server, "/", f"evil.example:{server.port}")[0] == 403


@pytest.mark.parametrize("name", ["Host", "Origin", "Sec-WebSocket-Protocol"])
def test_a_duplicate_header_is_rejected(server: Server, name: str) -> None:
    host = f"127.0.0.1:{server.port}"
    rows = {"Host": host, "Origin": f"http://{host}", "Sec-WebSocket-Protocol": "crs.1"}
    head = "".join(f"{each}: {value}\r\n" for each, value in rows.items())
    with socket.create_connection(("127.0.0.1", server.port), 5.0) as connection:
        connection.sendall(f"GET /channel HTTP/1.1\r\n{head}{name}: {rows[name]}\r\n\r\n".encode())
        assert connection.recv(100).startswith(b"HTTP/1.1 400 ")


def test_the_channel_requires_a_token_and_our_origin(server: Server) -> None:
    for options, status in (
        ({"token": "x" * 22}, 401),
        ({"token": server.tokens["view"], "origin": "https://evil.example"}, 403),
        ({"origin": "null"}, 403),
    ):
        with pytest.raises(InvalidStatus) as refused, opened(server, **options):
            pass
        assert refused.value.response.status_code == status
    own = f"http://127.0.0.1:{server.port}"
    for role in ("control", "view"):
        with opened(server, server.tokens[role], origin=own) as page:  # type: ignore[index,arg-type]
            assert page.recv(5) == f"hello {role}"
            page.send(json.dumps({"id": 1, "command": "play"}))
            assert json.loads(page.recv(5))["value"] == "play"


def test_another_user_is_rejected_even_with_the_token(
    server: Server, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(host_system, "_user_of_peer", lambda _client: os.geteuid() + 1)
    with pytest.raises(InvalidStatus) as refused, opened(server):
        pass
    assert refused.value.response.status_code == 403


@pytest.mark.parametrize("sent", ["nonsense", "[]", '{"id": "x", "command": "play"}', "[" * 60_000])
def test_an_invalid_command_ends_the_connection(server: Server, sent: str) -> None:
    with opened(server) as page:
        page.recv(5)
        page.send(sent)
        with pytest.raises(ConnectionClosed) as closed:
            page.recv(5)
    assert closed.value.rcvd is not None
    assert closed.value.rcvd.code == 1008


def test_a_large_message_and_a_flood_end_the_connection(server: Server) -> None:
    with opened(server) as page:
        page.send("x" * (MAX_BYTES + 1))
        with pytest.raises(ConnectionClosed) as closed:
            [page.recv(5) for _ in range(2)]
    assert closed.value.rcvd is not None
    assert closed.value.rcvd.code == 1009
    with opened(server) as page, pytest.raises(ConnectionClosed):
        flood(page)


def flood(page: ClientConnection) -> None:
    for number in range(2000):
        page.send(json.dumps({"id": number, "command": "play"}))
    while True:
        page.recv(5)


def test_a_slow_page_skips_frames_and_then_receives_a_key_frame(server: Server) -> None:
    values = np.zeros((3, 4))
    with opened(server) as page:
        page.recv(5)
        while not server.page_count:
            time.sleep(0.001)
        decoder, seen = FrameDecoder(), []
        for number in range(50):
            values = values + 0.25
            server.broadcast_frame(float(number), values)
        while not seen or seen[-1][0] < 49.0:
            data = page.recv(5)
            assert isinstance(data, bytes)
            time_s = float(np.frombuffer(data, "<f8", 1, 1)[0])
            seen.append((time_s, decoder.decode(frame_in(data))[0, 0]))
    assert all(value == (time_s + 1) * 0.25 for time_s, value in seen)


def test_messages_arrive_in_order_whether_sent_directly_or_queued(server: Server) -> None:
    sent = [f"{number} {'x' * (300_000 if number % 7 == 0 else 10)}" for number in range(40)]
    with opened(server, max_size=None) as page:
        page.recv(5)
        while not server.page_count:
            time.sleep(0.001)
        for text in sent:
            server.broadcast(text)
        texts = (each for each in page if isinstance(each, str))  # besides the last frame
        assert list(islice(texts, len(sent))) == sent


def test_a_hundred_pages_receive_the_run_and_a_killed_one_frees_its_slot() -> None:
    server = Server(Echo())
    with ExitStack() as stack:
        pages = [stack.enter_context(opened(server)) for _ in range(MAX_CLIENTS)]
        with pytest.raises(InvalidStatus) as refused, opened(server):
            pass
        assert refused.value.response.status_code == 503
        pages.pop().socket.shutdown(SHUT_RDWR)  # without a word, as a browser that is killed
        while server.page_count == MAX_CLIENTS:
            time.sleep(0.001)
        pages.append(stack.enter_context(opened(server)))
        server.broadcast("to all")
        assert {tuple(page.recv(5) for _ in range(2)) for page in pages} == {
            ("hello control", "to all")
        }
        server.close()


def test_a_port_in_use_is_an_error(server: Server) -> None:
    with pytest.raises(OSError, match="in use"):
        Server(Echo(), server.port)


def test_pages_are_notified_when_the_server_ends() -> None:
    server = Server(Echo())
    with opened(server) as page:
        page.recv(5)
        server.close()
        with pytest.raises(ConnectionClosed) as closed:
            page.recv(5)
    assert closed.value.rcvd is not None
    assert closed.value.rcvd.code == 1001


class Beginner(Echo):
    """Begins something for each page that would take long."""

    def __init__(self) -> None:
        self.begun: list[asyncio.Future[None]] = []

    def greet(self, client: Client) -> None:
        self.begun.append(asyncio.ensure_future(asyncio.sleep(300)))
        super().greet(client)


def test_tasks_of_pages_end_with_the_server() -> None:
    """What is begun just as it ends was collected unfinished, with a warning."""
    receiver = Beginner()
    server = Server(receiver)
    with opened(server) as page:
        page.recv()
        server.close()
    assert [each.cancelled() for each in receiver.begun] == [True]
