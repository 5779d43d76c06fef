"""What is gathered of a run until it is encoded: copies of arrays, quick to take.

A block is written as one chunk. What is in it of a second can be encoded before, so that it can be
saved; the whole block takes fewer bytes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.recording import readings, topics
from crs_cc.recording.frames import encode
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

_VALUE: Final = 4  # bytes of a number in a frame
_ROW: Final = 32  # bytes of a reading when encoded, roughly
_HASH: Final = 64


class Block:
    """What has been gathered since the last chunk.

    Attributes:
        begin_s: when it begins [s].
        rows: how many readings it has.
    """

    def __init__(self, begin_s: float) -> None:
        """Create an empty one."""
        self.begin_s = begin_s
        self.rows = 0
        self._frames: list[_RawFrame] = []
        self._times_ns: list[int] = []
        self._believed: list[FloatArray] = []
        self._believed_ns: list[int] = []
        self._answers: list[Answers] = []
        self._answered_ns: list[int] = []
        self._hashes: list[tuple[int, Mapping[str, Any]]] = []
        self._saved = (0, 0, 0, 0)

    @property
    def frames(self) -> int:
        """Return the number of frames."""
        return len(self._frames)

    @property
    def size(self) -> int:
        """Return how many bytes it takes when encoded, roughly."""
        frames = 3 * _VALUE * self.frames * (len(self._frames[0][2]) if self._frames else 0)
        robots = 3 * _VALUE * sum(each.shape[1] for each in self._believed)
        return frames + robots + _ROW * self.rows + _HASH * len(self._hashes)

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

    def add_odometry(self, time_ns: int, state: EnvState) -> None:
        """Copy what the robots believe from a state."""
        odometry = state.odometry
        self._believed_ns.append(time_ns)
        self._believed.append(np.array((odometry.x_m, odometry.y_m, odometry.heading_rad)))

    def add_answers(self, time_ns: int, answers: Answers) -> None:
        """Add readings that were given in a timestep."""
        self._answered_ns.append(time_ns)
        self._answers.append(answers)
        self.rows += len(answers[1])

    def add_hash(self, time_ns: int, values: Mapping[str, Any]) -> None:
        """Add the hashes of an instant: always the same names."""
        self._hashes.append((time_ns, values))

    def last_frame(self) -> FloatArray:
        """Return the numbers of the last frame, (columns, rows)."""
        found: FloatArray = _values(self._frames[-1:])[0]
        return found

    def unsaved(self) -> Iterator[Encoded]:
        """Yield messages of what is new since the last time; all of it stays in the block."""
        frame, believed, answer, made = self._saved
        self._saved = (
            len(self._frames), len(self._believed), len(self._answers), len(self._hashes)
        )  # fmt: skip
        yield from self._frame_messages(frame)
        yield from self._odometry(believed)
        yield from self.readings(ReadingEncoder(), answer)
        yield from self._hash_messages(made)

    def messages(self, encoder: ReadingEncoder) -> Iterator[Encoded]:
        """Yield the messages of all that is in the block; the encoder knows the readings before."""
        yield from self._frame_messages(0)
        yield from self._odometry(0)
        yield from self.readings(encoder, 0)
        yield from self._hash_messages(0)

    def readings(self, encoder: ReadingEncoder, first: int = 0) -> Iterator[Encoded]:
        """Yield the messages of the readings from one on."""
        found = self._answers[first:]
        if not found:
            return
        time_ns = self._answered_ns[first]
        codes, robots, clock_s, states = zip(*found, strict=True)
        counts = [len(each) for each in robots]
        rows = Readings(
            np.repeat(codes, counts),
            np.concatenate(robots),
            np.concatenate(clock_s),
            np.concatenate(states),
        )
        for begin in range(0, sum(counts), readings.MAX_ROWS):
            part = rows.of(slice(begin, begin + readings.MAX_ROWS))
            yield topics.STATE, time_ns, encoder.encode(part, time_ns)

    def forget_readings(self) -> None:
        """Remove the readings, which have been encoded."""
        self._answers, self._answered_ns, self.rows = [], [], 0

    def _frame_messages(self, first: int) -> Iterator[Encoded]:
        found = self._frames[first:]
        if found:
            for time_ns, data in encode(self._times_ns[first:], _values(found)):
                yield topics.FRAME, time_ns, data

    def _odometry(self, first: int) -> Iterator[Encoded]:
        found = self._believed[first:]
        if found:
            for time_ns, data in encode(self._believed_ns[first:], np.array(found)):
                yield topics.ODOMETRY, time_ns, data

    def _hash_messages(self, first: int) -> Iterator[Encoded]:
        found = self._hashes[first:]
        if found:
            columns = {name: [values[name] for _, values in found] for name in found[0][1]}
            yield topics.HASH, found[-1][0], topics.as_json(columns)


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
