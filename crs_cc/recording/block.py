"""What is gathered of a run until it is encoded.

A block is written as one chunk. What is in it of a second can be encoded before, so that it can be
saved; the whole block takes fewer bytes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Final

from crs_cc.recording import readings, topics
from crs_cc.recording.content import as_fields
from crs_cc.recording.entries import Entries
from crs_cc.recording.frames import messages
from crs_cc.recording.gathered import GatheredFrames, GatheredOdometry, GatheredReadings
from crs_cc.recording.hashes import Hash, entry_of
from crs_cc.recording.mcap_records import Channel
from crs_cc.recording.readings import ReadingEncoder

Encoded = tuple[Channel, int, bytes]
"""A message: its channel, time [ns] and content."""

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
        odometry: its frames of what the robots believe.
        readings: its readings of `State`.
        entries_size: the bytes of everything in JSON but hashes, roughly.
    """

    def __init__(self, begin_s: float) -> None:
        """Create an empty one."""
        self.begin_s = begin_s
        self.seconds = self.entries_size = 0
        self.frames, self.odometry = GatheredFrames(), GatheredOdometry()
        self.readings = GatheredReadings()
        self._entries = Entries()
        self._output: list[tuple[int, int, int, bytes]] = []  # time [ns], robot, stream, content
        self._hashes: list[tuple[int, Hash]] = []
        self._saved = 0, 0, 0  # frames, frames of odometry, and readings
        self._saved_hashes = 0

    @property
    def size(self) -> int:
        """Return how many bytes it takes when encoded, roughly."""
        poses = _ROW * (self.frames.rows + self.odometry.rows)
        rest = _READING * self.readings.rows + _HASH * len(self._hashes)
        return poses + rest + self.entries_size

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

    def unsaved(self) -> Iterator[Encoded]:
        """Yield messages of what is new since the last time; all of it stays in the block."""
        hashes, self._saved_hashes = self._hashes[self._saved_hashes :], len(self._hashes)
        frames, odometry, found = self._saved
        self._saved = len(self.frames), len(self.odometry), len(self.readings)
        yield from _frame_messages(topics.FRAME, self.frames, frames)
        yield from _frame_messages(topics.ODOMETRY, self.odometry, odometry)
        yield from _reading_messages(ReadingEncoder(), self.readings, found)
        self._encode_output()
        yield from self._entries.unmarked()
        yield from _hash_messages(hashes)

    def messages(self, encoder: ReadingEncoder) -> Iterator[Encoded]:
        """Yield the messages of all that is in the block; the encoder knows the readings before."""
        yield from _frame_messages(topics.FRAME, self.frames)
        yield from _frame_messages(topics.ODOMETRY, self.odometry)
        yield from _reading_messages(encoder, self.readings)
        self._encode_output()
        yield from self._entries.messages()
        yield from _hash_messages(self._hashes)

    def take(self, encoder: ReadingEncoder) -> Iterator[Encoded]:
        """Yield the messages of readings and entries, and remove these; nothing must be saved."""
        yield from _reading_messages(encoder, self.readings)
        self._encode_output()
        yield from self._entries.messages()
        self.readings, self._entries, self.entries_size = GatheredReadings(), Entries(), 0

    def _encode_output(self) -> None:
        for time_ns, robot, stream, content in self._output:
            data = {"robot": robot, "stream": stream, **as_fields(content)}
            self._entries.add(topics.OUTPUT, time_ns, data)
        self._output = []


def _frame_messages(
    channel: Channel, frames: GatheredFrames | GatheredOdometry, since: int = 0
) -> Iterator[Encoded]:
    """Yield the messages of frames from a number on."""
    if len(frames) > since:
        for time_ns, data in messages(*frames.since(since)):
            yield channel, time_ns, data


def _reading_messages(
    encoder: ReadingEncoder, gathered: GatheredReadings, since: int = 0
) -> Iterator[Encoded]:
    """Yield the messages of readings from a number on."""
    if len(gathered) > since:
        time_ns, rows = gathered.since(since)
        for begin in range(0, len(rows.robots), readings.MAX_ROWS):
            part = rows.of(slice(begin, begin + readings.MAX_ROWS))
            yield topics.STATE, time_ns, encoder.encode(part, time_ns)


def _hash_messages(found: Sequence[tuple[int, Hash]]) -> Iterator[Encoded]:
    """Yield the message of hashes, which is one entry."""
    if found:
        entries = Entries()
        entries.add(topics.HASH, found[-1][0], entry_of([each for _, each in found]))
        yield from entries.messages()
