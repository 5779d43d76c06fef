"""Range, walls, delay, jitter, bandwidth and queues, compared with values worked out by hand."""

import numpy as np
import pytest

from crs_cc.sim.comms.message_log import Fate
from tests.sim.driver import Driver, open_world
from tests.sim.messages.radio import DT, talking

# -- range and walls -------------------------------------------------------------------------------


@pytest.mark.parametrize(("distance", "hears"), [("3.999m", True), ("4.001m", False)])
def test_range_limits_delivery(distance, hears):
    talk = talking(f'<robot x="0" y="0"/><robot x="{distance}" y="0"/>', 'range="4m"')
    talk.send(0, 1)
    talk.run(2)
    assert bool(talk.kinds(1)) == hears
    assert len(talk.fates(Fate.RANGE)) == (not hears)


WALL = '<wall x1="1m" y1="-1m" x2="1m" y2="1m"/>'
BOX = '<box x="1m" y="0" length="40cm" width="40cm" heading="30deg" mass="2kg"/>'
ROUND = '<cylinder x="1m" y="0" radius="20cm"/>'
AWAY = '<wall x1="1m" y1="0.1m" x2="1m" y2="2m"/>'


@pytest.mark.parametrize(
    ("elements", "fate"),
    [(WALL, Fate.BLOCKED), (BOX, Fate.BLOCKED), (ROUND, Fate.BLOCKED), (AWAY, Fate.DELIVERED)],
)
def test_channel_that_needs_line_of_sight_is_blocked_by_one_object(elements, fate):
    """The wall that does not block ends 5 cm from the line, as it has a thickness of 10 cm.

    a . | . b
    """
    talk = talking(f'<robot x="0" y="0"/><robot x="2m" y="-5mm"/>{elements}', 'walls="0"')
    talk.send(0, 1)
    talk.run(2)
    assert len(talk.fates(fate)) == 1


@pytest.mark.parametrize(("walls", "hears"), [(0, True), (1, True), (2, True), (3, False)])
def test_each_object_between_reduces_the_range(walls, hears):
    """Range 10 m, factor 0.5, distance 2 m: two walls leave 2.5 m, three 1.25 m."""
    elements = "".join(
        f'<wall x1="{x}cm" y1="-1m" x2="{x}cm" y2="1m" thickness="2cm"/>'
        for x in range(50, 50 + 30 * walls, 30)
    )
    talk = talking(
        f'<robot x="0" y="0"/><robot x="2m" y="0"/>{elements}', 'range="10m" walls="0.5"'
    )
    talk.send(0, 1)
    talk.run(2)
    assert bool(talk.kinds(1)) == hears


def test_robots_do_not_attenuate():
    elements = '<robot x="0" y="0"/><robot x="2m" y="0"/><robot x="1m" y="0"/>'
    talk = talking(elements, 'walls="0"')
    talk.send(0, 1)
    talk.run(2)
    assert talk.kinds(1) == [0]


def test_box_that_was_pushed_away_no_longer_blocks():
    """A robot pushes a box sideways out of the line between two others."""
    elements = """<robot x="0" y="0"/><robot x="2m" y="0"/><robot x="1m" y="-0.5m" heading="90deg"/>
        <box x="1m" y="0" length="40cm" width="40cm" mass="2kg"/>
        <communication><channel name="radio" walls="0"/></communication>"""
    driver = Driver.of(open_world(elements))
    driver.ask("PR", 300, 300, robot=2)
    fates = []
    for _ in range(2):
        driver.post("SEND", 1, -1, 0, 0, robot=0)
        steps = driver.run_s(3.0)
        fates += [row["fate"] for step in steps for row in step.traffic]
    assert driver.environment.state.bodies.position_m[3, 1] > 0.3
    assert fates == [Fate.SENT, Fate.BLOCKED, Fate.SENT, Fate.DELIVERED]


# -- time ------------------------------------------------------------------------------------------


def test_message_arrives_after_transmission_and_delay():
    """28 bytes and a header of 12 at 400 B/s take 0.1 s, the delay 0.23 s: sent at 0.01, 0.34."""
    talk = talking(channel='bandwidth="400B/s" delay="230ms"')
    talk.send(0, 1, at_s=0.01, size=28)
    talk.run(6)
    message, goes_on_s = talk.receive(1, at_s=0.30, wait_ms=1000)
    assert goes_on_s == pytest.approx(0.34)
    assert message["f"][:2] == pytest.approx([0.01, 0.34])
    talk.run(1)
    assert talk.fates(Fate.DELIVERED)["time_s"] == pytest.approx([0.34])


