"""The server as the process that an editor starts."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from crs_cc.cli.exit_status import SYSTEM
from crs_cc.cli.main import main
from crs_cc.debug.dap.framing import encode, read_message
from tests.commands import crs
from tests.debug.dap.programs import LOOP

ROOT = Path(__file__).parents[3]
WAIT_S = 60


@pytest.fixture
def server(tmp_path: Path) -> Iterator[subprocess.Popen[bytes]]:
    (tmp_path / "loop.c").write_text(LOOP)
    pipe = subprocess.PIPE
    command = crs("debug", "--dap", "stdio")
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    process = subprocess.Popen(
        command, stdin=pipe, stdout=pipe, stderr=pipe, env=environment, cwd=tmp_path
    )
    yield process
    process.kill()
    process.communicate()


def say(server: subprocess.Popen[bytes], command: str, **arguments: Any) -> None:
    assert server.stdin is not None
    message = {"seq": 1, "type": "request", "command": command, "arguments": arguments}
    server.stdin.write(encode(message))
    server.stdin.flush()


def test_end_of_input_ends_the_process_silently(
    server: subprocess.Popen[bytes],
) -> None:
    out, err = server.communicate(b"", timeout=WAIT_S)
    assert (server.returncode, out, err) == (0, b"", b"")


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT there")
def test_an_editor_that_closes_the_pipe_and_interrupts_is_no_failure(
    server: subprocess.Popen[bytes],
) -> None:
    assert server.stdin is not None
    assert server.stdout is not None
    say(server, "initialize", adapterID="crs")
    read_message(server.stdout)
    server.stdin.close()
    server.stdin = None
    server.send_signal(signal.SIGINT)
    assert server.wait(WAIT_S) == 0
    assert server.stderr is not None
    assert server.stderr.read() == b""


def test_a_client_that_stops_reading_ends_the_process(server: subprocess.Popen[bytes]) -> None:
    assert server.stdout is not None
    assert server.stderr is not None
    server.stdout.close()
    say(server, "initialize", adapterID="crs")
    say(server, "launch", program="loop.c")
    assert server.wait(WAIT_S) == 0
    assert server.stderr.read() == b""


def test_compiler_messages_reach_the_client(
    server: subprocess.Popen[bytes], tmp_path: Path
) -> None:
    (tmp_path / "loop.c").write_text("main() { return nothing; }\n")
    say(server, "launch", program="loop.c")
    say(server, "launch", program="loop.c", world="none.xml")
    say(server, "launch", program="loop.c", standard="c2000")
    say(server, "disconnect")
    out, err = server.communicate(timeout=WAIT_S)
    assert (server.returncode, err) == (0, b"")
    reasons = [message["message"] for message in messages(out) if "message" in message]
    assert "loop.c:1:17: error: use of undeclared" in reasons[0]
    assert "none.xml: error: no such file" in reasons[1]
    assert "c2000" in reasons[2]


def test_launch_sets_arguments_input_and_files(
    server: subprocess.Popen[bytes], tmp_path: Path
) -> None:
    (tmp_path / "copy.c").write_text(COPY)
    (tmp_path / "words.txt").write_text("one\ntwo\n")
    say(
        server,
        "launch",
        program="copy.c",
        args=["-x", "a b"],
        stdin="words.txt",
        files=["map=words.txt"],
        define=["LIMIT=3"],
        noDebug=True,
    )
    say(server, "configurationDone")
    assert server.stdout is not None
    found = ""
    while (message := read_message(server.stdout)) is not None:
        if message.get("event") == "output":
            found += message["body"]["output"]
        if message.get("event") == "terminated":
            break
    assert found == "-x\na b\none\nfile one\n3\n"
    say(server, "disconnect")
    assert server.wait(WAIT_S) == 0


def hear_interrupts() -> None:
    """Undo what is handed down to jobs in the background: that they hear no Ctrl-C."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def test_an_unusable_port_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    with socket.create_server(("127.0.0.1", 0)) as other:
        assert main(["debug", "--dap", str(other.getsockname()[1])]) == SYSTEM
    assert "Address already in use" in capsys.readouterr().err
    for wrong in ("65536", "tcp", "-1", ""):
        assert main(["debug", f"--dap={wrong}"]) == 2
    assert "neither stdio nor a port number" in capsys.readouterr().err


def test_a_token_that_can_be_guessed_is_refused(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CRS_DAP_TOKEN", "secret")
    assert main(["debug", "--dap", "0"]) == 2
    assert "CRS_DAP_TOKEN has fewer than 16 characters." in capsys.readouterr().err


COPY = """\
#include <stdio.h>
int main(int argc, char **argv)
{
    char line[80];
    puts(argv[1]);
    puts(argv[2]);
    fputs(fgets(line, sizeof line, stdin), stdout);
    printf("file %s", fgets(line, sizeof line, fopen("map", "r")));
    printf("%d\\n", LIMIT);
    return 0;
}
"""


def messages(content: bytes) -> list[dict[str, Any]]:
    """Return all messages in what a server has said."""
    parts = content.split(b"Content-Length: ")[1:]
    return [json.loads(part.partition(b"\r\n\r\n")[2]) for part in parts]
