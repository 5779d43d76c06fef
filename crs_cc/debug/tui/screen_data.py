"""What the panes show of a stopped run, as plain data; `build_snapshot` makes it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final, Literal

from rich.text import Text

from crs_cc.debug.world.events import WorldEvent

Key = tuple[str, ...]
"""Names a row of the variables for good: robot, function, and the way to it through the values."""

Badge = Literal["stopped", "over", "error"]
"""How a run stands: something runs on, nothing is left, the program was stopped by an error."""

OPEN: Final[frozenset[Key]] = frozenset({("locals",), ("watched",)})
"""The groups of variables that are unfolded at first."""


@dataclass(frozen=True, slots=True)
class BreakpointMark:
    """A breakpoint at a line: its number, and whether it is enabled."""

    number: int
    enabled: bool = True


@dataclass(frozen=True, slots=True)
class SourceData:
    """A file and where the run stands in it.

    Attributes:
        file: its name, for the title and for places like `wander.c:12`.
        lines: its text.
        line: where the frame that is looked at stands, from 1; 0 when it is in another file.
        innermost: the run itself stands there, not only a caller.
        breakpoints: by line, the one that is there.
        files: all files of the program.
    """

    file: str = ""
    lines: Sequence[str] = ()
    line: int = 0
    innermost: bool = True
    breakpoints: Mapping[int, BreakpointMark] = field(default_factory=dict)
    files: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class ValueRow:
    """A value with a name, which may have parts.

    Attributes:
        key: what it is, the same at each stop.
        name: what to call it.
        text: the value.
        has_parts: whether it can be unfolded.
        parts: its parts, as far as they are unfolded.
    """

    key: Key
    name: str
    text: str = ""
    has_parts: bool = False
    parts: tuple[ValueRow, ...] = ()


@dataclass(frozen=True, slots=True)
class ListEntry:
    """A row of the stack or of the robots: what it says and whether it is the one looked at."""

    number: int
    text: str
    place: str = ""
    is_current: bool = False


@dataclass(frozen=True, slots=True)
class OutputLine:
    """A line that a program wrote: who, where there are several, what, and whether to `stderr`."""

    who: str
    text: str
    is_error: bool = False


@dataclass(frozen=True, slots=True)
class ScreenData:
    """All that the screen shows.

    Attributes:
        state: why it stopped, in one line.
        badge: how it stands, in a word.
        time_s: the simulated time [s] of where it stands.
        end_s: the latest time [s] that the run has reached.
        place: where it stands, in counts of timesteps and statements.
        source: the file to show.
        frames: the stack, innermost first.
        robots: who there is.
        variables: groups of values: the frame's, what is watched, the program's.
        chart: the world from above.
        output: the last lines that the programs have written so far.
        events: what happened, in the order of time.
    """

    state: str = ""
    badge: Badge = "stopped"
    time_s: float = 0.0
    end_s: float = 0.0
    place: str = ""
    source: SourceData = SourceData()
    frames: tuple[ListEntry, ...] = ()
    robots: tuple[ListEntry, ...] = ()
    variables: tuple[ValueRow, ...] = ()
    chart: Text = field(default_factory=Text)
    output: tuple[OutputLine, ...] = ()
    events: tuple[WorldEvent, ...] = ()
