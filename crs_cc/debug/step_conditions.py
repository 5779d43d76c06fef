"""Where stepping ends: what `step`, `next`, `finish` and `until` wait for.

A program steps from line to line. Statements that follow each other in one line of one call belong
together, until one of them comes again: then the line begins anew.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Protocol

from crs_cc.core.source import Location

if TYPE_CHECKING:
    from crs_cc.runtime.diagnosis.inspect import StackFrame


@dataclass(frozen=True, slots=True)
class ProgramPoint:
    """Where a program stands that has stopped before a statement.

    Attributes:
        function: the innermost active function.
        fp: the address of its frame; those of its callers are higher.
        entered: how many statements had begun when it was called; so it is told from other calls
            that have their frame at the same place.
        site: the number of the statement.
        location: the place of the statement.
        statements: how many statements have begun.
    """

    function: str
    fp: int
    entered: int
    site: int
    location: Location
    statements: int

    def shares_line(self, other: ProgramPoint) -> bool:
        """Return whether both are in the same line of the same call."""
        mine, theirs = self.location, other.location
        here = (self.fp, self.entered, mine.file, mine.line)
        return here == (other.fp, other.entered, theirs.file, theirs.line)


@dataclass(frozen=True, slots=True)
class ActiveCalls:
    """Some active calls of a program's functions.

    Attributes:
        functions: the functions.
        frames: the addresses of the frames, and how many statements had begun when it was called;
            -1 where that is not known, as in a function that has failed.
    """

    functions: frozenset[str]
    frames: frozenset[tuple[int, int]]

    @classmethod
    def of(cls, stack: Iterable[StackFrame]) -> ActiveCalls:
        """Return those of some frames."""
        rows = [(each.function, (each.fp, each.entered)) for each in stack]
        return cls(frozenset(name for name, _ in rows), frozenset(frame for _, frame in rows))

    def include(self, program_point: ProgramPoint) -> bool:
        """Return whether a statement belongs to one of them."""
        return (program_point.fp, program_point.entered) in self.frames or (
            program_point.fp,
            -1,
        ) in self.frames


class StepCondition(Protocol):
    """What one robot's program is to come to.

    Attributes:
        robot: the robot.
        calls: the calls of functions in which it may be; None for all.
    """

    robot: int
    calls: ActiveCalls | None

    def reached(self, program_point: ProgramPoint) -> bool:
        """Return of one statement after the other whether it is what was wanted."""


@dataclass(slots=True)
class StepToStatement:
    """The next statement, whatever its line."""

    robot: int
    calls: ActiveCalls | None = None

    def reached(self, program_point: ProgramPoint) -> bool:
        """Report that it is."""
        return program_point is not None


@dataclass(slots=True)
class StepToLine:
    """The next line: of any call for `step`; for `next` of this call, or of a caller.

    Attributes:
        start: where the program stood; None when it was not before a statement of the user's.
        onward: within the call, only what stands further down in the source counts.
    """

    robot: int
    start: ProgramPoint | None
    calls: ActiveCalls | None = None
    onward: bool = False
    _seen: set[int] = field(default_factory=set)

    def __post_init__(self) -> None:
        if self.start is not None:
            self._seen.add(self.start.site)

    def reached(self, program_point: ProgramPoint) -> bool:
        """Return whether a new line begins."""
        start = self.start
        if self.calls is not None and not self.calls.include(program_point):
            return False
        if start is None:
            return True
        if self.onward and (program_point.fp, program_point.entered) == (start.fp, start.entered):
            return program_point.location.line > start.location.line
        if start.shares_line(program_point) and program_point.site not in self._seen:
            self._seen.add(program_point.site)
            return False
        return True


@dataclass(slots=True)
class StepToCaller:
    """The next statement of a caller."""

    robot: int
    calls: ActiveCalls | None

    def reached(self, program_point: ProgramPoint) -> bool:
        """Return whether the call has ended."""
        return self.calls is None or self.calls.include(program_point)


class ReverseStepCondition:
    """What one robot's program is to go back to: the first of some statements in a row.

    Attributes:
        robot: the robot.
        calls: the calls of functions in which they may be; None for all.
    """

    def __init__(
        self, robot: int, calls: ActiveCalls | None = None, *, whole_line: bool = True
    ) -> None:
        """Take whose program it is, the calls that count, and whether lines count."""
        self.robot = robot
        self.calls = calls
        self._whole_line = whole_line
        self._last: ProgramPoint | None = None
        self._seen: set[int] = set()

    def belongs(self, program_point: ProgramPoint) -> bool:
        """Return whether a statement counts."""
        return self.calls is None or self.calls.include(program_point)

    def can_advance(self, program_point: ProgramPoint) -> bool:
        """Return whether a statement belongs to those that are wanted, from the last one back."""
        if self._last is None:
            self._last = program_point
        elif (
            not (self._whole_line and self._last.shares_line(program_point))
            or program_point.site in self._seen
        ):
            return False
        self._seen.add(program_point.site)
        return True
