"""The conditions that end stepping: those of `step`, `next`, `finish` and `until`.

A program steps from line to line. Statements that follow each other in one line of one call belong
together until one of them is repeated: then the line starts again.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Protocol

from crs_cc.core.source import Location
from crs_cc.runtime.diagnosis.inspect import StackFrame


@dataclass(frozen=True, slots=True)
class ProgramPoint:
    """A site at which a program has stopped, and its activation.

    Attributes:
        function: the innermost active function.
        fp: the address of its frame; those of its callers are higher.
        entered: how many sites had been passed when it was called, which distinguishes calls
            whose frames have the same address.
        site: the number of the site.
        location: the location of the statement or the call.
        statements: how many sites have been passed.
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
        frames: the addresses of the frames, and how many sites had been passed at the call;
            -1 if that is unknown, as in a function that has failed.
    """

    functions: frozenset[str]
    frames: frozenset[tuple[int, int]]

    @classmethod
    def of(cls, stack: Iterable[StackFrame]) -> ActiveCalls:
        """Return the calls of some frames."""
        rows = [(each.function, (each.fp, each.entered)) for each in stack]
        return cls(frozenset(name for name, _ in rows), frozenset(frame for _, frame in rows))

    def include(self, program_point: ProgramPoint) -> bool:
        """Return whether a statement belongs to one of them."""
        frame = program_point.fp
        return not self.frames.isdisjoint({(frame, program_point.entered), (frame, -1)})


class StepCondition(Protocol):
    """The condition that ends a step of one robot's program.

    Attributes:
        calls: the calls in which it may be met; None for all.
        after_calls: whether it may be met behind a call, in the middle of a statement of those.
        by_lines: whether it steps by lines, and so not into what the user skips.
    """

    robot: int
    calls: ActiveCalls | None
    after_calls: bool
    by_lines: bool

    def reached(self, program_point: ProgramPoint) -> bool:
        """Return whether a step ends at a statement; called for each in turn."""


@dataclass(slots=True)
class StepToStatement:
    """The next statement, whatever its line: of any call, or of some."""

    robot: int
    calls: ActiveCalls | None = None
    after_calls: bool = False
    by_lines: bool = False

    def reached(self, program_point: ProgramPoint) -> bool:
        """Return whether it is in one of the calls."""
        return self.calls is None or self.calls.include(program_point)


@dataclass(slots=True)
class StepToLine:
    """The next line: of any call for `step`; for `next` of this call, or of a caller.

    Attributes:
        start: the start of the step; None if it was not before a statement of the user's.
        onward: whether only lines further down count within the call.
    """

    robot: int
    start: ProgramPoint | None
    calls: ActiveCalls | None = None
    onward: bool = False
    after_calls: bool = False
    by_lines: bool = True
    _seen: set[int] = field(default_factory=set)

    def __post_init__(self) -> None:
        if self.start is not None:
            self._seen.add(self.start.site)

    def reached(self, program_point: ProgramPoint) -> bool:
        """Return whether a new line starts."""
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


class ReverseStepCondition:
    """The target of a backward step of one robot's program: the first of consecutive statements.

    Attributes:
        calls: the calls in which they may be; None for all.
        after_calls: whether a place behind one of their calls counts, too.
        by_lines: whether it steps by lines.
    """

    def __init__(
        self,
        robot: int,
        calls: ActiveCalls | None = None,
        *,
        whole_line: bool = True,
        after_calls: bool = False,
    ) -> None:
        """Store the robot, the calls that count, and whether to step by lines."""
        self.robot = robot
        self.calls = calls
        self.after_calls = after_calls
        self.by_lines = whole_line
        self._last: ProgramPoint | None = None
        self._seen: set[int] = set()

    def belongs(self, program_point: ProgramPoint) -> bool:
        """Return whether a statement counts."""
        return self.calls is None or self.calls.include(program_point)

    def can_advance(self, program_point: ProgramPoint) -> bool:
        """Return whether a statement belongs to the target, from the last one backward."""
        if self._last is None:
            self._last = program_point
        elif (
            not (self.by_lines and self._last.shares_line(program_point))
            or program_point.site in self._seen
        ):
            return False
        self._seen.add(program_point.site)
        return True
