"""Commands that find writes in the recorded past: `last`, `next`, `why`."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import PurePath
from typing import Final

from crs_cc.debug.cause import Cause
from crs_cc.debug.commands.answer import Answer, Line
from crs_cc.debug.commands.arguments import require_argument
from crs_cc.debug.commands.command import Command, Group
from crs_cc.debug.commands.context import CommandContext, ListedInstant
from crs_cc.debug.errors import DebugError
from crs_cc.debug.navigator import Navigator
from crs_cc.debug.stop import Stop
from crs_cc.debug.stop_points import StopPoints
from crs_cc.debug.why import Why

_WIDTH: Final = 60
_NUMBER: Final = 5
_HANGING: Final = 4
"""Columns: of the number of an instant, and more for what continues in the next line."""


def go_to_write(context: CommandContext, expression: str, *, backward: bool) -> Answer:
    """Go to the last write of an object, or to the next one; breakpoints do not count.

    Raises:
        DebugError: it is not written, or the expression names no object.
    """
    debugger = context.debugger
    here = debugger.position
    points = StopPoints(debugger.view)
    points.add_watchpoint(require_argument(expression, "an expression"), "write", location=True)
    navigator = Navigator(debugger.run, points)
    stop = navigator.backward() if backward else navigator.forward()
    if not stop.breakpoints:
        debugger.run.seek(here)
        if stop.reason == "interrupt":
            raise DebugError("interrupted")
        raise DebugError(f"'{expression}' was not written before" if backward else _NOT_AGAIN)
    yield Line(stop.text, "stop")
    yield from context.move(partial(_arrived, context, stop))


def _arrived(context: CommandContext, stop: Stop) -> Stop:
    """Select the program and the function that a write is about."""
    debugger = context.debugger
    arrived = debugger.goto(stop.position)
    debugger.view.select_function(stop.function)
    return replace(arrived, robot=stop.robot)


_NOT_AGAIN: Final = "it is not written again"


def _last(context: CommandContext, text: str) -> Answer:
    return go_to_write(context, text, backward=True)


def _why(context: CommandContext, text: str) -> Answer:
    debugger = context.debugger
    cause = Why(debugger.view, debugger.navigator).explain(require_argument(text, "an expression"))
    context.instants = []
    yield from _rows(context, cause, 0)


def _rows(context: CommandContext, cause: Cause, depth: int) -> Iterator[Line]:
    """Yield a node and those below it, and number them."""
    number = ""
    if cause.position is not None:
        context.instants.append(ListedInstant(cause.position, cause.robot, cause.function))
        number = f"@{len(context.instants)}"
    names = context.debugger.names
    whose = f"{names[cause.robot]}: " if len(names) > 1 and cause.robot >= 0 else ""
    where = ""
    if cause.location is not None:
        where = f"{PurePath(cause.location.file).name}:{cause.location.line}  "
    at = f"t = {cause.time_s:.3f} s  " if cause.position is not None and cause.time_s > 0.0 else ""
    head = f"{'  ' * depth}{whose}{cause.text}"
    text = f"{number:<4} {head:<{_WIDTH - 20}}  {at}{where}{cause.how}".rstrip()
    yield Line(text, indent=_NUMBER + 2 * depth + _HANGING)
    for each in cause.causes:
        yield from _rows(context, each, depth + 1)


WHY: Final = Group(
    "why",
    "Where values came from.",
    (
        Command(
            "last", "EXPRESSION", "Go back to the last write to an object.", _last,
            text='Breakpoints on the way are ignored. "next EXPRESSION" goes to the next write.',
            completes="expression",
        ),
        Command(
            "why", "EXPRESSION", "Show where a value came from.", _why,
            text="Shows the last write to the object, what that value was computed from, and so "
            "on: through assignments, arguments, return values and messages from other robots, "
            "back to sensors, with the object that a beam hit and the degradation that changed "
            "the reading. For a value of the world, such as leader.heading, it shows the motion "
            "command, contacts, manual changes and degradations. The current position does not "
            'change; "goto @3" goes to the position with that number.',
            completes="expression",
        ),
    ),
)  # fmt: skip
