"""The table of all robots, in which each host knows and changes its own rows."""

from __future__ import annotations

import math

import numpy as np
import pytest

from crs_cc.core.errors import WorldError
from crs_cc.net.changed_words import KnownRows
from crs_cc.net.channel import HEAD_BYTES
from crs_cc.net.frames import GRANT, GRANT_FRONT, RAN
from crs_cc.net.host_registry import HostRegistry
from crs_cc.net.shared_rows import SharedRows
from crs_cc.net.word_kernel import ROWS
from crs_cc.runtime.turns import RECORD
from crs_cc.sim.files.world_xml import parse_world

END_S = 0.05


class Both:
    """The rows of the environment and of two hosts, all of whose programs can run."""

    def __init__(self) -> None:
        self.rows = SharedRows(4)
        self.parts = np.array([0, 3]), np.array([1, 2])
        self.numbers = [self.rows.add(part) for part in self.parts]
        self.there = [KnownRows(2), KnownRows(2)]
        self.said: dict[int, tuple[int, float, bool]] = {}  # in front of the last grant
        self.records = self.rows.table.reshape(-1).view(RECORD)
        self.records["timing"]["alive"], self.records["timing"]["due_s"] = True, math.inf

    def grant(self, *, is_new: bool = True) -> list[int]:
        """Grant a round; return the hosts that receive a grant."""
        granted = self.rows.grant(END_S, is_new=is_new)
        for host in granted:
            frame = self.rows.packed(host)
            self.said[host] = GRANT.unpack_from(frame, HEAD_BYTES)
            self.there[host].enter(frame[GRANT_FRONT:])
        return granted

    def answer(self, host: int, rounds: int, number: int | None = None, **fields: float) -> None:
        """Put an answer of a host that changes fields of its first program.

        Args:
            host: the host.
            rounds: the rounds.
            number: of the grant that it answers, the last one by default.
            fields: their new values.
        """
        table = self.there[host].table().copy()
        for name, value in fields.items():
            table.reshape(-1).view(RECORD)[:1]["timing"][name] = value
        front = RAN.pack(self.said[host][0] if number is None else number, rounds)
        self.rows.put(host, front + self.there[host].pack(table))


def test_a_later_request_is_applied_once_the_other_hosts_reach_its_round() -> None:
    both = Both()
    assert both.grant() == [0, 1]
    both.answer(0, 3, clock_s=0.03, asks=1)
    both.answer(1, 1, clock_s=0.01, asks=1)
    assert both.rows.take(0) == (1, True)
    assert both.records["timing"]["clock_s"].tolist() == [0.0, 0.01, 0.0, 0.0]
    both.records["timing"]["asks"] = 0  # it is answered
    assert both.grant(is_new=False) == [1]
    both.answer(1, 9, clock_s=END_S)
    assert both.rows.take(1) == (3, True)
    assert both.records["timing"]["clock_s"].tolist() == [0.03, END_S, 0.0, 0.0]
    assert both.records["timing"]["asks"].tolist() == [1, 0, 0, 0]


def test_an_invalid_answer_of_one_host_does_not_affect_the_other() -> None:
    both = Both()
    both.grant()
    both.answer(0, 1, clock_s=0.02, speed_hz=1.0)  # which is not its own
    both.answer(1, 1, clock_s=0.01)
    assert both.rows.take(0) is None
    assert "not its own" in both.rows.error(0)
    assert not both.rows.error(1)
    assert not both.records["timing"]["clock_s"].any()
    both.there[0].set(both.rows.known(0))
    both.answer(0, 1, clock_s=0.02)
    assert both.rows.take(0) == (1, True)
    assert both.records["timing"]["clock_s"].tolist() == [0.02, 0.01, 0.0, 0.0]


@pytest.mark.parametrize(
    ("fields", "runs"), [({"alive": False}, []), ({"clock_s": END_S}, []), ({"due_s": 0.01}, [])]
)
def test_idle_hosts_receive_no_grants(fields: dict[str, float], runs: list[int]) -> None:
    both = Both()
    for name, value in fields.items():
        both.records["timing"][name] = value
    assert both.grant() == runs
    assert both.rows.take(7) == (7, False)


def test_a_removed_host_receives_no_grants() -> None:
    both = Both()
    both.rows.remove(0)
    assert both.grant() == [1]


def test_grants_have_a_number_per_host_and_the_end_of_the_cycle() -> None:
    both = Both()
    for number in (1, 2, 3):
        assert both.grant() == [0, 1]
        assert both.said == dict.fromkeys([0, 1], (number, END_S, True))
        assert [both.rows.last_grant(host) for host in both.numbers] == [number, number]
        both.answer(0, 1)
        both.answer(1, 1)
        assert both.rows.take(0) == (1, True)


@pytest.mark.parametrize(
    ("number", "rounds"), [(0, 1), (1, 1), (3, 1), (2**63, 1), (2, 2**24 + 1), (2, 2**32 - 1)]
)
def test_an_answer_to_a_different_grant_or_with_too_many_rounds_is_rejected(
    number: int, rounds: int
) -> None:
    both = Both()
    for _ in range(2):
        both.grant()
        both.answer(1, 1)
    both.answer(0, rounds, number, clock_s=0.02)
    assert both.rows.take(0) is None
    assert "different grant" in both.rows.error(0)
    assert not both.rows.error(1)
    both.there[0].set(both.rows.known(0))
    both.answer(0, 2**24, clock_s=0.02)
    assert both.rows.take(0) == (2**24, True)
    assert both.records["timing"]["clock_s"].tolist() == [0.02, 0.0, 0.0, 0.0]


@pytest.mark.parametrize("size", [0, 11, RAN.size + 7, RAN.size + 8 * 2 * 57 + 8])
def test_answers_of_a_wrong_size_are_rejected(size: int) -> None:
    both = Both()
    both.grant()
    with pytest.raises(ValueError, match="changes"):
        both.rows.put(0, bytes(size))


def test_a_world_with_too_many_robots_is_rejected_before_any_host_connects() -> None:
    text = '<world version="1"><area length="2m" width="2m"/><robot id="r" x="1m" y="1m"/></world>'
    [robot] = parse_world(text.encode(), "one.xml").robots
    with pytest.raises(WorldError, match=f"{ROWS} at most can have programs on hosts"):
        HostRegistry([robot] * (ROWS + 1))
    with pytest.raises(ValueError, match="at most"):
        SharedRows(ROWS + 1)
