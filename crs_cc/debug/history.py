"""Snapshots of a run by their instants."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from crs_cc.debug.position import Position

if TYPE_CHECKING:
    from crs_cc.debug.console import ConsolePlace
    from crs_cc.session.result import SessionSnapshot

_EVERY: Final = 10
"""A snapshot every so many timesteps; chosen by us."""


@dataclass(frozen=True, slots=True)
class Kept:
    """A whole run: the session, and what had been written and read."""

    session: SessionSnapshot
    console: ConsolePlace


class History:
    """The snapshots of one run, and where the user has changed it."""

    def __init__(self) -> None:
        self._positions: list[Position] = []
        self._kept: dict[Position, Kept] = {}
        self._edits: list[Position] = []

    def wants(self, position: Position) -> bool:
        """Tells whether a snapshot of the start of a timestep is worth its cost."""
        return position.timestep % _EVERY == 0 and position not in self._kept

    def keep(self, position: Position, kept: Kept) -> None:
        """Takes a snapshot."""
        if position not in self._kept:
            self._positions.insert(bisect_left(self._positions, position), position)
        self._kept[position] = kept

    def branch(self, position: Position, kept: Kept) -> None:
        """Takes the snapshot behind a change: all that was later is no longer so."""
        for each in self._positions[bisect_left(self._positions, position) :]:
            del self._kept[each]
        del self._positions[bisect_left(self._positions, position) :]
        self._edits[:] = [each for each in self._edits if each < position] + [position]
        self.keep(position, kept)

    def at(self, position: Position) -> Kept:
        """Gives the snapshot of an instant of which there is one."""
        return self._kept[position]

    def latest(self) -> Position:
        """Gives the latest instant of which there is a snapshot."""
        return self._positions[-1]

    def before(self, position: Position) -> tuple[Position, Kept]:
        """Gives the latest snapshot that is not later than an instant."""
        found = self._positions[bisect_right(self._positions, position) - 1]
        return found, self._kept[found]

    def back_from(self, position: Position) -> Iterator[Position]:
        """Gives the instants before this one of which there are snapshots, the latest first."""
        yield from reversed(self._positions[: bisect_left(self._positions, position)])

    def next_edit(self, position: Position) -> Position | None:
        """Gives the next instant behind this one at which the user has changed something."""
        number = bisect_right(self._edits, position)
        return self._edits[number] if number < len(self._edits) else None
