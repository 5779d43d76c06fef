"""The report of a stopped program: what went wrong, where, with which object, called by whom.

`explain` finds the words; here they are put together with the line of source, the values of the
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
from crs_cc.runtime.diagnosis.inspect import StackFrame, Stopped
from crs_cc.runtime.diagnosis.objects import Object
from crs_cc.runtime.diagnosis.variables import Variables

FIRST_CALLS: Final = 3
LAST_CALLS: Final = 2
MOST_VALUES: Final = 4
LONGEST_STRUCT: Final = 24  # characters; a longer one has no place among arguments
MOST_NAMES: Final = 3


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
    """Return the report of a failure, about the innermost place in the user's own files."""
    if failure.stopped is None:
        return ErrorReport(
            failure.kind, failure.location, _sentence(failure, explain(Case(failure)))
        )
    return _Reporter(failure, failure.stopped).report()


def current_call(stopped: Stopped) -> ActiveCall | None:
    """Return the innermost active function of the user's own files; None when there is none."""
    frame = next((each for each in stopped.stack if not _is_library(each)), None)
    return None if frame is None else _call(frame, stopped, Variables(stopped))


def library_call(stopped: Stopped) -> ActiveCall | None:
    """Return the library's function that the user's code has called, with the place of the call."""
    for frame, caller in itertools.pairwise(stopped.stack):
        if _is_library(frame) and not _is_library(caller):
            call = _call(frame, stopped, Variables(stopped))
            return replace(call, location=caller.location)
    return None


def _sentence(failure: Failure, explained: Explanation) -> str:
    return f"{failure.kind}: {explained.text}" if explained.text else failure.kind


class _Reporter:
    """Makes the report of one failure."""

    def __init__(self, failure: Failure, stopped: Stopped) -> None:
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
            told = {explained.told, failure.object.name if failure.object else ""}
            values = self.values(frame, expression, told)
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

    def line(self, place: Location) -> str:
        """Return the line of source at a place."""
        lines = self.stopped.lines.get(place.file, ())
        return lines[place.line - 1] if 0 < place.line <= len(lines) else ""

    def call(self, frame: StackFrame) -> ActiveCall:
        """Return an active function with its arguments."""
        return _call(frame, self.stopped, self.variables)

    def values(
        self, frame: StackFrame, expression: str, told: set[str]
    ) -> tuple[tuple[str, str], ...]:
        """Return the values of the variables in an expression, and of the structs they point to."""
        values = []
        for name in names_in(expression):
            known = self.variables.find(name, frame)
            if known is None or name in told:
                continue
            shown = self.variables.show(known)
            if shown.endswith("..."):  # too much to help
                continue
            values.append((name, shown))
            target = self.variables.values.show_target(known.variable.ctype, known.content)
            if target:
                values.append((f"*{name}", target))
        return tuple(values[:MOST_VALUES])

    def folded(self, rows: Sequence[StackFrame]) -> tuple[ActiveCall, ...]:
        """Return the call stack; of a long one the first and the last calls."""
        if len(rows) <= FIRST_CALLS + LAST_CALLS + 1:
            return tuple(map(self.call, rows))
        hidden = rows[FIRST_CALLS:-LAST_CALLS]
        names = list(dict.fromkeys(plain_name(frame.function) for frame in hidden))
        shown = " and ".join(names) if len(names) <= MOST_NAMES else ""
        return (
            *map(self.call, rows[:FIRST_CALLS]),
            ActiveCall(shown, count=len(hidden)),
            *map(self.call, rows[-LAST_CALLS:]),
        )


def _call(frame: StackFrame, stopped: Stopped, variables: Variables) -> ActiveCall:
    arguments = [
        (each.variable.name, _brief(variables.show(each))) for each in variables.arguments(frame)
    ]
    if stopped.compiled.info(frame.function).function.variadic:
        arguments.append(("...", ""))
    place = None if _is_library(frame) else frame.location
    return ActiveCall(plain_name(frame.function), tuple(arguments), place)


def _brief(value: str) -> str:
    return "{...}" if value.startswith("{") and len(value) > LONGEST_STRUCT else value


def _expression(line: str, place: Location) -> tuple[Location, str]:
    """Return the place and the text of the expression there, of one token at least."""
    place = replace(place, last=place.last or place.column)
    start = max(0, place.column - 1)
    return place, line[start : start + len(underline(line, place))]


def _narrowed(place: Location, expression: str, blamed: str) -> tuple[Location, str]:
    """Return place and text of a variable alone, if it is to blame of an expression."""
    found = re.search(rf"\b{re.escape(blamed)}\b", expression) if blamed else None
    if found is None:
        return place, expression
    column = place.column + found.start()
    return replace(place, column=column, last=column), blamed


def _is_library(frame: StackFrame) -> bool:
    return in_library(frame.location)


def _shown_frames(stopped: Stopped) -> list[StackFrame]:
    """Return the user's functions, and those of the library that they called themselves."""
    rows: list[StackFrame] = []
    for frame, caller in zip(stopped.stack, [*stopped.stack[1:], None], strict=True):
        by_user = caller is not None and not _is_library(caller)
        if not _is_library(frame) or (by_user and not frame.function.startswith("__")):
            rows.append(frame)
    return rows
