"""Frames: where everything is, as columns of whole numbers of 0.1 mm and 0.1 mrad.

A frame is a key frame, or the difference to the frame before, or to what the two before it lead
one to expect, since things mostly go on as they do; the first frame of each recorded second is a
key frame. Numbers are folded so that small ones of either sign are small (`zigzag`), and their
bytes are written apart: all low bytes first. What hardly changes is mostly zeros then, which zstd
shortens well. A message in a recording is a frame, or, when they are small, a group of all of a
second.

>>> blocks = np.array([[[0.0, 1.5]], [[0.0001, np.nan]]])  # two frames, one column, two rows
>>> data = encode(blocks)
>>> [len(each) for each in data], data[0][:HEAD.size].hex()
([16, 16], '0001010002000000')
>>> decoder = FrameDecoder()
>>> [decoder.decode(each).tolist() for each in data]
[[[0.0, 1.5]], [[0.0001, nan]]]
>>> [(time_ns, len(message)) for time_ns, message in grouped([5, 9], data)]
[(5, 48)]
"""

from __future__ import annotations

import struct
from collections.abc import Sequence
from typing import Any, Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import FloatArray

HEAD: Final = struct.Struct("<BBHI")
"""Kind, number of columns, version, number of rows; of a group, 0 columns and the frames."""

KEY, DIFFERENCE, EXTRAPOLATION, GROUP = range(4)
"""The kinds: the values themselves, less those of the frame before, less twice those of the frame
before plus those of the one before that; several frames."""

VERSION: Final = 1
COLUMNS: Final = ("x", "y", "heading", "turret")
PER_UNIT: Final = 1e4
"""Steps in a metre or a radian."""

NOWHERE: Final = -(2**31)
"""The x of a robot that is not in the world."""

MAX_ROWS: Final = 1_000_000
_LARGEST_GROUP: Final = 2**20  # that is read
MAX_GROUP: Final = 16_384
"""The frames of a second are a group if they take at most so much [bytes]."""

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
    whole[2:] -= whole[1:-1].copy()
    planes = folded(whole).view(np.uint8).reshape(frames, columns, rows, _BYTES).swapaxes(2, 3)
    content = np.ascontiguousarray(planes).reshape(frames, -1)
    kinds = (KEY, DIFFERENCE, *[EXTRAPOLATION] * frames)
    heads = (HEAD.pack(kinds[frame], columns, VERSION, rows) for frame in range(frames))
    return [head + each.tobytes() for head, each in zip(heads, content, strict=True)]


def grouped(times_ns: Sequence[int], frames: Sequence[bytes]) -> list[tuple[int, bytes]]:
    """Return the messages of a second's frames, with their times: one of all, if they are small."""
    size = sum(map(len, frames))
    if len(frames) < 2 or size > MAX_GROUP or times_ns[-1] - times_ns[0] >= 2**32:
        return list(zip(times_ns, frames, strict=True))
    head = HEAD.pack(GROUP, 0, VERSION, len(frames))
    steps_ns = np.diff(times_ns, prepend=times_ns[0]).astype("<u4").tobytes()
    return [(times_ns[0], b"".join([head, steps_ns, *frames]))]


def frames_in(time_ns: int, message: bytes) -> list[tuple[int, bytes]]:
    """Return the frames in a message of a time, with their times; raise ValueError if it is none.

    They may be in another form than frames have: only decoding shows.
    """
    if message[:1] != bytes([GROUP]):
        return [(time_ns, message)]
    if len(message) < HEAD.size:
        raise ValueError("a frame is too short")
    _, _, version, count = HEAD.unpack_from(message)
    begin = HEAD.size + 4 * count
    size, rest = divmod(len(message) - begin, max(1, count))
    if version != VERSION or rest or size < HEAD.size or len(message) > _LARGEST_GROUP:
        raise ValueError("a group of frames has an unknown form")
    steps_ns = np.frombuffer(message, "<u4", count, HEAD.size).cumsum(dtype=np.int64)
    return [
        (time_ns + after_ns, message[begin + place * size : begin + (place + 1) * size])
        for place, after_ns in enumerate(steps_ns.tolist())
    ]


class FrameDecoder:
    """Decodes frames in their order."""

    def __init__(self) -> None:
        self._last: Numbers | None = None
        self._step: Numbers | None = None  # from the frame before that to the last one

    def decode(self, data: bytes) -> FloatArray:
        """Return the numbers [m, rad], (columns, rows), NaN for what is not in the world.

        Raises:
            ValueError: it is no frame, or the frame before is missing.
        """
        if len(data) < HEAD.size:
            raise ValueError("a frame is too short")
        kind, columns, version, rows = HEAD.unpack_from(data)
        if (
            version != VERSION
            or kind > EXTRAPOLATION
            or not 0 < columns <= len(COLUMNS)
            or rows > MAX_ROWS
        ):
            raise ValueError("a frame has an unknown form")
        if len(data) != HEAD.size + columns * rows * _BYTES:
            raise ValueError("a frame has the wrong length")
        planes = np.frombuffer(data, np.uint8, offset=HEAD.size).reshape(columns, _BYTES, rows)
        content = np.ascontiguousarray(planes.swapaxes(1, 2)).view("<u4").reshape(columns, rows)
        whole = self._whole(unfolded(content), kind)
        signed = whole.view(np.int32)
        return np.where(signed == NOWHERE, np.nan, signed / PER_UNIT)

    def _whole(self, found: Numbers, kind: int) -> Numbers:
        """Return the numbers of a frame, given its content."""
        last, step = self._last, self._step
        if kind == KEY:
            self._step = None
        else:
            if kind == EXTRAPOLATION:
                if step is None or step.shape != found.shape:
                    raise ValueError("the frame before is missing")
                found = found + step
            if last is None or last.shape != found.shape:
                raise ValueError("the frame before is missing")
            self._step = found
            found = found + last
        self._last = found
        return found

    def forget(self) -> None:
        """Forget the frame before: the next one must be a key frame."""
        self._last = self._step = None


def is_key(data: bytes) -> bool:
    """Return whether a message begins with a key frame; a group does."""
    return data[:1] in (bytes([KEY]), bytes([GROUP]))


def folded(values: npt.NDArray[Any]) -> Numbers:
    """Return 32-bit numbers folded (`zigzag`): 0, -1, 1, -2, ... as 0, 1, 2, 3, ..."""
    signed = values.view(np.int32)
    return ((signed << 1) ^ (signed >> 31)).view(np.uint32)


def unfolded(values: npt.NDArray[Any]) -> Numbers:
    """Return what has been folded."""
    return (values >> 1).view(np.uint32) ^ (-(values & 1).astype(np.int32)).view(np.uint32)
