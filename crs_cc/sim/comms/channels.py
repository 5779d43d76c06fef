"""The channels of a world as arrays: constants for the vectorised parts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, Int32Array, Int64Array, Records
from crs_cc.sim.model.communication import HEAD_BYTES, Communication

_MAX_RANGE_M: Final = 1e5  # no world is larger


@dataclass(frozen=True, slots=True)
class Channels:
    """Constants of all channels, each of shape (channels,), as in `communication.Channel`."""

    names: tuple[str, ...]
    range_m: FloatArray
    walls: FloatArray
    delay_s: FloatArray
    jitter_s: FloatArray
    bandwidth_bps: FloatArray
    queue: Int64Array
    drops_oldest: BoolArray
    loss: FloatArray
    burst_begin: FloatArray
    burst_end: FloatArray
    burst_loss: FloatArray
    corruption: FloatArray

    @classmethod
    def of(cls, communication: Communication) -> Self:
        """Return the channels of a world."""
        channels = communication.channels
        return cls(
            tuple(channel.name for channel in channels),
            np.array([min(channel.range_m, _MAX_RANGE_M) for channel in channels]),
            np.array([channel.walls for channel in channels]),
            np.array([channel.delay_s for channel in channels]),
            np.array([channel.jitter_s for channel in channels]),
            np.array([channel.bandwidth_bps for channel in channels]),
            np.array([channel.queue for channel in channels]),
            np.array([channel.drops_oldest for channel in channels]),
            np.array([channel.loss for channel in channels]),
            np.array([channel.burst_begin for channel in channels]),
            np.array([channel.burst_end for channel in channels]),
            np.array([channel.burst_loss for channel in channels]),
            np.array([channel.corruption for channel in channels]),
        )

    def __len__(self) -> int:
        return len(self.names)

    def duration_s(self, packets: Records) -> FloatArray:
        """Return the duration of each message's transmission [s], shape (k,)."""
        size: Int32Array = packets["size"]
        channel: Int32Array = packets["channel"]
        return np.asarray((size + HEAD_BYTES) / self.bandwidth_bps[channel])
