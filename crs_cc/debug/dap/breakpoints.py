"""Where the client wants to stop. It says it in groups, each of which replaces the one before.

What is as it was in a group is left alone, with its hits. When the programs are compiled again all
is set again; so a breakpoint has a number of its own towards the client.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Literal

from crs_cc.debug.errors import DebugError

if TYPE_CHECKING:
    from crs_cc.core.source import Location
    from crs_cc.debug.breakpoints import Breakpoint
    from crs_cc.debug.dap.framing import Message
    from crs_cc.debug.dap.session import EditorSession
    from crs_cc.debug.engine import Debugger
    from crs_cc.debug.watch import Kind as Access

Group = tuple[str, str]
"""What is replaced together: `line` with the file, `function`, `data`, `exception`."""

_HITS: Final = re.compile(r"\s*(>=|>|==|)\s*(\d{1,9})\s*")


@dataclass(frozen=True, slots=True)
class Wish:
    """A breakpoint that a client wants.

    Attributes:
        kind: what it is.
        what: the function, `data_id` of an object, the kind of happenings; of a line the file.
        line: the line.
        access: of data: `write`, `read` or `readWrite`.
        condition: a C expression; empty for none.
        hits: the client's condition on the number of hits; empty for none.
        log: what to say instead of stopping; empty to stop.
    """

    kind: Literal["line", "function", "data", "exception"]
    what: str
    line: int = 0
    access: str = ""
    condition: str = ""
    hits: str = ""
    log: str = ""


@dataclass(slots=True)
class _Set:
    """A wish, and what became of it.

    Attributes:
        wish: what the client wants.
        id: the client's number of it.
        number: the debugger's, 0 where it is not set.
        message: why it is not, or not where it was wanted.
        location: the place in the source, if it has one.
    """

    wish: Wish
    id: int
    number: int = 0
    message: str = ""
    location: Location | None = None


class EditorBreakpoints:
    """All breakpoints of a session: the client's, and those that its user sets by commands."""

    def __init__(self) -> None:
        self._groups: dict[Group, list[_Set]] = {}
        self._others: dict[int, int] = {}
        self._made = 0

    def replace(
        self, session: EditorSession, group: Group, wishes: Sequence[Wish]
    ) -> list[Message]:
        """Sets what a client wants instead of what it wanted before in this group."""
        left = list(self._groups.get(group, ()))
        self._groups[group] = now = []
        for wish in wishes:
            found = next((each for each in left if each.wish == wish and each.number), None)
            if found is None:
                now.append(_Set(wish, self._next()))
            else:
                left.remove(found)
                now.append(found)
        if session.debugger is not None:
            for each in left:
                _remove(session.debugger, each)
            for each in now:
                if not each.number:
                    _set(session, each)
        return [_body(session, each) for each in now]

    def set_again(self, session: EditorSession) -> None:
        """Sets everything in a debugger that has none yet, and tells what became of it."""
        self._others.clear()
        for each in self._all():
            each.number = 0
            _set(session, each)
            _tell(session, "changed", _body(session, each))

    def look(self, session: EditorSession) -> None:
        """Tells the client of breakpoints that came, or went, without it."""
        there = {made.number: made for made in session.opened().stop_points.breakpoints}
        own = {each.number for each in self._all()}
        for each in self._all():
            if each.number and each.number not in there:
                each.number, each.message = 0, "removed by a command"
                _tell(session, "changed", _body(session, each))
        for number in [number for number in self._others if number not in there]:
            _tell(session, "removed", {"id": self._others.pop(number), "verified": False})
        for number, made in there.items():
            if number not in own and number not in self._others:
                self._others[number] = self._next()
                found = _Set(Wish("line", ""), self._others[number], number, "", _location(made))
                _tell(session, "new", _body(session, found))

    def ids(self, numbers: Iterable[int]) -> list[int]:
        """Gives the client's numbers of some of the debugger's breakpoints."""
        ids = {each.number: each.id for each in self._all()} | self._others
        return [ids[number] for number in numbers if number in ids]

    def are_functions(self, numbers: Iterable[int]) -> bool:
        """Tells whether these are breakpoints at functions, all of them."""
        kinds = {each.number: each.wish.kind for each in self._all()}
        return {kinds.get(number) for number in numbers} == {"function"}

    def kind_of(self, numbers: Iterable[int]) -> str:
        """Gives the kind of happenings that the first of these wants."""
        kinds = {each.number: each.wish.what for each in self._all()}
        return next((kinds[number] for number in numbers if number in kinds), "happening")

    def _all(self) -> list[_Set]:
        return [each for group in self._groups.values() for each in group]

    def _next(self) -> int:
        self._made += 1
        return self._made


