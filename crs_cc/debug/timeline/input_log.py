"""The input of programs in each round of a run, so that they can be replayed without the world.

To look for something in the past only the programs have to run again; most of a run's time goes to
the world. A program's round is a function of its state, of the fuel that it gets and of the message
that it finds in its slot, which is the answer to its request. So these two are noted, and the clock
of each program, for as long a piece of the past as there is memory for.

Rounds are kept in blocks, packed when full: the answers of successive rounds have much in common.
"""

from __future__ import annotations

import struct
from array import array
from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, ByteArray, FloatArray, IndexArray, Int64Array, Records
from crs_cc.debug.timeline.packed_rounds import PackedRounds, RoundBlock
from crs_cc.debug.timeline.position import Position
from crs_cc.requests import MESSAGE
from crs_cc.runtime.fleet import Fleet

MAX_BYTES: Final = 128 * 2**20
"""Memory for what is noted [bytes]; chosen by us: days of a robot, over a minute of a hundred."""

_UNKNOWN: Final = -1
_ONE: Final = struct.Struct("=qqqd")
_FEW: Final = 8
"""Messages of a part of the programs as small as this are unpacked one by one."""


@dataclass(frozen=True, slots=True)
class RoundInput:
    """The replies that programs were given in a round.

    Messages are mostly zeros, and only the other bytes are kept.

    Attributes:
        count: how many programs ran.
        content: that number, as int64; the robots, rising, as int64; the fuel of each
            [instructions], as int64; its clock [s], as float64; for the messages that they found,
            a bit for each byte that is not zero, then these bytes.
    """

    count: int
    content: bytes

    @classmethod
    def of(cls, pending: Int64Array, clock_s: FloatArray, fleet: Fleet) -> Self:
        """Record the round that starts.

        Args:
            pending: by robot, its fuel; 0 for those that do not run.
            clock_s: by robot, the clock of its program [s].
            fleet: the programs, with their replies.
        """
        robots = pending.nonzero()[0]
        messages = fleet.messages(robots).view(np.uint8)
        places = messages != 0
        if len(robots) == 1:  # the same bytes, without arrays of one
            only = int(robots[0])
            head = _ONE.pack(1, only, pending[only], clock_s[only])
        else:
            count = np.array([len(robots)], np.int64)
            numbers = count, robots.astype(np.int64), pending[robots], clock_s[robots]
            head = b"".join(each.tobytes() for each in numbers)
        content = head + np.packbits(places).tobytes() + messages[places].tobytes()
        return cls(len(robots), content)

    @classmethod
    def unpacked(cls, content: bytes) -> Self:
        """Return the round of a content."""
        return cls(int(np.frombuffer(content, np.int64, 1)[0]), content)

    @property
    def robots(self) -> IndexArray:
        """Return the robots whose programs ran, rising."""
        return np.frombuffer(self.content, np.int64, self.count, 8)

    def feed(
        self, fleet: Fleet, clock_s: FloatArray, pending: Int64Array, chosen: BoolArray | None
    ) -> IndexArray:
        """Feed it to programs again, and set their clocks [s] and fuel.

        Args:
            fleet: the programs.
            clock_s: by robot, the clock of its program [s].
            pending: by robot, its fuel; 0 for those that do not run.
            chosen: by robot, whether its program is to run again; None for all.

        Returns:
            The robots whose programs run.
        """
        robots, size = self.robots, 8 * self.count
        which = np.ones(self.count, np.bool_) if chosen is None else chosen[robots]
        given = robots[which]
        pending[:] = 0
        if not given.size:
            return given
        fuel = np.frombuffer(self.content, np.int64, self.count, 8 + size)[which]
        fleet.slots["run"][given] = 1
        fleet.slots["fuel"][given] = fuel
        is_few = chosen is not None and _FEW * given.size < self.count
        fleet.reply(given, self._messages_of(which) if is_few else self._messages()[which])
        clocks_s = np.frombuffer(self.content, np.float64, self.count, 8 + 2 * size)
        clock_s[given] = clocks_s[which]
        pending[given] = fuel
        return given

    def _messages(self) -> Records:
        """Return the messages that the programs found."""
        messages = np.zeros(self.count, MESSAGE)
        room = messages.view(np.uint8)
        places, kept = self._packed()
        room[np.unpackbits(places, count=len(room)).view(np.bool_)] = kept
        return messages

    def _messages_of(self, which: BoolArray) -> Records:
        """Return the messages of some programs, which are not looked for among all bytes."""
        places, kept = self._packed()
        rows = places.reshape(self.count, -1)
        ends = np.bitwise_count(rows).sum(1, np.int64).cumsum()
        messages = np.zeros(np.count_nonzero(which), MESSAGE)
        room = messages.view(np.uint8).reshape(len(messages), -1)
        for row, number in zip(room, which.nonzero()[0].tolist(), strict=True):
            first = ends[number - 1] if number else 0
            row[np.unpackbits(rows[number]).view(np.bool_)] = kept[first : ends[number]]
        return messages

    def _packed(self) -> tuple[ByteArray, ByteArray]:
        """Return the bits of all messages for bytes that are not zero, and these bytes."""
        first, size = 8 + 24 * self.count, self.count * MESSAGE.itemsize // 8
        places = np.frombuffer(self.content, np.uint8, size, first)
        return places, np.frombuffer(self.content, np.uint8, offset=first + size)


