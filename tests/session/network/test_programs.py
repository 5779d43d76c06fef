"""Servers and clients as programs of robots do what they do on Linux."""

from __future__ import annotations

import socket
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from tests import gcc
from tests.session.network.network_runs import HERE, NetworkRun, served_clients

FACTS = HERE / "facts.txt"

needs_gcc = pytest.mark.skipif(bool(gcc.why_not()), reason=gcc.why_not())


def test_one_program_sees_of_sockets_what_is_written_down(
    check_golden: Callable[[Path, bytes], None],
) -> None:
    (written,) = NetworkRun(["facts.c"], timestep="10ms").finish()
    check_golden(FACTS, written.encode())


@needs_gcc
def test_what_is_written_down_of_sockets_is_what_linux_does(tmp_path: Path) -> None:
    program = tmp_path / "facts"
    assert not gcc.complaint([HERE / "facts.c"], program, ["-w"])
    assert gcc.run(program, 20.0) == gcc.Result(FACTS.read_bytes(), "exit 0")


@needs_gcc
def test_a_server_and_its_client_write_the_same_as_two_processes(tmp_path: Path) -> None:
    for name in ("server", "client"):
        assert not gcc.complaint([HERE / f"{name}.c"], tmp_path / name, ["-w"])
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = str(free.getsockname()[1])
    command = [tmp_path / "server", port, "1"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server:
        assert server.stdout is not None
        said = server.stdout.readline()
        client = [tmp_path / "client", "127.0.0.1", port, "2"]
        done = subprocess.run(client, check=True, capture_output=True, text=True, timeout=20.0)
        said += server.communicate(timeout=20.0)[0]
    assert served_clients(rounds=2).finish() == [said, done.stdout]


def test_a_server_serves_several_clients() -> None:
    said, *replies = served_clients(clients=3).finish()
    assert said == "ready\nserved\n"
    assert set(replies) == {
        "hello\n46\nunknown: dance\na longer line, which goes in pieces\n"
    }  # fmt: skip


def test_a_broadcast_finds_the_others_and_latency_is_that_of_the_world() -> None:
    commands = ["ping.c"], ["ping.c"], ["ping.c", "answer"]
    near, far = "", '<communication network-latency="180ms"/>'
    for communication, both_ways_s in ((near, 0.1), (far, 0.4)):
        *_, found = NetworkRun(*commands, communication=communication).finish()
        refused, *answers = found.splitlines()
        assert refused == "-1"
        assert answers == [
            f"answer robot2 {both_ways_s / 2:.2f}",  # a broadcast reaches its sender, too
            f"answer robot0 {both_ways_s:.2f}",
            f"answer robot1 {both_ways_s:.2f}",
        ]
