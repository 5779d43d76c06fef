"""A session gives the same results when its programs run on hosts, and when hosts are lost."""

from __future__ import annotations

import math
import os
import random
import socket
import sys
import weakref
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from crs_cc.core.gc_pause import gc_paused
from crs_cc.core.source import Diagnostics
from crs_cc.net import hosted_programs
from crs_cc.net.changed_words import KnownRows
from crs_cc.net.channel import Channel, ConnectionLostError, KeepAlive, Kind
from crs_cc.net.frames import RAN
from crs_cc.net.host_link import HostGoneError, HostLink
from crs_cc.net.remote_fleet import RemoteFleet
from crs_cc.net.shared_rows import SharedRows
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.turns import RECORD
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.model.world import WorldModel
from tests.net.faulty_wire import FaultyWire
from tests.net.local_hosts import LocalHosts
from tests.session.programs import build

TALK = r"""
#include <stdio.h>
#include <stdlib.h>
#include <sys/time.h>
#include "Nclient.h"

int main(void)
{
    int turn, sum = 0;
    char text[80];
    struct timeval now;
    FILE *file = fopen("log", "w");
    connect_robot(1);
    for (turn = 0; turn < 12; turn++) {
        int i;
        for (i = 0; i <= turn * 3; i++)
            gettimeofday(&now, 0);
        for (i = 0; i < 2000 * (turn + State[STATE_SONAR_0] % 7); i++)
            sum = sum * 31 + i;
        gs();
        sprintf(text, "%d %ld %d %d", turn, now.tv_usec, sum, (int)State[STATE_SONAR_0]);
        puts(text);
        fprintf(file, "%s\n", text);
        vm(50 + 10 * turn, 100 - 30 * turn, 0);
        if (turn % 4 == 3)
            ws(1, 1, 0, 1);
    }
    if (State[STATE_SONAR_0] % 2)
        return ((int *)malloc(4))[1];
    return turn;
}
"""
COUNT = 5
MAX_TIME_S = 8.0

TRAPS = r"""
#include <stdio.h>
#include "Nclient.h"

int main(void)
{
    int place;
    connect_robot(1);
    gs();
    place = (int)State[STATE_SONAR_0] % 2 ? 0x7f000000 : (int)&place;
    printf("%d\n", *(volatile int *)place);
    vm(50, 0, 0);
    gs();
    return 3;
}
"""

Written = list[tuple[int, int, bytes]]


def world() -> WorldModel:
    rows = "".join(
        f'<robot id="robot{n}" x="{n + 1}m" y="{1 + n % 2}m" heading="{n * 50}deg"/>'
        for n in range(COUNT)
    )
    text = f'<world version="1"><area length="7m" width="5m"/>{rows}</world>'
    return parse_world(text.encode(), "world.xml")


def finished(executables: Sequence[Executable], **options: Any) -> tuple[Session, Written]:
    """Return a finished session and the output of its programs."""
    written: Written = []
    session = Session(
        world(), executables, output=lambda *each: written.append(each), seed=3, **options
    )
    while session.time_s < MAX_TIME_S and session.advance(40):
        pass
    return session, written


@pytest.fixture(scope="module")
def programs(tmp_path_factory: pytest.TempPathFactory) -> list[Executable]:
    return [build(tmp_path_factory.mktemp("talk"), TALK)] * COUNT


@pytest.fixture(scope="module")
def local(programs: list[Executable]) -> tuple[str, Written]:
    session, written = finished(programs)
    assert {each.outcome for each in session.result().robots} == {"exited", "failed"}
    return session.state_hash(), written


@pytest.mark.parametrize(("count", "threads"), [(1, 1), (2, 1), (COUNT, 1), (1, 2), (2, 3)])
def test_a_run_on_hosts_is_the_same(
    programs: list[Executable],
    local: tuple[str, Written],
    monkeypatch: pytest.MonkeyPatch,
    count: int,
    threads: int,
) -> None:
    monkeypatch.setattr(LocalHosts, "threads", threads)
    shown: Written = []
    hosts = LocalHosts(programs, count, write=lambda *each: shown.append(each))
    session, written = finished(programs, fleet=hosts.fleet)
    assert (session.state_hash(), written) == local
    texts = [each.error.text for each in session.result().robots if each.error]
    assert texts
    assert all("out of bounds" in text for text in texts)
    hosts.close()
    assert sorted(shown) == sorted(written)
    assert len(hosts.ended) == count
    assert not hosts.lost


