"""Nodes of the why-tree, which shows where a value came from."""

from __future__ import annotations

from dataclasses import dataclass

from crs_cc.core.source import Location
from crs_cc.debug.timeline.position import Position


@dataclass(frozen=True, slots=True)
class Beam:
    """The beam of a sonar that a reading is from.

    Attributes:
        sonar: the number of the sonar.
        echo_m: the distance of its echo, infinite for none.
        met: the object that it met; empty if none was there.
    """

    sonar: int
    echo_m: float
    met: str


@dataclass(frozen=True, slots=True)
class Cause:
    """A node of the tree.

    Attributes:
        text: what it is about: `speed = 40`; or a fact about its parent.
        how: the source of the statement that did it, or what else did; empty for a fact.
        position: where to go to see it; None for nowhere.
        time_s: the clock of the robot's program then [s].
        robot: the robot.
        location: the location of the statement, if there is one.
        causes: what it was computed from.
        expression: the expression whose value it is; empty for a fact.
        beam: the beam that a reading is from, if it is of a sonar.
        times: the number of writes that it represents, in each of which the object depended on
            itself. The value is that after the last of them; position and causes are those of the
            first.
        function: the function of the statement, by the linker's name; empty for the innermost.
    """

    text: str
    how: str = ""
    position: Position | None = None
    time_s: float = 0.0
    robot: int = -1
    location: Location | None = None
    causes: tuple[Cause, ...] = ()
    expression: str = ""
    beam: Beam | None = None
    times: int = 1
    function: str = ""
