"""Only hosts of the same user on the same machine switch from TCP to a local socket."""

from __future__ import annotations

import random
import resource
import socket
import struct
import sys
import threading
import time
from collections.abc import Iterator

import pytest

from crs_cc.net import local_socket
from crs_cc.net.access import Access
from crs_cc.net.channel import Channel, ConnectionLostError, KeepAlive, Kind, SocketPair
from crs_cc.net.environment_connection import connect
from crs_cc.net.handshake import Hello, Program, devices_digest
from crs_cc.net.host_registry import HostRegistry
from crs_cc.net.listener import Listener, bound_socket
from crs_cc.sim.files.world_xml import parse_world
from tests.net.faulty_wire import FaultyWire

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux has such sockets")

TEXT = b'<world version="1"><area length="2m" width="2m"/><robot id="left" x="1m" y="1m"/></world>'
WORLD = parse_world(TEXT, "hall.xml")
PROGRAM = Program("a.c", "a", sources=("/a.c",), files={"/a.c": ""})
NOBODY = 65534


def meet(
    address: tuple[str, int], listener: Listener, registry: HostRegistry, access: Access
) -> bool:
    """Connect a host to an address; return whether both sides have left TCP.

    Messages go both ways in any case.
    """
    hello = Hello(access.token("robot"), "one", (), PROGRAM.digest, devices=devices_digest())
    try:
        with KeepAlive() as keep_alive:
            found = connect(address, hello, PROGRAM.content(), keep_alive)
            while registry.missing():
                registry.wait()
            channel = registry.wait_for_channel(registry.begin()[0], lambda: False)
            assert channel
            for size in (0, 3_000, 500_000):
                content = random.Random(size).randbytes(size)
                thread = threading.Thread(target=channel.send, args=(Kind.RESTORE, content))
                thread.start()
                assert found.channel.receive(Kind.RESTORE).content == content
                thread.join()
                found.channel.send(Kind.RAN, content[:3_000])
                assert channel.receive(Kind.RAN).content == content[:3_000]
            assert found.channel.is_local == channel.is_local
            found.channel.close()
            with pytest.raises(ConnectionLostError, match="closed"):
                channel.receive(Kind.RAN)
            channel.close()
            return found.channel.is_local
    finally:
        listener.close()


def opened(
    *, only_tcp: bool = False, host: str = "127.0.0.1"
) -> tuple[Listener, HostRegistry, Access]:
    registry, access = HostRegistry(WORLD.robots), Access.made()
    return Listener(bound_socket(host, 0), access, registry, only_tcp=only_tcp), registry, access


def test_a_host_on_this_machine_switches_to_a_local_socket() -> None:
    made = opened()
    assert meet(("127.0.0.1", made[0].port), *made)


@pytest.mark.skipif(not socket.has_dualstack_ipv6(), reason="no IPv6")
def test_it_switches_if_one_side_has_ipv6_addresses() -> None:
    made = opened(host="::")
    assert meet(("127.0.0.1", made[0].port), *made)


def test_it_stays_on_tcp_if_the_environment_requires_it() -> None:
    made = opened(only_tcp=True)
    assert not meet(("127.0.0.1", made[0].port), *made)


@pytest.fixture
def proxy() -> Iterator[socket.socket]:
    with socket.create_server(("127.0.0.1", 0)) as made:
        yield made


def test_it_stays_on_tcp_behind_a_proxy(proxy: socket.socket) -> None:
    made = opened()
    far: list[socket.socket] = []

    def carry() -> None:
        near, _ = proxy.accept()
        far.append(socket.create_connection(("127.0.0.1", made[0].port)))
        FaultyWire(random.Random(1), 0.0).between(near, far[0])

    thread = threading.Thread(target=carry)
    thread.start()
    assert not meet(proxy.getsockname(), *made)
    thread.join()


