"""What happens to messages: a record of each, counts, and how to say it.

>>> monitor = Monitor(("radio",), ("a", "b"))
>>> monitor.count(record([(0.5, Fate.SENT), (0.5, Fate.LOSS)], sender=0, receiver=1))
>>> monitor.total(Fate.LOSS), monitor.total(Fate.LOSS, sender=1)
(1, 0)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from enum import IntEnum
from typing import TYPE_CHECKING, Final, Protocol, Self

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import FloatArray, Records
from crs_cc.sim.state.events import Event
from crs_cc.sim.state.messages import EVERYBODY, FATES, NO_GROUP, TRAFFIC, MessageState

if TYPE_CHECKING:
    from crs_cc.sim.model.world import WorldModel


class Fate(IntEnum):
    """What can come of a message; `SENT` comes first, then one of the others for each receiver."""

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
    Fate.CORRUPTED: "delivered, with bytes that are not those that were sent",
    Fate.RANGE: "lost: out of range",
    Fate.BLOCKED: "lost: something is in the way",
    Fate.LOSS: "lost on the way",
    Fate.QUEUE: "lost: the sender's queue was full",
    Fate.SHUT: "lost: the way was shut",
    Fate.INBOX: "lost: the receiver's inbox was full",
    Fate.ABSENT: "lost: its sender or its receiver was not in the world",
}
"""What each fate means, for people."""


def record(
    happened: Sequence[tuple[float, Fate]], *, sender: int, receiver: int, channel: int = 0
) -> Records:
    """Return a record made by hand, for tests and examples."""
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
) -> None:
    """Record what happened to messages.

    Args:
        messages: changed in place.
        fate: what it was, one for all or one for each.
        packets: the messages, k of them.
        time_s: when it was, (k,).
        receivers: at which robots, (k,); by default those for whom the messages are.
    """
    if not len(packets):
        return
    table = np.zeros(len(packets), TRAFFIC)
    table["time_s"], table["fate"] = time_s, fate
    for name in ("channel", "sender", "group", "type", "size", "number"):
        table[name] = packets[name]
    table["receiver"] = packets["to"] if receivers is None else receivers
    messages.traffic = np.concatenate([messages.traffic, table])
    np.add.at(messages.counts, (table["channel"], table["fate"]), 1)


def take(messages: MessageState) -> Records:
    """Return what happened in a cycle, by time, and clear it."""
    traffic = messages.traffic
    if not len(traffic):
        return traffic
    messages.traffic = np.zeros(0, TRAFFIC)
    return traffic[np.argsort(traffic["time_s"], kind="stable")]


def events(traffic: Records, channels: Sequence[str], robots: Sequence[str]) -> Iterator[Event]:
    """Return what happened as events.

    Args:
        traffic: what happened, of dtype `TRAFFIC`.
        channels: the channels' names.
        robots: the robots' names.
    """
    for row in traffic.tolist():
        time_s, fate, channel, sender, receiver, group, kind, size, number = row
        if receiver != EVERYBODY:
            to = robots[receiver]
        else:
            to = "all" if group == NO_GROUP else f"group {group}"
        text = (
            f"{channels[channel]} message {number} of {robots[sender]} to {to}, "
            f"type {kind}, {size} bytes: {MEANINGS[Fate(fate)]}"
        )
        yield Event(time_s, "message", text, sender if fate == Fate.SENT else receiver)


class HasTraffic(Protocol):
    """A timestep that has ended, as far as messages are concerned."""

    @property
    def traffic(self) -> Records:
        """What happened to messages in it, of dtype `TRAFFIC`."""


class Monitor:
    """Counts what happened to messages, timestep after timestep.

    Give its `step` to a session as its trace, or call it with each `Step`.
    """

    def __init__(self, channels: Sequence[str], robots: Sequence[str]) -> None:
        """Start counting.

        Args:
            channels: the channels' names, in the order of their numbers.
            robots: the robots' names.
        """
        self.channels = tuple(channels)
        self.robots = tuple(robots)
        self._counts: dict[tuple[int, int, int, int], int] = {}

    @classmethod
    def of(cls, world: WorldModel) -> Self:
        """Start counting in a world."""
        channels = [channel.name for channel in world.communication.channels]
        return cls(channels, [robot.id for robot in world.robots])

    def step(self, step: HasTraffic) -> None:
        """Count what happened in a timestep that has ended."""
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
        """Return how often something happened: on a channel, from a sender, to a receiver.

        A message to all is sent to the receiver -1.
        """
        wanted = (channel, sender, receiver, int(fate))
        return sum(
            count
            for key, count in self._counts.items()
            if all(want is None or want == have for want, have in zip(wanted, key, strict=True))
        )

    def pairs(self) -> dict[tuple[int, int, int], dict[Fate, int]]:
        """Return the counts of each channel, sender and receiver, in rising order."""
        found: dict[tuple[int, int, int], dict[Fate, int]] = {}
        for (channel, sender, receiver, fate), count in sorted(self._counts.items()):
            found.setdefault((channel, sender, receiver), {})[Fate(fate)] = count
        return found
