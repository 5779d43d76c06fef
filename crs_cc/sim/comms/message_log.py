"""The log of messages: a record of each message's fate, counts, and their texts.

>>> monitor = Monitor(("radio",), ("a", "b"))
>>> monitor.count(record([(0.5, Fate.SENT), (0.5, Fate.LOSS)], sender=0, receiver=1))
>>> monitor.total(Fate.LOSS), monitor.total(Fate.LOSS, sender=1)
(1, 0)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from enum import IntEnum
from typing import Final, Protocol, Self

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import FloatArray, IndexArray, Records
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.events import Event
from crs_cc.sim.state.messages import EVERYBODY, FATES, NO_GROUP, TRAFFIC, MessageState


class Fate(IntEnum):
    """The fate of a message: `SENT` first, then one of the others for each receiver."""

    SENT = 0
    DELIVERED = 1
    CORRUPTED = 2
    RANGE = 3
    BLOCKED = 4
    LOSS = 5
    QUEUE = 6
    SHUT = 7
    INBOX = 8
    ABSENT = 9


assert len(Fate) == FATES

MEANINGS: Final = {
    Fate.SENT: "sent",
    Fate.DELIVERED: "delivered",
    Fate.CORRUPTED: "delivered with corrupted bytes",
    Fate.RANGE: "lost: out of range",
    Fate.BLOCKED: "lost: path blocked",
    Fate.LOSS: "lost in transit",
    Fate.QUEUE: "lost: sender's queue full",
    Fate.SHUT: "lost: link outage",
    Fate.INBOX: "lost: receiver's inbox full",
    Fate.ABSENT: "lost: sender or receiver not in the world",
}
"""The text of each fate, as users see it."""


def record(
    happened: Sequence[tuple[float, Fate]], *, sender: int, receiver: int, channel: int = 0
) -> Records:
    """Return a hand-made record, for tests and examples."""
    table = np.zeros(len(happened), TRAFFIC)
    table["time_s"], table["fate"] = zip(*happened, strict=True)
    table["channel"], table["sender"], table["receiver"] = channel, sender, receiver
    table["group"] = NO_GROUP
    return table


def note(
    messages: MessageState,
    fate: Fate | npt.NDArray[np.int8],
    packets: Records,
    time_s: FloatArray,
    receivers: npt.NDArray[np.integer] | None = None,
    *,
    which: IndexArray | None = None,
) -> None:
    """Record the fate of messages.

    Args:
        messages: changed in place.
        fate: their fate, one for all or one for each.
        packets: the messages, k of them.
        time_s: the time of each, (k,).
        receivers: the receiving robots, (k,); by default the messages' addressees.
        which: rows among `packets`, (k,), if there are other ones, or in another order.
    """
    if not len(time_s):
        return
    table, keys = np.zeros(len(packets), TRAFFIC), packets["channel"].astype(np.intp) * FATES
    for name in ("channel", "sender", "group", "type", "size", "number"):
        table[name] = packets[name]
    table["receiver"] = packets["to"]
    if which is not None:
        table, keys = table.take(which), keys.take(which)
    table["time_s"], table["fate"] = time_s, fate
    if receivers is not None:
        table["receiver"] = receivers
    before = messages.traffic
    messages.traffic = np.concatenate([before, table]) if len(before) else table
    counts = messages.counts
    counts += np.bincount(keys + fate, minlength=counts.size).reshape(counts.shape)


def take(messages: MessageState) -> Records:
    """Return the records of a cycle, sorted by time, and clear them."""
    traffic = messages.traffic
    if not len(traffic):
        return traffic
    messages.traffic = np.zeros(0, TRAFFIC)
    return traffic.take(np.argsort(traffic["time_s"], kind="stable"))


def events(traffic: Records, channels: Sequence[str], robots: Sequence[str]) -> Iterator[Event]:
    """Return the records as events."""
    for row in traffic.tolist():
        time_s, fate, channel, sender, receiver, group, kind, size, number = row
        if receiver != EVERYBODY:
            to = robots[receiver]
        else:
            to = "all" if group == NO_GROUP else f"group {group}"
        text = (
            f"{channels[channel]} message {number} from {robots[sender]} to {to}, "
            f"type {kind}, {size} byte{'s' * (size != 1)}: {MEANINGS[Fate(fate)]}"
        )
        yield Event(time_s, "message", text, sender if fate == Fate.SENT else receiver)


class HasTraffic(Protocol):
    """The messages of a completed timestep."""

    @property
    def traffic(self) -> Records:
        """Return its records of messages, of dtype `TRAFFIC`."""


class Monitor:
    """A counter of messages' fates over timesteps.

    Pass its `step` to a session as its trace, or call it with each `Step`.
    """

    def __init__(self, channels: Sequence[str], robots: Sequence[str]) -> None:
        """Create a counter with all counts 0."""
        self.channels = tuple(channels)
        self.robots = tuple(robots)
        self._counts: dict[tuple[int, int, int, int], int] = {}

    @classmethod
    def of(cls, world: WorldModel) -> Self:
        """Return a counter for a world."""
        channels = [channel.name for channel in world.communication.channels]
        return cls(channels, [robot.id for robot in world.robots])

    def step(self, step: HasTraffic) -> None:
        """Count the records of a completed timestep."""
        self.count(step.traffic)

    def count(self, traffic: Records) -> None:
        """Count records, of dtype `TRAFFIC`."""
        keys = np.column_stack(
            [traffic[name].astype(np.int64) for name in ("channel", "sender", "receiver", "fate")]
        )
        rows, counts = np.unique(keys, axis=0, return_counts=True)
        for row, count in zip(map(tuple, rows.tolist()), counts.tolist(), strict=True):
            self._counts[row] = self._counts.get(row, 0) + count

    def total(
        self,
        fate: Fate,
        *,
        channel: int | None = None,
        sender: int | None = None,
        receiver: int | None = None,
    ) -> int:
        """Return the count of a fate, optionally only of a channel, a sender or a receiver.

        A broadcast counts as sent to receiver -1.
        """
        wanted = (channel, sender, receiver, int(fate))
        return sum(
            count
            for key, count in self._counts.items()
            if all(want is None or want == have for want, have in zip(wanted, key, strict=True))
        )

    def pairs(self) -> dict[tuple[int, int, int], dict[Fate, int]]:
        """Return the counts by channel, sender and receiver, in ascending order."""
        found: dict[tuple[int, int, int], dict[Fate, int]] = {}
        for (channel, sender, receiver, fate), count in sorted(self._counts.items()):
            found.setdefault((channel, sender, receiver), {})[Fate(fate)] = count
        return found
