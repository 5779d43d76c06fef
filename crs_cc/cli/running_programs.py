"""The current locations of programs that have not ended: function and line.

For a program that hangs in a loop, they show where, and since when it has not called its robot.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

from crs_cc.cli.messages import printable

if TYPE_CHECKING:
    from crs_cc.cli.summary import Run
    from crs_cc.runtime.diagnosis.active_call import ActiveCall
    from crs_cc.session.result import RobotResult

LONG_S: Final = 5.0
"""A program that has not called its robot for longer than this may hang."""

MOST_NAMES: Final = 3
MOST_LINES: Final = 5


def running_programs(run: Run) -> Iterator[str]:
    """Yield a line for each of the first few locations."""
    alike: dict[tuple[str, str], list[RobotResult]] = {}
    for robot, call in zip(run.result.robots, run.calls, strict=True):
        if call is not None:
            last_call = _last_call(robot)
            alike.setdefault((_place(call, alone=len(run.calls) == 1), last_call), []).append(robot)
    for (place, last_call), robots in list(alike.items())[:MOST_LINES]:
        verb = "is" if len(robots) == 1 else "are"
        yield f"{_names(robots)} {verb} {place}{last_call}"
    if len(alike) > MOST_LINES:
        yield f"... and {len(alike) - MOST_LINES} more places"


def _place(call: ActiveCall, *, alone: bool) -> str:
    """Return the location of a program, with the call's arguments if it is the only one."""
    text = str(call) if alone else f"{call.function}()"
    return f"in {printable(text)} at {printable(str(call.location))}"


def _last_call(robot: RobotResult) -> str:
    if robot.robot_call_s is None:
        return ", no robot call so far" if robot.time_s > LONG_S else ""
    if robot.time_s - robot.robot_call_s > LONG_S:
        return f", no robot call since {robot.robot_call_s:.2f} s"
    return ""


def _names(robots: list[RobotResult]) -> str:
    names = [printable(robot.id) for robot in robots[:MOST_NAMES]]
    more = len(robots) - len(names)
    return ", ".join(names) + (f" and {more} more" if more else "")
