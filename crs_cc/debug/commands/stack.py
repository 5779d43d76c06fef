"""Commands for stack frames and source."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Final

from crs_cc.core.source import Location
from crs_cc.debug.commands.answer import Answer, NestedCommand, SourceLine
from crs_cc.debug.commands.arguments import parse_count, require_argument
from crs_cc.debug.commands.command import Command, Group
from crs_cc.debug.commands.context import CommandContext, Listing
from crs_cc.debug.commands.stop_text import frame_text
from crs_cc.debug.errors import DebugError
from crs_cc.debug.locations import find_location, is_file
from crs_cc.ir.names import in_library, plain_name

if TYPE_CHECKING:
    from crs_cc.debug.data.variables import Variable
    from crs_cc.debug.view import BacktraceFrame
    from crs_cc.ir.program import Function


def frames(context: CommandContext) -> list[BacktraceFrame]:
    """Return the stack frames of the selected robot; raise DebugError if there are none."""
    found = context.debugger.view.frames()
    if not found:
        name = context.debugger.names[context.debugger.view.robot]
        raise DebugError(f"no frames: {name}'s program has not started or has ended")
    return found


def frame(context: CommandContext) -> BacktraceFrame:
    """Return the selected frame; raise DebugError if there is none."""
    found = frames(context)
    return next((each for each in found if each.number == context.debugger.view.frame), found[0])


def _backtrace(context: CommandContext, text: str) -> Answer:
    here = frame(context).number
    found = list(_shown(frames(context)))
    words = text.split()
    is_full = words[:1] in (["full"], ["-full"])
    count = " ".join(words[is_full:])
    is_outermost = count.startswith("-")
    most = parse_count(count.removeprefix("-")) if count else context.settings["backtrace limit"]
    shown = found[-most:] if is_outermost else found[:most]
    for each in shown:
        mark = "=>" if each.number == here else "  "
        yield f"{mark} #{each.number}  {frame_text(context.debugger, each)}"
        if is_full:
            yield from _locals(context, each)
    if len(found) > most and not is_outermost:
        yield f"(more frames follow: {len(found) - most})"


def _locals(context: CommandContext, of: BacktraceFrame) -> Iterator[str]:
    """Return lines with the variables of a frame, but not its parameters."""
    variables = [] if of.is_library else context.debugger.view.variables(frame=of.number)
    found = [each for each in variables if each.scope != "parameter"]
    yield from (f"        {each.name} = {variable_text(context, each)}" for each in found)
    if not found:
        yield "        No locals."


def variable_text(context: CommandContext, variable: Variable) -> str:
    """Return a variable's value as lists of variables show it: in a line unless it is pretty."""
    return variable.value.full if context.settings["print pretty"] else variable.value.text


def _shown(found: list[BacktraceFrame]) -> Iterator[BacktraceFrame]:
    """Return the user's frames, and those of library functions that they have called."""
    for each, caller in zip(found, [*found[1:], None], strict=True):
        if not each.is_library or (caller is not None and not caller.is_library):
            yield each


def _frame(context: CommandContext, text: str) -> Answer:
    kind, _, rest = text.partition(" ")
    if kind == "apply":
        return _apply(context, rest.strip())
    _select(context, text)
    return context.show_selection()


def _select(context: CommandContext, text: str) -> None:
    """Select a frame; by default, check that there is one."""
    kind, _, rest = text.partition(" ")
    if kind == "function":
        context.debugger.view.select_frame(_frame_of(context, rest.strip()))
    elif text:
        wanted = rest.strip() if kind == "level" else text
        numbers = {str(each.number): each.number for each in frames(context)}
        if wanted not in numbers:
            raise DebugError(f'no frame #{wanted}; see "backtrace"')
        context.debugger.view.select_frame(numbers[wanted])
    frame(context)


