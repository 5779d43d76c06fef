"""Values as a client shows them: a line each, and their parts when somebody unfolds them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from crs_cc.debug.dap.arguments import RefusalError
from crs_cc.debug.dap.memory import reference_of
from crs_cc.debug.errors import DebugError
from crs_cc.debug.robot_rows import robot_rows
from crs_cc.debug.state_rows import state_fields
from crs_cc.debug.world_rows import world_rows
from crs_cc.ir.types import ArrayType, PointerType, RecordType

if TYPE_CHECKING:
    from crs_cc.debug.dap.arguments import Arguments
    from crs_cc.debug.dap.framing import Message
    from crs_cc.debug.dap.session import EditorSession
    from crs_cc.debug.rows import Row
    from crs_cc.debug.values import Value
    from crs_cc.debug.variables import Variable

_INDEX: Final = re.compile(r"\[(\d+)\].*")
_POSTFIX: Final = r"(?:[\w.\[\]]|->)+"
"""Expressions that need no parentheses before another postfix operator (C17 6.5.2)."""

_MOST: Final = 10_000  # parts in one answer; chosen by us


@dataclass(frozen=True, slots=True)
class FrameHandle:
    """An active function of a robot's program.

    Attributes:
        robot: the robot's number.
        frame: the function's; None for a program without one.
        function: its name; empty without one.
    """

    robot: int
    frame: int | None = None
    function: str = ""


def frame_handle(session: EditorSession, arguments: Arguments) -> FrameHandle:
    """Gives the active function that a request means; the one looked at where it means none.

    Raises:
        RefusalError: it is gone.
    """
    debugger = session.opened()
    if "frameId" not in arguments:
        frame = debugger.current_frame()
        if frame is None:
            return FrameHandle(debugger.robot)
        return FrameHandle(debugger.robot, frame.number, frame.function)
    found = session.handles.take(arguments.integer("frameId"))
    if not isinstance(found, FrameHandle):
        raise RefusalError("'frameId' is that of no frame")
    return found


@dataclass(frozen=True, slots=True)
class Scope:
    """What can be looked at from an active function.

    Attributes:
        name: which of it.
        at: the function.
    """

    name: str
    at: FrameHandle


@dataclass(frozen=True, slots=True)
class Parts:
    """A value with parts.

    Attributes:
        value: it.
        expression: the C expression that gives it; empty for none.
        at: from where.
    """

    value: Value
    expression: str
    at: FrameHandle


@dataclass(frozen=True, slots=True)
class Rows:
    """Rows of text."""

    rows: Sequence[Row]


def scopes_at(session: EditorSession, at: FrameHandle) -> Iterator[Message]:
    """Gives the scopes of an active function, or of a program without one."""
    hints = {"Locals": "locals"}
    for name in _SCOPES:
        if at.frame is None and name == "Locals":
            continue
        if name == "State" and _state(session, at) is None:
            continue
        scope = {
            "name": name,
            "variablesReference": session.handles.give(Scope(name, at)),
            "expensive": False,
        }
        yield scope | ({"presentationHint": hints[name]} if name in hints else {})


def variables(session: EditorSession, arguments: Arguments) -> Message:
    """Gives what stands in a scope, or the parts of a value."""
    thing = session.handles.take(arguments.integer("variablesReference"))
    start, count = arguments.natural("start", 0), arguments.natural("count", 0)
    wanted = arguments.text("filter", "")
    match thing:
        case Parts():
            is_array = isinstance(thing.value.type, ArrayType)
            if wanted and (wanted == "indexed") != is_array:
                return {"variables": []}
            rows = _parts(session, thing, start, min(count or _MOST, _MOST))
            return {"variables": list(rows)}
        case Rows():
            made = [_row(session, row) for row in thing.rows]
        case Scope():
            made = list(_SCOPES[thing.name](session, thing.at))
        case _:
            raise RefusalError("'variablesReference' is that of nothing with parts")
    if wanted == "indexed":
        return {"variables": []}
    return {"variables": made[start : start + count] if count else made[start:]}


def _parts(session: EditorSession, parts: Parts, start: int, count: int) -> Iterator[Message]:
    for name, value in parts.value.children(start, count):
        expression = part_of(parts.expression, name)
        yield {"name": name, **shown(session, value, expression, parts.at)}


def _unfolded(value: Value, expression: str) -> tuple[Value, str]:
    """Gives the value whose parts are shown: of a pointer to a struct, the struct."""
    if isinstance(value.type, PointerType) and isinstance(value.type.target, RecordType):
        for name, target in value.children():
            return target, part_of(expression, name)
    return value, expression


def part_of(expression: str, name: str) -> str:
    """Gives the C expression for a part of a value.

    >>> part_of("row", "[2]"), part_of("*here", "x"), part_of("next", "*"), part_of("", "x")
    ('row[2]', 'here->x', '*next', '')
    """
    if not expression:
        return ""
    whole = expression if re.fullmatch(_POSTFIX, expression) else f"({expression})"
    if name == "*":
        return f"*{whole}"
    if name.startswith("["):
        return whole + name
    if name.startswith("<"):  # without a name: its members are those of the whole
        return expression
    pointer = re.fullmatch(rf"\*({_POSTFIX})", expression)
    return f"{pointer[1]}->{name}" if pointer else f"{whole}.{name}"


def shown(
    session: EditorSession,
    value: Value,
    expression: str,
    at: FrameHandle,
    *,
    text: str | None = None,
    key: str = "value",
) -> Message:
    """Gives a value as the client takes it.

    Args:
        session: the session.
        value: the value.
        expression: the C expression that gives it; empty for none.
        at: from where.
        text: what to show of it; by default its line.
        key: what the protocol calls that.
    """
    whole, its_expression = _unfolded(value, expression)
    count = whole.child_count
    body: Message = {
        key: value.text if text is None else text,
        "type": str(value.type),
        "variablesReference": 0,
    }
    if count:
        body["variablesReference"] = session.handles.give(Parts(whole, its_expression, at))
        indexed = isinstance(whole.type, ArrayType)
        body["indexedVariables" if indexed else "namedVariables"] = count
    if expression and key == "value":
        body["evaluateName"] = expression
    if value.address is not None:
        body["memoryReference"] = reference_of(at.robot, value.address)
    return body


def expression_of(session: EditorSession, arguments: Arguments) -> tuple[FrameHandle, str]:
    """Gives the C expression for what has a name in something with parts, and where it holds.

    Raises:
        RefusalError: there is none.
    """
    thing = session.handles.take(arguments.integer("variablesReference"))
    name = arguments.text("name")
    expression = ""
    if isinstance(thing, Parts):
        expression = part_of(thing.expression, name)
    elif isinstance(thing, Scope) and thing.name in {"Locals", "Globals"}:
        expression = name.partition(" ")[0]  # behind a blank we say that it is hidden
    elif isinstance(thing, Scope) and thing.name == "State":
        found = _INDEX.fullmatch(name)
        expression = f"State[{found[1]}]" if found else ""
    if not expression or (" " in name and not isinstance(thing, Scope)):
        raise RefusalError(f"'{name}' has no name in C: it can only be looked at")
    return thing.at, expression


def _row(session: EditorSession, row: Row) -> Message:
    parts = session.handles.give(Rows(row.children)) if row.children else 0
    hint = {"attributes": ["readOnly"]}
    return {
        "name": row.name,
        "value": row.text,
        "variablesReference": parts,
        "presentationHint": hint,
    }


def _locals(session: EditorSession, at: FrameHandle) -> Iterator[Message]:
    found = session.opened().variables(robot=at.robot, frame=at.frame)
    return _variables(session, found, at)


def _globals(session: EditorSession, at: FrameHandle) -> Iterator[Message]:
    return _variables(session, session.opened().globals_(robot=at.robot), at)


def _variables(
    session: EditorSession, found: Iterable[Variable], at: FrameHandle
) -> Iterator[Message]:
    for each in found:
        expression = "" if each.is_hidden else each.name
        name = f"{each.name} (hidden)" if each.is_hidden else each.name
        yield {"name": name, **shown(session, each.value, expression, at)}


def _state(session: EditorSession, at: FrameHandle) -> Value | None:
    """Gives a program's `State[]`, if it has one."""
    debugger = session.opened()
    frame = debugger.first_own_frame(at.robot) if at.frame is not None else None
    try:
        value = debugger.look_up("State", robot=at.robot, frame=frame)
    except DebugError:
        return None
    return value if isinstance(value.type, ArrayType) else None


