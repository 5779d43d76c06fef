"""What is gathered of a run until it is encoded: copies of arrays, quick to take.

A block is written as one chunk. What is in it of a second can be encoded before, so that it can be
saved; the whole block takes fewer bytes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.recording import readings, topics
from crs_cc.recording.content import as_fields
from crs_cc.recording.entries import Entries
from crs_cc.recording.frames import messages
from crs_cc.recording.hashes import Hash, entry_of
from crs_cc.recording.mcap_records import NS, Channel
from crs_cc.recording.readings import ReadingEncoder, Readings

if TYPE_CHECKING:
    from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array
    from crs_cc.sim.state.env_state import EnvState

Encoded = tuple[Channel, int, bytes]
"""A message: its channel, time [ns] and content."""

_RawFrame = tuple[bytes, bytes, bytes, bytes, "BoolArray"]
"""Positions [m] of all bodies (rows, 2), their angles [rad], headings [rad] of the robots, the
turrets' angles [rad] if there are any, and which robots are in the world."""

_RawAnswers = tuple[int, int, bytes, bytes, bytes]
"""The request's code, how many robots were answered, and what `Block.add_answers` is given."""

_Frames = tuple[list[int], "FloatArray"]
"""Times [ns], and the numbers of the frames of these times (frames, columns, rows)."""

_ROW: Final = 12  # bytes of a body in a frame
_READING: Final = 32  # bytes of a reading when encoded, roughly
_HASH: Final = 64
_PIECE: Final = 54  # bytes of a piece of output besides its text


class Block:
    """What has been gathered since the last chunk.

    Attributes:
        begin_s: when it begins [s].
        frames: how many frames it has.
        rows: how many readings it has.
        seconds: how many whole seconds it has; the recorder counts them.
        entries_size: the bytes of everything in JSON but hashes, roughly.
    """

    def __init__(self, begin_s: float) -> None:
        """Create an empty one."""
        self.begin_s = begin_s
        self.frames = self.rows = self.seconds = self.entries_size = 0
        self._entries = Entries()
        self._size = 0
        self._frames: list[_RawFrame] = []
        self._times_s: list[float] = []
        self._believed: list[bytes] = []
        self._believed_s: list[float] = []
        self._answers: list[_RawAnswers] = []
        self._answered_s = 0.0  # when the first of them were
        self._output: list[tuple[int, int, int, bytes]] = []  # time [ns], robot, stream, content
        self._hashes: list[tuple[int, Hash]] = []
        self._saved_frames: list[_Frames] = []
        self._saved_odometry: list[_Frames] = []
        self._saved_readings: list[tuple[int, Readings]] = []
        self._saved_hashes = 0

    @property
    def size(self) -> int:
        """Return how many bytes it takes when encoded, roughly."""
        return self._size + self.entries_size

    def add_frame(self, time_s: float, state: EnvState, *, has_turret: bool) -> None:
        """Copy a frame from a state."""
        bodies = state.bodies
        self._times_s.append(time_s)
        self._frames.append(
            (
                bodies.position_m.tobytes(),
                bodies.angle_rad.tobytes(),
                state.heading_rad.tobytes(),
                state.drive.turret_rad.tobytes() if has_turret else b"",
                state.presence.present,  # never changed in place
            )
        )
        self.frames += 1
        self._size += _ROW * len(bodies.angle_rad)

    def add_odometry(self, time_s: float, state: EnvState) -> None:
        """Copy what the robots believe from a state."""
        odometry = state.odometry
        self._believed_s.append(time_s)
        for column in (odometry.x_m, odometry.y_m, odometry.heading_rad):
            self._believed.append(column.tobytes())
        self._size += _ROW * len(odometry.x_m)

    def add_answers(
        self,
        time_s: float,
        code: int,
        robots: IndexArray,
        clock_s: FloatArray,
        states: Int32Array,
    ) -> None:
        """Add readings that were given together in a timestep.

        Args:
            time_s: its start.
            code: the request's code.
            robots: who was answered.
            clock_s: when each program continued.
            states: the vectors.
        """
        count = len(robots)
        if not self._answers:
            self._answered_s = time_s
        self._answers.append((code, count, robots.tobytes(), clock_s.tobytes(), states.tobytes()))
        self.rows += count
        self._size += _READING * count

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
        self._size += _HASH

    def last_frame(self) -> FloatArray:
        """Return the numbers of the last frame, (columns, rows)."""
        found: FloatArray = _values(self._frames[-1:])[0]
        return found

    def unsaved(self) -> Iterator[Encoded]:
        """Yield messages of what is new since the last time; all of it stays in the block."""
        hashes, self._saved_hashes = self._hashes[self._saved_hashes :], len(self._hashes)
        frames, odometry, found = self._gather()
        yield from _frame_messages(topics.FRAME, self._saved_frames[frames:])
        yield from _frame_messages(topics.ODOMETRY, self._saved_odometry[odometry:])
        yield from _readings(ReadingEncoder(), self._saved_readings[found:])
        yield from self._entries.unmarked()
        yield from _hash_messages(hashes)

    def messages(self, encoder: ReadingEncoder) -> Iterator[Encoded]:
        """Yield the messages of all that is in the block; the encoder knows the readings before."""
        self._gather()
        yield from _frame_messages(topics.FRAME, self._saved_frames)
        yield from _frame_messages(topics.ODOMETRY, self._saved_odometry)
        yield from _readings(encoder, self._saved_readings)
        yield from self._entries.messages()
        yield from _hash_messages(self._hashes)

    def take(self, encoder: ReadingEncoder) -> Iterator[Encoded]:
        """Yield the messages of readings and entries, and remove these; nothing must be saved."""
        self._gather()
        yield from _readings(encoder, self._saved_readings)
        yield from self._entries.messages()
        self._saved_readings, self._entries = [], Entries()
        self.rows = self.entries_size = 0

    def _gather(self) -> tuple[int, int, int]:
        """Put what is new into arrays; return how many of each kind have been there before."""
        before = len(self._saved_frames), len(self._saved_odometry), len(self._saved_readings)
        if self._frames:
            self._saved_frames.append(([ns(each) for each in self._times_s], _values(self._frames)))
            self._times_s, self._frames = [], []
        if self._believed:
            believed = np.frombuffer(b"".join(self._believed)).reshape(len(self._believed_s), 3, -1)
            self._saved_odometry.append(([ns(each) for each in self._believed_s], believed))
            self._believed_s, self._believed = [], []
        if self._answers:
            self._saved_readings.append((ns(self._answered_s), _together(self._answers)))
            self._answers = []
        for time_ns, robot, stream, content in self._output:
            data = {"robot": robot, "stream": stream, **as_fields(content)}
            self._entries.add(topics.OUTPUT, time_ns, data)
        self._output = []
        return before


