"""The client's breakpoints. It sends them in groups, each of which replaces the previous one.

Breakpoints that a group keeps stay as they are, with their hit counts. When the programs are
compiled again all are set again; so each has a number of its own towards the client.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Final, Literal

from crs_cc.core.source import Location
from crs_cc.debug.breakpoints import Breakpoint
from crs_cc.debug.dap.connection import Connection
from crs_cc.debug.dap.framing import Message
from crs_cc.debug.dap.locations import ClientLocations
from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.watch import AccessKind

Group = tuple[str, str]
"""What is replaced together: `line` with the file, `function`, `data`, `exception`."""

_HIT_CONDITION: Final = re.compile(r"\s*(>=|>|==|%|)\s*(\d{1,9})\s*")


@dataclass(frozen=True, slots=True)
class RequestedBreakpoint:
    """A breakpoint as a client requests it.

    Attributes:
        target: the function, the `data_id` of an object, the kind of event; of a line the file.
        access: for data: `write`, `read` or `readWrite`.
        condition: a C expression; empty for none.
        hits: the client's condition on the number of hits; empty for none.
        log: the message to log instead of stopping; empty to stop.
    """

    kind: Literal["line", "function", "data", "exception"]
    target: str
    line: int = 0
    access: str = ""
    condition: str = ""
    hits: str = ""
    log: str = ""


@dataclass(slots=True)
class _ClientBreakpoint:
    """A requested breakpoint and its state.

    Attributes:
        request: what the client requested.
        id: its number towards the client.
        number: its number in the debugger, 0 if it is not set.
        message: why it is not set, or why it is elsewhere.
        location: its location in the source, if it has one.
    """

    request: RequestedBreakpoint
    id: int
    number: int = 0
    message: str = ""
    location: Location | None = None


class EditorBreakpoints:
    """All breakpoints of a session: the client's, and those that its user sets by commands.

    Attributes:
        debugger: the debugger of the run; None while nothing is launched.
    """

    def __init__(self, connection: Connection, locations: ClientLocations) -> None:
        self.debugger: Debugger | None = None
        self._connection = connection
        self._locations = locations
        self._groups: dict[Group, list[_ClientBreakpoint]] = {}
        self._others: dict[int, int] = {}
        self._last_id = 0

    def replace(self, group: Group, requests: Sequence[RequestedBreakpoint]) -> list[Message]:
        """Replace the breakpoints of a group; return descriptions of the new ones."""
        obsolete = list(self._groups.get(group, ()))
        self._groups[group] = now = []
        for request in requests:
            found = next(
                (each for each in obsolete if each.request == request and each.number), None
            )
            if found is None:
                now.append(_ClientBreakpoint(request, self._next_id()))
            else:
                obsolete.remove(found)
                now.append(found)
        if self.debugger is not None:
            for each in obsolete:
                _remove(self.debugger, each)
            for each in now:
                if not each.number:
                    self._set(self.debugger, each)
        return [self._body(each) for each in now]

    def set_again(self, debugger: Debugger) -> None:
        """Set all breakpoints in a new debugger and report their state."""
        self.debugger = debugger
        self._others.clear()
        for each in self._all():
            each.number = 0
            self._set(debugger, each)
            self._report("changed", self._body(each))

    def synchronize(self, debugger: Debugger) -> None:
        """Report breakpoints that were added or removed by commands."""
        existing = {made.number: made for made in debugger.stop_points.breakpoints}
        own = {each.number for each in self._all()}
        for each in self._all():
            if each.number and each.number not in existing:
                each.number, each.message = 0, "removed by a command"
                self._report("changed", self._body(each))
        for number in [number for number in self._others if number not in existing]:
            self._report("removed", {"id": self._others.pop(number), "verified": False})
        for number, made in existing.items():
            if number not in own and number not in self._others:
                self._others[number] = self._next_id()
                unrequested = RequestedBreakpoint("line", "")
                added = _ClientBreakpoint(
                    unrequested, self._others[number], number, "", _location(made)
                )
                self._report("new", self._body(added))

    def ids(self, numbers: Iterable[int]) -> list[int]:
        """Return the client's numbers for some of the debugger's breakpoints."""
        ids = {each.number: each.id for each in self._all()} | self._others
        return [ids[number] for number in numbers if number in ids]

    def are_functions(self, numbers: Iterable[int]) -> bool:
        """Return whether all of these are function breakpoints."""
        kinds = {each.number: each.request.kind for each in self._all()}
        return {kinds.get(number) for number in numbers} == {"function"}

    def event_kind(self, numbers: Iterable[int]) -> str:
        """Return the kind of event that the first of these catches."""
        kinds = {each.number: each.request.target for each in self._all()}
        return next((kinds[number] for number in numbers if number in kinds), "happening")

    def _all(self) -> list[_ClientBreakpoint]:
        return [each for group in self._groups.values() for each in group]

    def _next_id(self) -> int:
        self._last_id += 1
        return self._last_id

    def _set(self, debugger: Debugger, wanted: _ClientBreakpoint) -> None:
        """Set a breakpoint, or record why it cannot be set."""
        request = wanted.request
        try:
            if request.kind == "line":
                made = self._add_line(debugger, request)
            else:
                made = _ADD[request.kind](debugger, request)
        except DebugError as error:
            wanted.number, wanted.message, wanted.location = 0, str(error), None
            return
        wanted.number, wanted.location = made.number, _location(made)
        wanted.message = made.location.note if made.location else ""

    def _add_line(self, debugger: Debugger, request: RequestedBreakpoint) -> Breakpoint:
        file = self._locations.file_at(request.target)
        if file is None:
            raise DebugError("no program of this run was built from this file")
        return _add_place(debugger, f"{file}:{request.line}", request)

    def _body(self, each: _ClientBreakpoint) -> Message:
        """Return the description of a breakpoint for a client."""
        body: Message = {"id": each.id, "verified": bool(each.number)}
        message = each.message or ("" if self.debugger else "no program is launched")
        if message:
            body["message"] = message
        if each.location is not None:
            place = self._locations.location(each.location)
            body |= {"source": place["source"], "line": place["line"]}
        elif each.request.line:  # nvim-dap finds the sign of a breakpoint by its line
            body["line"] = self._locations.line(each.request.line)
        return body

    def _report(self, reason: str, body: Message) -> None:
        self._connection.event("breakpoint", {"reason": reason, "breakpoint": body})


def _remove(debugger: Debugger, obsolete: _ClientBreakpoint) -> None:
    if obsolete.number in {each.number for each in debugger.stop_points.breakpoints}:
        debugger.stop_points.remove(obsolete.number)


def _counting(hits: str) -> dict[str, Any]:
    """Return the hit counting of a breakpoint; raise DebugError if the hit condition is malformed.

    >>> _counting(""), _counting("3"), _counting(">= 3"), _counting(">3"), _counting("% 50")
    ({}, {'ignore': 2}, {'ignore': 2}, {'ignore': 3}, {'every': 50})
    """
    if not hits.strip():
        return {}
    match = _HIT_CONDITION.fullmatch(hits)
    if match is None or (int(match[2]) == 0 and match[1] != ">"):
        raise DebugError(f"'{hits}' is not a hit count (expected N, >= N, > N or % N)")
    if match[1] == "%":
        return {"every": int(match[2])}
    return {"ignore": int(match[2]) - (match[1] != ">")}


def _add_function(debugger: Debugger, request: RequestedBreakpoint) -> Breakpoint:
    return _add_place(debugger, request.target, request)


def _add_place(debugger: Debugger, place: str, request: RequestedBreakpoint) -> Breakpoint:
    counting = _counting(request.hits)
    add = debugger.stop_points.add_breakpoint
    return add(place, condition=request.condition, log=request.log, **counting)


def data_id(robot: int, function: str, expression: str) -> str:
    """Return an identifier for an object, which names the scope of its expression.

    Args:
        robot: the number of the robot.
        function: the active function; empty for global scope.
        expression: a C expression without side effects.
    """
    return f"{robot} {function or '-'} {expression}"


def _add_data(debugger: Debugger, request: RequestedBreakpoint) -> Breakpoint:
    """Watch the object that a `data_id` identifies."""
    robot, _, rest = request.target.partition(" ")
    function, _, expression = rest.partition(" ")
    if not (robot.isascii() and robot.isdigit() and len(robot) < 9 and expression):
        raise DebugError(f"'{request.target}' is not a known data ID")
    view = debugger.view
    before = view.robot, view.frame
    try:
        view.select_robot(int(robot))
        found = [each.number for each in view.frames() if each.function == function]
        if found:
            view.select_frame(found[0])
        return debugger.stop_points.add_watchpoint(
            expression,
            ACCESS[request.access],
            condition=request.condition,
            robot=int(robot),
            **_counting(request.hits),
        )
    finally:
        view.robot, view.frame = before


def _add_exception(debugger: Debugger, request: RequestedBreakpoint) -> Breakpoint:
    return debugger.stop_points.add_catchpoint(request.target, condition=request.condition)


def _location(made: Breakpoint) -> Location | None:
    return made.location.location if made.location else None


_ADD: Final[dict[str, Callable[[Debugger, RequestedBreakpoint], Breakpoint]]] = {
    "function": _add_function,
    "data": _add_data,
    "exception": _add_exception,
}

ACCESS: Final[dict[str, AccessKind]] = {"write": "change", "read": "read", "readWrite": "access"}
"""The debugger's terms for the protocol's; a write of the same value is of no interest."""
