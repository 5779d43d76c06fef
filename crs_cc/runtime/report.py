"""The report of a stopped program: what went wrong, where, with which object, called by whom.

`explain` finds the words; here they are put together with the line of source, the values of the
variables in the expression, and the call stack.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from crs_cc.runtime.blame import names_in
from crs_cc.runtime.explain import Case, explain
from crs_cc.runtime.inspect import plain_name
from crs_cc.runtime.link import LIBRARY
from crs_cc.source import Location, underline

if TYPE_CHECKING:
    from crs_cc.runtime.fleet import Failure
    from crs_cc.runtime.inspect import StackFrame, StoppedProgram
    from crs_cc.runtime.objects import Object

FIRST_CALLS: Final = 3
LAST_CALLS: Final = 2
MOST_VALUES: Final = 4
MOST_NAMES: Final = 3


@dataclass(frozen=True, slots=True)
class ActiveCall:
    """A function that is active, or several of them that are not shown one by one.

    Attributes:
        function: its name; of several the names, empty when there are too many.
        arguments: names and values of its arguments; `...` without a value for those unnamed.
        location: where it is; None in the library, and for several.
        count: how many calls this stands for.
    """

    function: str
    arguments: tuple[tuple[str, str], ...] = ()
    location: Location | None = None
    count: int = 1

    def __str__(self) -> str:
        if self.count > 1:
            return f"{self.count:,} more calls" + (f" of {self.function}" if self.function else "")
        arguments = ", ".join(
            f"{name}={value}" if value else name for name, value in self.arguments
        )
        return f"{self.function}({arguments})"


@dataclass(frozen=True, slots=True)
class ErrorReport:
    """Why a program was stopped.

    Attributes:
        kind: one of `crs_cc.requests.ERROR_KINDS`.
        location: the innermost place in the user's own files.
        text: what happened, in a sentence that begins with the kind.
        source_line: the line of source; empty when unknown.
        values: the variables in the expression with their values.
        notes: what else there is to say, a sentence each: of the object, of the heap block.
        stack: the active functions, the innermost first; those in the middle of many are one.
        object: what the failure is about, if it is known.
    """

    kind: str
    location: Location
    text: str
    source_line: str = ""
    values: tuple[tuple[str, str], ...] = ()
    notes: tuple[str, ...] = ()
    stack: tuple[ActiveCall, ...] = ()
    object: Object | None = None


def report(failure: Failure) -> ErrorReport:
    """Gives the report of a failure, about the innermost place in the user's own files."""
    program = failure.program
    if program is None:
        return ErrorReport(failure.kind, failure.location, explain(Case(failure)).text)
    rows = _rows(program)
    mine = [frame for frame in rows if not _is_library(frame)]
    place = mine[0].location if mine else failure.location
    place = replace(place, last=place.last or place.column)  # one token at least
    line = _line(program, place)
    start = max(0, place.column - 1)
    expression = line[start : start + len(underline(line, place))]
    callee = _active_call(program, rows[0]) if rows and _is_library(rows[0]) else None
    case = Case(failure, expression, mine[0] if mine else None, callee)
    explained = explain(case)
    if not explained.shows_callee and callee is not None:
        rows = rows[1:]
    values: tuple[tuple[str, str], ...] = ()
    if mine and callee is None and explained.shows_values:
        values = _values(program, mine[0], expression, explained.told)
    stack = _folded(program, rows)
    text = f"{failure.kind}: {explained.text}" if explained.text else failure.kind
    found = failure.object
    return ErrorReport(failure.kind, place, text, line, values, explained.notes, stack, found)


def _is_library(frame: StackFrame) -> bool:
    return frame.location.file.startswith(LIBRARY)


def _rows(program: StoppedProgram) -> list[StackFrame]:
    """Gives the user's functions, and those of the library that they called themselves."""
    rows: list[StackFrame] = []
    for frame, caller in zip(program.stack, [*program.stack[1:], None], strict=True):
        by_user = caller is not None and not _is_library(caller)
        if not _is_library(frame) or (by_user and not frame.function.startswith("__")):
            rows.append(frame)
    return rows


def _line(program: StoppedProgram, place: Location) -> str:
    lines = program.detail.lines.get(place.file, ())
    return lines[place.line - 1] if 0 < place.line <= len(lines) else ""


def _active_call(program: StoppedProgram, frame: StackFrame) -> ActiveCall:
    arguments = [
        (variable.name, program.values.show(variable.ctype, content))
        for variable, content in program.arguments(frame)
    ]
    if program.infos[frame.function].function.variadic:
        arguments.append(("...", ""))
    place = None if _is_library(frame) else frame.location
    return ActiveCall(plain_name(frame.function), tuple(arguments), place)


def _values(
    program: StoppedProgram, frame: StackFrame, expression: str, told: str
) -> tuple[tuple[str, str], ...]:
    """Gives the values of the variables in an expression, and of the structs they point to."""
    values = []
    for name in names_in(expression):
        known = program.variable(name, frame)
        if known is None or name == told:
            continue
        variable, content = known
        shown = program.values.show(variable.ctype, content)
        target = program.values.show_target(variable.ctype, content)
        values.append((name, shown))
        if target:
            values.append((f"*{name}", target))
    return tuple(values[:MOST_VALUES])


def _folded(program: StoppedProgram, rows: Sequence[StackFrame]) -> tuple[ActiveCall, ...]:
    """Gives the call stack; of a long one the first and the last calls."""
    if len(rows) <= FIRST_CALLS + LAST_CALLS + 1:
        return tuple(_active_call(program, frame) for frame in rows)
    hidden = rows[FIRST_CALLS:-LAST_CALLS]
    names = list(dict.fromkeys(plain_name(frame.function) for frame in hidden))
    shown = " and ".join(names) if len(names) <= MOST_NAMES else ""
    return (
        *(_active_call(program, frame) for frame in rows[:FIRST_CALLS]),
        ActiveCall(shown, count=len(hidden)),
        *(_active_call(program, frame) for frame in rows[-LAST_CALLS:]),
    )
