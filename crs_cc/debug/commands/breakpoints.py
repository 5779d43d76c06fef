"""Commands for breakpoints, watchpoints and catchpoints."""

from __future__ import annotations

import contextlib
import re
from functools import partial
from typing import TYPE_CHECKING, Final

from crs_cc.debug.breakpoints import Breakpoint
from crs_cc.debug.commands.answer import Answer
from crs_cc.debug.commands.arguments import (
    BreakpointArguments,
    parse_breakpoint_arguments,
    parse_count,
    parse_numbers,
    parse_pattern,
    parse_robot,
    require_argument,
    split_arguments,
)
from crs_cc.debug.commands.breakpoint_numbers import numbers, numbers_or_all
from crs_cc.debug.commands.breakpoint_text import described, name_of
from crs_cc.debug.commands.command import Command, Group
from crs_cc.debug.commands.context import CommandContext, CommandInput
from crs_cc.debug.commands.display import remove_displays
from crs_cc.debug.commands.enabling import DISABLE, DISPLAY, ENABLE, NUMBERS
from crs_cc.debug.commands.log_text import log_text
from crs_cc.debug.commands.past import log_past
from crs_cc.debug.commands.stack import functions
from crs_cc.debug.errors import DebugError
from crs_cc.debug.watch import WatchedWorld
from crs_cc.debug.world.events import KINDS

if TYPE_CHECKING:
    from crs_cc.debug.watch import AccessKind

_LOCATION: Final = re.compile(r"-l(?:oc(?:ation)?)?(?:\s+|$)")
_OFFSET: Final = re.compile(r"[+-]\d{1,6}")
_MAX_FUNCTIONS: Final = 200


def _robot(context: CommandContext, text: str) -> int | None:
    return parse_robot(text, context.debugger.names) if text else None


def _made(context: CommandContext, made: Breakpoint) -> Answer:
    context.keep_number("bpnum", made.number)
    yield f"{name_of(made)}: {described(made)}"
    yield from _warned(context, made)
    note = made.location.note if made.location else made.watch.note if made.watch else ""
    if note:
        yield note


def _warned(context: CommandContext, one: Breakpoint) -> Answer:
    if context.debugger.stop_points.assigns(one):
        yield f"warning: '{one.condition}' is an assignment, which has no effect; '==' compares"


def _break(context: CommandContext, text: str, *, temporary: bool = False) -> Answer:
    where = parse_breakpoint_arguments(text)
    return _made(context, placed(context, where, _robot(context, where.robot), temporary=temporary))


def placed(
    context: CommandContext, where: BreakpointArguments, robot: int | None, **options: bool
) -> Breakpoint:
    """Add a breakpoint.

    Args:
        context: the debugger.
        where: its place and condition.
        robot: the only robot concerned; None for all.
        options: those of `add_breakpoint`.

    Raises:
        DebugError: there is no such location, or the condition is invalid there.
    """
    points, here = context.debugger.stop_points, context.debugger.view.robot
    if not where.place and where.condition and _is_of_world(context, where.condition):
        evaluated_in = here if robot is None else robot
        return points.add_world_breakpoint(where.condition, evaluated_in, **options)
    place, condition = _place(context, where.place), where.condition
    return points.add_breakpoint(place, condition=condition, robot=robot, **options)


def _is_of_world(context: CommandContext, condition: str) -> bool:
    """Return whether a condition uses the world, and no local variables."""
    evaluator = context.debugger.view.evaluator(context.debugger.view.robot)
    if not evaluator.uses_external_values(condition):
        return False
    with contextlib.suppress(DebugError):
        evaluator.global_scope(condition)
        return True
    return False


def _rbreak(context: CommandContext, text: str) -> Answer:
    pattern = parse_pattern(require_argument(text, "a regular expression"))
    names = sorted({name for name, _ in functions(context) if pattern.search(name)})
    if not names:
        raise DebugError(f"no function matches '{text}'")
    if len(names) > _MAX_FUNCTIONS:
        raise DebugError(f"{len(names)} functions match '{text}' (at most {_MAX_FUNCTIONS})")
    for name in names:
        yield from _break(context, name)


def _watch(context: CommandContext, text: str, *, kind: AccessKind) -> Answer:
    where = parse_breakpoint_arguments(text)
    is_location = _LOCATION.match(where.place)
    expression = where.place[is_location.end() :] if is_location else where.place
    made = context.debugger.stop_points.add_watchpoint(
        require_argument(expression, "an expression such as speed or *p"),
        kind,
        location=bool(is_location),
        condition=where.condition,
        robot=_robot(context, where.robot),
    )
    return _made(context, made)


def _catch(context: CommandContext, text: str, *, temporary: bool = False) -> Answer:
    where = parse_breakpoint_arguments(
        require_argument(text, "an event, such as exit or collision")
    )
    made = context.debugger.stop_points.add_catchpoint(
        where.place,
        condition=where.condition,
        robot=_robot(context, where.robot),
        temporary=temporary,
    )
    return _made(context, made)