def _remove(debugger: Debugger, gone: _Set) -> None:
    if gone.number in {each.number for each in debugger.stop_points.breakpoints}:
        debugger.stop_points.remove(gone.number)


def _set(session: EditorSession, wanted: _Set) -> None:
    """Sets a breakpoint, or notes why it cannot be."""
    wish = wanted.wish
    try:
        made = _ADD[wish.kind](session, wish)
    except DebugError as error:
        wanted.number, wanted.message, wanted.location = 0, str(error), None
        return
    wanted.number, wanted.location = made.number, _location(made)
    wanted.message = made.place.note if made.place else ""


def _ignored(hits: str) -> int:
    """Gives how many hits are passed over.

    Raises:
        DebugError: it cannot be said so.

    >>> _ignored(""), _ignored("3"), _ignored(">= 3"), _ignored(">3")
    (0, 2, 2, 3)
    """
    if not hits.strip():
        return 0
    match = _HITS.fullmatch(hits)
    if match is None or (int(match[2]) == 0 and match[1] != ">"):
        raise DebugError(f"'{hits}' is no hit count: say N or >= N to stop from hit N on, or > N")
    return int(match[2]) - (match[1] != ">")


def _add_line(session: EditorSession, wish: Wish) -> Breakpoint:
    file = session.places.file_at(wish.what)
    if file is None:
        raise DebugError("no program of this run is made of this file")
    return _add_place(session, f"{file}:{wish.line}", wish)


def _add_function(session: EditorSession, wish: Wish) -> Breakpoint:
    return _add_place(session, wish.what, wish)


def _add_place(session: EditorSession, place: str, wish: Wish) -> Breakpoint:
    ignore = _ignored(wish.hits)
    add = session.opened().stop_points.add_breakpoint
    return add(place, condition=wish.condition, ignore=ignore, log=wish.log)


def data_id(robot: int, function: str, expression: str) -> str:
    """Gives a name for an object, which tells where its expression has a meaning.

    Args:
        robot: the number of the robot.
        function: the active function; empty for what all know.
        expression: a C expression without side effects.
    """
    return f"{robot} {function or '-'} {expression}"


def _add_data(session: EditorSession, wish: Wish) -> Breakpoint:
    """Watches the object that a `data_id` means."""
    debugger = session.opened()
    robot, _, rest = wish.what.partition(" ")
    function, _, expression = rest.partition(" ")
    if not (robot.isascii() and robot.isdigit() and len(robot) < 9 and expression):
        raise DebugError(f"'{wish.what}' is nothing that was given out as data")
    before = debugger.view.robot, debugger.view.frame
    try:
        debugger.view.select_robot(int(robot))
        found = [each.number for each in debugger.view.frames() if each.function == function]
        if found:
            debugger.view.select_frame(found[0])
        return debugger.stop_points.add_watchpoint(
            expression,
            ACCESS[wish.access],
            condition=wish.condition,
            ignore=_ignored(wish.hits),
            robot=int(robot),
        )
    finally:
        debugger.view.robot, debugger.view.frame = before


def _add_exception(session: EditorSession, wish: Wish) -> Breakpoint:
    return session.opened().stop_points.add_catchpoint(wish.what, condition=wish.condition)


def _location(made: Breakpoint) -> Location | None:
    return made.place.location if made.place else None


def _body(session: EditorSession, each: _Set) -> Message:
    """Gives what a client is told of a breakpoint."""
    body: Message = {"id": each.id, "verified": bool(each.number)}
    message = each.message or ("" if session.debugger else "nothing is launched yet")
    if message:
        body["message"] = message
    if each.location is not None:
        place = session.places.place(each.location)
        body |= {"source": place["source"], "line": place["line"]}
    return body


def _tell(session: EditorSession, reason: str, body: Message) -> None:
    session.connection.event("breakpoint", {"reason": reason, "breakpoint": body})


_ADD: Final[dict[str, Callable[[EditorSession, Wish], Breakpoint]]] = {
    "line": _add_line,
    "function": _add_function,
    "data": _add_data,
    "exception": _add_exception,
}

ACCESS: Final[dict[str, Access]] = {"write": "change", "read": "read", "readWrite": "access"}
"""The debugger's words for the protocol's; a write of the same value interests nobody."""