def test_programs_that_compute_for_long_are_moved_to_several_threads(
    programs: list[Executable], local: tuple[str, Written], monkeypatch: pytest.MonkeyPatch
) -> None:
    counts: list[int] = []

    class Counted(Fleet):
        def __init__(self, executables: Any, driver: Any, threads: int) -> None:
            counts.append(threads)
            super().__init__(executables, driver, threads)

    monkeypatch.setattr(hosted_programs, "Fleet", Counted)
    monkeypatch.setattr(hosted_programs, "default_threads", lambda _: 2)
    monkeypatch.setattr(hosted_programs, "SPREAD_S", 1e-5)
    hosts = LocalHosts(programs, 1)
    session, written = finished(programs, fleet=hosts.fleet)
    assert (session.state_hash(), written) == local
    hosts.close()
    assert counts == [1, 2]


def test_a_closed_fleet_that_nobody_uses_is_freed_at_once(programs: list[Executable]) -> None:
    hosts = LocalHosts(programs, 2)
    known = weakref.ref(hosts.fleet)
    hosts.close()
    with gc_paused():
        del hosts
        assert known() is None


@pytest.mark.parametrize("threads", [1, 2])
def test_a_program_that_traps_stops_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, threads: int
) -> None:
    source = tmp_path / "traps.c"
    source.write_text(TRAPS)
    unchecked = [build_executable([source], Diagnostics(), checked=False)] * COUNT
    session, written = finished(unchecked)
    outcomes = [each.outcome for each in session.result().robots]
    assert {"failed", "exited"} == set(outcomes)
    monkeypatch.setattr(LocalHosts, "threads", threads)
    hosts = LocalHosts(unchecked, 2)
    distant, also_written = finished(unchecked, fleet=hosts.fleet)
    assert (distant.state_hash(), also_written) == (session.state_hash(), written)
    assert [each.outcome for each in distant.result().robots] == outcomes
    hosts.close()
    assert not hosts.lost


@pytest.mark.parametrize("seed", range(5))
def test_lost_hosts_are_replaced_to_the_same_bits(
    programs: list[Executable], local: tuple[str, Written], seed: int
) -> None:
    shown: Written = []
    wire = FaultyWire(random.Random(seed), often=0.02)
    hosts = LocalHosts(programs, 2, wire, lambda *each: shown.append(each))
    session, written = finished(programs, fleet=hosts.fleet)
    assert (session.state_hash(), written) == local
    hosts.close()
    assert len(hosts.lost) >= 3
    assert set(shown) <= set(written)
    assert len(shown) == len(set(shown)), "nothing is shown twice"


