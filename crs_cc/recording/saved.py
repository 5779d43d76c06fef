r"""The data of a second, saved as collected, until a chunk replaces it.

It is part of a file only during a run, or if the run was killed. It is not encoded: a second of one
robot takes a few copies. The format is little-endian, see `HEAD`, and private; `crs replay
--recover` converts it to chunks.

>>> hashes = [(9, Hash(20, "0f3a", 7, ""))]
>>> columns = [b""] * COLUMNS
>>> second = Second(Shape(1, 0, False), 0, columns, [(5_000, 0, 1, b"hi\n")], hashes, [])
>>> unpacked(b"".join(second.parts())) == second
True
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

from crs_cc.recording.columns import Part, Parts
from crs_cc.recording.frame_buffer import Shape
from crs_cc.recording.frames import MAX_ROWS
from crs_cc.recording.hashes import DIGITS, Hash

Output = tuple[int, int, int, bytes]
"""A piece of output: its time [ns], robot and stream, and what was printed."""

Entry = tuple[str, int, bytes]
"""An entry in JSON: its topic, its time [us], and its text."""

COLUMNS: Final = 8
HEAD: Final = struct.Struct(f"<IIBQ3I{COLUMNS}I")
"""Robots, movable objects, whether there are turrets, frames before; the numbers of pieces of
output, of hashes and of entries; the sizes of the columns, which follow, and then the others."""

_MAX_FRAMES: Final = 2**40
_OUTPUT: Final = struct.Struct("<qIBI")  # time [ns], robot, stream, size of what follows
_HASH: Final = struct.Struct(f"<qQ{DIGITS}sI16s")  # time [ns], timesteps, digest, output, state
_ENTRY: Final = struct.Struct("<qBI")  # time [us], sizes of the topic and of the text


class Second(NamedTuple):
    """The content of a recording that is new since it was last saved.

    Attributes:
        shape: the robots and objects in its frames.
        before: the number of earlier frames.
        columns: the data in columns, `COLUMNS` of them.
        output: pieces of output.
        hashes: hashes, each with its time [ns].
        entries: entries in JSON.
    """

    shape: Shape
    before: int
    columns: Parts
    output: Sequence[Output]
    hashes: Sequence[tuple[int, Hash]]
    entries: Sequence[Entry]

    def parts(self) -> Iterator[Part]:
        """Yield its bytes."""
        counts = (len(self.output), len(self.hashes), len(self.entries))
        yield HEAD.pack(*self.shape, self.before, *counts, *map(len, self.columns))
        yield from self.columns
        for time_ns, robot, stream, content in self.output:
            yield _OUTPUT.pack(time_ns, robot, stream, len(content)) + content
        for time_ns, found in self.hashes:
            digest, state = found.digest.encode(), found.state.encode()
            yield _HASH.pack(time_ns, found.timesteps, digest, found.output, state)
        for topic, time_us, text in self.entries:
            yield _ENTRY.pack(time_us, len(topic), len(text)) + topic.encode() + text


def unpacked(data: bytes) -> Second:
    """Return the saved data.

    Raises:
        struct.error, ValueError: it is not valid.
    """
    cursor = _Cursor(data)
    robots, objects, turret, before, *rest = cursor.numbers(HEAD)
    outputs, hashes, entries, *sizes = rest
    if robots + objects > MAX_ROWS or before > _MAX_FRAMES:
        raise ValueError("the saved data has too many rows")
    second = Second(
        Shape(robots, objects, bool(turret)),
        before,
        [cursor.take(size) for size in sizes],
        [cursor.output() for _ in range(outputs)],
        [cursor.hash() for _ in range(hashes)],
        [cursor.entry() for _ in range(entries)],
    )
    if cursor.at != len(data):
        raise ValueError("the saved data is longer than its content")
    return second


class _Cursor:
    """Reads fields, and raises struct.error or ValueError at the end of the data."""

    def __init__(self, data: bytes) -> None:
        self.at = 0
        self._data = data

    def numbers(self, form: struct.Struct) -> tuple[int, ...]:
        found = form.unpack_from(self._data, self.at)
        self.at += form.size
        return found

    def take(self, size: int) -> bytes:
        if size > len(self._data) - self.at:
            raise ValueError("the saved data is shorter than its content")
        self.at += size
        return self._data[self.at - size : self.at]

    def output(self) -> Output:
        time_ns, robot, stream, size = self.numbers(_OUTPUT)
        return time_ns, robot, stream, self.take(size)

    def hash(self) -> tuple[int, Hash]:
        time_ns, timesteps, digest, output, state = _HASH.unpack(self.take(_HASH.size))
        text = state.rstrip(b"\0").decode("ascii")
        return time_ns, Hash(timesteps, digest.decode("ascii"), output, text)

    def entry(self) -> Entry:
        time_us, topic, size = self.numbers(_ENTRY)
        return self.take(topic).decode("ascii"), time_us, self.take(size)
