"""What a world says of messages between robots: its channels, and when they are shut.

Three channels are always there. Nothing in them is random, and a world file changes them as it
likes. Their numbers were chosen by us:

- `radio`: a serial radio modem of 115.2 kbit/s; indoors, a wall takes about 6 dB, which halves the
  range of a wave whose power falls with the square of the distance;
- `infrared`: a line of 9600 bit/s (IrDA's slowest rate) over a few metres, which needs sight;
- `local`: the local broadcast of swarm simulators: whoever is near hears, at once and always.

>>> [channel.name for channel in Communication().channels]
['radio', 'infrared', 'local']
>>> Communication().channels[1].duration_s(108)         # of 120 bytes, with the head
0.125
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

HEAD_BYTES: Final = 12
"""What goes ahead of each message: sender, receiver and type, four bytes each."""

ANY: Final = -1
"""Any channel, any robot."""

MAX_CHANNELS: Final = 16
LONGEST_QUEUE: Final = 64


@dataclass(frozen=True, slots=True)
class Channel:
    """A way for messages to go.

    Attributes:
        name: its name, unique in the world.
        range_m: how far it reaches.
        walls: what share of the range is left behind each thing in the way, walls and boxes and so
            on, robots apart: 1 where they do not matter, 0 where sight is needed.
        delay_s: the time from the end of the transmission to the arrival.
        jitter_s: up to how much longer it is, uniformly distributed.
        bandwidth_bps: how many bytes each sender sends in a second.
        queue: how many messages wait at most until the sender has sent those before them.
        drops_oldest: which one is dropped when they are more: the oldest, else the newest.
        loss: the share of messages that is lost, from 0 to 1.
        burst_begin: how likely a burst of losses begins with a message.
        burst_end: how likely it has ended with the next message.
        burst_loss: the share of messages that is lost in a burst.
        corruption: the share of bytes that arrive as others.
    """

    name: str
    range_m: float = math.inf
    walls: float = 1.0
    delay_s: float = 0.0
    jitter_s: float = 0.0
    bandwidth_bps: float = math.inf
    queue: int = 16
    drops_oldest: bool = False
    loss: float = 0.0
    burst_begin: float = 0.0
    burst_end: float = 1.0
    burst_loss: float = 1.0
    corruption: float = 0.0

    def duration_s(self, size: int) -> float:
        """Gives how long the transmission of a message of so many bytes takes."""
        return (size + HEAD_BYTES) / self.bandwidth_bps


@dataclass(frozen=True, slots=True)
class Shut:
    """Messages that cannot pass for a while: those that begin to be transmitted in it.

    Attributes:
        at_s: from when.
        until_s: to when.
        channel: on which channel, by number; `ANY` for all.
        sender: from which robot, by number; `ANY` for all.
        receiver: to which one; `ANY` for all.
    """

    at_s: float = 0.0
    until_s: float = math.inf
    channel: int = ANY
    sender: int = ANY
    receiver: int = ANY


PREDEFINED: Final = (
    Channel("radio", 100.0, walls=0.5, delay_s=0.005, jitter_s=0.005, bandwidth_bps=14_400.0),
    Channel("infrared", 3.0, walls=0.0, delay_s=0.001, bandwidth_bps=960.0, queue=4),
    Channel("local", 5.0),
)
"""The channels that every world has, in the order of their numbers."""


@dataclass(frozen=True, slots=True)
class Communication:
    """All that a world says of messages."""

    channels: tuple[Channel, ...] = PREDEFINED
    shuts: tuple[Shut, ...] = ()


PLAIN_COMMUNICATION: Final = Communication()
"""Of a world that says nothing of it."""
