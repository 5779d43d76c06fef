"""The server on a port: whom it serves, and that nobody keeps it from serving the next."""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import struct
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from crs_cc.cli.exit_status import INTERRUPTED
from crs_cc.core import host_system, loopback
from crs_cc.debug.dap import gate, port
from crs_cc.debug.dap.framing import MAX_MESSAGE_BYTES, encode, read_message
from tests.commands import crs
from tests.debug.dap.programs import LOOP, open_run
from tests.debug.dap.test_processes import hear_interrupts

ROOT = Path(__file__).parents[3]
WAIT_S = 60
TOKEN = "a token of these tests"


class Address(NamedTuple):
    port: int
    token: str


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Address]:
    """Start a server as users do; it ends by Ctrl-C, without a traceback."""
    folder = tmp_path_factory.mktemp("server")
    (folder / "loop.c").write_text(LOOP)
    command = crs("debug", "--dap", "0")
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    with subprocess.Popen(
        command,
        stderr=subprocess.PIPE,
        text=True,
        env=environment,
        cwd=folder,
        preexec_fn=hear_interrupts,  # noqa: PLW1509 - no threads here
    ) as process:
        assert process.stderr is not None
        said, token = process.stderr.readline(), process.stderr.readline()
        assert said.startswith("waiting for an editor on 127.0.0.1:")
        yield Address(int(said.rpartition(":")[2]), token.removeprefix("token: ").strip())
        process.send_signal(signal.SIGINT)
        assert process.wait(WAIT_S) == INTERRUPTED
        assert process.stderr.read().strip() == "crs: interrupted"


@contextlib.contextmanager
def connected(number: int) -> Iterator[socket.socket]:
    with socket.create_connection(("127.0.0.1", number)) as client:
        client.settimeout(WAIT_S)
        yield client


def request(command: str, **arguments: Any) -> bytes:
    return encode({"seq": 1, "type": "request", "command": command, "arguments": arguments})


def answers(client: socket.socket, *requests: bytes) -> list[tuple[str, bool, str]]:
    """Return the responses to requests: command, success, message; empty at the end."""
    client.sendall(b"".join(requests))
    heard: list[tuple[str, bool, str]] = []
    with client.makefile("rb") as stream, contextlib.suppress(ConnectionError):
        while len(heard) < len(requests) and (message := read_message(stream)) is not None:
            if message["type"] == "response":
                heard.append((message["command"], message["success"], message.get("message", "")))
    return heard


INITIALIZE = request("initialize", adapterID="crs")


def launch(token: object) -> bytes:
    return request("launch", program="loop.c", token=token, stopOnEntry=True)


def test_a_client_that_knows_the_token_is_served_after_rude_ones(server: Address) -> None:
    rude = struct.pack("ii", 1, 0)  # closing throws away what is on the way
    for content in (b"", b"junk\r\n", b"Content-Length: 5\r\n\r\n{", INITIALIZE):
        with connected(server.port) as client:
            client.sendall(content)
            client.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, rude)
    with connected(server.port) as client:
        heard = answers(client, INITIALIZE, launch(server.token), request("threads"))
    assert [success for _, success, _ in heard] == [True, True, True]


@pytest.mark.parametrize(
    "asked",
    [
        request("launch", program="loop.c"),
        launch("wrong"),
        launch(None),
        launch(["token"]),
        request("initialize", adapterID="crs", token="wrong"),
        request("attach", token=""),
        request("source", source={"path": "/etc/passwd"}, sourceReference=0),
        request("evaluate", expression="1"),
        request("setBreakpoints", source={"path": "/etc/passwd"}),
    ],
)
def test_a_client_without_the_token_is_refused_and_disconnected(
    server: Address, asked: bytes
) -> None:
    with connected(server.port) as client:
        heard = answers(client, asked, INITIALIZE)
        assert len(heard) == 1
        assert not heard[0][1]
        assert "token" in heard[0][2]
        with contextlib.suppress(ConnectionError):
            assert client.recv(1) == b""


