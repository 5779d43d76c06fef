"""The error report of a stopped program: message, location, object and call stack.

`explain` supplies the message; here it is combined with the source line, the values of the
variables in the expression, and the call stack.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from crs_cc.core.source import Location, underline
from crs_cc.ir.names import in_library, plain_name
from crs_cc.runtime.diagnosis.active_call import ActiveCall
from crs_cc.runtime.diagnosis.explain import Case, Explanation, explain
from crs_cc.runtime.diagnosis.expression_text import names_in
from crs_cc.runtime.diagnosis.failure import Failure
from crs_cc.runtime.diagnosis.inspect import StackFrame, StoppedProgram
from crs_cc.runtime.diagnosis.objects import Object
from crs_cc.runtime.diagnosis.variables import Variables

FIRST_CALLS: Final = 3
LAST_CALLS: Final = 2
MAX_VALUES: Final = 4
LONGEST_STRUCT: Final = 24  # characters; longer ones are omitted from arguments
MAX_NAMES: Final = 3


@dataclass(frozen=True, slots=True)
class ErrorReport:
    """The report of a run-time error.

    Attributes:
        kind: one of `crs_cc.requests.ERROR_KINDS`.
        location: the innermost location in the user's files.
        text: the message, which starts with the kind.
        source_line: the source line; empty if unknown.
        values: the variables in the expression with their values.
        notes: further information, a sentence each: on the object, on the heap block.
        stack: the active calls, the innermost first; of many those in the middle are summarised.
        object: the object concerned, if known.
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
    """Return the report of a failure, located in the user's files."""
    if failure.stopped is None:
        return ErrorReport(
            failure.kind, failure.location, _sentence(failure, explain(Case(failure)))
        )
    return _Reporter(failure, failure.stopped).report()


def current_call(stopped: StoppedProgram) -> ActiveCall | None:
    """Return the innermost active call in the user's files, if any."""
    frame = next((each for each in stopped.stack if not _is_library(each)), None)
    return None if frame is None else _call(frame, stopped, Variables(stopped))


def library_call(stopped: StoppedProgram) -> ActiveCall | None:
    """Return the library function called by the user's code, with the location of the call."""
    for frame, caller in itertools.pairwise(stopped.stack):
        if _is_library(frame) and not _is_library(caller):
            call = _call(frame, stopped, Variables(stopped))
            return replace(call, location=caller.location)
    return None


def _sentence(failure: Failure, explained: Explanation) -> str:
    return f"{failure.kind}: {explained.text}" if explained.text else failure.kind


class _Reporter:
    """Builds the report of one failure."""

    def __init__(self, failure: Failure, stopped: StoppedProgram) -> None:
        self.failure = failure
        self.stopped = stopped
        self.variables = Variables(stopped)

    def report(self) -> ErrorReport:
        failure, frames = self.failure, _shown_frames(self.stopped)
        frame = next((each for each in frames if not _is_library(each)), None)
        place = failure.location if frame is None else frame.location
        line = self.line(place)
        place, expression = _expression(line, place)
        callee = self.call(frames[0]) if frames and _is_library(frames[0]) else None
        explained = explain(Case(failure, expression, self.variables, frame, callee))
        if callee is not None and not explained.shows_callee:
            frames = frames[1:]
        place, expression = _narrowed(place, expression, explained.blamed)
        values: tuple[tuple[str, str], ...] = ()
        if frame is not None and callee is None and explained.shows_values:
            mentioned = {explained.mentioned, failure.object.name if failure.object else ""}
            values = self.values(frame, expression, mentioned)
        return ErrorReport(
            failure.kind,
            place,
            _sentence(failure, explained),
            line,
            values,
            explained.notes,
            self.folded(frames),
            failure.object,
        )

    def line(self, location: Location) -> str:
        """Return the source line at a location."""
        lines = self.stopped.lines.get(location.file, ())
        return lines[location.line - 1] if 0 < location.line <= len(lines) else ""

    def call(self, frame: StackFrame) -> ActiveCall:
        """Return an active call with its arguments."""
        return _call(frame, self.stopped, self.variables)

    def values(
        self, frame: StackFrame, expression: str, mentioned: set[str]
    ) -> tuple[tuple[str, str], ...]:
        """Return the values of the variables in an expression, and of the structs they point to."""
        values = []
        for name in names_in(expression):
            known = self.variables.find(name, frame)
            if known is None or name in mentioned:
                continue
            shown = self.variables.show(known)
            if shown.endswith("..."):  # too long to be useful
                continue
            values.append((name, shown))
            target = self.variables.values.show_target(known.variable.ctype, known.content)
            if target:
                values.append((f"*{name}", target))
        return tuple(values[:MAX_VALUES])

    def folded(self, rows: Sequence[StackFrame]) -> tuple[ActiveCall, ...]:
        """Return the call stack; of a long one the first and the last calls."""
        if len(rows) <= FIRST_CALLS + LAST_CALLS + 1:
            return tuple(map(self.call, rows))
        hidden = rows[FIRST_CALLS:-LAST_CALLS]
        names = list(dict.fromkeys(plain_name(frame.function) for frame in hidden))
        shown = " and ".join(names) if len(names) <= MAX_NAMES else ""
        return (
            *map(self.call, rows[:FIRST_CALLS]),
            ActiveCall(shown, count=len(hidden)),
            *map(self.call, rows[-LAST_CALLS:]),
        )


def _call(frame: StackFrame, stopped: StoppedProgram, variables: Variables) -> ActiveCall:
    arguments = [
        (each.variable.name, _brief(variables.show(each))) for each in variables.arguments(frame)
    ]
    if stopped.compiled.info(frame.function).function.variadic:
        arguments.append(("...", ""))
    place = None if _is_library(frame) else frame.location
    return ActiveCall(plain_name(frame.function), tuple(arguments), place)


def _brief(value: str) -> str:
    return "{...}" if value.startswith("{") and len(value) > LONGEST_STRUCT else value


def _expression(line: str, location: Location) -> tuple[Location, str]:
    """Return the location and the text of the expression there, at least one token."""
    location = replace(location, last=location.last or location.column)
    start = max(0, location.column - 1)
    return location, line[start : start + len(underline(line, location))]


def _narrowed(location: Location, expression: str, blamed: str) -> tuple[Location, str]:
    """Return location and text of the variable at fault in an expression, if there is one."""
    found = re.search(rf"\b{re.escape(blamed)}\b", expression) if blamed else None
    if found is None:
        return location, expression
    column = location.column + found.start()
    return replace(location, column=column, last=column), blamed


def _is_library(frame: StackFrame) -> bool:
    return in_library(frame.location)


def _shown_frames(stopped: StoppedProgram) -> list[StackFrame]:
    """Return the user's functions, and the library functions called directly by them."""
    rows: list[StackFrame] = []
    for frame, caller in zip(stopped.stack, [*stopped.stack[1:], None], strict=True):
        by_user = caller is not None and not _is_library(caller)
        if not _is_library(frame) or (by_user and not frame.function.startswith("__")):
            rows.append(frame)
    return rows
