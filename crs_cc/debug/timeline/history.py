"""Snapshots of a run by position, and the choice of those to keep.

The shorter the replay from a snapshot to the target, the sooner the run is there; but
snapshots take time and memory. So on the way forward one is taken every few timesteps, as many as
cost little compared with running (`INTERVAL`), and more of them just before the position that the
user last went back to, as the next command is often a step further back. When memory runs out,
snapshots are thinned: those go first whose gap would be small relative to their distance from
the current position. So they are dense near it and ever sparser far away, and where the user goes
back to, replaying fills the gaps. None of this depends on a clock.

The start is always kept, and so is the snapshot after every change by the user: the
programs do not repeat that by themselves.
"""

from __future__ import annotations

import copy
from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from operator import attrgetter
from typing import Final

import numpy as np

from crs_cc.debug.timeline.change import UNLINKED, Change, MemoryPatch
from crs_cc.debug.timeline.chunk_store import ChunkStore
from crs_cc.debug.timeline.console import ConsolePosition
from crs_cc.debug.timeline.position import Position
from crs_cc.session.result import SessionSnapshot

MAX_BYTES: Final = 72 * 2**20
"""Memory for snapshots by default [bytes]; chosen by us."""

INTERVAL: Final = 10
"""Timesteps from one snapshot to the next, for one robot."""

ROBOTS_LATER: Final = 8
"""The interval grows by a timestep per this many robots: snapshots become costlier than steps."""

NEAR, FINER = 1, 10
"""The number of intervals before a revisited position, and the factor by which they are shorter."""

MAX_REPLAY_INTERVALS: Final = 64
"""The most intervals that are run through at once on the way back."""

_LEFT: Final = 7 / 8  # of the memory, after thinning
_ROUNDS: Final = 1e-3  # the weight of a round in timesteps, about


@dataclass(frozen=True, slots=True)
class RunSnapshot:
    """The state of a run: the session, and the position of its console."""

    session: SessionSnapshot
    console: ConsolePosition


_position: Final = attrgetter("position")


