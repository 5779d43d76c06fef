"""Why a run has stopped."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from crs_cc.debug.timeline.position import Position

Reason = Literal[
    "start", "step", "breakpoint", "watchpoint", "catchpoint", "error", "exit", "end", "goto",
    "beginning", "interrupt", "tick",
]  # fmt: skip
"""`exit` is the end of one program, `end` that of the last one; `beginning` is met backward."""


@dataclass(frozen=True, slots=True)
class Stop:
    """A run that has stopped.

    Attributes:
        reason: why.
        position: where in the run.
        time_s: the clock of the program that stopped, or else of the world [s].
        robot: whose program it is; -1 for none.
        breakpoints: the numbers of the breakpoints, watchpoints and catchpoints that it hit.
        text: what happened, in a sentence for people; empty where the reason says it all.
        function: the active function that it is about, by the linker's name; empty for the
            innermost.
    """

    reason: Reason
    position: Position
    time_s: float
    robot: int = -1
    breakpoints: tuple[int, ...] = ()
    text: str = ""
    function: str = ""
