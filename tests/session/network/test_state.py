"""The network is a part of a run's state, and bounded."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from crs_cc.requests import CODES, MESSAGE
from crs_cc.session.host import HostRequest
from crs_cc.session.network.network import Network
from crs_cc.session.network.service import NETWORK_CODES, NetworkService
from crs_cc.session.network.sockets import BUFFER, MAX_SOCKETS
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import empty_world
from tests.session.network.network_runs import NetworkRun, served_clients

SLOW = '<communication network-latency="700ms"/>'
MIDDLE = 80
"""A timestep in which commands and replies are on their way."""


def test_a_run_goes_on_from_a_snapshot_in_the_middle_of_a_connection(tmp_path: Path) -> None:
    whole, first, second = (served_clients(rounds=2, communication=SLOW) for _ in range(3))
    said = whole.finish()
    for _ in range(MIDDLE):
        first.session.step()
    assert first.session.network.network.state.segments
    first.session.save(tmp_path / "snapshot")
    snapshot = first.session.snapshot()
    middle = first.session.state_hash()
    assert first.finish() == said
    end = whole.session.state_hash()
    assert first.session.state_hash() == end
    first.session.restore(snapshot)  # and back
    assert first.session.state_hash() == middle
    first.finish()
    assert first.session.state_hash() == end
    loaded = second.session.load(
        tmp_path / "snapshot",
        second.session.environment.world,
        [second.session.fleet.executable(robot) for robot in range(2)],
        arguments=[["server.c", "7000", "1"], ["client.c", "robot0", "7000", "2"]],
    )
    while loaded.advance(1000):
        pass
    assert loaded.state_hash() == end


def test_the_timesteps_run_at_once_change_nothing() -> None:
    runs = [served_clients(clients=2, communication=SLOW) for _ in range(2)]
    said = [run.finish(at_once=at_once) for run, at_once in zip(runs, (1, 1000), strict=True)]
    assert said[0] == said[1]
    assert runs[0].session.result() == runs[1].session.result()


def test_a_program_that_uses_no_socket_has_no_network() -> None:
    run = NetworkRun(["idle.c"])
    run.finish()
    assert run.session.snapshot().network is None
    assert run.session.network.hashed() == b""


def test_what_is_open_when_a_program_ends_is_closed_and_others_hear_of_it() -> None:
    run = NetworkRun(["server.c", "7000", "1"], ["leaves.c", "robot0"])
    assert run.finish()[0] == "ready\nserved\n"
    assert not run.session.network.network.state.sockets


def answer(service: NetworkService, code: int, message: np.void, clock_s: float = 0.0) -> int:
    service.serve(code, HostRequest(0, message, clock_s))
    return int(message["result"])


def test_no_request_can_break_the_network_or_fill_it() -> None:
    environment = Environment(empty_world(), seed=0)
    service = NetworkService(environment)
    rng = np.random.default_rng(1)
    codes = sorted(NETWORK_CODES)
    alive, clock_s = np.ones(1, np.bool_), np.zeros(1)
    for turn in range(6000):
        message = np.zeros(1, MESSAGE)[0]
        message["i"] = rng.choice([-1, 0, 1, 2, 3, 5, 7, 70_000, 2**31 - 1], 8)
        message["i"][1] = rng.choice([0, 1, 2, -1, 0x7F000001, 0x0A000001, 0x0A000002])
        message["f"] = rng.choice([-1.0, 0.0, 1e300, np.inf, np.nan], 4)
        message["size"] = rng.choice([-1, 0, 1, 100, 248, 9999])
        message["data"] = rng.integers(0, 256, 248)
        code = codes[int(rng.integers(len(codes)))]
        answer(service, code, message, environment.time_s)
        if turn % 20 == 0:
            environment.step()
            service.begin_cycle(clock_s, alive)
    network = service.network
    assert len(network.state.sockets) > 5
    assert_bounded(network)


def assert_bounded(network: Network) -> None:
    own = [socket for key, socket in network.state.sockets.items() if key[0] == 0]
    assert len(own) - sum(len(each.waiting) for each in own) <= MAX_SOCKETS
    for socket in own:
        assert len(socket.received) <= BUFFER
        assert 0 <= socket.unread <= BUFFER + 20_000
        assert sum(len(content) for _, content in socket.datagrams) <= BUFFER


def test_an_unread_sender_fills_only_one_buffer() -> None:
    service = NetworkService(Environment(empty_world(), seed=0))
    message = np.zeros(1, MESSAGE)[0]
    message["i"][0] = 1  # SOCK_STREAM
    first = answer(service, CODES["SOCKET_PAIR"], message)
    sent = 0
    while True:
        message["i"][0], message["size"] = first, 248
        count = answer(service, CODES["SOCKET_SEND"], message)
        if count < 0:
            break
        sent += count
    assert (count, sent) == (-11, BUFFER)
