"""Data of a run that is collected until it is encoded.

A block is written as one chunk. What a second brings can be saved before, as it is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Final, NamedTuple

import numpy as np

from crs_cc.core.arrays import Int64Array
from crs_cc.recording import beliefs, frames, topics
from crs_cc.recording.columns import Columns, Part
from crs_cc.recording.content import as_fields
from crs_cc.recording.courses import Course
from crs_cc.recording.entries import Entries
from crs_cc.recording.gathered import Frames, GatheredFrames, Shape
from crs_cc.recording.gathered_readings import GatheredReadings
from crs_cc.recording.hashes import Hash, entry_of
from crs_cc.recording.mcap_records import Channel
from crs_cc.recording.readings import MAX_ROWS, ReadingEncoder
from crs_cc.recording.saved import COLUMNS, Output, Second, unpacked

Encoded = tuple[Channel, int, bytes]
"""A message: its channel, time [ns] and content."""

ODOMETRY_FRAMES: Final = 5
"""Every so many frames, what the robots believe is recorded, too."""

_ROW: Final = 12  # bytes of a body in a frame
_READING: Final = 32  # bytes of a reading when encoded, roughly
_HASH: Final = 64
_PIECE: Final = 54  # bytes of a piece of output besides its text


class Block:
    """What has been gathered since the last chunk.

    Attributes:
        begin_s: when it begins [s].
        seconds: how many whole seconds it has; the recorder counts them.
        frames: its frames.
        readings: its readings of `State`.
        entries_size: the bytes of everything in JSON but hashes, roughly.
        is_whole: whether its messages have to be in the same chunk; known when they are made.
        shape: who is in its frames.
    """

    def __init__(self, begin_s: float, shape: Shape, frames_before: int = 0) -> None:
        """Create an empty one.

        Args:
            begin_s: when it begins [s].
            shape: who is in its frames.
            frames_before: how many frames the recording has before it.
        """
        self.begin_s = begin_s
        self.seconds, self.is_whole = 0, False
        self.frames = GatheredFrames(shape)
        self._gather()
        self.shape, self._frames_before = shape, frames_before
        self._output: list[Output] = []
        self._hashes: list[tuple[int, Hash]] = []
        self._saved_bytes = [0] * COLUMNS
        self._saved_frames = 0
        self._saved_output = self._saved_hashes = 0

    @property
    def size(self) -> int:
        """Return how many bytes it takes when encoded, roughly."""
        believed = self.shape.robots / ODOMETRY_FRAMES
        poses = _ROW * (self.shape.robots + self.shape.objects + believed) * len(self.frames)
        rest = _READING * self.readings.count + _HASH * len(self._hashes)
        return round(poses) + rest + self.entries_size

    @property
    def frames_after(self) -> int:
        """Return how many frames the recording has with those of this block."""
        return self._frames_before + len(self.frames)

    def add_output(self, time_ns: int, robot: int, stream: int, content: bytes) -> None:
        """Add a piece of a program's output."""
        self._output.append((time_ns, robot, stream, content))
        self.entries_size += _PIECE + len(content)

    def add_entry(self, channel: Channel, time_ns: int, data: Mapping[str, Any]) -> None:
        """Add an entry of anything in JSON but output and hashes."""
        self.entries_size += self._entries.add(channel, time_ns, data)

    def add_hash(self, time_ns: int, found: Hash) -> None:
        """Add the hash of an instant, in the place of one that it has."""
        if self._hashes and self._hashes[-1][0] == time_ns:
            self._hashes.pop()
            self._saved_hashes = min(self._saved_hashes, len(self._hashes))
        self._hashes.append((time_ns, found))

    def unsaved(self) -> Second:
        """Return the data that is new since the last call; all data stays in the block.

        Nothing must be added to the block as long as it is used.
        """
        self.frames.settle()
        self.readings.settle()
        tails: list[Part] = []
        saved = self._saved_bytes
        for number, column in enumerate(self._content):
            begin, end = saved[number], len(column)
            if end > begin:
                tails.append(memoryview(column)[begin:])
                saved[number] = end
            else:
                tails.append(b"")
        before = self._frames_before + self._saved_frames
        self._saved_frames = len(self.frames)
        output, self._saved_output = self._output[self._saved_output :], len(self._output)
        hashes, self._saved_hashes = self._hashes[self._saved_hashes :], len(self._hashes)
        entries = list(self._entries.unmarked()) if self._entries.are_new else []
        return Second(self.shape, before, tails, output, hashes, entries)

    def put(self, second: Second) -> None:
        """Add the saved data of another block; raise ValueError if it is invalid."""
        at = 0
        for columns in self._columns():
            count = len(columns.content())
            columns.extend(second.columns[at : at + count])
            at += count
        self.readings.count = len(self.readings.single) + len(self.readings.passed)
        self._output += second.output
        self._hashes += second.hashes
        for topic, time_us, text in second.entries:
            channel = topics.TOPICS.get(topic)
            if channel is None or channel.encoding != "json":
                raise ValueError("an entry of an unknown topic")
            self._entries.put(channel, time_us, text)

    def messages(self, encoder: ReadingEncoder) -> Iterator[Encoded]:
        """Yield the messages of all that is in the block; the encoder knows the readings before.

        Where its frames are a group, readings depend on them: `is_whole` is true.
        """
        course = None
        if len(self.frames):
            found = _Whole.of(self.frames.frames(), self._first_believed)
            yield from found.messages()
            if self.readings.count:
                course = found.course()
                self.is_whole = course is not None
        yield from _reading_messages(encoder, self.readings, course)
        self._encode_output()
        yield from self._entries.messages()
        yield from _hash_messages(self._hashes)

    def take(self, encoder: ReadingEncoder) -> Iterator[Encoded]:
        """Yield the messages of readings and entries, and remove these; nothing must be saved."""
        yield from _reading_messages(encoder, self.readings)
        self._encode_output()
        yield from self._entries.messages()
        self._gather()

    def _columns(self) -> tuple[Columns, ...]:
        """Return all columns: single frames, heads and frames of passages, and readings."""
        frames, readings = self.frames, self.readings
        return frames.single, frames.heads, frames.passed, readings.single, readings.passed

    def _gather(self) -> None:
        """Begin to gather readings and entries."""
        self.readings, self._entries, self.entries_size = GatheredReadings(), Entries(), 0
        self._content = [column for columns in self._columns() for column in columns.content()]

    @property
    def _first_believed(self) -> int:
        """The number of the first frame with which it is recorded what robots believe."""
        return -self._frames_before % ODOMETRY_FRAMES

    def _encode_output(self) -> None:
        for time_ns, robot, stream, content in self._output:
            self._entries.add_text(topics.OUTPUT, time_ns, (robot, stream), as_fields(content))
        self._output = []