def _state_rows(session: EditorSession, at: FrameHandle) -> Iterator[Message]:
    """Gives the numbers of `State[]` with their names and units."""
    debugger, state = session.opened(), _state(session, at)
    if state is None:
        return
    drive = debugger.session.environment.world.robots[at.robot].model.drive
    dialect = debugger.run.programs[at.robot].options.dialect
    fields = state_fields(dialect, synchro=drive.steering is not None)
    for field, (_, value) in zip(fields, state.children(), strict=False):
        number = value.number
        text = field.text(number) if isinstance(number, int) else value.text
        yield {
            "name": f"[{field.index}] {field.name}",
            "value": text,
            "type": str(value.type),
            "variablesReference": 0,
            "evaluateName": f"State[{field.index}]",
        }


def _robot(session: EditorSession, at: FrameHandle) -> Iterator[Message]:
    for row in robot_rows(session.opened().session, at.robot):
        yield _row(session, row)


def _world(session: EditorSession, _at: FrameHandle) -> Iterator[Message]:
    for row in world_rows(session.opened().session.environment):
        yield _row(session, row)


_SCOPES: Final[dict[str, Callable[[EditorSession, FrameHandle], Iterator[Message]]]] = {
    "Locals": _locals,
    "Globals": _globals,
    "State": _state_rows,
    "Robot": _robot,
    "World": _world,
}
"""The scopes, in the order in which they are shown."""