def test_it_stays_on_tcp_if_the_socket_belongs_to_another_user(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(local_socket.os, "geteuid", lambda: NOBODY)
    made = opened()
    assert not meet(("127.0.0.1", made[0].port), *made)


def test_it_stays_on_tcp_if_the_socket_cannot_be_reached(monkeypatch: pytest.MonkeyPatch) -> None:
    original = local_socket.connect_local
    monkeypatch.setattr(
        "crs_cc.net.environment_connection.connect_local", lambda name: original(name[::-1] + "x")
    )
    made = opened()
    assert not meet(("127.0.0.1", made[0].port), *made)


def test_a_closed_connection_has_no_endpoints(proxy: socket.socket) -> None:
    connection = socket.create_connection(proxy.getsockname())
    assert local_socket.endpoints(connection)
    near, _ = proxy.accept()
    near.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    near.close()  # resets it
    with pytest.raises(ConnectionResetError):
        connection.recv(1)
    assert local_socket.endpoints(connection) == ""
    connection.close()


def test_connections_of_other_users_are_not_accepted(monkeypatch: pytest.MonkeyPatch) -> None:
    owners = [False, True, True]
    with local_socket.LocalListener() as offer:
        strange, own = (socket.socket(socket.AF_UNIX) for _ in range(2))
        thread = threading.Thread(target=lambda: taken.append(offer.accept()))
        taken: list[SocketPair] = []
        strange.connect("\0crs-" + offer.name)
        monkeypatch.setattr(local_socket, "_is_own", lambda _connection: owners.pop(0))
        thread.start()
        assert strange.recv(1) == b""
        own.connect("\0crs-" + offer.name)
        with socket.socket(socket.AF_UNIX) as back:
            back.connect("\0crs-" + offer.name)
            thread.join()
            own.sendall(b"own")
            assert taken[0].receiver.recv(3) == b"own"
            taken[0].sender.sendall(b"back")
            assert back.recv(4) == b"back"
    for each in (strange, own, *taken):
        each.close()


def test_a_host_that_announces_a_connection_it_has_not_made_is_lost(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(local_socket, "HANDSHAKE_TIMEOUT_S", 0.05)
    with (
        local_socket.LocalListener() as offer,
        pytest.raises(ConnectionLostError, match="did not connect"),
    ):
        offer.accept()


def test_a_host_that_connects_only_one_direction_is_lost(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(local_socket, "HANDSHAKE_TIMEOUT_S", 0.05)
    with local_socket.LocalListener() as offer, socket.socket(socket.AF_UNIX) as half:
        half.connect("\0crs-" + offer.name)
        with pytest.raises(ConnectionLostError, match="did not connect"):
            offer.accept()
        assert half.recv(1) == b""


def test_a_waiting_process_is_not_woken_when_its_message_is_read() -> None:
    with local_socket.LocalListener() as offer:
        one = local_socket.connect_local(offer.name)
        assert one
        other = offer.accept()
    asker, answerer, count = Channel(one.sender), Channel(other.receiver), 50
    for channel, way in ((asker, one), (answerer, other)):
        channel._connection, channel._sender = way
    switches: list[int] = []

    def ask() -> None:
        begin = resource.getrusage(resource.RUSAGE_THREAD).ru_nvcsw
        for _ in range(count):
            asker.send(Kind.RAN, b"question")
            asker.receive(Kind.GRANT)
        switches.append(resource.getrusage(resource.RUSAGE_THREAD).ru_nvcsw - begin)

    thread = threading.Thread(target=ask)
    thread.start()
    for _ in range(count):
        time.sleep(0.001)  # until it waits
        answerer.receive(Kind.RAN)
        time.sleep(0.001)  # until it has been woken, if it is
        answerer.send(Kind.GRANT)
    thread.join()
    one.close()
    other.close()
    assert switches[0] < 1.6 * count


def test_nothing_is_lost_while_other_threads_send() -> None:
    for _ in range(20):
        one, other = map(Channel, socket.socketpair())
        (there, here), (back, forth) = socket.socketpair(), socket.socketpair()
        ways = SocketPair(back, there), SocketPair(here, forth)
        done = threading.Event()

        def chatter(channel: Channel, done: threading.Event = done) -> None:
            while not done.is_set():
                channel.send(Kind.KEEP_ALIVE)
                done.wait(0.0002)

        def answer(other: Channel = other, way: SocketPair = ways[1]) -> None:
            other.receive(Kind.SWITCHED)
            other.switch_to(way, is_announced=True)
            other.receive(Kind.GRANT)
            other.send(Kind.RAN, b"answer")

        threads = [threading.Thread(target=chatter, args=(each,)) for each in (one, other)]
        threads.append(threading.Thread(target=answer))
        for thread in threads:
            thread.start()
        one.switch_to(ways[0], is_announced=False)
        one.send(Kind.GRANT, b"question")
        assert one.receive(Kind.RAN).content == b"answer"
        done.set()
        for thread in threads:
            thread.join()
        one.close()
        other.close()