def _apply(context: CommandContext, text: str) -> Answer:
    """Execute a command in some frames, and select the one that was selected again."""
    count, _, command = require_argument(text, "frame apply (all|N) COMMAND").partition(" ")
    command = require_argument(command, "a command: frame apply all print n")
    found = list(_shown(frames(context)))
    if count != "all":
        most = parse_count(count.removeprefix("-"))
        found = found[-most:] if count.startswith("-") else found[:most]
    view, before = context.debugger.view, context.debugger.view.frame
    try:
        for each in found:
            view.select_frame(each.number)
            yield f"#{each.number}  {frame_text(context.debugger, each)}"
            yield NestedCommand(command)
    finally:
        view.frame = before


def _select_frame(context: CommandContext, text: str) -> Answer:
    _select(context, require_argument(text, "a frame's number, or function NAME"))
    yield from ()


def _frame_of(context: CommandContext, function: str) -> int:
    """Return the number of the innermost frame of a function."""
    name = require_argument(function, "the name of a function")
    for each in frames(context):
        if each.function == name:
            return each.number
    raise DebugError(f"no frame of function '{name}'; see \"backtrace\"")


def _up(context: CommandContext, text: str) -> Answer:
    return _move_frame(context, parse_count(text))


def _down(context: CommandContext, text: str) -> Answer:
    return _move_frame(context, -parse_count(text))


def _move_frame(context: CommandContext, by: int) -> Answer:
    numbers = [each.number for each in frames(context)]
    place = numbers.index(frame(context).number)
    target = min(max(place + by, 0), len(numbers) - 1)
    if target == place:
        end = "outermost" if by > 0 else "innermost"
        raise DebugError(f"already at the {end} frame")
    context.debugger.view.select_frame(numbers[target])
    return context.show_selection()


def _info_frame(context: CommandContext, _text: str) -> Answer:
    found, here = frames(context), frame(context)
    yield f"#{here.number}  {frame_text(context.debugger, here)}"
    place = [each.number for each in found].index(here.number)
    if place + 1 < len(found):
        caller = found[place + 1]
        yield f"called by #{caller.number}  {frame_text(context.debugger, caller)}"


def _list(context: CommandContext, text: str) -> Answer:
    file, first, last = _range(context, text)
    lines = context.debugger.view.source(file)
    if not lines:
        raise DebugError(f"the source of '{file}' is not available")
    count = line_count(lines)
    if first > count:
        raise DebugError(f"'{file}' has only {count} lines")
    last = min(last, count)
    context.listing = Listing(file, first, last)
    yield from source_lines(context, file, first, last)


def source_lines(context: CommandContext, file: str, first: int, last: int) -> Iterator[SourceLine]:
    """Return lines of a file, with their marks."""
    lines, here = context.debugger.view.source(file), context.debugger.view.location()
    current = here.line if here is not None and here.file == file else 0
    stops = _lines_with_breakpoints(context, file)
    for number in range(first, last + 1):
        yield SourceLine(number, lines[number - 1], number == current, number in stops)


def line_count(lines: Sequence[str]) -> int:
    """Return the number of lines of a file, as `wc` counts them."""
    return len(lines) - (bool(lines) and not lines[-1])


def _lines_with_breakpoints(context: CommandContext, file: str) -> set[int]:
    places = [
        each.location.location for each in context.debugger.stop_points.breakpoints if each.location
    ]
    return {each.line for each in places if each is not None and each.file == file}


def _range(context: CommandContext, text: str) -> tuple[str, int, int]:
    """Return the file and the first and last line to list."""
    listed, lines = context.listing, context.settings["listsize"]
    if text in {"", "+", "-"} and listed is not None:
        return _further(listed, lines, is_back=text == "-")
    first, comma, last = text.partition(",")
    if text in {"", "+", "-"}:
        middle = _here(context)
        return _around(middle.file, middle.line, lines)
    if not comma:
        middle = _listed(context, first)
        return _around(middle.file, middle.line, lines)
    if not first.strip():
        end = _listed(context, require_argument(last, "a line: list FIRST,LAST"))
        return end.file, max(1, end.line - lines + 1), end.line
    begin = _listed(context, first)
    if not last.strip():
        return begin.file, begin.line, begin.line + lines - 1
    end = _listed(context, last)
    if end.file != begin.file or end.line < begin.line:
        raise DebugError(f"{end} is not after {begin}")
    return begin.file, begin.line, end.line


