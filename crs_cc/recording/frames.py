"""Frames: the positions of everything, as columns of integers of 0.1 mm and 0.1 mrad.

A frame is a key frame, or the difference from the previous frame, or from the linear extrapolation
of the two previous ones, since most objects keep their velocity; the first frame of each recorded
second is a key frame. Numbers are encoded as `zigzag`, so that small negative ones are small, too,
and in byte planes: all low bytes first. Data that hardly changes is then mostly zeros, which zstd
compresses well. A message in a recording is a frame, or a group of small frames, with the low bytes
of all frames first.

>>> block = np.array([[[0.0, 1.5]], [[0.0001, np.nan]]])  # two frames, one column, two rows
>>> [len(each) for each in encode(block)]
[16, 16]
>>> ((time_ns, group),) = messages([5, 9], block)
>>> time_ns, len(group), group[:HEAD.size].hex()
(5, 44, '0301010002000000')
>>> [(time_ns, frame.tolist()) for time_ns, frame in FrameDecoder().frames(5, group)]
[(5, [[0.0, 1.5]]), (9, [[0.0001, nan]])]
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from typing import Any, Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import FloatArray, Int64Array

HEAD: Final = struct.Struct("<BBHI")
"""Kind, number of columns, version, number of rows."""

KEY, DIFFERENCE, EXTRAPOLATION, GROUP = range(4)
"""The kinds: the values; their first difference; their second difference; a group of frames."""

VERSION: Final = 1
COLUMNS: Final = ("x", "y", "heading", "turret")
PER_UNIT: Final = 1e4
"""Steps in a metre or a radian."""

NOWHERE: Final = -(2**31)
"""The stored value of NaN, as of the x of a robot that is not in the world."""

MAX_ROWS: Final = 1_000_000
_MAX_GROUP_BYTES: Final = 2**20  # limit when reading
MAX_GROUP: Final = 2**18
"""The frames of a chunk are a group if they are not larger than this [bytes]."""

_COUNT: Final = struct.Struct("<I")  # of the frames of a group
_TIME: Final = 8  # bytes of a frame's time in a group

_MAX_VALUE: Final = 2.0**31 - 1
_BYTES: Final = 4

Numbers = npt.NDArray[np.uint32]
Times = Sequence[int] | Int64Array


def encode(block: FloatArray) -> list[bytes]:
    """Encode frames, the first as a key frame.

    Args:
        block: values [m, rad], NaN for absent objects, of shape (frames, columns, rows).
    """
    return _single_messages(
        _steps(quantized(block)), (KEY, DIFFERENCE, *[EXTRAPOLATION] * len(block))
    )


def messages(times_ns: Times, block: FloatArray) -> list[tuple[int, bytes]]:
    """Return the messages of frames, with their times: one group, or one each if they are large.

    Args:
        times_ns: the frames' times.
        block: see `encode`.
    """
    return messages_of(times_ns, quantized(block))


def messages_of(times_ns: Times, whole: Numbers) -> list[tuple[int, bytes]]:
    """Return the messages of quantized frames."""
    return encoded_messages(
        times_ns, _steps(whole), (KEY, DIFFERENCE, *[EXTRAPOLATION] * len(whole))
    )


def encoded_messages(
    times_ns: Times, steps: Numbers, kinds: Sequence[int]
) -> list[tuple[int, bytes]]:
    """Return the messages of frames, given their differences.

    Args:
        times_ns: the frames' times.
        steps: the differences, (frames, columns, rows).
        kinds: the kind of each frame, if each is a message of its own.
    """
    if not is_grouped(steps):
        return list(zip(map(int, times_ns), _single_messages(steps, kinds), strict=True))
    frames, columns, rows = steps.shape
    head = HEAD.pack(GROUP, columns, VERSION, rows) + _COUNT.pack(frames)
    after_ns = np.diff(times_ns, prepend=times_ns[0]).astype("<u8")
    content = _byte_planes(steps).transpose(3, 1, 0, 2).tobytes()
    return [(int(times_ns[0]), head + after_ns.tobytes() + content)]


def is_grouped(block: npt.NDArray[Any]) -> bool:
    """Return whether frames are one message."""
    return len(block) > 1 and block.size * _BYTES <= MAX_GROUP


def _single_messages(steps: Numbers, kinds: Sequence[int]) -> list[bytes]:
    """Return a message for each frame."""
    content = np.ascontiguousarray(_byte_planes(steps).swapaxes(2, 3)).reshape(len(steps), -1)
    _, columns, rows = steps.shape
    heads = (HEAD.pack(kinds[frame], columns, VERSION, rows) for frame in range(len(steps)))
    return [head + each.tobytes() for head, each in zip(heads, content, strict=True)]


def _steps(whole: Numbers) -> Numbers:
    """Return the differences of frames: the first is a key frame."""
    steps = whole.copy()
    steps[1:] -= whole[:-1]
    steps[2:] -= steps[1:-1].copy()
    return steps


def _byte_planes(steps: Numbers) -> npt.NDArray[np.uint8]:
    """Return the bytes of encoded differences, (frames, columns, rows, 4)."""
    return zigzag(steps).view(np.uint8).reshape(*steps.shape, _BYTES)


def difference(before: Numbers, now: Numbers) -> bytes:
    """Encode a frame as the difference from the previous one.

    Args:
        before: the previous frame, see `quantized`.
        now: this frame, of the same shape (columns, rows).
    """
    columns, rows = now.shape
    planes = zigzag(now - before).view(np.uint8).reshape(columns, rows, _BYTES).swapaxes(1, 2)
    return HEAD.pack(DIFFERENCE, columns, VERSION, rows) + planes.tobytes()


def quantized(values: FloatArray) -> Numbers:
    """Return values [m, rad] in stored units: rounded to integers, `NOWHERE` for NaN."""
    with np.errstate(over="ignore", invalid="ignore"):  # of an invalid file
        scaled = np.rint(values * PER_UNIT)
    np.minimum(scaled, _MAX_VALUE, out=scaled)  # np.clip takes longer for few numbers
    np.maximum(scaled, -_MAX_VALUE, out=scaled)
    missing = np.isnan(scaled)
    if missing.any():
        scaled[missing] = NOWHERE
    return scaled.astype(np.int32).view(np.uint32)


def count_in(message: bytes) -> int:
    """Return the number of frames in a message; raise ValueError if it is invalid."""
    if not is_group(message):
        return 1
    if len(message) < HEAD.size + _COUNT.size:
        raise ValueError("a frame is too short")
    count: int = _COUNT.unpack_from(message, HEAD.size)[0]
    return count


class FrameDecoder:
    """Decodes frames in their order."""

    def __init__(self) -> None:
        self._last: Numbers | None = None
        self._step: Numbers | None = None  # from the frame before that to the last one

    def frames(self, time_ns: int, message: bytes) -> Iterator[tuple[int, FloatArray]]:
        """Yield the frames in a message, with their times; see `decode`.

        Raises:
            ValueError: the message is invalid, or the previous frame is missing.
        """
        if not is_group(message):
            yield time_ns, self.decode(message)
            return
        self.reset()
        after_ns, steps = group_in(message)
        steps[1:] = steps[1:].cumsum(axis=0, dtype=np.uint32)
        values = dequantized(steps.cumsum(axis=0, dtype=np.uint32))
        for each_ns, each in zip(after_ns.tolist(), values, strict=True):
            yield time_ns + each_ns, each

    def decode(self, data: bytes) -> FloatArray:
        """Return the values [m, rad], (columns, rows), NaN for absent objects.

        Raises:
            ValueError: the frame is invalid, or the previous frame is missing.
        """
        kind, found = frame_in(data)
        return dequantized(self._decoded(found, kind))

    def _decoded(self, found: Numbers, kind: int) -> Numbers:
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

    def reset(self) -> None:
        """Discard the previous frame: the next one must be a key frame."""
        self._last = self._step = None


def group_in(message: bytes) -> tuple[Int64Array, Numbers]:
    """Return the frames of a group: their times after the first [ns], and their differences.

    Raises:
        ValueError: the message is invalid.
    """
    count, begin = count_in(message), HEAD.size + _COUNT.size
    _, columns, version, rows = HEAD.unpack_from(message)
    size = columns * rows * _BYTES + _TIME
    if (
        version != VERSION
        or not 0 < columns <= len(COLUMNS)
        or count * rows == 0
        or len(message) != begin + count * size
        or len(message) > _MAX_GROUP_BYTES
    ):
        raise ValueError("a group of frames has an unknown form")
    after_ns = np.frombuffer(message, "<u8", count, begin).cumsum().astype(np.int64)
    if after_ns.min() < 0 or (np.diff(after_ns) < 0).any():
        raise ValueError("a group of frames has an unknown form")
    planes = np.frombuffer(message, np.uint8, offset=begin + count * _TIME)
    planes = planes.reshape(_BYTES, columns, count, rows).transpose(2, 1, 3, 0)
    content = np.ascontiguousarray(planes).view("<u4").reshape(count, columns, rows)
    return after_ns, unzigzag(content)


def frame_in(data: bytes) -> tuple[int, Numbers]:
    """Return a frame's kind and contents; raise ValueError if it is invalid."""
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
    return kind, unzigzag(content)


def is_group(message: bytes) -> bool:
    """Return whether a message has several frames."""
    return message[:1] == bytes([GROUP])


def is_key(message: bytes) -> bool:
    """Return whether a message begins with a key frame; a group does."""
    return message[:1] in (bytes([KEY]), bytes([GROUP]))


def dequantized(whole: Numbers) -> FloatArray:
    """Return values [m, rad] from stored units, NaN for `NOWHERE`."""
    signed = whole.view(np.int32)
    return np.where(signed == NOWHERE, np.nan, signed / PER_UNIT)


def zigzag(values: npt.NDArray[Any]) -> Numbers:
    """Encode signed 32-bit numbers as unsigned ones: 0, -1, 1, -2, ... as 0, 1, 2, 3, ..."""
    signed = values.view(np.int32)
    return ((signed << 1) ^ (signed >> 31)).view(np.uint32)


def unzigzag(values: npt.NDArray[Any]) -> Numbers:
    """Decode numbers that were encoded by `zigzag`."""
    return (values >> 1).view(np.uint32) ^ (-(values & 1).astype(np.int32)).view(np.uint32)