def test_large_messages_require_the_token(server: Address) -> None:
    with connected(server.port) as client:
        heard = answers(client, b"Content-Length: 70000\r\n\r\n", b"")
        assert not heard[0][1]
    with connected(server.port) as client:
        filled = request("evaluate", expression="1", padding="x" * 70000)
        assert len(filled) < MAX_MESSAGE_BYTES
        assert len(answers(client, INITIALIZE, launch(server.token), filled)) == 3


def test_silent_clients_do_not_block_others(server: Address) -> None:
    with contextlib.ExitStack() as opened:
        for _ in range(port.MAX_CLIENTS // 2):
            opened.enter_context(connected(server.port)).sendall(INITIALIZE[:20])
        with connected(server.port) as client:
            heard = answers(client, INITIALIZE, launch(server.token))
        assert [success for _, success, _ in heard] == [True, True]


@pytest.fixture
def clients(monkeypatch: pytest.MonkeyPatch) -> Iterator[int]:
    """Serve in this process, with short limits."""
    monkeypatch.setattr(loopback.BoundedStream.__init__, "__defaults__", (0.2,))
    monkeypatch.setattr(gate, "SEAT_S", 0.2)
    import threading

    made = port.Clients(open_run, TOKEN)
    with loopback.listen(0) as listener:

        def work() -> None:
            with contextlib.suppress(OSError):
                while True:
                    made.start(listener.accept()[0])

        thread = threading.Thread(target=work)
        thread.start()
        yield listener.getsockname()[1]
        listener.shutdown(socket.SHUT_RDWR)
        thread.join(WAIT_S)
    made.close()


@pytest.mark.parametrize(
    "begun",
    [
        b"",
        INITIALIZE[:10],
        INITIALIZE + b"Content-Length: 100\r\n\r\n{",
        INITIALIZE + request("initialize", token=TOKEN) + b"Content-Length: 100\r\n\r\n{",
    ],
)
def test_half_a_message_ends_the_session(clients: int, begun: bytes) -> None:
    with connected(clients) as client, client.makefile("rb") as stream:
        client.sendall(begun)
        last = None
        while (message := read_message(stream)) is not None:
            last = message
        assert last is not None
        assert last["message"] == "a message is incomplete"


def test_a_message_that_drips_ends_the_session(
    clients: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(loopback, "STALL_S", 0.3)
    with connected(clients) as client, client.makefile("rb") as stream:
        client.settimeout(0.1)
        for byte in INITIALIZE:
            client.sendall(bytes([byte]))
            with contextlib.suppress(TimeoutError):
                client.recv(1, socket.MSG_PEEK)
                break  # it has answered
        client.settimeout(WAIT_S)
        message = read_message(stream)
        assert message is not None
        assert message["message"] == "a message took too long"


def test_a_second_editor_is_refused_while_the_first_is_connected(clients: int) -> None:
    with connected(clients) as first, connected(clients) as second:
        assert answers(first, request("initialize", token=TOKEN))[0][1]
        ((_, success, why),) = answers(second, request("initialize", token=TOKEN))
        assert not success
        assert why == "another editor is being served: end its session first"
    with connected(clients) as third:
        assert answers(third, request("initialize", token=TOKEN))[0][1]


def test_a_client_of_another_user_gets_no_response(
    clients: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(os, "geteuid", lambda: os.getuid() + 1)
    with connected(clients) as client:
        assert answers(client, request("initialize", token=TOKEN)) == []


@pytest.mark.skipif(not Path("/proc/net/tcp").exists(), reason="this system does not say")
@pytest.mark.parametrize("family", [socket.AF_INET, socket.AF_INET6])
def test_the_user_at_the_other_end_is_known(family: socket.AddressFamily) -> None:
    """An IPv6 socket can connect to an IPv4 address; it is in another table."""
    with loopback.listen(0) as listener:
        host = "127.0.0.1" if family == socket.AF_INET else "::ffff:127.0.0.1"
        with socket.socket(family) as client:
            try:
                client.connect((host, listener.getsockname()[1]))
            except OSError:
                pytest.skip("no IPv6 here")
            accepted, _ = listener.accept()
            with accepted:
                assert host_system._user_of_peer(accepted) == os.geteuid()
                assert not host_system.is_of_another_user(accepted)
