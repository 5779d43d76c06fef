"""Stops of a run, and their reasons."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final, Literal

from crs_cc.debug.data.values import Value
from crs_cc.debug.timeline.position import Position

Reason = Literal[
    "start", "step", "breakpoint", "watchpoint", "catchpoint", "error", "exit", "end", "goto",
    "beginning", "interrupt", "tick",
]  # fmt: skip
"""`exit` is the end of one program, `end` that of the last one; `beginning` is met backward."""

WORDS: Final[dict[Reason, str]] = {
    "start": "the run is at its start",
    "beginning": "the run is at its start: no earlier history",
    "interrupt": "interrupted",
    "tick": "end of timestep",
    "exit": "the program has ended",
    "end": "all programs have ended",
}
"""What all screens say of reasons that need words, and of which nothing more is known."""


@dataclass(frozen=True, slots=True)
class Stop:
    """A stop of a run.

    Attributes:
        position: the position in the run.
        time_s: the clock of the program that stopped, or else of the world [s].
        robot: the robot whose program it is; -1 for none.
        breakpoints: the numbers of the breakpoints, watchpoints and catchpoints that it hit.
        text: a description; empty if the reason needs none.
        function: the function that it is about, by the linker's name; empty for the
            innermost.
        returned: the value that a finished function has returned.
    """

    reason: Reason
    position: Position
    time_s: float
    robot: int = -1
    breakpoints: tuple[int, ...] = ()
    text: str = ""
    function: str = ""
    returned: Value | None = field(default=None, compare=False, repr=False)

    @property
    def why(self) -> str:
        """The reason in a line; empty for a completed step."""
        if self.text:
            return self.text.partition("\n")[0]
        if self.breakpoints:
            return f"{self.reason} {', '.join(map(str, self.breakpoints))}"
        return "" if self.reason in {"step", "goto"} else WORDS.get(self.reason, self.reason)
