"""Samples on two and four hosts over a faulty wire end in the state of a run in one process."""

from __future__ import annotations

import random
from collections.abc import Sequence
from typing import Final

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import parse_world
from tests.net.faulty_wire import FaultyWire
from tests.net.local_hosts import LocalHosts
from tests.net.lossy_runs import HALL, SAMPLES

NAMES: Final = ("wander", "follow_wall")
MAX_TIME_S: Final = 2.0


def state_of(executables: Sequence[Executable], fleet: Fleet | None) -> str:
    """Return the hash of the state of a run after some time."""
    world = parse_world(HALL.encode(), "hall.xml")
    session = Session(world, executables, fleet=fleet)
    while session.time_s < MAX_TIME_S and session.advance(20):
        pass
    return session.state_hash()


@pytest.mark.parametrize("name", NAMES)
def test_a_sample_ends_in_the_same_state_when_hosts_are_lost(name: str) -> None:
    executables = [build_executable([SAMPLES / f"{name}.c"], Diagnostics())] * 4
    expected = state_of(executables, None)
    for count in (2, 4):
        hosts = LocalHosts(executables, count, FaultyWire(random.Random(count), often=0.01))
        assert state_of(executables, hosts.fleet) == expected
        hosts.close()
        assert hosts.lost
