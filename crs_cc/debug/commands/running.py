"""Commands for forward and reverse execution."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import partial
from typing import Final

from crs_cc.debug.commands.answer import Answer
from crs_cc.debug.commands.arguments import (
    parse_breakpoint_arguments,
    parse_count,
    parse_robot,
    require_argument,
)
from crs_cc.debug.commands.breakpoints import placed
from crs_cc.debug.commands.command import Command, Group
from crs_cc.debug.commands.context import CommandContext
from crs_cc.debug.commands.skipping import SKIPPING
from crs_cc.debug.commands.stop_text import program_lines
from crs_cc.debug.commands.why import go_to_write
from crs_cc.debug.errors import DebugError
from crs_cc.debug.interventions import interventions, revert
from crs_cc.debug.past import Past
from crs_cc.debug.stop import Stop
from crs_cc.debug.timeline.position import BEGINNING


def _start(context: CommandContext, _text: str) -> Answer:
    context.debugger.goto(BEGINNING)
    return context.move(context.debugger.start)


def _run(context: CommandContext, text: str) -> Answer:
    if text not in {"", "-keep"}:
        raise DebugError(f"unexpected argument '{text}' (expected -keep)")
    done = interventions(context.debugger)
    if done and not text:
        revert(context.debugger, 0)
        what = "one change" if len(done) == 1 else f"{len(done)} changes"
        yield f'Discarded {what}, which "run -keep" would have repeated.'
    context.debugger.goto(BEGINNING)
    yield from context.move(context.debugger.resume)


def _continue(context: CommandContext, text: str) -> Answer:
    count = parse_count(text)
    if count > 1:
        hit = context.debugger.stop.breakpoints
        if not hit:
            raise DebugError("no breakpoint at this stop to ignore")
        context.debugger.stop_points.ignore(hit[0], count - 1)
        yield f"Will ignore next {count - 1} crossings of breakpoint {hit[0]}.  Continuing."
    yield from context.move(context.debugger.resume)


def _reverse_continue(context: CommandContext, _text: str) -> Answer:
    return context.move(partial(context.debugger.resume, backward=True))


def _step(context: CommandContext, text: str, *, backward: bool = False) -> Answer:
    return context.move(partial(context.debugger.step, parse_count(text), backward=backward))


def _next(context: CommandContext, text: str, *, backward: bool = False) -> Answer:
    if text and not backward and not text.isdigit():
        return go_to_write(context, text, backward=False)
    return context.move(partial(context.debugger.next, parse_count(text), backward=backward))


def _stepi(
    context: CommandContext, text: str, *, backward: bool = False, over_calls: bool = False
) -> Answer:
    step, count = context.debugger.step_statement, parse_count(text)
    return context.move(partial(step, count, backward=backward, over_calls=over_calls))


def _tick(context: CommandContext, text: str, *, backward: bool = False) -> Answer:
    return context.move(partial(context.debugger.tick, parse_count(text), backward=backward))


def _finish(context: CommandContext, _text: str, *, backward: bool = False) -> Answer:
    return context.move(partial(_finished, context, backward=backward))


def _finished(context: CommandContext, *, backward: bool) -> Stop:
    """Finish the selected function, and record the value that it has returned."""
    stop = context.debugger.finish(backward=backward)
    if stop.returned is None:
        return stop
    number = context.record(stop.returned)
    return replace(stop, text=f"Value returned is ${number} = {stop.returned.text}")


def _until(context: CommandContext, text: str) -> Answer:
    if text:
        return _advance(context, text)
    return context.move(context.debugger.until)


def _advance(context: CommandContext, text: str) -> Answer:
    where = parse_breakpoint_arguments(require_argument(text, "a line or a function"))
    debugger = context.debugger
    robot = parse_robot(where.robot, debugger.names) if where.robot else debugger.view.robot

    def go() -> Stop:
        return debugger.advance(placed(context, where, robot, internal=True, temporary=True))

    return context.move(go)


_INSTANT: Final = re.compile(
    r"(?P<kind>t|time|tick|timestep|stmt|statement)?\s*[= ]?\s*(?P<number>\d+(?:\.\d*)?|\.\d+)\s*s?"
)


_LISTED: Final = re.compile(r"@(\d{1,6})")


def _go_to_listed(context: CommandContext, number: int) -> Stop:
    """Go to an instant of the last list, and select its robot."""
    if not 1 <= number <= len(context.instants):
        raise DebugError(f"no @{number} in the last list (it has {len(context.instants)} entries)")
    instant, view = context.instants[number - 1], context.debugger.view
    stop = context.debugger.goto(instant.position)
    if 0 <= instant.robot < len(context.debugger.names):
        view.select_robot(instant.robot)
        view.select_function(instant.function)
        stop = replace(stop, robot=instant.robot, time_s=view.time_s)
    return stop


_PRINTED: Final = re.compile(r"output\s+(\d{1,9})")


def _go_to_output(context: CommandContext, line: int) -> Stop:
    """Go to before the statement that printed a line."""
    debugger = context.debugger
    robot, number = Past(debugger.view, debugger.stop_points).printed(line)
    debugger.view.select_robot(robot)
    return debugger.goto_statement(number)


def _goto(context: CommandContext, text: str) -> Answer:
    text = require_argument(text, "a time, such as 12.3 or tick 120")
    if text == "end":
        return context.move(context.debugger.goto_end)
    if text == "start":
        return context.move(partial(context.debugger.goto, BEGINNING))
    if listed := _LISTED.fullmatch(text):
        return context.move(partial(_go_to_listed, context, int(listed[1])))
    if printed := _PRINTED.fullmatch(text):
        return context.move(partial(_go_to_output, context, int(printed[1])))
    found = _INSTANT.fullmatch(text)
    if not found:
        raise DebugError(
            f"'{text}' is not a time (expected 12.3 [s], tick 120, stmt 40210, start or end)"
        )
    kind, number = found["kind"] or "t", found["number"]
    if kind in {"t", "time"}:
        return context.move(partial(context.debugger.goto_time, float(number)))
    if not number.isdigit():
        raise DebugError(f"'{kind}' needs an integer")
    is_tick = kind.startswith("ti")
    go = context.debugger.goto_timestep if is_tick else context.debugger.goto_statement
    return context.move(partial(go, int(number)))


def _info_program(context: CommandContext, _text: str) -> Answer:
    return program_lines(context.debugger)


_BACKWARD_TEXT: Final = (
    "The programs and the world go back together; their state is restored exactly."
)

RUNNING: Final = Group(
    "running",
    "Forward and reverse execution.",
    (
        Command(
            "start", "", "Go to the first statement of the first program.", _start,
            ("starti",),
            text="Breakpoints are kept. Recorded history is discarded only when"
            " the past is changed.",
        ),
        Command(
            "run", "[-keep]", "Go to the start, then continue to the first breakpoint.",
            _run, ("r",),
            text="The run starts over: changes and lines typed for programs are discarded"
            ' (see "info edits"). With -keep, they are repeated.',
        ),
        Command(
            "continue", "[N]", "Continue to the next breakpoint, watchpoint or catchpoint.",
            _continue, ("c", "fg"),
            text="With N, ignore the current breakpoint N - 1 times. Ctrl-C interrupts.",
            repeats="on",
        ),
        Command(
            "step", "[N]", "Step to the next line, entering calls.", _step, ("s",),
            text="With N, repeat N times. Calls to C library functions are stepped over.",
            repeats="same",
        ),
        Command(
            "next", "[N|EXPRESSION]", "Step to the next line, stepping over calls.",
            _next, ("n",), text="With EXPRESSION, go to the next write to that object.",
            repeats="same",
        ),
        Command(
            "stepi", "[N]", "Step one statement.",
            _stepi, ("si",), repeats="same",
        ),
        Command(
            "nexti", "[N]", "Step one statement, stepping over calls.",
            partial(_stepi, over_calls=True), ("ni",), repeats="same",
        ),
        Command(
            "finish", "", "Continue until the selected function returns, and show its value.",
            _finish, ("fin",),
            text="It stops right after the call, in the caller's line, before the value is used."
            ' The value is recorded, as by "print".',
            repeats="same",
        ),
        Command(
            "until", "[LOCATION] [robot NAME] [if CONDITION]",
            "Like next, but run a loop to its end.", _until, ("u",),
            text='With LOCATION, the same as "advance".',
            repeats="same", completes="place",
        ),
        Command(
            "advance", "[LOCATION] [robot NAME] [if CONDITION]", "Continue to a location.",
            _advance, completes="place",
            text='LOCATION and the rest of the arguments are as for "break". It also stops when the'
            " selected function has returned.",
        ),
        Command(
            "tick", "[N]", "Continue to the start of the next timestep.", _tick,
            repeats="same",
        ),
        Command(
            "reverse-continue", "", "Continue backward to the previous stop.",
            _reverse_continue, ("rc", "rewind"), text=_BACKWARD_TEXT, repeats="on",
        ),
        Command(
            "reverse-step", "[N]", "Step back to the previous line, entering calls.",
            partial(_step, backward=True), ("rs",), text=_BACKWARD_TEXT, repeats="same",
        ),
        Command(
            "reverse-next", "[N]", "Step back to the previous line, stepping over calls.",
            partial(_next, backward=True), ("rn",), repeats="same",
        ),
        Command(
            "reverse-stepi", "[N]", "Step back one statement.",
            partial(_stepi, backward=True), ("rsi",), repeats="same",
        ),
        Command(
            "reverse-nexti", "[N]", "Step back one statement, stepping over calls.",
            partial(_stepi, backward=True, over_calls=True), ("rni",), repeats="same",
        ),
        Command(
            "reverse-finish", "", "Go back to the call of the selected function.",
            partial(_finish, backward=True), repeats="same",
        ),
        Command(
            "reverse-tick", "[N]", "Go back to the start of the previous timestep.",
            partial(_tick, backward=True), ("rt",), repeats="same",
        ),
        Command(
            "goto", "TIME|tick N|stmt N|output N|@N|start|end",
            "Go to a point in time, forward or in reverse.",
            _goto,
            text="TIME, in seconds, means the start of the timestep that contains it; tick N is"
            " the start of timestep N; stmt N is the point just before statement N of the robot's"
            ' program (see "when"), where returns from calls also count. Breakpoints on the'
            " way are ignored; end runs until all programs have ended. @N is position N in the most"
            ' recent list (see "when" and "history"); output N is the statement that printed line N'
            ' of the output (see "output /n").',
        ),
        Command(
            "info program", "", "Show where the robot's program is, and why it stopped.",
            _info_program,
        ),
        *SKIPPING,
    ),
)  # fmt: skip
