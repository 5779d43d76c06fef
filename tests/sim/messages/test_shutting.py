"""Outages of channels, senders and pairs: from the world file, and set at run time."""

from dataclasses import replace

import pytest

from crs_cc.sim.comms.message_log import Fate, Monitor, events
from crs_cc.sim.model.world import Pose
from tests.sim.messages.radio import PAIR, talking

THREE = f'{PAIR}<robot id="c" x="0" y="2m"/>'


@pytest.mark.parametrize(
    ("shut", "heard"),
    [
        ('channel="test"', []),
        ('channel="radio"', [(0, 1), (0, 2), (1, 0), (1, 2)]),
        ('from="a"', [(1, 0), (1, 2)]),
        ('to="b"', [(0, 2), (1, 0), (1, 2)]),
        ('from="a" to="b"', [(0, 2), (1, 0), (1, 2)]),
        ('channel="test" from="b" to="c"', [(0, 1), (0, 2), (1, 0)]),
    ],
)
def test_outage_applies_to_messages_that_match_all_attributes(shut, heard):
    talk = talking(THREE, shuts=f"<shut {shut}/>")
    talk.send(0)
    talk.send(1)
    talk.run(2)
    delivered = talk.fates(Fate.DELIVERED)
    pairs = zip(delivered["sender"].tolist(), delivered["receiver"].tolist(), strict=True)
    assert sorted(pairs) == heard
    assert len(talk.fates(Fate.SHUT)) == 4 - len(heard)


def test_outage_has_a_start_and_an_end():
    talk = talking(shuts='<shut from="a" at="0.12s" until="0.3s"/>')
    times_s = [0.11, 0.12, 0.2, 0.299, 0.3]
    for kind, at_s in enumerate(times_s):
        while talk.environment.end_s <= at_s:
            talk.run()
        talk.send(0, 1, kind=kind, at_s=at_s)
    talk.run(2)
    assert talk.kinds(1) == [0, 4]
    said = [event for step in talk.steps for event in step.events]
    assert [(event.time_s, event.text) for event in said] == [
        (0.12, "all channels from a blocked"),
        (0.3, "all channels from a unblocked"),
    ]


def test_start_of_transmission_decides_about_an_outage():
    """The first takes until 0.12 s; the second waits that long, and then falls into the outage."""
    talk = talking(channel='bandwidth="100B/s"', shuts='<shut at="0.1s"/>')
    talk.send(0, 1, kind=1)
    talk.send(0, 1, kind=2)
    talk.run(6)
    assert talk.kinds(1) == [1]


def test_outage_can_be_set_and_cleared():
    talk = talking()
    control = talk.environment.communication
    control.shut(channel="test")
    talk.send(0, 1, kind=1)
    talk.run()
    talk.environment.communication.open(channel="test")
    talk.send(0, 1, kind=2)
    talk.run(2)
    assert talk.kinds(1) == [2]
    assert [event.text for step in talk.steps for event in step.events] == [
        "test blocked",
        "test unblocked",
    ]
    assert talk.environment.communication.counts("test")[Fate.SHUT] == 1


def test_control_object_follows_a_restored_world():
    talk = talking()
    control = talk.environment.communication
    talk.run()
    control.shut(channel="test")
    snapshot = talk.environment.snapshot()
    (event,) = talk.environment.step().events
    assert (event.time_s, event.text) == (0.05, "test blocked")
    talk.environment.restore(snapshot)
    control.open(channel="test")
    control.shut(sender="a")
    (event,) = talk.environment.step().events
    assert event.text == "all channels from a blocked"
    talk.environment.add_robot(replace(talk.environment.world.robots[0], id="z", start=Pose(0, 3)))
    control.shut(receiver="z")
    assert [event.text for event in talk.environment.step().events][-1:] == [
        "all channels to z blocked"
    ]


def test_invalid_outages_are_rejected():
    control = talking().environment.communication
    with pytest.raises(ValueError, match=r"unknown channel 'telepathy' \(known: radio, inf"):
        control.shut(channel="telepathy")
    with pytest.raises(ValueError, match="unknown robot 'z'"):
        control.shut(receiver="z")
    with pytest.raises(ValueError, match="no such outage"):
        control.open(sender="a")


def test_monitor_counts_fates_and_events_describe_them():
    talk = talking(THREE, 'range="2.1m"', shuts='<shut from="a" to="c"/>')
    talk.send(0, kind=5, size=3)
    talk.send(1, 2)
    talk.run(2)
    monitor = Monitor.of(talk.environment.world)
    for step in talk.steps:
        monitor.step(step)
    assert monitor.pairs() == {
        (3, 0, -1): {Fate.SENT: 1},
        (3, 0, 1): {Fate.DELIVERED: 1},
        (3, 0, 2): {Fate.SHUT: 1},
        (3, 1, 2): {Fate.SENT: 1, Fate.RANGE: 1},
    }
    assert monitor.total(Fate.SENT, channel=3) == 2
    traffic = [
        event
        for step in talk.steps
        for event in events(step.traffic, monitor.channels, monitor.robots)
    ]
    assert [event.text for event in traffic] == [
        "test message 0 from a to all, type 5, 3 bytes: sent",
        "test message 0 from b to c, type 0, 0 bytes: sent",
        "test message 0 from a to c, type 5, 3 bytes: lost: link outage",
        "test message 0 from b to c, type 0, 0 bytes: lost: out of range",
        "test message 0 from a to b, type 5, 3 bytes: delivered",
    ]
    assert traffic[-1].robot == 1