def _dprintf(context: CommandContext, text: str) -> Answer:
    place, *rest = split_arguments(require_argument(text, 'LOCATION,"FORMAT",EXPRESSION...'))
    if not rest:
        raise DebugError('a format is missing: dprintf LOCATION,"FORMAT",...')
    made = context.debugger.stop_points.add_breakpoint(
        _place(context, place), log=log_text(rest[0], rest[1:])
    )
    return _made(context, made)


def _log(context: CommandContext, text: str) -> Answer:
    if text.startswith('"'):
        yield from log_past(context, text)
        return
    place, _, message = require_argument(text, "LOCATION TEXT").partition(" ")
    made = context.debugger.stop_points.add_breakpoint(
        place, log=require_argument(message, "LOCATION TEXT")
    )
    yield from _made(context, made)


def _place(context: CommandContext, text: str) -> str:
    """Return a location: by default the current line, or some lines before or after it."""
    offset = _OFFSET.fullmatch(text)
    if text and offset is None:
        return text
    place = context.debugger.view.location()
    if place is None:
        raise DebugError("no current line: specify a location")
    return f"{place.file}:{place.line + (int(text) if offset else 0)}"


def _delete(context: CommandContext, text: str) -> Answer:
    if display := DISPLAY.match(text):
        remove_displays(context.displays, parse_numbers(text[display.end() :]))
        return
    for number in numbers_or_all(context, text):
        context.debugger.stop_points.remove(number)
        context.scripts.pop(number, None)
    yield from ()


def _clear(context: CommandContext, text: str) -> Answer:
    points = context.debugger.stop_points
    where = points.location(_place(context, text), context.debugger.view.robot).location
    found = [
        each.number
        for each in points.breakpoints
        if where is not None
        and each.location is not None
        and each.location.location is not None
        and (each.location.location.file, each.location.location.line) == (where.file, where.line)
    ]
    if not found:
        raise DebugError(f"no breakpoint at {text or 'this line'}")
    for number in found:
        points.remove(number)
        context.scripts.pop(number, None)
        yield f"Deleted breakpoint {number}."


def _condition(context: CommandContext, text: str) -> Answer:
    number, _, condition = require_argument(
        text, "a breakpoint's number and a condition"
    ).partition(" ")
    for each in numbers(context, number):
        context.debugger.stop_points.set_condition(each, condition.strip())
        yield from _warned(context, context.debugger.stop_points.breakpoints.get(each))
        if not condition.strip():
            yield f"Breakpoint {each} now unconditional."


def _ignore(context: CommandContext, text: str) -> Answer:
    number, _, count = require_argument(text, "a breakpoint's number and a count").partition(" ")
    times = 0 if count.strip() == "0" else parse_count(require_argument(count, "an ignore count"))
    for each in numbers(context, number):
        context.debugger.stop_points.ignore(each, times)
        yield f"Will ignore next {times} crossings of breakpoint {each}."


def _commands(context: CommandContext, text: str) -> Answer:
    known = [each.number for each in context.debugger.stop_points.breakpoints]
    chosen = numbers(context, text) or known[-1:]
    if not chosen:
        raise DebugError("no breakpoints")
    missing = [each for each in chosen if each not in known]
    if missing:
        raise DebugError(f"no breakpoint {missing[0]}")
    context.input = CommandInput(chosen)
    shown = ", ".join(map(str, chosen))
    yield (
        f"Type commands for breakpoint {shown}, one per line. End with a line saying just 'end'."
    )


def _info(context: CommandContext, text: str, *, kind: str = "") -> Answer:
    wanted = set(numbers(context, text))
    rows = [
        each
        for each in context.debugger.stop_points.breakpoints
        if (not wanted or each.number in wanted) and kind in ("", each.kind)
    ]
    if not rows:
        what = kind or "breakpoint"
        yield f"No {what}s." if not wanted else f"No such {what}."
    for one in rows:
        yield f"{one.number:<3} {_state(one):11} {described(one)}{_of_robot(context, one)}"
        if one.condition:
            yield f"    stop only if {one.condition}"
        if one.log:
            yield f"    log {one.log}"
        if one.hits or one.ignore:
            times = f"{one.hits} time{'s' * (one.hits != 1)}"
            yield f"    breakpoint already hit {times}" + (
                f", ignore next {one.ignore} hits" if one.ignore else ""
            )
        if one.stops_left:
            yield f"    will be disabled after {one.stops_left} stop{'s' * (one.stops_left > 1)}"
        yield from (f"        {line}" for line in context.scripts.get(one.number, ()))


def _state(one: Breakpoint) -> str:
    kind = "log" if one.log else "temporary" if one.temporary else one.kind
    return kind if one.enabled else f"({kind})"


def _of_robot(context: CommandContext, one: Breakpoint) -> str:
    names = context.debugger.names
    if one.robot is None or len(names) == 1:
        return ""
    name = names[one.robot]
    if one.watch is not None and isinstance(one.watch.watched, WatchedWorld):
        return f", evaluated in {name}'s program"
    return f", {name} only"


