"""What programs were given in each round of a run, so that they can run again without the world.

To look for something in the past only the programs have to run again; most of a run's time goes to
the world. A program's round is a function of its state, of the fuel that it gets and of the message
that it finds in its slot, which is the answer to its request. So these two are noted, for as long
a piece of the past as there is memory for.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import IndexArray, Int64Array, Records
from crs_cc.debug.timeline.position import Position
from crs_cc.requests import MESSAGE
from crs_cc.runtime.fleet import Fleet

MAX_BYTES: Final = 128 * 2**20
"""Memory for what is noted [bytes]; chosen by us: over a minute of a hundred robots."""

_ROUND: Final = 180
"""What noting a round takes besides its bytes, about [bytes]; measured."""


@dataclass(frozen=True, slots=True)
class RoundInput:
    """The replies that programs were given in a round.

    Messages are mostly zeros, and only the other bytes are kept.

    Attributes:
        count: how many programs ran.
        packed: the robots, rising, as int64; the fuel of each [instructions], as int64; for the
            messages that they found, a bit for each byte that is not zero, then these bytes.
    """

    count: int
    packed: bytes

    @classmethod
    def of(
        cls,
        robots: IndexArray,
        fuel: Int64Array,
        messages: Records,
    ) -> Self:
        """Create it from the robots, their fuel and their messages, of dtype `MESSAGE`."""
        content = messages.view(np.uint8)
        places = content != 0
        arrays = robots.astype(np.int64), fuel, np.packbits(places), content[places]
        return cls(len(robots), b"".join(array.tobytes() for array in arrays))

    @property
    def robots(self) -> IndexArray:
        """Return the robots whose programs ran, rising."""
        return np.frombuffer(self.packed, np.int64, self.count)

    @property
    def size(self) -> int:
        """Return its size [bytes]."""
        return _ROUND + len(self.packed)

    def give(self, fleet: Fleet) -> None:
        """Feed it to the programs again."""
        robots, packed = self.robots, self.packed
        messages = np.zeros(self.count, MESSAGE)
        content = messages.view(np.uint8)
        first = 2 * robots.nbytes
        places = np.frombuffer(packed, np.uint8, -(-len(content) // 8), first)
        kept = np.frombuffer(packed, np.uint8, offset=first + len(places))
        content[np.unpackbits(places, count=len(content)).view(np.bool_)] = kept
        fleet.slots["run"][robots] = 1
        fleet.slots["fuel"][robots] = np.frombuffer(packed, np.int64, self.count, robots.nbytes)
        fleet.reply(robots, messages)


class InputLog:
    """The rounds of a run, and how many each timestep had."""

    def __init__(self, most_bytes: int = MAX_BYTES) -> None:
        self._most_bytes = most_bytes
        self._bytes = 0
        self._rounds: dict[int, RoundInput] = {}  # by `_key`
        self._counts: dict[int, int] = {}
        self._ended: dict[int, tuple[int, ...]] = {}

    def note(self, place: Position, pending: Int64Array, fleet: Fleet) -> None:
        """Record a round that starts.

        Args:
            place: the position before it.
            pending: by robot, its fuel; 0 for those that do not run.
            fleet: the programs, with their replies.
        """
        key = _key(place.timestep, place.round)
        if key in self._rounds:
            return
        robots = np.flatnonzero(pending)
        self._rounds[key] = RoundInput.of(robots, pending[robots], fleet.messages(robots))
        self._bytes += self._rounds[key].size
        while self._bytes > self._most_bytes:
            oldest = next(iter(self._rounds))
            self._bytes -= self._rounds.pop(oldest).size

    def end(self, timestep: int, rounds: int, ended: tuple[int, ...] = ()) -> None:
        """Record how many rounds a timestep had, and which programs ended with it."""
        self._counts[timestep] = rounds
        if ended:
            self._ended[timestep] = ended

    def ended_in(self, timestep: int) -> tuple[int, ...]:
        """Return the robots that left with a timestep."""
        return self._ended.get(timestep, ())

    def round_at(self, place: Position) -> RoundInput | None:
        """Return the round that starts at a position; None if it is not logged."""
        return self._rounds.get(_key(place.timestep, place.round))

    def knows(self, begin: Position, limit: Position) -> bool:
        """Return whether all rounds between two positions are logged."""
        first = begin.round
        for timestep in range(begin.timestep, limit.timestep + 1):
            is_last = timestep == limit.timestep
            if not is_last and timestep not in self._counts:
                return False
            end = limit.round + (limit.robot >= 0) if is_last else self._counts[timestep]
            if any(_key(timestep, number) not in self._rounds for number in range(first, end)):
                return False
            first = 0
        return True

    def rounds_in(self, timestep: int) -> int | None:
        """Return how many rounds a timestep had; None if it is not logged."""
        return self._counts.get(timestep)

    def forget(self, place: Position) -> None:
        """Discard the rounds from a position on."""
        here = _key(place.timestep, place.round + (place.robot >= 0))
        for key in [each for each in self._rounds if each >= here]:
            self._bytes -= self._rounds.pop(key).size
        for timestep in [each for each in self._counts if each >= place.timestep]:
            del self._counts[timestep]
            self._ended.pop(timestep, None)


def _key(timestep: int, number: int) -> int:
    """Return the key of a round: one number takes a quarter of the memory of a pair."""
    return timestep << 32 | number
