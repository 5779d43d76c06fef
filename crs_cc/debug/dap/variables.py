"""The contents of scopes: variables, `State[]`, robot, world; and C expressions for them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from crs_cc.debug.dap.arguments import Arguments, RefusalError
from crs_cc.debug.dap.framing import Message
from crs_cc.debug.dap.session import EditorSession
from crs_cc.debug.dap.value_messages import (
    ExpandableValue,
    FrameHandle,
    child_messages,
    value_message,
)
from crs_cc.debug.data.part_expression import child_expression
from crs_cc.debug.data.variables import Variable
from crs_cc.debug.world.robot_rows import robot_rows
from crs_cc.debug.world.rows import Row
from crs_cc.debug.world.state_rows import state_rows
from crs_cc.debug.world.world_rows import world_rows
from crs_cc.ir.types import ArrayType

_INDEX: Final = re.compile(r"\[(\d+)\].*")
_HIDDEN: Final = " (hidden)"
_MAX: Final = 10_000  # parts in one answer; chosen by us


@dataclass(frozen=True, slots=True)
class ScopeHandle:
    """A scope of a stack frame.

    Attributes:
        at: the frame.
    """

    name: str
    at: FrameHandle


@dataclass(frozen=True, slots=True)
class RowsHandle:
    """Rows of text."""

    rows: Sequence[Row]


def scopes_at(session: EditorSession, at: FrameHandle) -> Iterator[Message]:
    """Return the scopes of a frame, or of a program without one."""
    hints = {"Locals": "locals"}
    for name in _SCOPES:
        if at.frame is None and name == "Locals":
            continue
        if name == "State" and not session.require_debugger().view.vendor_state(at.robot):
            continue
        scope = {
            "name": name,
            "variablesReference": session.handles.add(ScopeHandle(name, at)),
            "expensive": False,
        }
        yield scope | ({"presentationHint": hints[name]} if name in hints else {})


def variables(session: EditorSession, arguments: Arguments) -> Message:
    """Return the variables of a scope, or the parts of a value."""
    handle = session.handles.get(arguments.integer("variablesReference"))
    start, count = arguments.natural("start", 0), arguments.natural("count", 0)
    wanted = arguments.text("filter", "")
    match handle:
        case ExpandableValue():
            is_array = isinstance(handle.value.type, ArrayType)
            if wanted and (wanted == "indexed") != is_array:
                return {"variables": []}
            made = list(child_messages(session, handle, start, min(count or _MAX, _MAX)))
            left = handle.value.child_count - start - len(made)
            if left > 0 and not count:  # for clients that do not ask piece by piece
                made.append({"name": "...", "value": f"{left:,} more", "variablesReference": 0})
            return {"variables": made}
        case RowsHandle():
            made = [_row(session, row) for row in handle.rows]
        case ScopeHandle():
            made = list(_SCOPES[handle.name](session, handle.at))
        case _:
            raise RefusalError("unknown 'variablesReference'")
    if wanted == "indexed":
        return {"variables": []}
    return {"variables": made[start : start + count] if count else made[start:]}


def expression_of(session: EditorSession, arguments: Arguments) -> tuple[FrameHandle, str]:
    """Return the C expression for a named part of a variable, and its scope.

    Raises:
        RefusalError: there is none.
    """
    handle = session.handles.get(arguments.integer("variablesReference"))
    name = arguments.text("name")
    expression = ""
    if isinstance(handle, ExpandableValue):
        expression = child_expression(handle.expression, name)
    elif isinstance(handle, ScopeHandle) and handle.name in {"Locals", "Globals"}:
        expression = "" if name.endswith(_HIDDEN) else name
    elif isinstance(handle, ScopeHandle) and handle.name == "State":
        found = _INDEX.fullmatch(name)
        expression = f"State[{found[1]}]" if found else ""
    if not expression:
        raise RefusalError(f"'{name}' cannot be expressed in C: it is read only")
    return handle.at, expression


def _row(session: EditorSession, row: Row) -> Message:
    parts = session.handles.add(RowsHandle(row.children)) if row.children else 0
    hint = {"attributes": ["readOnly"]}
    return {
        "name": row.name,
        "value": row.text,
        "variablesReference": parts,
        "presentationHint": hint,
    }


def _locals(session: EditorSession, at: FrameHandle) -> Iterator[Message]:
    found = session.require_debugger().view.variables(robot=at.robot, frame=at.frame)
    return _variables(session, found, at)


def _globals(session: EditorSession, at: FrameHandle) -> Iterator[Message]:
    return _variables(session, session.require_debugger().view.globals_(robot=at.robot), at)


def _variables(
    session: EditorSession, found: Iterable[Variable], at: FrameHandle
) -> Iterator[Message]:
    for each in found:
        expression = "" if each.is_hidden else each.name
        name = each.name + _HIDDEN * each.is_hidden
        yield {"name": name, **value_message(session, each.value, expression, at)}


def _state_rows(session: EditorSession, at: FrameHandle) -> Iterator[Message]:
    """Return the numbers of `State[]` with their names and units."""
    elements = session.require_debugger().view.vendor_state(at.robot)
    for row, (field, _) in zip(state_rows(elements), elements, strict=True):
        yield {
            "name": row.name,
            "value": row.text,
            "variablesReference": 0,
            "evaluateName": f"State[{field.index}]",
        }


def _robot(session: EditorSession, at: FrameHandle) -> Iterator[Message]:
    for row in robot_rows(session.require_debugger().session, at.robot):
        yield _row(session, row)


def _world(session: EditorSession, _at: FrameHandle) -> Iterator[Message]:
    for row in world_rows(session.require_debugger().session.environment):
        yield _row(session, row)


_SCOPES: Final[dict[str, Callable[[EditorSession, FrameHandle], Iterator[Message]]]] = {
    "Locals": _locals,
    "Globals": _globals,
    "State": _state_rows,
    "Robot": _robot,
    "World": _world,
}
"""The scopes, in the order in which they are shown."""
