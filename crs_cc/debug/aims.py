"""Where stepping ends: what `step`, `next`, `finish` and `until` wait for.

A program steps from line to line. Statements that follow each other in one line of one call belong
together, until one of them comes again: then the line begins anew.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Protocol

from crs_cc.source import Location


@dataclass(frozen=True, slots=True)
class Spot:
    """Where a program stands that has stopped before a statement.

    Attributes:
        function: the innermost active function.
        fp: the address of its frame; those of its callers are higher.
        site: the number of the statement.
        location: the place of the statement.
        statements: how many statements have begun.
    """

    function: str
    fp: int
    site: int
    location: Location
    statements: int

    def shares_line(self, other: Spot) -> bool:
        """Tells whether both are in the same line of the same call."""
        mine, theirs = self.location, other.location
        here = (self.fp, self.function, mine.file, mine.line)
        return here == (other.fp, other.function, theirs.file, theirs.line)


class Aim(Protocol):
    """What one robot's program is to come to.

    Attributes:
        robot: the robot.
        functions: the functions in which it may be; None for all.
    """

    robot: int
    functions: frozenset[str] | None

    def reached(self, spot: Spot) -> bool:
        """Tells of one statement after the other whether it is what was wanted."""


@dataclass(slots=True)
class ToStatement:
    """The next statement, whatever its line."""

    robot: int
    functions: frozenset[str] | None = None

    def reached(self, spot: Spot) -> bool:
        """Tells that it is."""
        return spot is not None


@dataclass(slots=True)
class ToLine:
    """The next line: of any call for `step`; for `next` of this call, or of a caller.

    Attributes:
        start: where the program stood; None when it was not before a statement of the user's.
        lowest_fp: calls with a lower frame are passed over.
        onward: within the call, only what stands further down in the source counts.
    """

    robot: int
    start: Spot | None
    functions: frozenset[str] | None = None
    lowest_fp: int = 0
    onward: bool = False
    _seen: set[int] = field(default_factory=set)

    def __post_init__(self) -> None:
        if self.start is not None:
            self._seen.add(self.start.site)

    def reached(self, spot: Spot) -> bool:
        """Tells whether a new line begins."""
        start = self.start
        if spot.fp < self.lowest_fp:
            return False
        if start is None:
            return True
        if self.onward and (spot.fp, spot.function) == (start.fp, start.function):
            return spot.location.line > start.location.line
        if start.shares_line(spot) and spot.site not in self._seen:
            self._seen.add(spot.site)
            return False
        return True


@dataclass(slots=True)
class ToCaller:
    """The next statement of a caller."""

    robot: int
    functions: frozenset[str] | None
    fp: int

    def reached(self, spot: Spot) -> bool:
        """Tells whether the call has ended."""
        return spot.fp > self.fp


class BackAim:
    """What one robot's program is to go back to: the first of some statements in a row.

    Attributes:
        robot: the robot.
        functions: the functions in which they may be; None for all.
    """

    def __init__(
        self,
        robot: int,
        functions: frozenset[str] | None = None,
        *,
        lowest_fp: int = 0,
        whole_line: bool = True,
    ) -> None:
        """Takes whose program it is, the lowest frame that counts, and whether lines count."""
        self.robot = robot
        self.functions = functions
        self._lowest_fp = lowest_fp
        self._whole_line = whole_line
        self._last: Spot | None = None
        self._seen: set[int] = set()

    def belongs(self, spot: Spot) -> bool:
        """Tells whether a statement counts."""
        return spot.fp >= self._lowest_fp

    def goes_on(self, spot: Spot) -> bool:
        """Tells whether a statement belongs to those that are wanted, from the last one back."""
        if self._last is None:
            self._last = spot
        elif not (self._whole_line and self._last.shares_line(spot)) or spot.site in self._seen:
            return False
        self._seen.add(spot.site)
        return True
