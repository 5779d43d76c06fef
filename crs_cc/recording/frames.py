"""Frames: where everything that moves is, in whole tenths of millimetres and of milliradians.

A frame has columns (x, y, heading, and the turret if any robot has one) with a number for each
robot and then for each movable object. A key frame holds the numbers, any other frame their
differences to the frame before; the first frame of each recorded second is a key frame. Numbers are
folded so that small ones of either sign are small (`zigzag`), and their bytes are written apart:
all low bytes first. What hardly changes is mostly zeros then, which zstd shortens well: about two
bytes for a robot and frame.

>>> blocks = np.array([[[0.0, 1.5]], [[0.0001, np.nan]]])  # two frames, one column, two rows
>>> data = encode(blocks)
>>> [len(each) for each in data], data[0][:HEAD.size].hex()
([16, 16], '0001010002000000')
>>> decoder = FrameDecoder()
>>> [decoder.decode(each).tolist() for each in data]
[[[0.0, 1.5]], [[0.0001, nan]]]
"""

from __future__ import annotations

import struct
from typing import Any, Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import FloatArray

HEAD: Final = struct.Struct("<BBHI")
"""Kind (0 key, 1 difference), number of columns, version, number of rows."""

VERSION: Final = 1
COLUMNS: Final = ("x", "y", "heading", "turret")
PER_UNIT: Final = 1e4
"""Steps in a metre or a radian."""

NOWHERE: Final = -(2**31)
"""The x of a robot that is not in the world."""

MAX_ROWS: Final = 1_000_000
_LARGEST: Final = 2.0**31 - 1
_BYTES: Final = 4

Numbers = npt.NDArray[np.uint32]


def encode(block: FloatArray) -> list[bytes]:
    """Return the frames of a second, the first of them a key frame.

    Args:
        block: numbers [m, rad], NaN for what is not in the world, shape (frames, columns, rows).
    """
    frames, columns, rows = block.shape
    scaled = np.rint(block * PER_UNIT)
    np.clip(scaled, -_LARGEST, _LARGEST, out=scaled)
    missing = np.isnan(scaled)
    scaled[missing] = NOWHERE
    whole = scaled.astype(np.int32).view(np.uint32)
    whole[1:] -= whole[:-1].copy()
    folded = _zigzag(whole)
    planes = folded.view(np.uint8).reshape(frames, columns, rows, _BYTES).swapaxes(2, 3)
    content = np.ascontiguousarray(planes).reshape(frames, -1)
    heads = (HEAD.pack(frame > 0, columns, VERSION, rows) for frame in range(frames))
    return [head + each.tobytes() for head, each in zip(heads, content, strict=True)]


class FrameDecoder:
    """Decodes frames in their order."""

    def __init__(self) -> None:
        self._last: Numbers | None = None

    def decode(self, data: bytes) -> FloatArray:
        """Return the numbers [m, rad], (columns, rows), NaN for what is not in the world.

        Raises:
            ValueError: it is no frame, or the frame before is missing.
        """
        if len(data) < HEAD.size:
            raise ValueError("a frame is too short")
        kind, columns, version, rows = HEAD.unpack_from(data)
        if version != VERSION or kind > 1 or not 0 < columns <= len(COLUMNS) or rows > MAX_ROWS:
            raise ValueError("a frame has an unknown form")
        if len(data) != HEAD.size + columns * rows * _BYTES:
            raise ValueError("a frame has the wrong length")
        planes = np.frombuffer(data, np.uint8, offset=HEAD.size).reshape(columns, _BYTES, rows)
        folded = np.ascontiguousarray(planes.swapaxes(1, 2)).view("<u4").reshape(columns, rows)
        whole = (folded >> 1) ^ (-(folded & 1).astype(np.int32)).view(np.uint32)
        if kind == 1:
            if self._last is None or self._last.shape != whole.shape:
                raise ValueError("the frame before is missing")
            whole += self._last
        self._last = np.asarray(whole, np.uint32)
        signed = whole.view(np.int32)
        return np.where(signed == NOWHERE, np.nan, signed / PER_UNIT)

    def forget(self) -> None:
        """Forget the frame before: the next one must be a key frame."""
        self._last = None


def is_key(data: bytes) -> bool:
    """Return whether a message is a key frame."""
    return data[:1] == b"\0"


def _zigzag(values: npt.NDArray[Any]) -> Numbers:
    signed = values.view(np.int32)
    return ((signed << 1) ^ (signed >> 31)).view(np.uint32)
