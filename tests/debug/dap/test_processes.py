"""The server as the process that an editor starts."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from crs_cc.debug.dap.framing import encode, read_message
from tests.debug.dap.programs import LOOP

ROOT = Path(__file__).parents[3]
WAIT_S = 60


@pytest.fixture
def server(tmp_path: Path) -> Iterator[subprocess.Popen[bytes]]:
    (tmp_path / "loop.c").write_text(LOOP)
    pipe = subprocess.PIPE
    command = [sys.executable, "-m", "crs_cc", "debug", "--dap", "stdio"]
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


def test_the_end_of_input_ends_the_process_without_a_word(
    server: subprocess.Popen[bytes],
) -> None:
    out, err = server.communicate(b"", timeout=WAIT_S)
    assert (server.returncode, out, err) == (0, b"", b"")


def test_a_client_that_reads_no_longer_ends_the_process(server: subprocess.Popen[bytes]) -> None:
    assert server.stdout is not None
    assert server.stderr is not None
    server.stdout.close()
    say(server, "initialize", adapterID="crs")
    say(server, "launch", program="loop.c")
    assert server.wait(WAIT_S) == 0
    assert server.stderr.read() == b""


def test_what_the_compiler_says_is_said_to_the_client(
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


def test_programs_take_arguments_input_and_files_from_launch(
    server: subprocess.Popen[bytes], tmp_path: Path
) -> None:
    (tmp_path / "copy.c").write_text(COPY)
    (tmp_path / "words.txt").write_text("one\ntwo\n")
    say(
        server,
        "launch",
        program="copy.c",
        args=["-x", "a b"],
        input="words.txt",
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
    """Gives all messages in what a server has said."""
    parts = content.split(b"Content-Length: ")[1:]
    return [json.loads(part.partition(b"\r\n\r\n")[2]) for part in parts]
