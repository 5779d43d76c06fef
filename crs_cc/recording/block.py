"""What is gathered of a run until it is encoded: copies of arrays, quick to take.

A block is written as one chunk. What is in it of a second can be encoded before, so that it can be
saved; the whole block takes fewer bytes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.recording import readings, topics
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

Answers = tuple[int, "IndexArray", "FloatArray", "Int32Array"]
"""Readings that were given together: the request's code, the robots, when each program continued
[s], the vectors; none of the arrays is ever changed."""

_RawFrame = tuple["FloatArray", "FloatArray", "FloatArray", "BoolArray", "FloatArray | None"]
"""Positions [m] of all bodies (rows, 2), headings [rad] of the robots, angles [rad] of all bodies,
which robots are in the world, and the turrets' angles [rad] if there are any."""

_Frames = tuple[list[int], "FloatArray"]
"""Times [ns], and the numbers of the frames of these times (frames, columns, rows)."""

_ROW: Final = 12  # bytes of a body in a frame
_READING: Final = 32  # bytes of a reading when encoded, roughly
_HASH: Final = 64


class Block:
    """What has been gathered since the last chunk.

    Attributes:
        begin_s: when it begins [s].
        frames: how many frames it has.
        rows: how many readings it has.
        seconds: how many whole seconds it has; the recorder counts them.
        entries: what it has of everything in JSON but hashes.
    """

    def __init__(self, begin_s: float) -> None:
        """Create an empty one."""
        self.begin_s = begin_s
        self.frames = self.rows = self.seconds = 0
        self.entries = Entries()
        self._size = 0
        self._frames: list[_RawFrame] = []
        self._times_ns: list[int] = []
        self._believed: list[FloatArray] = []
        self._believed_ns: list[int] = []
        self._answers: list[Answers] = []
        self._answered_ns: list[int] = []
        self._hashes: list[tuple[int, Hash]] = []
        self._saved_frames: list[_Frames] = []
        self._saved_odometry: list[_Frames] = []
        self._saved_readings: list[tuple[int, Readings]] = []
        self._saved_hashes = 0

    @property
    def size(self) -> int:
        """Return how many bytes it takes when encoded, roughly."""
        return self._size + self.entries.size

    def add_frame(self, time_ns: int, state: EnvState, *, has_turret: bool) -> None:
        """Copy a frame from a state."""
        bodies = state.bodies
        self._times_ns.append(time_ns)
        self._frames.append(
            (
                bodies.position_m.copy(),
                state.heading_rad.copy(),
                bodies.angle_rad.copy(),
                state.presence.present,  # never changed in place
                state.drive.turret_rad.copy() if has_turret else None,
            )
        )
        self.frames += 1
        self._size += _ROW * len(bodies.angle_rad)

    def add_odometry(self, time_ns: int, state: EnvState) -> None:
        """Copy what the robots believe from a state."""
        odometry = state.odometry
        self._believed_ns.append(time_ns)
        self._believed.append(np.array((odometry.x_m, odometry.y_m, odometry.heading_rad)))
        self._size += _ROW * len(odometry.x_m)

    def add_answers(self, time_ns: int, answers: Answers) -> None:
        """Add readings that were given in a timestep."""
        self._answered_ns.append(time_ns)
        self._answers.append(answers)
        self.rows += len(answers[1])
        self._size += _READING * len(answers[1])

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
        yield from self.entries.unmarked()
        yield from _hash_messages(hashes)

    def messages(self, encoder: ReadingEncoder) -> Iterator[Encoded]:
        """Yield the messages of all that is in the block; the encoder knows the readings before."""
        self._gather()
        yield from _frame_messages(topics.FRAME, self._saved_frames)
        yield from _frame_messages(topics.ODOMETRY, self._saved_odometry)
        yield from _readings(encoder, self._saved_readings)
        yield from self.entries.messages()
        yield from _hash_messages(self._hashes)

    def take(self, encoder: ReadingEncoder) -> Iterator[Encoded]:
        """Yield the messages of readings and entries, and remove these; nothing must be saved."""
        self._gather()
        yield from _readings(encoder, self._saved_readings)
        yield from self.entries.messages()
        self._saved_readings, self.rows, self.entries = [], 0, Entries()

    def _gather(self) -> tuple[int, int, int]:
        """Put what is new into arrays; return how many of each kind have been there before."""
        before = len(self._saved_frames), len(self._saved_odometry), len(self._saved_readings)
        if self._frames:
            self._saved_frames.append((self._times_ns, _values(self._frames)))
            self._times_ns, self._frames = [], []
        if self._believed:
            self._saved_odometry.append((self._believed_ns, np.array(self._believed)))
            self._believed_ns, self._believed = [], []
        if self._answers:
            self._saved_readings.append((self._answered_ns[0], _together(self._answers)))
            self._answered_ns, self._answers = [], []
        return before


def _together(answers: Sequence[Answers]) -> Readings:
    """Return answers as rows."""
    codes, robots, clock_s, states = zip(*answers, strict=True)
    return Readings(
        np.repeat(codes, [len(each) for each in robots]),
        np.concatenate(robots),
        np.concatenate(clock_s),
        np.concatenate(states),
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
    positions_m, headings_rad, angles_rad, present, turrets_rad = zip(*frames, strict=True)
    robots, has_turret = len(headings_rad[0]), turrets_rad[0] is not None
    block = np.zeros((len(frames), 3 + has_turret, len(angles_rad[0])))
    block[:, :2] = np.array(positions_m).swapaxes(1, 2)
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
