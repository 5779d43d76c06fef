"""Hosts of the same user on the same machine leave TCP, and nobody else does."""

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

from crs_cc.net import local_way
from crs_cc.net.access import Access
from crs_cc.net.channel import Channel, ConnectionLostError, Kind, Pulse, Way
from crs_cc.net.gate import Gate, bound
from crs_cc.net.handshake import Hello, Program, devices_digest
from crs_cc.net.roster import Roster
from crs_cc.net.visit import visit
from crs_cc.sim.files.world_xml import parse_world
from tests.net.faulty_wire import FaultyWire

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux has such sockets")

TEXT = b'<world version="1"><area length="2m" width="2m"/><robot id="left" x="1m" y="1m"/></world>'
WORLD = parse_world(TEXT, "hall.xml")
PROGRAM = Program("a.c", "a", sources=("/a.c",), files={"/a.c": ""})
NOBODY = 65534


def meet(address: tuple[str, int], gate: Gate, roster: Roster, access: Access) -> bool:
    """Have a host come by an address; return whether both sides have left TCP.

    Messages go both ways in any case.
    """
    hello = Hello(access.token("robot"), "one", (), PROGRAM.digest, devices=devices_digest())
    try:
        with Pulse() as pulse:
            found = visit(address, hello, PROGRAM.content(), pulse)
            while roster.missing():
                roster.wait()
            channel = roster.take(roster.begin()[0], lambda: False)
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
        gate.close()


def opened(*, only_tcp: bool = False, host: str = "127.0.0.1") -> tuple[Gate, Roster, Access]:
    roster, access = Roster(WORLD.robots), Access.made()
    return Gate(bound(host, 0), access, roster, only_tcp=only_tcp), roster, access


def test_a_host_on_this_machine_leaves_tcp() -> None:
    made = opened()
    assert meet(("127.0.0.1", made[0].port), *made)


@pytest.mark.skipif(not socket.has_dualstack_ipv6(), reason="no IPv6")
def test_it_does_so_where_one_side_has_ipv6_addresses() -> None:
    made = opened(host="::")
    assert meet(("127.0.0.1", made[0].port), *made)


def test_it_stays_if_the_environment_says_so() -> None:
    made = opened(only_tcp=True)
    assert not meet(("127.0.0.1", made[0].port), *made)


@pytest.fixture
def proxy() -> Iterator[socket.socket]:
    with socket.create_server(("127.0.0.1", 0)) as made:
        yield made


def test_it_stays_behind_a_proxy(proxy: socket.socket) -> None:
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


def test_it_stays_if_the_socket_is_of_another_user(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(local_way.os, "geteuid", lambda: NOBODY)
    made = opened()
    assert not meet(("127.0.0.1", made[0].port), *made)


def test_it_stays_if_the_socket_cannot_be_reached(monkeypatch: pytest.MonkeyPatch) -> None:
    take = local_way.take
    monkeypatch.setattr("crs_cc.net.visit.take", lambda name: take(name[::-1] + "x"))
    made = opened()
    assert not meet(("127.0.0.1", made[0].port), *made)


def test_a_connection_that_is_gone_has_no_ends(proxy: socket.socket) -> None:
    connection = socket.create_connection(proxy.getsockname())
    assert local_way.ends(connection)
    near, _ = proxy.accept()
    near.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    near.close()  # resets it
    with pytest.raises(ConnectionResetError):
        connection.recv(1)
    assert local_way.ends(connection) == ""
    connection.close()


def test_other_users_do_not_take_what_is_offered(monkeypatch: pytest.MonkeyPatch) -> None:
    owners = [False, True, True]
    with local_way.Offer() as offer:
        strange, own = (socket.socket(socket.AF_UNIX) for _ in range(2))
        thread = threading.Thread(target=lambda: taken.append(offer.taken()))
        taken: list[Way] = []
        strange.connect("\0crs-" + offer.name)
        monkeypatch.setattr(local_way, "_is_own", lambda _connection: owners.pop(0))
        thread.start()
        assert strange.recv(1) == b""
        own.connect("\0crs-" + offer.name)
        with socket.socket(socket.AF_UNIX) as back:
            back.connect("\0crs-" + offer.name)
            thread.join()
            own.sendall(b"own")
            assert taken[0].into.recv(3) == b"own"
            taken[0].out.sendall(b"back")
            assert back.recv(4) == b"back"
    for each in (strange, own, *taken):
        each.close()


def test_who_says_that_it_has_come_and_has_not_is_lost(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(local_way, "GREETING_S", 0.05)
    with local_way.Offer() as offer, pytest.raises(ConnectionLostError, match="did not connect"):
        offer.taken()


def test_who_comes_by_half_a_way_is_lost(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(local_way, "GREETING_S", 0.05)
    with local_way.Offer() as offer, socket.socket(socket.AF_UNIX) as half:
        half.connect("\0crs-" + offer.name)
        with pytest.raises(ConnectionLostError, match="did not connect"):
            offer.taken()
        assert half.recv(1) == b""


def test_who_waits_for_an_answer_is_not_woken_when_its_question_is_read() -> None:
    with local_way.Offer() as offer:
        one = local_way.take(offer.name)
        assert one
        other = offer.taken()
    asker, answerer, count = Channel(one.out), Channel(other.into), 50
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
        ways = Way(back, there), Way(here, forth)
        done = threading.Event()

        def chatter(channel: Channel, done: threading.Event = done) -> None:
            while not done.is_set():
                channel.send(Kind.ALIVE)
                done.wait(0.0002)

        def answer(other: Channel = other, way: Way = ways[1]) -> None:
            other.receive(Kind.MOVED)
            other.move(way, is_told=True)
            other.receive(Kind.GRANT)
            other.send(Kind.RAN, b"answer")

        threads = [threading.Thread(target=chatter, args=(each,)) for each in (one, other)]
        threads.append(threading.Thread(target=answer))
        for thread in threads:
            thread.start()
        one.move(ways[0], is_told=False)
        one.send(Kind.GRANT, b"question")
        assert one.receive(Kind.RAN).content == b"answer"
        done.set()
        for thread in threads:
            thread.join()
        one.close()
        other.close()
