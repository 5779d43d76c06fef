"""Communication between robots: channels and their outages.

Three channels are predefined. They are lossless, and a world file can change them. Their
parameters are our choice:

- `radio`: a serial radio modem of 115.2 kbit/s; indoors, a wall attenuates by about 6 dB, which
  halves the range of a wave whose power falls with the square of the distance;
- `infrared`: a 9600 bit/s link (IrDA's lowest rate) over a few metres; needs line of sight;
- `local`: the local broadcast of swarm simulators: every robot in range receives without delay.

>>> [channel.name for channel in Communication().channels]
['radio', 'infrared', 'local']
>>> Communication().channels[1].duration_s(108)         # 120 bytes with the header
0.125
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

HEAD_BYTES: Final = 12
"""Size of a message's header: sender, receiver and type, four bytes each."""

ANY: Final = -1
"""Any channel or robot."""

MAX_CHANNELS: Final = 16
MAX_QUEUE: Final = 64


@dataclass(frozen=True, slots=True)
class Channel:
    """A communication channel.

    Attributes:
        name: its name, unique in the world.
        range_m: maximum distance between sender and receiver.
        walls: factor on the range for each object between them (robots do not count): 1 for no
            attenuation, 0 where line of sight is needed.
        delay_s: latency from the end of the transmission to the arrival.
        jitter_s: maximum additional latency, uniformly distributed.
        bandwidth_bps: data rate of each sender [byte/s].
        queue: capacity of each sender's queue, in messages.
        drops_oldest: whether a full queue drops its oldest message instead of the new one.
        loss: probability that a message is lost, 0 to 1.
        burst_begin: probability that a burst of losses starts with a message.
        burst_end: probability that it has ended with the next message.
        burst_loss: probability that a message is lost during a burst.
        corruption: probability that a byte is corrupted.
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
        """Return the transmission time of a message with `size` bytes of data."""
        return (size + HEAD_BYTES) / self.bandwidth_bps


@dataclass(frozen=True, slots=True)
class Shut:
    """An outage: messages whose transmission starts during it are lost.

    Attributes:
        at_s: its start.
        until_s: its end.
        channel: the channel's number; `ANY` for all.
        sender: the sending robot's number; `ANY` for all.
        receiver: the receiving robot's number; `ANY` for all.
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
"""The predefined channels, in the order of their numbers."""


@dataclass(frozen=True, slots=True)
class Communication:
    """All channels of a world and their outages, and the network between the robots' computers.

    Attributes:
        channels: the channels.
        shuts: their outages.
        network_latency_s: how long what a program sends to a socket takes at least; the default
            is chosen by us, that of a wireless network.
    """

    channels: tuple[Channel, ...] = PREDEFINED
    shuts: tuple[Shut, ...] = ()
    network_latency_s: float = 0.002


PLAIN_COMMUNICATION: Final = Communication()
"""Default of a world without `<communication>`."""
