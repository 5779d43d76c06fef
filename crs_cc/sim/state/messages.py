"""Messages in queues, in transmission, and in inboxes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, FloatArray, Int64Array, Records
from crs_cc.requests import DATA_SIZE
from crs_cc.sim.model.world import WorldModel

PACKET: Final = np.dtype(
    [
        ("sender", "<i4"),
        ("to", "<i4"),  # a robot, or `EVERYBODY`
        ("group", "<i4"),  # a group, or `NO_GROUP`
        ("channel", "<i4"),
        ("type", "<i4"),
        ("size", "<i4"),
        ("number", "<i8"),  # number of messages that its sender sent before
        ("sent_s", "<f8"),
        ("begins_s", "<f8"),  # start of its transmission; NaN while it waits
        ("data", "u1", (DATA_SIZE,)),
    ]
)
"""One message, as it was sent."""

RECEPTION: Final = np.dtype(
    [
        ("receiver", "<i4"),
        ("packet", "<i4"),  # its row among the packets
        ("arrives_s", "<f8"),
        ("status", "i1"),
        ("corrupted", "?"),
    ]
)
"""The reception of a message by one robot: on its way, or in its inbox."""

IN_TRANSIT: Final = 0
ARRIVED: Final = 1
DONE: Final = 2
"""Status of a reception: on its way, in the inbox, read or rejected."""

SHUT: Final = np.dtype(
    [
        ("at_s", "<f8"),
        ("until_s", "<f8"),
        ("channel", "<i4"),
        ("sender", "<i4"),
        ("receiver", "<i4"),
    ]
)
"""Outages, as in `communication.Shut`."""

TRAFFIC: Final = np.dtype(
    [
        ("time_s", "<f8"),
        ("fate", "i1"),
        ("channel", "<i4"),
        ("sender", "<i4"),
        ("receiver", "<i4"),  # the addressee or the actual receiver; `EVERYBODY`
        ("group", "<i4"),
        ("type", "<i4"),
        ("size", "<i4"),
        ("number", "<i8"),
    ]
)
"""An event of a message: see `comms.message_log`."""

EVERYBODY: Final = -1
NO_GROUP: Final = -1
GROUPS: Final = 32


@dataclass(slots=True)
class MessageState:
    """All messages; tables have as many rows as there are messages.

    Attributes:
        sent: number of messages that each robot has sent, (robots,).
        groups: the groups that each robot is in, as bits, (robots,).
        free_s: end of the current transmission of each sender, (robots, channels).
        bursts: whether each receiver is in a burst of losses, (robots, channels).
        outbox: queued messages, in order, of dtype `PACKET`.
        packets: messages on their way or in inboxes, of dtype `PACKET`.
        receptions: their receptions, by rising receiver and arrival, of dtype `RECEPTION`.
        shuts: past and future outages, of dtype `SHUT`.
        traffic: the events of this cycle, of dtype `TRAFFIC`.
        counts: number of messages with each fate on each channel, (channels, fates).
    """

    sent: Int64Array
    groups: npt.NDArray[np.uint32]
    free_s: FloatArray
    bursts: BoolArray
    outbox: Records
    packets: Records
    receptions: Records
    shuts: Records
    traffic: Records
    counts: Int64Array

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return a state without messages."""
        robots, channels = len(world.robots), len(world.communication.channels)
        shuts = [
            (shut.at_s, shut.until_s, shut.channel, shut.sender, shut.receiver)
            for shut in world.communication.shuts
        ]
        return cls(
            sent=np.zeros(robots, dtype=np.int64),
            groups=np.zeros(robots, dtype=np.uint32),
            free_s=np.zeros((robots, channels)),
            bursts=np.zeros((robots, channels), dtype=np.bool_),
            outbox=np.zeros(0, PACKET),
            packets=np.zeros(0, PACKET),
            receptions=np.zeros(0, RECEPTION),
            shuts=np.array(shuts, SHUT),
            traffic=np.zeros(0, TRAFFIC),
            counts=np.zeros((channels, FATES), dtype=np.int64),
        )


FATES: Final = 10
"""Number of fates in `comms.message_log.Fate`."""