def saved_messages(data: bytes) -> Iterator[Encoded]:
    """Yield the messages of the saved data.

    Raises:
        struct.error, ValueError: it is not valid.
    """
    second = unpacked(data)
    block = Block(0.0, second.shape, second.before)
    block.put(second)
    for message in block.messages(ReadingEncoder()):
        if not 0 <= message[1] < 2**63:
            raise ValueError("a time that was saved is not valid")
        yield message


class _Whole(NamedTuple):
    """Frames as they are written, see `frames.whole_numbers`.

    Attributes:
        times_ns: when, (k,).
        true: where everything is, robots first, (k, columns, rows).
        some_ns: the times of those with which it is written what robots believe, (m,).
        believed: that, (m, 3, robots).
    """

    times_ns: Int64Array
    true: frames.Numbers
    some_ns: Int64Array
    believed: frames.Numbers

    @classmethod
    def of(cls, found: Frames, first_believed: int) -> _Whole:
        """Return frames; each fifth from one on has what robots believe."""
        some = slice(first_believed, None, ODOMETRY_FRAMES)
        believed = frames.whole_numbers(found.believed[some])
        return cls(
            found.times_ns, frames.whole_numbers(found.poses), found.times_ns[some], believed
        )

    def messages(self) -> Iterator[Encoded]:
        """Yield the messages of the frames, and of what the robots believe in some of them."""
        for time_ns, data in frames.messages_of(self.times_ns, self.true):
            yield topics.FRAME, time_ns, data
        if len(self.some_ns):
            last = np.searchsorted(self.times_ns, self.some_ns, side="right") - 1  # of that time
            for time_ns, data in beliefs.messages_of(self.some_ns, self.believed, self.true[last]):
                yield topics.ODOMETRY, time_ns, data

    def course(self) -> Course | None:
        """Return what the frames say of odometry at any time, None if they do not."""
        if not (frames.are_grouped(self.true) and self.believed.size):
            return None
        return Course(self.times_ns, self.true, self.some_ns, self.believed)


def _reading_messages(
    encoder: ReadingEncoder, gathered: GatheredReadings, course: Course | None = None
) -> Iterator[Encoded]:
    """Yield the messages of readings."""
    if gathered.count:
        time_ns, rows = gathered.rows()
        for begin in range(0, len(rows.robots), MAX_ROWS):
            part = rows.of(slice(begin, begin + MAX_ROWS))
            yield topics.STATE, time_ns, encoder.encode(part, time_ns, course)


def _hash_messages(found: Sequence[tuple[int, Hash]]) -> Iterator[Encoded]:
    """Yield the message of hashes, which is one entry."""
    if found:
        entries = Entries()
        entries.add(topics.HASH, found[-1][0], entry_of([each for _, each in found]))
        yield from entries.messages()