def test_arrival_is_never_before_the_end_of_the_cycle_of_sending():
    talk = talking()
    talk.send(0, 1, at_s=0.001)
    assert not talk.receive(1, at_s=0.049)[0]["result"]
    talk.run()
    message, _ = talk.receive(1, at_s=DT)
    assert message["f"][1] == DT


def test_pending_receive_ends_at_the_arrival():
    talk = talking(channel='delay="120ms"')
    assert talk.receive(1, at_s=0.0, wait_ms=-1)[1] == np.inf
    talk.send(0, 1, kind=9, at_s=0.0)
    talk.run(2)
    assert [list(step.robots) for step in talk.steps] == [[], [1]]
    assert talk.steps[1].at_s == pytest.approx([0.12])
    assert talk.steps[1].messages["i"][0, 3] == 9


def test_receive_times_out():
    talk = talking()
    message, goes_on_s = talk.receive(1, at_s=0.01, wait_ms=20)
    assert (message["result"], goes_on_s) == (0, pytest.approx(0.03))
    talk.receive(0, at_s=0.02, wait_ms=100)
    talk.run(2)
    assert talk.steps[1].at_s == pytest.approx([0.12])
    assert talk.steps[1].messages["result"] == [0]


def test_wheels_keep_turning_during_a_receive():
    """10 in/s, 50 in/s2: after 2 s, 19 in."""
    driver = Driver.of(open_world())
    driver.ask("AC", 500, 500)
    driver.ask("VM", 100, 100)
    driver.post("RECEIVE", -1)
    driver.run_s(2.0)
    assert driver.state.x_m[0] == pytest.approx(19 * 0.0254)


def test_jitter_is_uniform_and_independent_per_receiver():
    """1,000 messages to two robots: mean 0.2 + 0.05, deviation 0.1 / sqrt(12)."""
    elements = '<robot x="0" y="0"/><robot x="1m" y="0"/><robot x="0" y="1m"/>'
    talk = talking(elements, 'delay="200ms" jitter="100ms"')
    talk.state.receptions["status"] = 2
    took_s = []
    for _ in range(20):
        sent_s = talk.environment.time_s
        for _ in range(50):
            talk.send(0)
        talk.run()
        coming = talk.state.receptions
        arrives_s = coming["arrives_s"][np.lexsort([coming["packet"], coming["receiver"]])]
        took_s.append(arrives_s.reshape(2, -1) - sent_s)
        talk.state.receptions["status"] = 2
        talk.run()
    took = np.concatenate(took_s, axis=1)
    assert took.shape == (2, 1000)
    assert 0.2 <= took.min() < 0.202
    assert 0.298 < took.max() < 0.3
    assert took.mean(axis=1) == pytest.approx([0.25, 0.25], abs=0.004)
    assert took.std(axis=1) == pytest.approx([0.1 / 12**0.5] * 2, rel=0.05)
    assert abs(np.corrcoef(took)[0, 1]) < 0.1


# -- bandwidth -------------------------------------------------------------------------------------


def test_messages_of_one_sender_are_transmitted_in_sequence():
    """40 bytes each with the header, at 1000 B/s: 0.04 s each, so they arrive 0.04 s apart.

    The third begins at 0.10, with a cycle: it cannot arrive before its end, at 0.15.
    """
    talk = talking(channel='bandwidth="1kB/s"')
    for kind in range(5):
        talk.send(0, 1, kind=kind, at_s=0.02, size=28)
    talk.run(8)
    assert talk.fates(Fate.DELIVERED)["time_s"] == pytest.approx([0.06, 0.1, 0.15, 0.18, 0.22])
    assert talk.kinds(1) == [0, 1, 2, 3, 4]


def test_bandwidth_is_per_sender_and_channel():
    elements = '<robot x="0" y="0"/><robot x="1m" y="0"/><robot x="0" y="1m"/>'
    talk = talking(elements, 'bandwidth="1kB/s"')
    for sender in (0, 2):
        talk.send(sender, 1, size=88)
    talk.channel = 2
    talk.send(0, 1, size=88)
    talk.run(4)
    assert talk.fates(Fate.DELIVERED)["time_s"] == pytest.approx([0.05, 0.1, 0.1])


