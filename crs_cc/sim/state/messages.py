"""The messages that wait, that are on their way, and that lie in inboxes."""

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
        ("number", "<i8"),  # how many its sender had sent before
        ("sent_s", "<f8"),
        ("begins_s", "<f8"),  # when its transmission begins; NaN while it waits
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
"""A message on its way to one robot, or in its inbox."""

COMING: Final = 0
ARRIVED: Final = 1
GONE: Final = 2
"""Status of a reception: on its way, in the inbox, taken out of it or never let in."""

SHUT: Final = np.dtype(
    [
        ("at_s", "<f8"),
        ("until_s", "<f8"),
        ("channel", "<i4"),
        ("sender", "<i4"),
        ("receiver", "<i4"),
    ]
)
"""Messages that cannot pass for a while, as in `communication.Shut`."""

TRAFFIC: Final = np.dtype(
    [
        ("time_s", "<f8"),
        ("fate", "i1"),
        ("channel", "<i4"),
        ("sender", "<i4"),
        ("receiver", "<i4"),  # whom it is for, or went to; `EVERYBODY`
        ("group", "<i4"),
        ("type", "<i4"),
        ("size", "<i4"),
        ("number", "<i8"),
    ]
)
"""Something that happened to a message: see `messages.traffic`."""

EVERYBODY: Final = -1
NO_GROUP: Final = -1
GROUPS: Final = 32


@dataclass(slots=True)
class MessageState:
    """All messages; tables have as many rows as there are messages.

    Attributes:
        sent: how many messages each robot has sent, (robots,).
        groups: the groups that each robot is in, a bit for each, (robots,).
        free_s: when each sender has sent what it has begun to send, (robots, channels).
        bursts: whether what each receiver loses comes in a burst now, (robots, channels).
        outbox: what has been sent and has not gone on the air, in order, of dtype `PACKET`.
        packets: what is on its way or in inboxes, of dtype `PACKET`.
        receptions: where it is going, by rising receiver and arrival, of dtype `RECEPTION`.
        shuts: when messages could and cannot pass, of dtype `SHUT`.
        traffic: what happened in this cycle, of dtype `TRAFFIC`.
        counts: how often each fate came to messages on each channel, (channels, fates).
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
        """Return a state in which nobody has sent anything."""
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
"""How many fates there are in `messages.traffic.Fate`."""
