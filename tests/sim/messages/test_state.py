"""A snapshot holds all messages, wherever they are."""

import numpy as np
import pytest

from crs_cc.sim.messages.traffic import Fate
from tests.sim.messages.radio import talking

SIX = "".join(f'<robot x="{n % 3}m" y="{n // 3}m"/>' for n in range(6))
BAD = (
    'bandwidth="400B/s" queue="3" delay="60ms" jitter="150ms" loss="0.1" burst-begin="0.1" '
    'burst-end="0.3" corruption="0.01" range="1.5m" drop="oldest"'
)


def play(talk, cycles: range) -> list:
    """Lets robots talk and listen by chance; gives all that they hear and what happens."""
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
def test_from_a_snapshot_in_the_middle_of_transmissions_everything_happens_again(cycles):
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
    assert fates == set(Fate) - {Fate.BLOCKED, Fate.SHUT, Fate.INBOX}


def test_every_message_comes_to_one_end():
    """Each that was sent to one robot is delivered, or lost for one reason."""
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


def test_nothing_is_left_of_messages_that_were_taken():
    talk = talking()
    for _ in range(10):
        talk.send(0, 1, size=100)
        talk.run()
        talk.receive(1, at_s=talk.environment.time_s)
    talk.run()
    assert len(talk.state.packets) == len(talk.state.receptions) == len(talk.state.outbox) == 0
