"""`--forward` and `--connect`: named ways to the real network, recorded as inputs."""

from __future__ import annotations

import io
import socket
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, redirect_stderr
from pathlib import Path

import pytest
from websockets.sync.client import connect

from crs_cc.cli.main import main
from crs_cc.debug.errors import DebugError
from tests.cli.machines import free_port
from tests.cli.shown_run import page_of
from tests.debug.debuggers import debugger_of
from tests.workbench.test_screen import Page

PROGRAMS = Path(__file__).parents[1] / "session" / "network"
SERVER, CLIENT = str(PROGRAMS / "server.c"), str(PROGRAMS / "client.c")
REPLIES = b"hello\n46\nunknown: dance\na longer line, which goes in pieces\n"

WAIT_S = 20.0


@contextmanager
def beside(work: Callable[[], object]) -> Iterator[threading.Thread]:
    """Do something in a thread, and wait for its end."""
    thread = threading.Thread(target=work)
    thread.start()
    yield thread
    thread.join(WAIT_S)
    assert not thread.is_alive()


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def run(*arguments: str) -> int:
    program, *rest = arguments
    return main(["run", "-q", "--speed", "50", "--max-time", "900", program, *rest])


def test_a_client_of_this_machine_reaches_a_robot_and_the_run_needs_it_once_only(
    capfd: pytest.CaptureFixture[str],
) -> None:
    port, heard = free_port(), bytearray()

    def call() -> None:
        with socket.create_connection(("127.0.0.1", port), WAIT_S) as line:
            line.sendall(b"echo from out = side\nsum 4 5\n")
            while heard.count(b"\n") < 2:
                heard.extend(line.recv(100))

    def wait_and_call() -> None:
        while True:
            try:
                call()
            except ConnectionRefusedError:
                time.sleep(0.01)
                continue
            return

    with beside(wait_and_call):
        forwarded = ["--forward", f"{port}:robot0", "--record", "run.mcap"]
        assert run(SERVER, *forwarded, "--", str(port), "1") == 0
    assert heard == b"from out = side\n9\n"
    assert capfd.readouterr().out == "ready\nserved\n"
    assert main(["replay", "run.mcap", "--verify"]) == 0
    assert "the same run" in capfd.readouterr().out
    back = ["-ex", "continue", "-ex", "goto 0.05s", "-ex", "continue"]
    assert main(["debug", "run.mcap", "--batch", *back]) == 0
    shown = capfd.readouterr()
    assert shown.out.count("served\n") == 2
    assert "differs" not in shown.err


def test_a_program_reaches_a_server_of_this_machine(capfd: pytest.CaptureFixture[str]) -> None:
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        listener.listen()
        port = listener.getsockname()[1]

        def serve() -> None:
            listener.settimeout(WAIT_S)
            line, _ = listener.accept()
            with line, line.makefile("rw") as text:
                for command in text:
                    text.write(command[::-1].strip() + "\n")
                    text.flush()

        with beside(serve):
            way = f"logger:7000=127.0.0.1:{port}"
            assert run(CLIENT, "--connect", way, "--", "logger", "7000") == 0
    assert capfd.readouterr().out.splitlines()[:2] == ["olleh ohce", "04 3 2 1 mus"]


def test_a_connection_to_a_closed_port_is_refused(capfd: pytest.CaptureFixture[str]) -> None:
    way = f"logger:7000=127.0.0.1:{free_port()}"
    assert run(CLIENT, "--connect", way, "--", "logger", "7000") == 2
    assert run(CLIENT, "--", "host", "7000") == 2  # no way is open
    assert capfd.readouterr().err == "connect: Connection refused\n" * 2


def test_pages_pause_and_change_a_run_on_the_real_network(
    capfd: pytest.CaptureFixture[str],
) -> None:
    port, said = free_port(), io.BytesIO()
    options = "--forward", str(port), "--view", "--record", "run.mcap", "--max-time", "900"
    words = ["run", SERVER, *options, "--speed", "20", "--", str(port), "1"]
    stream = io.TextIOWrapper(said, write_through=True)
    with redirect_stderr(stream), beside(lambda: main(words)) as run:
        page_port, token = page_of(run, said)
        url, protocols = f"ws://127.0.0.1:{page_port}/channel", ["crs.1", f"token.{token}"]
        with connect(url, subprotocols=protocols, proxy=None, max_size=None) as line:  # type: ignore[arg-type]
            page = Page(line)
            page.ask("pause")
            assert "value" in page.ask("edit", text="heat robot0 5")
            page.ask("play")
            with socket.create_connection(("127.0.0.1", port), WAIT_S) as client:
                client.sendall(b"sum 4 5\n")
                assert client.recv(100) == b"9\n"
    assert main(["replay", "run.mcap", "--verify"]) == 0
    assert "the same run" in capfd.readouterr().out


def test_a_script_does_what_the_real_network_would(capfd: pytest.CaptureFixture[str]) -> None:
    Path("script").write_text(
        "0s: network call robot0 7000\n"
        "0.5s: network 0 send echo\\x20by\n"
        "0.6s: network 0 send  hand\\n\n"
        "0.9s: network 0 end\n"
    )
    assert run(SERVER, "--inputs", "script", "--", "7000", "1") == 0
    assert capfd.readouterr().out == "ready\nserved\n"


@pytest.mark.parametrize(
    ("option", "value", "said"),
    [
        ("--connect", "logger", "is not NAME=HOST:PORT"),
        ("--connect", "logger=somewhere:70000", "70000 is not a port"),
        ("--connect", "robot0=127.0.0.1:9", "a computer 'robot0' already exists"),
        ("--forward", "x", "is not PORT or PORT:ROBOT"),
        ("--forward", "7000:nobody", "unknown robot 'nobody' (known: robot0)"),
    ],
)
def test_an_invalid_connect_option_is_reported(
    option: str, value: str, said: str, capfd: pytest.CaptureFixture[str]
) -> None:
    assert run(str(PROGRAMS / "idle.c"), option, value) == 2
    assert said in capfd.readouterr().err


def test_a_port_that_is_taken_is_an_error(capfd: pytest.CaptureFixture[str]) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        assert run(str(PROGRAMS / "idle.c"), "--forward", str(port)) != 0
    assert f"port {port}:" in capfd.readouterr().err


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("network", "expected: network reach NAME PORT"),
        ("network 0 dance", "unknown action 'dance'"),
        ("network 0 end", "no connection 0"),
        ("network 0 send", "expected: network"),
        ("network call nobody 7", "unknown robot 'nobody'"),
        ("network call robot0 x", "'x' is not a number"),
        ("network reach robot0 7", "a computer 'robot0' already exists"),
        ("network reach a/b 7", "is not a name for a computer"),
        ("network reach a 0", "0 is not a port"),
    ],
)
def test_a_wrong_change_of_the_network_is_named(text: str, said: str) -> None:
    debugger = debugger_of("int main(void) { return 0; }\n")
    with pytest.raises(DebugError, match=said.replace("(", "\\(")):
        debugger.edit_world(text)
