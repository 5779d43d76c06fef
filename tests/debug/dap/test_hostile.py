"""Clients that are broken, or mean no good: they get an answer or the end, and nothing else."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from pathlib import Path

import pytest

from crs_cc.debug.dap import session
from crs_cc.debug.dap.framing import MAX_MESSAGE_BYTES
from crs_cc.debug.dap.inbox import MAX
from crs_cc.debug.dap.request_table import HANDLERS
from tests.debug.dap.client import Client
from tests.debug.dap.programs import LOOP, open_run
from tests.debug.debuggers import source_file


@pytest.fixture
def client() -> Iterator[Client]:
    with Client(open_run) as made:
        yield made


def framed(body: bytes) -> bytes:
    return b"Content-Length: %d\r\n\r\n%b" % (len(body), body)


@pytest.mark.parametrize(
    "content",
    [
        b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n",
        b"Content-Length: 12x\r\n\r\n",
        b"Content-Length: -1\r\n\r\n",
        b"Content-Length: \xd9\xa3\r\n\r\n",
        b"Content-Length: %d\r\n\r\n" % (MAX_MESSAGE_BYTES + 1),
        b"Content-Length: " + b"9" * 5000,
        b"X: y\r\n" * 1000,
        b"Content-Type: json\r\n\r\n{}",
        b"\r\n\r\n",
        b"\x00" * 5000,
    ],
)
def test_a_protocol_violation_is_reported_and_ends_the_session(
    client: Client, content: bytes
) -> None:
    client.send(content)
    client.hang_up()
    message = client.hear()
    assert message is not None
    assert not message["success"]
    assert client.hear() is None


def test_a_stream_that_ends_within_a_message_ends_the_session(client: Client) -> None:
    client.send(b"Content-Length: 1000\r\n\r\n{")
    client.hang_up()
    message = client.hear()
    assert message is not None
    assert "999 bytes" in message["message"]
    assert client.hear() is None


@pytest.mark.parametrize(
    "body",
    [
        b"",
        b"{",
        b"[]",
        b'"seq"',
        b"\xff\xfe",
        b"[" * 200_000,
        b'{"seq": ' + b"1" * 5000 + b"}",
        b'{"seq": NaN, "type": "request", "command": "threads"}',
        b'{"seq": 1.5, "type": "request", "command": "threads"}',
        b'{"seq": 1e400, "type": "request", "command": "threads"}',
        b'{"seq": 1, "type": "request", "command": ["threads"]}',
        b'{"seq": 1, "type": "request"}',
        b'{"seq": 1, "type": "event", "event": "stopped"}',
        b"{}",
    ],
)
def test_a_malformed_message_is_refused_and_the_session_continues(
    client: Client, body: bytes
) -> None:
    client.send(framed(body))
    message = client.hear()
    assert message is not None
    assert not message["success"]
    assert client.ask("threads") == {"threads": []}


@pytest.mark.parametrize("arguments", [[], "x", 3, False])
@pytest.mark.parametrize("command", ["setBreakpoints", "cancel", "launch"])
def test_arguments_must_be_an_object(client: Client, command: str, arguments: object) -> None:
    body = {"seq": 900, "type": "request", "command": command, "arguments": arguments}
    client.send(framed(json.dumps(body).encode()))
    assert not client.answer(900)["success"]


def test_responses_are_ignored(client: Client) -> None:
    client.send(framed(b'{"seq": 1, "type": "response", "request_seq": 3, "success": true}'))
    assert client.ask("threads") == {"threads": []}


def test_unknown_requests_are_refused(client: Client) -> None:
    assert client.refused("modules\ud800") == "unknown request 'modules\ud800'"


AWKWARD = [None, True, -1, 0, 2**70, 1.5, "", "\0\ud800", "x" * 10_000, [], {}, [[]], [{}]]
NAMES = [
    "accessType", "breakpoints", "column", "condition", "context", "count", "data", "dataId",
    "expression", "filter", "filterOptions", "filters", "frameId", "granularity",
    "instructionCount", "levels", "line", "linesStartAt1", "memoryReference", "name", "offset",
    "path", "pathFormat", "program", "requestId", "source", "sourceReference", "start",
    "startFrame", "targetId", "text", "threadId", "value", "variablesReference", "world",
]  # fmt: skip


@pytest.mark.parametrize("command", sorted(set(HANDLERS) - {"disconnect", "terminate", "restart"}))
@pytest.mark.parametrize("launched", [False, True])
def test_values_of_wrong_types_are_refused(client: Client, command: str, launched: bool) -> None:
    if launched:
        client.launch(source_file(LOOP, "loop.c"), stopOnEntry=True)
        client.begin()
    for value in AWKWARD:
        inner = dict.fromkeys(NAMES, value)
        whole = [
            inner,
            {**inner, "source": inner, "breakpoints": [inner], "filterOptions": [inner]},
        ]
        if value in (-1, []):
            whole += [{name: value} for name in NAMES]
        for arguments in whole:
            answer = client.answer(client.post(command, **arguments))
            assert "internal error" not in json.dumps(answer), (arguments, answer)
    client.ask("threads")


def test_too_many_pending_requests_are_refused(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "stay.c"
    path.write_text(
        "void stay(void)\n{\n    for (;;)\n        ;\n}\nint main(void)\n{\n    stay();\n}\n"
    )
    client.launch(path, stopOnEntry=True)
    client.begin()
    client.ask("next", threadId=1)
    seqs = [client.post("threads") for _ in range(MAX + 10)]
    assert "already pending" in client.answer(seqs[-1])["message"]
    client.hang_up()


def test_the_number_of_handles_is_limited(
    client: Client, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(session, "MAX_HANDLES", 100)
    path = tmp_path / "big.c"
    path.write_text("struct { int x; } big[200];\nint main(void) { return big[1].x; }\n")
    client.launch(path, stopOnEntry=True)
    client.begin()
    big = next(each for each in client.scope("Globals") if each["name"] == "big")
    number = big["variablesReference"]
    assert len(client.parts(number, start=150, count=10**9)) == 50
    assert "too many variables" in client.refused("variables", variablesReference=number)


@pytest.mark.parametrize("seed", range(3))
def test_random_requests_get_one_response_each(client: Client, seed: int) -> None:
    path = source_file(LOOP.replace("i < 3", "i < 3000"), "loop.c")
    client.launch(path, stopOnEntry=True)
    client.begin()
    chance = random.Random(seed)
    seqs: list[int] = []
    for _ in range(300):
        command, arguments = plausible(chance, path)
        seqs.append(client.post(command, **arguments))
        if chance.random() < 0.3:
            client.answer(seqs.pop(chance.randrange(len(seqs))))
    for seq in seqs:
        answer = client.answer(seq)
        assert "internal error" not in json.dumps(answer), answer
    client.ask("disconnect")
    assert client.hear() is None


def plausible(chance: random.Random, path: Path) -> tuple[str, dict[str, object]]:
    """Return a request as a client could make it."""
    number = chance.randint(1, 60)
    lines = [{"line": chance.randint(1, 20)} for _ in range(chance.randint(0, 2))]
    names = [{"name": chance.choice(["twice", "main", "other"])}]
    expression = chance.choice(
        ["i", "row", "total = 3", "twice(i)", "1 +", "next", "rs", "info world"]
    )
    context = chance.choice(["repl", "watch", "hover"])
    choices: list[tuple[str, dict[str, object]]] = [
        *[(move, {"threadId": 1}) for move in ("next", "stepIn", "stepBack", "stepOut", "pause")],
        ("continue", {"threadId": 1}),
        ("reverseContinue", {"threadId": 1}),
        ("pause", {"threadId": 1}),
        ("setBreakpoints", {"source": {"path": str(path)}, "breakpoints": lines}),
        ("setFunctionBreakpoints", {"breakpoints": names}),
        ("stackTrace", {"threadId": 1}),
        ("scopes", {"frameId": number}),
        ("variables", {"variablesReference": number}),
        ("evaluate", {"expression": expression, "context": context}),
        ("stepInTargets", {"frameId": number}),
        ("stepIn", {"threadId": 1, "targetId": number}),
        ("gotoTargets", {"source": {"path": str(path)}, "line": 15}),
        ("goto", {"threadId": 1, "targetId": number}),
        ("threads", {}),
        ("cancel", {"requestId": number}),
        ("restart", {}),
    ]
    return chance.choice(choices)
