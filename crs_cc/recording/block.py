"""Data of a run that is collected until it is encoded.

A block is written as one chunk. Before that, the new data of each second can be saved as it is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Final, NamedTuple

import numpy as np

from crs_cc.core.arrays import Int64Array
from crs_cc.recording import frames, odometry, topics
from crs_cc.recording.columns import Columns, Part
from crs_cc.recording.content import as_fields
from crs_cc.recording.entries import Entries
from crs_cc.recording.frame_buffer import FrameBuffer, Frames, Shape
from crs_cc.recording.hashes import Hash, entry_of
from crs_cc.recording.mcap_records import Channel
from crs_cc.recording.odometry_prediction import OdometryPrediction
from crs_cc.recording.reading_buffer import ReadingBuffer
from crs_cc.recording.readings import MAX_ROWS, ReadingEncoder
from crs_cc.recording.saved import COLUMNS, Output, Second, unpacked

Encoded = tuple[Channel, int, bytes]
"""A message: its channel, time [ns] and content."""

ODOMETRY_FRAMES: Final = 5
"""Every frame of this number has odometry: 5 for each fifth."""

_ROW: Final = 12  # bytes of a body in a frame
_READING: Final = 32  # bytes of a reading when encoded, roughly
_HASH: Final = 64
_PIECE: Final = 54  # bytes of a piece of output besides its text


class Block:
    """The data that was collected since the last chunk.

    Attributes:
        begin_s: its start [s].
        seconds: the number of complete seconds; counted by the recording file.
        frames: its frames.
        readings: its readings of `State`.
        entries_size: the approximate size of all JSON entries except hashes [bytes].
        is_whole: whether its messages must be in the same chunk; known once they are encoded.
        shape: the robots and objects in its frames.
    """

    def __init__(self, begin_s: float, shape: Shape, frames_before: int = 0) -> None:
        """Create an empty block.

        Args:
            begin_s: its start [s].
            shape: the robots and objects in its frames.
            frames_before: the number of earlier frames in the recording.
        """
        self.begin_s = begin_s
        self.seconds, self.is_whole = 0, False
        self.frames = FrameBuffer(shape)
        self._reset_buffers()
        self.shape, self._frames_before = shape, frames_before
        self._output: list[Output] = []
        self._hashes: list[tuple[int, Hash]] = []
        self._saved_bytes = [0] * COLUMNS
        self._saved_frames = 0
        self._saved_output = self._saved_hashes = 0

    @property
    def size(self) -> int:
        """The approximate encoded size [bytes]."""
        estimates = self.shape.robots / ODOMETRY_FRAMES
        poses = _ROW * (self.shape.robots + self.shape.objects + estimates) * len(self.frames)
        rest = _READING * self.readings.count + _HASH * len(self._hashes)
        return round(poses) + rest + self.entries_size

    @property
    def frames_after(self) -> int:
        """The number of frames in the recording up to the end of this block."""
        return self._frames_before + len(self.frames)

    def add_output(self, time_ns: int, robot: int, stream: int, content: bytes) -> None:
        """Add a piece of a program's output."""
        self._output.append((time_ns, robot, stream, content))
        self.entries_size += _PIECE + len(content)

    def add_entry(self, channel: Channel, time_ns: int, data: Mapping[str, Any]) -> None:
        """Add a JSON entry other than output and hashes."""
        self.entries_size += self._entries.add(channel, time_ns, data)

    def add_hash(self, time_ns: int, found: Hash) -> None:
        """Add the hash at a time, replacing an earlier one at the same time."""
        if self._hashes and self._hashes[-1][0] == time_ns:
            self._hashes.pop()
            self._saved_hashes = min(self._saved_hashes, len(self._hashes))
        self._hashes.append((time_ns, found))

    def take_unsaved(self) -> Second:
        """Return the data that is new since the last call; all data stays in the block.

        Nothing may be added to the block while the data is in use.
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
        entries = list(self._entries.take_unsaved()) if self._entries.are_new else []
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
        """Yield all messages of the block; the encoder knows the earlier readings.

        If its frames are a group, readings depend on them: `is_whole` is true.
        """
        prediction = None
        if len(self.frames):
            found = _QuantizedFrames.of(self.frames.frames(), self._first_odometry)
            yield from found.messages()
            if self.readings.count:
                prediction = found.prediction()
                self.is_whole = prediction is not None
        yield from _reading_messages(encoder, self.readings, prediction)
        self._encode_output()
        yield from self._entries.messages()
        yield from _hash_messages(self._hashes)

    def take(self, encoder: ReadingEncoder) -> Iterator[Encoded]:
        """Yield the messages of readings and entries, and remove these, if none were saved."""
        yield from _reading_messages(encoder, self.readings)
        self._encode_output()
        yield from self._entries.messages()
        self._reset_buffers()

    def _columns(self) -> tuple[Columns, ...]:
        """Return all columns: single frames, heads and frames of passages, and readings."""
        frames, readings = self.frames, self.readings
        return frames.single, frames.heads, frames.passed, readings.single, readings.passed

    def _reset_buffers(self) -> None:
        """Create empty buffers of readings and entries."""
        self.readings, self._entries, self.entries_size = ReadingBuffer(), Entries(), 0
        self._content = [column for columns in self._columns() for column in columns.content()]

    @property
    def _first_odometry(self) -> int:
        """The number of the first frame that has odometry."""
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
            raise ValueError("a saved time is not valid")
        yield message


class _QuantizedFrames(NamedTuple):
    """Frames in stored units, see `frames.quantized`.

    Attributes:
        times_ns: the times, (k,).
        true: the true poses, robots first, (k, columns, rows).
        some_ns: the times of the frames with odometry, (m,).
        odometry: the odometry at these times, (m, 3, robots).
    """

    times_ns: Int64Array
    true: frames.Numbers
    some_ns: Int64Array
    odometry: frames.Numbers

    @classmethod
    def of(cls, found: Frames, first_odometry: int) -> _QuantizedFrames:
        """Quantize frames; every fifth one from a number on has odometry."""
        some = slice(first_odometry, None, ODOMETRY_FRAMES)
        estimates = frames.quantized(found.odometry[some])
        return cls(found.times_ns, frames.quantized(found.poses), found.times_ns[some], estimates)

    def messages(self) -> Iterator[Encoded]:
        """Yield the messages of the frames, and of the odometry in some of them."""
        for time_ns, data in frames.messages_of(self.times_ns, self.true):
            yield topics.FRAME, time_ns, data
        if len(self.some_ns):
            last = np.searchsorted(self.times_ns, self.some_ns, side="right") - 1  # of that time
            for time_ns, data in odometry.messages_of(self.some_ns, self.odometry, self.true[last]):
                yield topics.ODOMETRY, time_ns, data

    def prediction(self) -> OdometryPrediction | None:
        """Return the odometry prediction by the frames; None if they have none."""
        if not (frames.is_grouped(self.true) and self.odometry.size):
            return None
        return OdometryPrediction(self.times_ns, self.true, self.some_ns, self.odometry)


def _reading_messages(
    encoder: ReadingEncoder, gathered: ReadingBuffer, prediction: OdometryPrediction | None = None
) -> Iterator[Encoded]:
    """Yield the messages of readings."""
    if gathered.count:
        time_ns, rows = gathered.rows()
        for begin in range(0, len(rows.robots), MAX_ROWS):
            part = rows.of(slice(begin, begin + MAX_ROWS))
            yield topics.STATE, time_ns, encoder.encode(part, time_ns, prediction)


def _hash_messages(found: Sequence[tuple[int, Hash]]) -> Iterator[Encoded]:
    """Yield the message of hashes, which is one entry."""
    if found:
        entries = Entries()
        entries.add(topics.HASH, found[-1][0], entry_of([each for _, each in found]))
        yield from entries.messages()