def _together(answers: Sequence[_RawAnswers]) -> Readings:
    """Return answers as rows."""
    codes, counts, robots, clock_s, states = zip(*answers, strict=True)
    return Readings(
        np.repeat(codes, counts),
        np.frombuffer(b"".join(robots), np.intp),
        np.frombuffer(b"".join(clock_s)),
        np.frombuffer(b"".join(states), np.int32).reshape(-1, readings.STATE),
    )


def _readings(encoder: ReadingEncoder, found: Sequence[tuple[int, Readings]]) -> Iterator[Encoded]:
    """Yield the messages of readings."""
    if not found:
        return
    time_ns, rows = found[0]
    if len(found) > 1:
        parts = [each for _, each in found]
        rows = Readings(
            np.concatenate([each.codes for each in parts]),
            np.concatenate([each.robots for each in parts]),
            np.concatenate([each.clock_s for each in parts]),
            np.concatenate([each.states for each in parts]),
        )
    for begin in range(0, len(rows.robots), readings.MAX_ROWS):
        part = rows.of(slice(begin, begin + readings.MAX_ROWS))
        yield topics.STATE, time_ns, encoder.encode(part, time_ns)


def _frame_messages(channel: Channel, found: Sequence[_Frames]) -> Iterator[Encoded]:
    """Yield the messages of frames."""
    if found:
        times_ns = [time_ns for times_ns, _ in found for time_ns in times_ns]
        values = found[0][1] if len(found) == 1 else np.concatenate([each for _, each in found])
        for time_ns, data in messages(times_ns, values):
            yield channel, time_ns, data


def _hash_messages(found: Sequence[tuple[int, Hash]]) -> Iterator[Encoded]:
    """Yield the message of hashes, which is one entry."""
    if found:
        entries = Entries()
        entries.add(topics.HASH, found[-1][0], entry_of([each for _, each in found]))
        yield from entries.messages()


def _values(frames: Sequence[_RawFrame]) -> FloatArray:
    """Return frames as an array (frames, columns, rows)."""
    count = len(frames)
    *columns, present = zip(*frames, strict=True)
    positions_m, angles_rad, headings_rad, turrets_rad = (
        np.frombuffer(b"".join(each)).reshape(count, -1) for each in columns
    )
    rows, robots, has_turret = angles_rad.shape[1], headings_rad.shape[1], turrets_rad.size > 0
    block = np.zeros((count, 3 + has_turret, rows))
    block[:, :2] = positions_m.reshape(count, rows, 2).swapaxes(1, 2)
    block[:, 2] = angles_rad
    block[:, 2, :robots] = headings_rad
    if has_turret:
        block[:, 3, :robots] = turrets_rad
    is_there = np.array(present)
    if not is_there.all():
        block.swapaxes(1, 2)[:, :robots][~is_there] = np.nan
    return block


def ns(time_s: float) -> int:
    """Return a time as it is in a recording."""
    return max(0, round(time_s * NS))
