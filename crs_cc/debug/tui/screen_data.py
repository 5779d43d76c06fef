"""The contents of the panes for a stopped run, as plain data; `build_snapshot` makes it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final, Literal

from rich.text import Text

from crs_cc.debug.world.events import WorldEvent

Key = tuple[str, ...]
"""Names a row of the variables for good: robot, function, and the way to it through the values."""

Badge = Literal["stopped", "over", "error"]
"""The state of a run: it can continue, it has ended, the program was stopped by an error."""

OPEN: Final[frozenset[Key]] = frozenset({("locals",), ("watched",)})
"""The groups of variables that are unfolded at first."""


@dataclass(frozen=True, slots=True)
class BreakpointMark:
    """A breakpoint at a line: its number, and whether it is enabled."""

    number: int
    enabled: bool = True


@dataclass(frozen=True, slots=True)
class SourceData:
    """A source file and the current line in it.

    Attributes:
        file: its name, for the title and for locations like `wander.c:12`.
        lines: its text.
        line: the current line of the selected frame, from 1; 0 if it is in another file.
        innermost: whether it belongs to the innermost frame.
        breakpoints: the breakpoints by line.
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
    """A named value, maybe with parts.

    Attributes:
        key: its identity across stops.
        text: the value.
        has_parts: whether it can be expanded.
        parts: its parts, as far as they are expanded.
    """

    key: Key
    name: str
    text: str = ""
    has_parts: bool = False
    parts: tuple[ValueRow, ...] = ()


@dataclass(frozen=True, slots=True)
class ListEntry:
    """An entry of the stack or of the robots: its text and whether it is selected."""

    number: int
    text: str
    place: str = ""
    is_current: bool = False


@dataclass(frozen=True, slots=True)
class OutputLine:
    """A line of output.

    Attributes:
        writer: the robot, if there are several.
        text: its text.
        is_error: whether it is from `stderr`.
        number: its number in the output of all robots, from 1; 0 while a command runs.
    """

    writer: str
    text: str
    is_error: bool = False
    number: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True)
class ScreenData:
    """The data that the screen shows.

    Attributes:
        state: the reason of the stop, in one line.
        badge: the state in a word.
        time_s: the clock of the selected robot's program [s].
        now_s: the start of the current timestep [s].
        end_s: the latest time [s] that the run has reached.
        timestep_s: the length of a timestep [s].
        place: the position, in counts of timesteps and statements.
        source: the file to show.
        frames: the stack, innermost first.
        variables: groups of values: locals, displays, globals and others.
        world_map: the map.
        output: the last lines of output.
        events: the events, by time.
    """

    state: str = ""
    badge: Badge = "stopped"
    time_s: float = 0.0
    now_s: float = 0.0
    end_s: float = 0.0
    timestep_s: float = 0.1
    place: str = ""
    source: SourceData = SourceData()
    frames: tuple[ListEntry, ...] = ()
    robots: tuple[ListEntry, ...] = ()
    variables: tuple[ValueRow, ...] = ()
    world_map: Text = field(default_factory=Text)
    output: tuple[OutputLine, ...] = ()
    events: tuple[WorldEvent, ...] = ()