def _listed(context: CommandContext, text: str) -> Location:
    """Return the location to list lines around: a line with or without code, a function."""
    file, _, line = text.strip().rpartition(":")
    if line.isascii() and line.isdigit() and len(line) < 9:
        known = file or context.debugger.view.current_file()
        for path in (
            context.debugger.run.programs[context.debugger.view.robot].executable.detail().lines
        ):
            if is_file(path, known):
                return Location(path, int(line))
    found = None if file else function_body(context, line)
    return found or find_line(context, text)


def _further(listed: Listing, lines: int, *, is_back: bool) -> tuple[str, int, int]:
    """Return the lines to list after, or before, the last listing."""
    if listed.is_found and not is_back:
        return _around(listed.file, listed.first, lines)
    if not is_back:
        return listed.file, listed.last + 1, listed.last + lines
    if listed.first == 1:
        raise DebugError(f"already at the start of '{listed.file}'")
    return listed.file, max(1, listed.first - lines), listed.first - 1


def _around(file: str, line: int, lines: int) -> tuple[str, int, int]:
    first = max(1, line - lines // 2)
    return file, first, first + lines - 1


def _here(context: CommandContext) -> Location:
    place = context.debugger.view.location()
    if place is None:
        raise DebugError("no current line: specify which lines, such as list main")
    return place


def find_line(context: CommandContext, text: str) -> Location:
    """Return the line of a location; raise DebugError if there is no such line or function."""
    debugger = context.debugger
    file = debugger.view.current_file()
    found = find_location(text, debugger.run.programs, [debugger.view.robot], file).location
    if found is None:
        raise DebugError(f"'{text}' is a robot function and has no source")
    return found


def functions(context: CommandContext) -> Iterator[tuple[str, Location]]:
    """Return names and locations of the user's functions in the selected robot's program."""
    for each in _functions(context):
        yield plain_name(each.name), each.location


def _functions(context: CommandContext) -> Iterator[Function]:
    program = context.debugger.run.programs[context.debugger.view.robot].executable.program
    unused = program.unused.functions if program.unused else {}
    own = (program.functions | unused).values()
    return (each for each in own if not in_library(each.location))


def function_body(context: CommandContext, name: str) -> Location | None:
    """Return where the body of a function begins, as gdb does; None if there is no function."""
    view = context.debugger.view
    for each in _functions(context):
        if plain_name(each.name) == name:
            with contextlib.suppress(DebugError):
                names = view.names_in(view.robot, each.name, each.location.file)
                return names.body(each.name) or each.location
            return each.location
    return None


_LIST_TEXT: Final = (
    "Lists ten lines (see set listsize) around LOCATION, starting at FIRST, or ending at LAST; or "
    "all lines from FIRST to LAST. Without arguments, those around the"
    ' current line, then those that follow; "list -" shows those before.'
)

STACK: Final = Group(
    "stack",
    "Stack frames and source.",
    (
        Command(
            "backtrace", "[full] [N]", "Show the stack frames, innermost first.", _backtrace,
            ("bt", "where", "info stack"), text="With N, the innermost N; with -N, the outermost N."
            " With full, also their local variables.",
        ),
        Command(
            "frame", "[[level] N|function NAME|apply (all|N) COMMAND]",
            "Select a frame, or show the selected one.",
            _frame, ("f",), text="N is its number; NAME selects the innermost frame of a function."
            " Expressions and listings refer to the selected frame. With apply, execute a command"
            " in all frames, or in the innermost N, or with -N in the outermost N.",
        ),
        Command(
            "select-frame", "[level] N|function NAME", "Select a frame without showing it.",
            _select_frame,
        ),
        Command("up", "[N]", "Select the caller's frame.", _up, repeats="same"),
        Command(
            "down", "[N]", "Select the callee's frame.", _down,
            repeats="same",
        ),
        Command("info frame", "", "Describe the selected frame.", _info_frame,
                ("info f",)),
        Command(
            "list", "[LOCATION|[FIRST],[LAST]|+|-]", "List source lines.", _list, ("l",),
            text=_LIST_TEXT, repeats="on", completes="place",
        ),
    ),
)  # fmt: skip
