"""Questions about the past, answered as data: why a value is what it is, histories, instants.

Each instant has its place in the run, as text, so that a page can go to exactly there (`go`). The
run is where it was after a question.
"""

from __future__ import annotations

import math
import re
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Final

from crs_cc.debug.errors import DebugError
from crs_cc.debug.past import Instant, Past, Range
from crs_cc.debug.why import Why
from crs_cc.workbench.positions import position_of, position_text

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from crs_cc.debug.cause import Beam, Cause
    from crs_cc.debug.engine import Debugger
    from crs_cc.workbench.context import Context

MAX_INSTANTS: Final = 2000
"""In an answer; of more, the first, the least and the greatest of each part are kept."""

_AT: Final = re.compile(r"^(?P<expression>.+?)\s+at\s+(?P<place>\S+)$")
_MAX_TEXT: Final = 120  # characters of a value that are shown

Row = tuple[float, float | None, str, str, int]
"""Time [s], value if it is a number, text, place, and robot or -1."""


def go_to(screen: Context, place: str, robot: int) -> None:
    """Go to a place in the run and select a robot; -1 for the one that is selected."""
    debugger = screen.run.shell().debugger
    position = position_of(debugger, place)
    screen.player.pause()
    with screen.working():
        if 0 <= robot < len(debugger.names):
            screen.run.select(robot)
        debugger.goto(position)
    if 0 <= robot < len(debugger.names):
        screen.run.select(robot)
        screen.robot = robot


def why(screen: Context, expression: str) -> dict[str, Any]:
    """Return where the value of an expression came from, as a tree."""
    with _query(screen) as debugger:
        cause = Why(debugger.view, debugger.navigator).explain(_single_expression(expression))
        return _node(debugger, cause)


def changes(
    screen: Context, *, robot: int, expression: str, begin_s: float, end_s: float
) -> dict[str, Any]:
    """Return the values that an expression has had between two times: the first, and each change.

    `EXPRESSION at LINE` has its values whenever the program was at that line.

    Raises:
        DebugError: it cannot be watched, or the run is not stopped.
    """
    if screen.player.is_playing:
        raise DebugError("the run is not paused: pause it first")
    if not 0.0 <= begin_s <= end_s:
        raise DebugError("the span must begin at 0 or later, and end after that")
    text = _single_expression(expression)
    with _query(screen, robot, until_s=end_s) as debugger:
        past = Past(debugger.view, debugger.stop_points)
        part = past.part(begin_s, end_s)
        found = _AT.match(text)
        if found is None:
            rows = past.values(text, part)
        else:
            place = debugger.stop_points.location(found["place"], robot)
            rows = past.values_at(place, found["expression"], part)
            if rows and all(each.text.startswith("<") for each in rows):
                raise DebugError(rows[0].text.strip("<>"))
        return {"rows": thinned_rows([_row(each) for each in rows]), "is_at": found is not None}


def when(screen: Context, condition: str) -> list[Row]:
    """Return when a condition became true, in all that is known of the run."""
    text = _single_expression(condition)

    def times(past: Past, whole: Range) -> Sequence[Instant]:
        return past.times(text, whole)

    return [(at, number, text, place, robot)
            for at, number, _, place, robot in _found(screen, times)]  # fmt: skip


def log_messages(screen: Context, file: str, line: int, text: str) -> list[Row]:
    """Return the messages of a log point at a line in the known part of the run."""
    wanted = _single_expression(text)

    def messages(past: Past, whole: Range) -> Sequence[Instant]:
        place = screen.run.debugger().stop_points.location(f"{file}:{line}")
        return past.messages(place, wanted, whole)

    return _found(screen, messages)


def hits(screen: Context, number: int) -> list[Row]:
    """Return when a breakpoint was or would have been hit, in all that is known of the run."""

    def found(past: Past, whole: Range) -> Sequence[Instant]:
        debugger = screen.run.debugger()
        wanted = next((each for each in debugger.stop_points.breakpoints
                       if each.number == number), None)  # fmt: skip
        if wanted is None:
            raise DebugError(f"no breakpoint {number}")
        return past.hits(wanted, whole)

    return _found(screen, found)


