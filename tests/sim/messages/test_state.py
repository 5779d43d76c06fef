"""A snapshot contains all messages, in every stage."""

from dataclasses import replace

import numpy as np
import pytest

from crs_cc.sim.comms.message_log import Fate
from crs_cc.sim.model.world import Pose
from tests.sim.messages.radio import talking

SIX = "".join(f'<robot x="{n % 3}m" y="{n // 3}m"/>' for n in range(6))
BAD = (
    'bandwidth="400B/s" queue="1" delay="60ms" jitter="150ms" loss="0.1" burst-begin="0.1" '
    'burst-end="0.3" corruption="0.01" range="1.5m" drop="oldest"'
)


def play(talk, cycles: range) -> list:
    """Let robots send and receive at random; return all that they receive and all events."""
    seen = []
    for cycle in cycles:
        rng = np.random.default_rng(cycle)
        for robot in rng.permutation(6).tolist():
            at_s = talk.environment.time_s + rng.random() * 0.04
            if talk.environment.state.waits.code[robot]:
                continue
            if rng.random() < 0.6:
                to = int(rng.integers(-1, 6))
                talk.send(robot, to, kind=cycle, at_s=at_s, size=int(rng.integers(0, 60)))
            if rng.random() < 0.4:
                wait_ms = int(rng.choice([0, 30, 400]))
                message, goes_on_s = talk.receive(robot, at_s=at_s, wait_ms=wait_ms)
                seen += [message.tobytes(), goes_on_s]
        talk.run()
        step = talk.steps[-1]
        seen += [step.robots.tobytes(), step.at_s.tobytes(), step.messages.tobytes()]
        seen += [step.traffic.tobytes(), talk.environment.hash()]
    return seen


@pytest.mark.parametrize("cycles", [5, 12])
def test_snapshot_during_transmissions_replays(cycles):
    talk = talking(SIX, BAD)
    play(talk, range(cycles))
    assert len(talk.state.outbox)
    assert len(talk.state.receptions)
    snapshot = talk.environment.snapshot()
    first = play(talk, range(cycles, cycles + 12))
    talk.environment.restore(snapshot)
    assert play(talk, range(cycles, cycles + 12)) == first
    other = talking(SIX, BAD)
    other.environment.restore(snapshot)
    assert play(other, range(cycles, cycles + 12)) == first
    fates = {Fate(fate) for step in talk.steps for fate in step.traffic["fate"].tolist()}
    assert fates == set(Fate) - {Fate.BLOCKED, Fate.SHUT, Fate.INBOX, Fate.ABSENT}


def test_every_message_has_exactly_one_fate():
    """Each message to one robot is delivered, or lost for one reason."""
    talk = talking(SIX, BAD)
    play(talk, range(20))
    talk.run(200)
    records = np.concatenate([step.traffic for step in talk.steps])
    single = records[records["receiver"] >= 0]
    sent = single[single["fate"] == Fate.SENT]
    for row in sent:
        same = (single["sender"] == row["sender"]) & (single["number"] == row["number"])
        assert (same & (single["fate"] != Fate.SENT)).sum() == 1
    counts = talk.environment.communication.counts("test")
    assert {fate: (records["fate"] == fate).sum() for fate in Fate} == counts
    assert not len(talk.state.outbox)


def test_received_messages_leave_no_state():
    talk = talking()
    for _ in range(10):
        talk.send(0, 1, size=100)
        talk.run()
        talk.receive(1, at_s=talk.environment.time_s)
    talk.run()
    assert len(talk.state.packets) == len(talk.state.receptions) == len(talk.state.outbox) == 0


def test_robots_that_left_neither_send_nor_receive():
    """Robot 2 leaves with messages waiting, on their way, and in its inbox."""
    talk = talking(SIX, 'bandwidth="1kB/s" delay="150ms"')
    for kind in range(3):
        talk.send(2, 1, kind=kind, size=88)
        talk.send(0, 2, kind=kind)
    talk.run(2)
    talk.environment.remove_robot(2)
    talk.send(0, 2, kind=9)
    talk.send(0, kind=10)
    talk.run(8)
    lost = talk.fates(Fate.ABSENT)
    pairs = zip(lost["sender"].tolist(), lost["type"].tolist(), strict=True)
    assert sorted(pairs) == [(0, 0), (0, 1), (0, 2), (0, 9), (2, 1), (2, 2)]
    assert talk.kinds(1) == [0, 10]
    assert 2 not in talk.fates(Fate.DELIVERED)["receiver"]


def test_joining_robot_receives_later_messages_only():
    talk = talking(f'{SIX}<robot id="late" x="1m" y="5m" join="0.1s"/>')
    for kind in range(4):
        talk.send(0, kind=kind)
        talk.run()
    talk.run()
    assert talk.kinds(6) == [2, 3]


def test_adding_a_robot_does_not_affect_others_messages():
    def heard(more: bool) -> list:
        talk = talking(SIX, BAD)
        play(talk, range(6))
        if more:
            old = talk.environment.world.robots[0]
            talk.environment.add_robot(replace(old, id="more", start=Pose(50.0, 50.0)))
        play(talk, range(6, 12))
        records = np.concatenate([step.traffic for step in talk.steps])
        return records.tolist()

    assert heard(False) == heard(True)


def test_added_robot_can_send_immediately():
    talk = talking(SIX)
    old = talk.environment.world.robots[0]
    number = talk.environment.add_robot(replace(old, id="more", start=Pose(0.0, 5.0)))
    assert talk.send(number, 0, kind=3)
    assert talk.send(0, number, kind=4)
    talk.run()
    assert (talk.kinds(0), talk.kinds(number)) == ([3], [4])


def test_result_is_independent_of_the_order_of_programs():
    """Robots post at different times, but are served in one order or the other."""

    def heard(order: list[int]) -> list:
        talk = talking(SIX, BAD)
        for cycle in range(8):
            for robot in order:
                at_s = talk.environment.time_s + 0.007 * ((robot * 5 + cycle) % 6)
                talk.send(robot, kind=robot, at_s=at_s, size=10)
                talk.receive(robot, at_s=at_s)
            talk.run()
        records = np.concatenate([step.traffic for step in talk.steps])
        return sorted(records.tolist())

    assert heard([0, 1, 2, 3, 4, 5]) == heard([4, 2, 5, 0, 3, 1])


def test_inboxes_are_found_anew_after_a_snapshot_is_restored_within_a_cycle():
    """Where a robot's messages begin is remembered; it moved back with the restored table."""
    talk = talking()
    for kind in range(5):
        talk.send(0, 1, kind=kind)
    talk.run()
    assert talk.receive(1, at_s=talk.environment.time_s)[0]["i"][3] == 0
    snapshot = talk.environment.snapshot()
    assert talk.kinds(1) == [1, 2, 3, 4]
    talk.environment.restore(snapshot)
    assert talk.kinds(1) == [1, 2, 3, 4]