@pytest.mark.parametrize(("drop", "left"), [("newest", [0, 1, 2]), ("oldest", [0, 3, 4])])
def test_full_queue_drops_the_oldest_or_the_newest(drop, left):
    """Message 0 is in transmission, two more wait, and two exceed the queue."""
    talk = talking(channel=f'bandwidth="100B/s" queue="2" drop="{drop}"')
    taken = [talk.send(0, 1, kind=kind, at_s=0.01 * kind) for kind in range(5)]
    assert taken == ([True] * 3 + [False] * 2 if drop == "newest" else [True] * 5)
    talk.run(20)
    assert talk.kinds(1) == left
    lost = talk.fates(Fate.QUEUE)
    assert lost["type"].tolist() == [kind for kind in range(5) if kind not in left]
    assert lost["time_s"] == pytest.approx([0.03, 0.04])


def test_queue_frees_a_slot_when_a_transmission_begins():
    """12 bytes at 100 B/s are sent in 0.12 s: the one that waits begins then, not before."""
    talk = talking(channel='bandwidth="100B/s" queue="1"')
    taken = [talk.send(0, 1, at_s=at_s) for at_s in (0.0, 0.01)]
    talk.run(2)
    taken += [talk.send(0, 1, at_s=at_s) for at_s in (0.11, 0.121, 0.13)]
    assert taken == [True, True, False, True, False]


def test_robot_sends_at_most_64_messages_in_a_cycle():
    talk = talking()
    assert [talk.send(0, 1) for _ in range(70)] == [True] * 64 + [False] * 6


# -- inboxes ---------------------------------------------------------------------------------------


def test_message_for_a_full_inbox_is_lost():
    talk = talking()
    for kind in range(100):
        talk.send(0, 1, kind=kind)
        if kind == 59:
            talk.run()
    talk.run(2)
    assert talk.fates(Fate.INBOX)["type"].tolist() == list(range(64, 100))
    assert talk.kinds(1) == list(range(64))


def test_robot_has_at_most_256_pending_messages():
    talk = talking(channel='delay="10s"')
    for _ in range(6):
        for _ in range(50):
            talk.send(0, 1)
        talk.run()
    assert len(talk.state.receptions) == 256
    assert len(talk.fates(Fate.INBOX)) == 44


def test_broadcast_to_full_inboxes_is_recorded_once():
    """12 robots flood each other, which once made a record and a line of sight for every pair.

    The first 256 of the 600 messages fill the inboxes of those that sent none of these; after that
    one record stands for all full inboxes. There were 600 * 11 - 12 * 256 = 3,528 records.
    """
    talk = talking("".join(f'<robot x="{2 * x}m" y="0"/>' for x in range(12)), 'delay="10s"')
    for _ in range(50):
        for robot in range(12):
            talk.send(robot)
    talk.run()
    assert len(talk.state.receptions) == 12 * 256
    lost = talk.fates(Fate.INBOX)
    assert len(lost[lost["receiver"] == -1]) == 600 - 256
    assert len(lost) < 1600
    assert len(talk.fates(Fate.RANGE)) == 0


def test_full_inboxes_do_not_hide_a_receiver_out_of_range():
    """Robot 3 is 1 km away from the others, whose inboxes are full."""
    elements = "".join(f'<robot x="{x}m" y="0"/>' for x in (0, 2, 4, 900))
    talk = talking(elements, 'delay="10s" range="10m"')
    for _ in range(6):
        for sender in range(3):
            for _ in range(50):
                talk.send(sender)
        talk.run()
    before = len(talk.fates(Fate.RANGE))
    talk.send(3)
    talk.send(0)
    talk.run()
    assert len(talk.fates(Fate.RANGE)) == before + 1
    assert talk.fates(Fate.INBOX)[-1]["receiver"] == -1


# -- who hears what --------------------------------------------------------------------------------


def test_messages_are_ordered_by_arrival_then_sending_then_sender():
    elements = '<robot x="0" y="0"/><robot x="1m" y="0"/><robot x="0" y="1m"/>'
    talk = talking(elements)
    talk.send(2, 1, kind=0, at_s=0.02)
    talk.send(0, 1, kind=1, at_s=0.02)
    talk.send(0, 1, kind=2, at_s=0.03)
    talk.send(2, 1, kind=3, at_s=0.021)
    talk.run()
    assert talk.kinds(1) == [1, 0, 3, 2]


def test_broadcast_without_receivers_is_lost_once():
    talk = talking(channel='range="1m"')
    talk.send(0)
    talk.run()
    assert talk.fates(Fate.RANGE)["receiver"].tolist() == [-1]