def _found(screen: Context, ask: Callable[[Past, Range], Sequence[Instant]]) -> list[Row]:
    """Return the results in the known part of the run; the first ones if there are too many."""
    screen.player.pause()
    with _query(screen, until_s=screen.feed.end_s) as debugger:
        past = Past(debugger.view, debugger.stop_points)
        return [_row(each) for each in ask(past, past.whole())[:MAX_INSTANTS]]


@contextmanager
def _query(screen: Context, robot: int = -1, until_s: float = 0.0) -> Iterator[Debugger]:
    """Yield the debugger for a query about the past, and restore the position after it.

    Args:
        screen: the screen.
        robot: the robot whose program is asked; -1 for the selected one.
        until_s: up to when the run must have been.
    """
    debugger = screen.run.shell().debugger
    if not -1 <= robot < len(debugger.names):
        raise DebugError(f"no robot {robot}")
    if robot < 0:
        screen.player.pause()
    here, stop, view = debugger.position, debugger.stop, debugger.view
    looked_at = view.robot, view.frame
    timestep = round(until_s / debugger.session.environment.timestep_s)
    with screen.working():
        try:
            if Past(view, debugger.stop_points).whole().end.timestep < timestep:
                debugger.goto_timestep(timestep)
                debugger.goto(here)
            if 0 <= robot != view.robot:
                view.select_robot(robot)
            yield debugger
        finally:
            if debugger.position != here:
                debugger.goto(here)
            debugger.stop, (view.robot, view.frame) = stop, looked_at


def thinned_rows(rows: list[Row]) -> list[Row]:
    """Return rows, of too many the first, the least and the greatest of each part.

    >>> rows = [(float(at), at % 7 - 3.0, "", "", 0) for at in range(9000)]
    >>> thinned = thinned_rows(rows)
    >>> len(thinned) <= MAX_INSTANTS, thinned[0] == rows[0], thinned_rows(rows[:5]) == rows[:5]
    (True, True, True)
    """
    if len(rows) <= MAX_INSTANTS:
        return rows
    size = math.ceil(3 * len(rows) / MAX_INSTANTS)
    chosen = set[int]()
    for start in range(0, len(rows), size):
        part = range(start, min(start + size, len(rows)))
        numbers = {each: number for each in part if (number := rows[each][1]) is not None}
        chosen.add(start)
        if numbers:
            chosen |= {min(numbers, key=numbers.__getitem__), max(numbers, key=numbers.__getitem__)}
    return [rows[each] for each in sorted(chosen)]


def _row(each: Instant) -> Row:
    number = None if each.number is None or not math.isfinite(each.number) else each.number
    text = each.text[:_MAX_TEXT]
    return round(each.time_s, 6), number, text, position_text(each.position), each.robot


def _node(debugger: Debugger, cause: Cause) -> dict[str, Any]:
    """Return a node of a why-tree and those below it."""
    place, at = cause.location, cause.position
    timestep_s = debugger.session.environment.timestep_s
    time_s = cause.time_s if at is None or cause.time_s > 0.0 else at.timestep * timestep_s
    return {
        "text": cause.text,
        "how": cause.how,
        "expression": cause.expression,
        "t": time_s,
        "place": "" if at is None else position_text(at),
        "robot": cause.robot,
        "file": place.file if place else "",
        "line": place.line if place else 0,
        "beam": None if cause.beam is None else _beam(cause.beam),
        "causes": [_node(debugger, each) for each in cause.causes],
    }


def _beam(beam: Beam) -> dict[str, Any]:
    echo_m = beam.echo_m if math.isfinite(beam.echo_m) else None
    return {"sonar": beam.sonar, "echo": echo_m, "met": beam.met}


def _single_expression(text: str) -> str:
    """Return an expression without space around it; raise DebugError if it has several lines."""
    text = text.strip()
    if not text or "\n" in text:
        raise DebugError("an expression is missing" if not text else "one line at a time")
    return text