class History:
    """The snapshots of one run, and the user's changes.

    Attributes:
        changes: the changes, in their order.
        farthest: the latest position that the run has reached.
    """

    def __init__(self, most_bytes: int = MAX_BYTES, robots: int = 1) -> None:
        """Create an empty history; the first snapshot kept is the start.

        Args:
            most_bytes: the memory for snapshots, unless all are needed.
            robots: how many robots the run has.
        """
        self._more_bytes = most_bytes // 2
        self._interval = INTERVAL + robots // ROBOTS_LATER
        self._reach = MAX_REPLAY_INTERVALS * self._interval
        self._store = ChunkStore(most_bytes)
        self._positions: list[Position] = []
        self._snapshots: dict[Position, RunSnapshot] = {}
        self._edits: list[Position] = []
        self.changes: tuple[Change, ...] = ()
        self.farthest = Position(0, 0)
        self._start: RunSnapshot | None = None  # before any change there
        self._user: Position | None = None  # the last position that the user went back to
        self._here = Position(0, 0)

    @property
    def size(self) -> int:
        """Return the size of the snapshots [bytes]."""
        return self._store.size

    def __len__(self) -> int:
        return len(self._positions)

    def should_keep(self, position: Position) -> bool:
        """Return whether a snapshot of the start of a timestep is worth its cost."""
        number = bisect_right(self._positions, position)
        gap = position.timestep - self._positions[number - 1].timestep
        interval = self._interval
        if self._user is not None:
            ahead = self._user.timestep - position.timestep
            interval //= FINER if 0 <= ahead < NEAR * interval else 1
        return gap >= interval

    def keep(self, position: Position, snapshot: RunSnapshot) -> None:
        """Store a snapshot."""
        if position in self._snapshots:
            self._store.remove(self._snapshots[position])
        else:
            self._positions.insert(bisect_left(self._positions, position), position)
        self._snapshots[position] = self._store.add(snapshot)
        self._here = position
        if self.size > self._store.most_bytes:
            self._thin()

    def branch(self, change: Change, snapshot: RunSnapshot) -> None:
        """Store a change and the snapshot after it; discard all later ones."""
        position = change.position
        self.changes = (*self.changes_until(position), change)
        if self._start is None and position == self._positions[0]:
            self._start = self._store.add(self._snapshots[position])
        self._drop(position)
        self._edits.append(position)
        self.farthest = position
        self._user = None
        self.keep(position, snapshot)

    def revert(self, position: Position) -> None:
        """Discard the changes and snapshots from a position on."""
        self.changes = self.changes[: bisect_left(self.changes, position, key=_position)]
        first = self._positions[0]
        if position > first or self._start is not None:
            self._drop(position)
        else:  # nothing was changed there
            self._drop_from(1)
        if self._start is not None and position == first:
            self._positions.append(first)
            self._snapshots[first], self._start = self._start, None
        del self._edits[bisect_left(self._edits, position) :]
        self.farthest = position
        self._user = None

    def _drop(self, position: Position) -> None:
        """Discard the snapshots and edits from a position on."""
        self._drop_from(bisect_left(self._positions, position))
        del self._edits[bisect_left(self._edits, position) :]

    def _drop_from(self, first: int) -> None:
        """Discard the snapshots from a number on."""
        for each in self._positions[first:]:
            self._store.remove(self._snapshots.pop(each))
        del self._positions[first:]

    def fork(self, position: Position) -> History:
        """Return an independent history with the snapshots up to a position.

        Both share common data, and the limit is raised by half of the original one: the
        snapshots of the inactive one must not take all memory from the other.
        """
        other = copy.copy(self)
        self._store.most_bytes += self._more_bytes
        other._positions = self._positions[: bisect_right(self._positions, position)]
        other._edits = self._edits[: bisect_right(self._edits, position)]
        other.changes = self.changes_until(position)
        other.farthest = position
        other._snapshots = {
            each: self._store.add(self._snapshots[each]) for each in other._positions
        }
        if self._start is not None:
            other._start = self._store.add(self._start)
        return other

    def release(self) -> None:
        """Discard all snapshots of a history that is not needed any more."""
        self._drop(self._positions[0])
        if self._start is not None:
            self._store.remove(self._start)
        self._store.most_bytes -= self._more_bytes

    def changes_until(self, position: Position) -> tuple[Change, ...]:
        """Return the changes up to a position."""
        return self.changes[: bisect_right(self.changes, position, key=_position)]

    def unused_edits(self, robot: int, position: Position) -> list[MemoryPatch]:
        """Return the changes, up to a position, of objects that a robot's program does not use."""
        made = (each for each in self.changes if each.robot == robot and each.position <= position)
        patches = (patch for each in made for patch in each.patches)
        return [each for each in patches if each.address >= UNLINKED]

    def at(self, position: Position) -> RunSnapshot:
        """Return the snapshot at a position that has one."""
        snapshot = self._store.get(self._snapshots[position])
        assert isinstance(snapshot, RunSnapshot)
        return snapshot

    def latest(self) -> Position:
        """Return the latest position with a snapshot."""
        return self._positions[-1]

    def snapshots_before(self, before: Position) -> Sequence[Position]:
        """Return all earlier positions with snapshots, ascending."""
        return self._positions[: bisect_left(self._positions, before)]

    def last_before(self, position: Position) -> Position:
        """Return the position of the last snapshot before a position that is not the start."""
        return self._positions[bisect_left(self._positions, position) - 1]

    def visit(self, position: Position) -> None:
        """Record that the user is at or just before a position, not at the latest one."""
        self._user = self._here = position

    def before(self, position: Position) -> tuple[Position, RunSnapshot]:
        """Return the latest snapshot that is not later than a target position.

        Gaps before it are filled when the run gets there again.
        """
        found = self._positions[bisect_right(self._positions, position) - 1]
        self.visit(position)
        return found, self.at(found)

    def back_from(self, position: Position) -> Iterator[Position]:
        """Return the positions of earlier snapshots, the latest first, for a backward search.

        Near ones are returned one by one. Then more and more are left out, as a search for
        something far back is likely to go further still, and every interval has its cost.
        """
        place, reach = position, 0
        while number := bisect_left(self._positions, place):  # some may have been dropped meanwhile
            number -= 1
            while number and place.timestep - self._positions[number - 1].timestep <= reach:
                number -= 1
            place = self._positions[number]
            yield place
            reach = min(2 * reach + self._interval, self._reach)

    def next_edit(self, position: Position) -> Position | None:
        """Return the position of the user's next change after this position."""
        number = bisect_right(self._edits, position)
        return self._edits[number] if number < len(self._edits) else None

    def _thin(self) -> None:
        """Drop snapshots until the limit is met."""
        places = np.array([each.timestep + _ROUNDS * each.round for each in self._positions])
        here = self._here.timestep + _ROUNDS * self._here.round
        edits = set(self._edits)
        needed = np.array([each in edits for each in self._positions])
        needed[0] = True
        left = list(range(len(places)))
        fewest = len(left) // 2  # dropping data shared with other branches frees nothing
        while self.size > _LEFT * self._store.most_bytes and len(left) > fewest:
            at, free = places[left], ~needed[left]
            free[-1] = False
            if not free.any():
                break
            gaps = np.full(len(at), np.inf)
            gaps[1:-1] = (at[2:] - at[:-2]) / (1.0 + np.abs(at[1:-1] - here))
            gaps[~free] = np.inf
            gone = left.pop(int(gaps.argmin()))
            self._store.remove(self._snapshots.pop(self._positions[gone]))
        self._positions = [self._positions[number] for number in left]
