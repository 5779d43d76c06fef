"""Sessions as an editor has them; each message that comes is checked against the schema."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.debug.dap.client import Client
from tests.debug.dap.programs import LOOP, open_run

WORLDS = Path(__file__).parents[3] / "worlds"


@pytest.fixture
def client() -> Iterator[Client]:
    with Client(open_run) as made:
        yield made


@pytest.fixture
def loop(tmp_path: Path) -> Path:
    path = tmp_path / "loop.c"
    path.write_text(LOOP)
    return path


def test_a_run_stops_at_a_breakpoint_and_at_its_end(client: Client, loop: Path) -> None:
    client.launch(loop)
    assert client.break_at(loop, 6)[0]["verified"]
    stop = client.begin()
    assert stop["reason"] == "breakpoint"
    assert stop["allThreadsStopped"]
    assert [frame["line"] for frame in client.frames()] == [6, 15]
    assert [frame["name"] for frame in client.frames()] == ["twice", "main"]
    client.break_at(loop)
    stop = client.move("continue")
    assert stop["reason"] == "exited"
    assert client.printed() == "0\n2\n6\n"
    assert client.frames()[0]["name"] == "exited with 6"
    client.ask("continue", threadId=1)
    assert client.event("exited") == {"exitCode": 6}
    client.event("terminated")
    client.ask("disconnect")


def test_steps_go_forward_and_backward(client: Client, loop: Path) -> None:
    client.launch(loop, stopOnEntry=True)
    assert client.begin()["reason"] == "entry"
    assert client.line() == 13
    moves = {"next": 14, "stepIn": 15, "stepBack": 14}
    assert [client.move(move)["reason"] for move in moves] == ["step"] * 3
    assert client.line() == 14


def test_back_to_a_breakpoint_and_to_the_beginning(client: Client, loop: Path) -> None:
    client.launch(loop)
    client.break_at(loop, 15)
    client.begin()
    client.move("continue")
    client.move("continue")
    stop = client.move("reverseContinue")
    assert stop["reason"] == "breakpoint"
    assert client.line() == 15
    client.break_at(loop)
    assert client.move("reverseContinue")["reason"] == "entry"