def test_programs_continue_from_memories_that_were_fetched(
    programs: list[Executable], local: tuple[str, Written], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("crs_cc.net.host_link.MAX_LOG_GRANTS", 7)
    hosts = LocalHosts(programs, 2, FaultyWire(random.Random(9), often=0.02))
    session, written = finished(programs, fleet=hosts.fleet)
    assert (session.state_hash(), written) == local
    hosts.close()
    assert len(hosts.lost) >= 3


def test_only_the_programs_of_a_permanently_lost_host_stop(programs: list[Executable]) -> None:
    hosts = LocalHosts(programs, COUNT, FaultyWire(random.Random(1), often=0.004), losses=0)
    session, _ = finished(programs, fleet=hosts.fleet)
    hosts.close()
    kinds = [each.error.kind if each.error else "" for each in session.result().robots]
    assert len(hosts.lost) == kinds.count("host lost") > 0
    assert any(each.outcome == "exited" for each in session.result().robots)


@pytest.mark.parametrize(
    ("field", "value"),
    [
        *(("clock_s", -1.0), ("clock_s", math.inf), ("clock_s", math.nan), ("clock_s", 0.5)),
        *(("fuel", 3), ("fuel", -1), ("pending", 1), ("alive", False), ("asks", 2)),
        *(("due_s", 1.0), ("speed_hz", 1.0), ("status", 3), ("status", -1), ("error_kind", 999)),
    ],
)
def test_a_host_can_change_only_its_own_programs(
    programs: list[Executable], field: str, value: float
) -> None:
    here, there = socket.socketpair()
    with here, there:
        link = HostLink(("robot0",), np.arange(1), Channel(here), refuse)
        fleet = RemoteFleet(programs[:1], [link])
        table = fleet.table()
        timing = fleet.timing
        timing["clock_s"], timing["fuel"], timing["alive"] = 1.0, 7, True
        timing["due_s"] = math.inf
        known, said = KnownRows(1), table.copy()
        known.set(table)
        part = "timing" if field in RECORD["timing"].names else "slot"
        said.view(RECORD)[:, 0][part][field] = value
        Channel(there).send(Kind.RAN, RAN.pack(1, 1) + known.pack(said))
        before = fleet.timing.copy()
        fleet.run_rounds(2.0)
        assert "not its own, or a clock goes back" in fleet.report(0).text
        before["asks"] = 1  # as its host is lost
        assert (fleet.timing == before).all()


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux keeps threads on a processor")
@pytest.mark.parametrize(("is_local", "processors"), [(True, 1), (True, 2), (False, 1)])
def test_the_thread_stays_on_its_processor_if_hosts_use_all_processors(
    programs: list[Executable], monkeypatch: pytest.MonkeyPatch, *, is_local: bool, processors: int
) -> None:
    usable, seen = os.sched_getaffinity(0), []
    monkeypatch.setattr("crs_cc.net.remote_fleet.available_cores", lambda: processors)
    monkeypatch.setattr(HostLink, "is_local", is_local)
    receive = Channel.receive_frame

    def noting(channel: Channel, kind: Kind, buffer: memoryview) -> int:
        if kind is Kind.RAN:
            seen.append(os.sched_getaffinity(0))
        return receive(channel, kind, buffer)

    monkeypatch.setattr(Channel, "receive_frame", noting)
    hosts = LocalHosts(programs, 1)
    finished(programs, fleet=hosts.fleet)
    hosts.close()
    assert seen
    kept = is_local and processors <= 1
    assert {len(each) for each in seen} == {1 if kept else len(usable)}
    assert os.sched_getaffinity(0) == usable


@pytest.mark.parametrize("content", [b"", bytes(11), RAN.pack(1, 1) + bytes(7), RAN.pack(2, 1)])
def test_an_incomplete_reply_or_one_to_a_different_grant_replaces_the_host(
    programs: list[Executable], content: bytes
) -> None:
    here, there = socket.socketpair()
    with here, there:
        link = HostLink(("robot0",), np.arange(1), Channel(here), refuse)
        fleet = RemoteFleet(programs[:1], [link])
        fleet.timing["alive"], fleet.timing["due_s"] = True, math.inf
        other = Channel(there)
        other.send(Kind.RAN, content)
        with KeepAlive() as keep_alive:
            keep_alive.add(other)  # it seems to be there
            fleet.run_rounds(2.0)
        assert "invalid answer" in fleet.report(0).text


def test_a_grant_is_not_sent_twice_to_the_host_that_replaces_a_lost_one() -> None:
    lost, here = socket.socketpair(), socket.socketpair()
    link = HostLink(("robot0",), np.arange(1), Channel(lost[0]), lambda *_: Channel(here[0]))
    for each in lost:
        each.close()
    rows = SharedRows(1)
    link.attach(rows)
    timing = rows.table.view(RECORD)["timing"]
    timing["alive"], timing["due_s"] = True, math.inf
    assert rows.grant(2.0, is_new=True) == [0]
    link.grant()
    link.close()
    other = Channel(here[1])
    received = [other.receive(Kind.RESTORE, Kind.GRANT).kind for _ in range(2)]
    assert received == [Kind.RESTORE, Kind.GRANT]
    with pytest.raises(ConnectionLostError, match="closed"):
        other.receive(Kind.GRANT)
    other.close()


def refuse(_link: HostLink, reason: str) -> Channel:
    raise HostGoneError(reason)