class InputLog:
    """The rounds of a run, and how many each timestep had."""

    def __init__(self, most_bytes: int = MAX_BYTES) -> None:
        self._packed = PackedRounds(most_bytes)
        self._fresh = RoundBlock()
        self._counts = array("i")  # by timestep
        self._ended: dict[int, tuple[int, ...]] = {}

    def record_round(
        self, place: Position, pending: Int64Array, clock_s: FloatArray, fleet: Fleet
    ) -> None:
        """Record a round that starts.

        Args:
            place: the position before it.
            pending: by robot, its fuel; 0 for those that do not run.
            clock_s: by robot, the clock of its program [s].
            fleet: the programs, with their replies.
        """
        key = _key(place.timestep, place.round)
        if key in self._fresh or key in self._packed:
            return
        if not self._fresh.is_empty and key != self._next(self._fresh.last):
            self._pack()
        self._fresh.append(key, RoundInput.of(pending, clock_s, fleet).content)
        if self._fresh.is_full:
            self._pack()

    def _pack(self) -> None:
        self._packed.add(self._fresh)
        self._fresh = RoundBlock()

    def _next(self, key: int) -> int | None:
        """Return the key of the round after one; None if that is not known."""
        timestep, number = key >> 32, (key & 0xFFFFFFFF) + 1
        while (count := self.rounds_in(timestep)) is not None:
            if number < count:
                return _key(timestep, number)
            timestep, number = timestep + 1, 0
        return _key(timestep, number)

    def end(self, timestep: int, rounds: int, ended: tuple[int, ...] = ()) -> None:
        """Record how many rounds a timestep had, and which programs ended with it."""
        missing = timestep + 1 - len(self._counts)
        self._counts.extend([_UNKNOWN] * missing)
        self._counts[timestep] = rounds
        if ended:
            self._ended[timestep] = ended

    def ended_in(self, timestep: int) -> tuple[int, ...]:
        """Return the robots that left with a timestep."""
        return self._ended.get(timestep, ())

    def round_at(self, place: Position) -> RoundInput | None:
        """Return the round that starts at a position; None if it is not logged."""
        key = _key(place.timestep, place.round)
        content = self._fresh.get(key)
        content = self._packed.get(key) if content is None else content
        return None if content is None else RoundInput.unpacked(content)

    def covers(self, begin: Position, limit: Position) -> bool:
        """Return whether all rounds between two positions are logged."""
        if any(self.rounds_in(each) is None for each in range(begin.timestep, limit.timestep)):
            return False
        end = _key(limit.timestep, limit.round + (limit.robot >= 0))
        key: int | None = _key(begin.timestep, begin.round)
        if begin.timestep < limit.timestep and begin.round == self.rounds_in(begin.timestep):
            key = self._next(_key(begin.timestep, begin.round) - 1)
        while key is not None and key < end:
            last = self._packed.last_of(key)
            if last is None:
                last = self._fresh.last if key in self._fresh else None
            if last is None:
                return False
            key = self._next(last)
        return key is not None

    def rounds_in(self, timestep: int) -> int | None:
        """Return the number of rounds of a timestep; None if it is not logged."""
        known = self._counts[timestep] if timestep < len(self._counts) else _UNKNOWN
        return None if known == _UNKNOWN else known

    def truncate(self, place: Position) -> None:
        """Discard the rounds from a position on."""
        here = _key(place.timestep, place.round + (place.robot >= 0))
        self._fresh.truncate(here)
        self._packed.truncate(here)
        del self._counts[place.timestep :]
        for timestep in [each for each in self._ended if each >= place.timestep]:
            del self._ended[timestep]


def _key(timestep: int, number: int) -> int:
    """Return the key of a round: one number takes a quarter of the memory of a pair."""
    return timestep << 32 | number