_PLACES: Final = (
    "LOCATION is a line (12, +2 from here), a line of a file (turn.c:12), a function of the "
    "program (turn), or a robot function (ws, get_sn), in which case it stops when that function "
    "is called. If the line has no code, the next line that has code is used. The default is the "
    "current line or, if CONDITION uses world values and no local variables, the start of any "
    "timestep at which it becomes true. With several robots, it applies to all of them unless one "
    "is named. CONDITION is a C expression."
)


def _kinds() -> str:
    """Return the event kinds with their meanings."""
    *first, last = (f"{kind} ({meaning})" for kind, meaning in KINDS.items())
    return f"{', '.join(first)} or {last}"


BREAKPOINTS: Final = Group(
    "breakpoints",
    "Where and when to stop, forward or in reverse.",
    (
        Command(
            "break", "[LOCATION] [robot NAME] [if CONDITION]",
            "Set a breakpoint at a line or a function.",
            _break, ("b", "br"), text=_PLACES, completes="place",
        ),
        Command(
            "tbreak", "[LOCATION] [robot NAME] [if CONDITION]",
            "Set a breakpoint that is deleted when hit.",
            partial(_break, temporary=True), ("tb",), text='LOCATION is as for "break".',
            completes="place",
        ),
        Command(
            "rbreak", "REGEX", "Set breakpoints on all functions whose names match.", _rbreak,
            text="REGEX is a regular expression; it may match any part of a name.",
        ),
        Command(
            "watch", "[-location] EXPRESSION [if CONDITION]",
            "Stop when the value of an expression changes.", partial(_watch, kind="change"),
            text="Stops after the statement that changed it (in reverse: before it). EXPRESSION "
            "is re-evaluated each time: after i has changed, a[i] is a different element. With "
            "-location (-l), the object that EXPRESSION names now is watched. A local variable "
            "is watched until its function returns.",
            completes="expression",
        ),
        Command(
            "wwatch", "[-location] EXPRESSION [if CONDITION]",
            "Stop when an object is written, changed or not.",
            partial(_watch, kind="write"), completes="expression",
        ),
        Command(
            "rwatch", "[-location] EXPRESSION [if CONDITION]", "Stop when an object is read.",
            partial(_watch, kind="read"), completes="expression",
        ),
        Command(
            "awatch", "[-location] EXPRESSION [if CONDITION]",
            "Stop when an object is read or written.",
            partial(_watch, kind="access"), completes="expression",
        ),
        Command(
            "catch", "EVENT [robot NAME]", "Stop when an event happens to a program or a robot.",
            _catch, text=f"EVENT is exit (a program ended), {_kinds()}.", completes="catch",
        ),
        Command(
            "tcatch", "EVENT [robot NAME]", "Set a catchpoint that is deleted when hit.",
            partial(_catch, temporary=True), text='EVENT is as for "catch".', completes="catch",
        ),
        Command(
            "dprintf", 'LOCATION,"FORMAT",EXPRESSION...',
            "Print a formatted message without stopping.", _dprintf,
            text="FORMAT and the values are as for printf.",
            completes="place",
        ),
        Command(
            "log", 'LOCATION TEXT|"FORMAT",EXPRESSION... at LOCATION [FROM..TO]',
            "Print TEXT without stopping.", _log,
            text="Expressions in braces are replaced by their values: log 12 speed is {speed}. "
            "{%5.1f speed} formats a value as printf does. The second form prints what dprintf "
            "would have printed in the recorded run, or in the part FROM..TO of it (in seconds), "
            "interleaved with the events of the world.",
            completes="place",
        ),
        Command(
            "delete", "[N...]", "Delete breakpoints.", _delete, ("d",),
            text=f'{NUMBERS} "delete display" is "undisplay".', completes="breakpoint",
        ),
        Command(
            "clear", "[LOCATION]", "Delete the breakpoints at a line or a function.", _clear,
            text='LOCATION is as for "break".', completes="place",
        ),
        DISABLE,
        ENABLE,
        Command(
            "condition", "N [CONDITION]", "Make a breakpoint conditional on a C expression.",
            _condition, text="Without CONDITION, make it unconditional.", completes="breakpoint",
        ),
        Command(
            "ignore", "N COUNT", "Ignore the next COUNT hits of a breakpoint.", _ignore,
            completes="breakpoint",
        ),
        Command(
            "commands", "[N...]", "Set commands to execute when a breakpoint is hit.", _commands,
            text='The commands follow, one per line, terminated by a line that says "end". If the'
            ' first is "silent", the stop is not reported. The default is the newest breakpoint.',
            completes="breakpoint",
        ),
        Command(
            "info breakpoints", "[N...]", "List breakpoints, watchpoints and catchpoints.",
            _info, ("info b",), completes="breakpoint",
        ),
        Command(
            "info watchpoints", "[N...]", "List watchpoints.", partial(_info, kind="watchpoint"),
            completes="breakpoint",
        ),
    ),
)  # fmt: skip
