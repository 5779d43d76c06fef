"""Blocks of frames: what a page fetches at once, and unpacks when it is looked at.

A block has about a second of frames as `recording.frames` encodes them, the first of them a key
frame, each after its time and length, compressed by zlib, which browsers can unpack.

>>> times, frames = unpacked(packed([0.0, 0.05], np.zeros((2, 3, 1))))
>>> times, frames.shape
([0.0, 0.05], (2, 3, 1))
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Sequence
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.recording.frames import FrameDecoder, encode

_PART: Final = struct.Struct("<dI")
"""The time [s] and the length of a frame."""


def packed(times_s: Sequence[float], frames: FloatArray, level: int = 6) -> bytes:
    """Return frames as a compressed block.

    Args:
        times_s: their times.
        frames: numbers [m, rad], shape (frames, columns, rows).
        level: how hard zlib tries.
    """
    parts = zip(times_s, encode(frames), strict=True)
    return zlib.compress(
        b"".join(_PART.pack(time_s, len(data)) + data for time_s, data in parts), level
    )


def unpacked(block: bytes) -> tuple[list[float], FloatArray]:
    """Return the times [s] and the frames of a block of our own."""
    content, decoder = zlib.decompress(block), FrameDecoder()
    times_s, frames, at = list[float](), list[FloatArray](), 0
    while at < len(content):
        time_s, size = _PART.unpack_from(content, at)
        at += _PART.size
        times_s.append(time_s)
        frames.append(decoder.decode(content[at : at + size]))
        at += size
    return times_s, np.array(frames)
