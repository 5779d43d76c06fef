"""Loss, bursts and corruption, compared with their distributions."""

import numpy as np
import pytest

from crs_cc.core.keyed_random import KeyedUniform
from crs_cc.sim.comms.loss import burst_states
from crs_cc.sim.comms.message_log import Fate
from tests.sim.messages.radio import talking

COUNT = 200
CROWD = "".join(f'<robot x="{n % 5}m" y="{n // 5}m"/>' for n in range(21))
"""A sender, and twenty that hear it."""


def lost(channel: str) -> np.ndarray:
    """Return which of 200 broadcasts each receiver lost, shape (receivers, messages)."""
    talk = talking(CROWD, channel)
    talk.many(COUNT, to=-1)
    losses = talk.fates(Fate.LOSS)
    flags = np.zeros((20, COUNT), dtype=bool)
    flags[losses["receiver"] - 1, losses["number"]] = True
    return flags


def test_loss_rate_matches_the_channel_and_losses_are_independent():
    """4,000 messages, loss 0.2: standard error of the rate 0.0063; of a correlation 0.016."""
    flags = lost('loss="0.2"')
    assert flags.mean() == pytest.approx(0.2, abs=0.02)
    assert abs(np.corrcoef(flags[:, 1:].ravel(), flags[:, :-1].ravel())[0, 1]) < 0.05
    assert abs(np.corrcoef(flags[1:].ravel(), flags[:-1].ravel())[0, 1]) < 0.05


def test_bursts_follow_the_gilbert_elliott_model():
    """With p = 0.05 and r = 0.25: bursts of 4 messages, a rate of 1/6; about 167 bursts."""
    flags = lost('burst-begin="0.05" burst-end="0.25"')
    begins = flags[:, 1:] & ~flags[:, :-1]
    bursts = begins.sum() + flags[:, 0].sum()
    assert flags.sum() / bursts == pytest.approx(4.0, abs=0.8)
    assert flags.mean() == pytest.approx(1 / 6, abs=0.04)


def test_loss_rates_inside_and_outside_of_bursts_combine():
    """1/2 of the messages in bursts with loss 0.6, else loss 0.1: 0.35 in all."""
    flags = lost('loss="0.1" burst-begin="0.2" burst-end="0.2" burst-loss="0.6"')
    assert flags.mean() == pytest.approx(0.35, abs=0.04)


@pytest.mark.parametrize(("begin", "end"), [(0.1, 0.2), (0.7, 0.8), (1.0, 1.0), (0.0, 0.5)])
def test_burst_chain_in_one_step_matches_single_steps(begin, end):
    rng = np.random.default_rng(3)
    chain, chance = np.sort(rng.integers(0, 7, 300)), rng.random(300)
    bad = rng.random(7) < 0.5
    one_by_one, state = [], bad.copy()
    for number, value in zip(chain, chance, strict=True):
        state[number] = value < (1.0 - end if state[number] else begin)
        one_by_one.append(state[number])
    found = burst_states(bad, chain, chance, np.full(300, begin), np.full(300, end))
    assert found.tolist() == one_by_one
    assert bad.tolist() == state.tolist()


def test_bursts_are_independent_per_receiver():
    """Rate 1/2, bursts of 5 messages: joint losses of receivers are those of independence."""
    flags = lost('burst-begin="0.2" burst-end="0.2"')
    assert flags.mean() == pytest.approx(0.5, abs=0.05)
    together = np.corrcoef(flags)[np.triu_indices(20, 1)]
    assert abs(together.mean()) < 0.05


def test_corruption_rate_matches_the_channel():
    """50 messages of 200 bytes, corruption 0.02: 200 bytes of 10,000, deviation 14."""
    talk = talking(channel='corruption="0.02"')
    changed, wholes = [], 0
    for _ in range(50):
        talk.send(0, 1, size=200)
        talk.run()
        message, _ = talk.receive(1, at_s=talk.environment.time_s)
        wrong = message["data"][:200] != np.arange(200)
        changed += np.flatnonzero(wrong).tolist()
        wholes += not wrong.any()
    talk.run()
    assert len(changed) == pytest.approx(200, abs=45)
    assert np.mean(changed) == pytest.approx(100, abs=15)
    assert len(talk.fates(Fate.DELIVERED)) == wholes
    assert len(talk.fates(Fate.CORRUPTED)) == 50 - wholes


def test_corruption_is_independent_per_receiver():
    elements = '<robot x="0" y="0"/><robot x="1m" y="0"/><robot x="0" y="1m"/>'
    talk = talking(elements, 'corruption="0.01"')
    for _ in range(100):
        talk.send(0, size=50)
        talk.run()
        assert talk.kinds(1) == talk.kinds(2) == [0]
    talk.run()
    hurt = talk.fates(Fate.CORRUPTED)
    numbers = [set(hurt["number"][hurt["receiver"] == robot].tolist()) for robot in (1, 2)]
    assert all(25 < len(each) < 55 for each in numbers)  # 1 - 0.99**50 = 0.395
    assert numbers[0] != numbers[1]


def test_fate_of_a_message_depends_on_no_other_message():
    """Robot b receives the same from a whether c sends or not, for several seeds."""
    elements = '<robot x="0" y="0"/><robot x="1m" y="0"/><robot x="0" y="1m"/>'

    def heard(others: bool, seed: int) -> list[int]:
        talk = talking(elements, 'loss="0.3" jitter="40ms"', seed=seed)
        for _ in range(20):
            if others:
                talk.send(2, 1, kind=99)
            talk.send(0, 1, kind=talk.environment.state.cycle)
            talk.run()
        talk.run()
        return [kind for kind in talk.kinds(1) if kind != 99]

    assert heard(False, 1) == heard(True, 1)
    assert heard(False, 1) != heard(False, 2)


def test_keyed_random_numbers_are_uniform_and_reproducible():
    """10,000 numbers: the mean has a standard error of 0.003."""
    chances = KeyedUniform(5, 1)
    numbers = chances.draw(np.repeat(np.arange(100), 100), np.tile(np.arange(100), 100))
    assert len(np.unique(numbers)) == 10_000
    assert numbers.mean() == pytest.approx(0.5, abs=0.01)
    assert numbers.std() == pytest.approx(12**-0.5, abs=0.005)
    assert np.histogram(numbers, 10, (0, 1))[0] == pytest.approx(1000, abs=120)
    table = numbers.reshape(100, 100)
    assert abs(np.corrcoef(table[:-1].ravel(), table[1:].ravel())[0, 1]) < 0.04
    assert abs(np.corrcoef(table[:, :-1].ravel(), table[:, 1:].ravel())[0, 1]) < 0.04
