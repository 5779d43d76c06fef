"""Commands that move the run: forward, backward, and to an instant."""

from __future__ import annotations

import re
from functools import partial
from typing import TYPE_CHECKING, Final

from crs_cc.debug.commands.answer import Answer
from crs_cc.debug.commands.arguments import parse_count, reject_arguments, require_argument
from crs_cc.debug.commands.command import Command, Group
from crs_cc.debug.commands.stop_text import when_text
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.position import BEGINNING

if TYPE_CHECKING:
    from crs_cc.debug.commands.context import CommandContext


def _start(context: CommandContext, text: str) -> Answer:
    reject_arguments(text)
    context.debugger.goto(BEGINNING)
    return context.move(context.debugger.start)


def _run(context: CommandContext, text: str) -> Answer:
    reject_arguments(text)
    context.debugger.goto(BEGINNING)
    return context.move(context.debugger.resume)


def _continue(context: CommandContext, text: str) -> Answer:
    count = parse_count(text)
    if count > 1:
        hit = context.debugger.stop.breakpoints
        if not hit:
            raise DebugError("there is no breakpoint here to be passed")
        context.debugger.stop_points.ignore(hit[0], count - 1)
        yield f"Will ignore next {count - 1} crossings of breakpoint {hit[0]}.  Continuing."
    yield from context.move(context.debugger.resume)


def _reverse_continue(context: CommandContext, text: str) -> Answer:
    reject_arguments(text)
    return context.move(partial(context.debugger.resume, backward=True))


def _step(context: CommandContext, text: str, *, backward: bool = False) -> Answer:
    return context.move(partial(context.debugger.step, parse_count(text), backward=backward))


def _next(context: CommandContext, text: str, *, backward: bool = False) -> Answer:
    return context.move(partial(context.debugger.next, parse_count(text), backward=backward))


def _stepi(context: CommandContext, text: str, *, backward: bool = False) -> Answer:
    return context.move(
        partial(context.debugger.step_statement, parse_count(text), backward=backward)
    )


def _tick(context: CommandContext, text: str, *, backward: bool = False) -> Answer:
    return context.move(partial(context.debugger.tick, parse_count(text), backward=backward))


def _finish(context: CommandContext, text: str, *, backward: bool = False) -> Answer:
    reject_arguments(text)
    return context.move(partial(context.debugger.finish, backward=backward))


def _until(context: CommandContext, text: str) -> Answer:
    if text:
        return _advance(context, text)
    return context.move(context.debugger.until)


def _advance(context: CommandContext, text: str) -> Answer:
    return context.move(
        partial(context.debugger.advance, require_argument(text, "a line or a function"))
    )


_INSTANT: Final = re.compile(
    r"(?P<kind>t|time|tick|timestep|stmt|statement)?\s*[= ]?\s*(?P<number>\d+(?:\.\d*)?|\.\d+)\s*s?"
)


def _goto(context: CommandContext, text: str) -> Answer:
    text = require_argument(text, "an instant, such as 12.3 or tick 120")
    if text == "start":
        return context.move(partial(context.debugger.goto, BEGINNING))
    found = _INSTANT.fullmatch(text)
    if not found:
        raise DebugError(
            f"'{text}' is no instant: write seconds as 12.3, or tick 120, stmt 40210, start"
        )
    kind, number = found["kind"] or "t", found["number"]
    if kind in {"t", "time"}:
        return context.move(partial(context.debugger.goto_time, float(number)))
    if not number.isdigit():
        raise DebugError(f"'{kind}' needs a whole number")
    is_tick = kind.startswith("ti")
    go = context.debugger.goto_timestep if is_tick else context.debugger.goto_statement
    return context.move(partial(go, int(number)))


def _when(context: CommandContext, text: str) -> Answer:
    reject_arguments(text)
    yield when_text(context.debugger)


_BACKWARD_TEXT: Final = (
    "Programs and world go back together: what was there is there again, to the byte."
)

MOVING: Final = Group(
    "moving",
    "Going forward and backward through the run.",
    (
        Command(
            "start", "", "Go to the first statement of the first program.", _start,
            text="Breakpoints stay. What was done after an earlier moment is forgotten only when"
            " something is changed there.",
        ),
        Command("run", "", "Go to the beginning, then on to the first breakpoint.", _run, ("r",)),
        Command(
            "continue", "[N]", "Go on to the next breakpoint, watchpoint or catchpoint.",
            _continue, ("c", "fg"),
            text="With N, pass the breakpoint at which the program stands N - 1 times. Ctrl-C"
            " stops.",
            repeats="on",
        ),
        Command(
            "step", "[N]", "Go to the next line, into functions that it calls.", _step, ("s",),
            text="With N, N times. Functions of the C library count as one line.",
            repeats="same",
        ),
        Command(
            "next", "[N]", "Go to the next line of this function, over those that it calls.",
            _next, ("n",), repeats="same",
        ),
        Command(
            "stepi", "[N]", "Go to the next statement, in the same line or another.",
            _stepi, ("si",), repeats="same",
        ),
        Command(
            "finish", "", "Go on until this function has returned.", _finish, ("fin",),
            repeats="same",
        ),
        Command(
            "until", "[PLACE]", "Go to the next line, but out of loops instead of round again.",
            _until, ("u",),
            text='With a place, the same as "advance".',
            repeats="same", completes="place",
        ),
        Command(
            "advance", "PLACE", "Go on to a line or a function, as if a breakpoint were there.",
            _advance, completes="place",
        ),
        Command(
            "tick", "[N]", "Go on to the beginning of the next timestep of the world.", _tick,
            repeats="same",
        ),
        Command(
            "reverse-continue", "", "Go back to the breakpoint, watchpoint or catchpoint before.",
            _reverse_continue, ("rc", "rewind"), text=_BACKWARD_TEXT, repeats="on",
        ),
        Command(
            "reverse-step", "[N]", "Go back to the line before, into functions that were called.",
            partial(_step, backward=True), ("rs",), text=_BACKWARD_TEXT, repeats="same",
        ),
        Command(
            "reverse-next", "[N]", "Go back to the line before of this function.",
            partial(_next, backward=True), ("rn",), repeats="same",
        ),
        Command(
            "reverse-stepi", "[N]", "Go back by a statement.",
            partial(_stepi, backward=True), ("rsi",), repeats="same",
        ),
        Command(
            "reverse-finish", "", "Go back to where this function was called.",
            partial(_finish, backward=True), repeats="same",
        ),
        Command(
            "reverse-tick", "[N]", "Go back to the beginning of the timestep before.",
            partial(_tick, backward=True), ("rt",), repeats="same",
        ),
        Command(
            "goto", "TIME|tick N|stmt N|start", "Go to an instant, forward or backward.", _goto,
            text="TIME is in seconds, such as 12.3; tick N the beginning of timestep N; stmt N"
            ' before statement N of the robot\'s program, as "when" tells. Breakpoints on the way'
            " do not stop it.",
        ),
        Command("when", "", "Tell the instant: time, timestep, statement.", _when),
    ),
)  # fmt: skip
