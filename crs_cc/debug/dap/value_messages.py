"""Messages for values: a line each, and their parts when expanded."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from crs_cc.debug.dap.arguments import Arguments, RefusalError
from crs_cc.debug.dap.framing import Message
from crs_cc.debug.dap.memory import reference_of
from crs_cc.debug.dap.session import EditorSession
from crs_cc.debug.data.part_expression import child_expression
from crs_cc.debug.data.values import Value
from crs_cc.ir.types import ArrayType, PointerType, RecordType


@dataclass(frozen=True, slots=True)
class FrameHandle:
    """A stack frame of a robot's program.

    Attributes:
        robot: the robot's number.
        frame: the number of the frame; None for a program without one.
        function: the name of its function; empty without one.
    """

    robot: int
    frame: int | None = None
    function: str = ""


def requested_frame(session: EditorSession, arguments: Arguments) -> FrameHandle:
    """Return the frame of a request; by default the selected one.

    Raises:
        RefusalError: it is no longer valid.
    """
    debugger = session.require_debugger()
    if "frameId" not in arguments:
        frame = debugger.view.current_frame()
        if frame is None:
            return FrameHandle(debugger.view.robot)
        return FrameHandle(debugger.view.robot, frame.number, frame.function)
    found = session.handles.get(arguments.integer("frameId"))
    if not isinstance(found, FrameHandle):
        raise RefusalError("unknown 'frameId'")
    return found


@dataclass(frozen=True, slots=True)
class ExpandableValue:
    """A value with parts.

    Attributes:
        expression: a C expression for it; empty for none.
        at: the scope of the expression.
    """

    value: Value
    expression: str
    at: FrameHandle


def child_messages(
    session: EditorSession, parts: ExpandableValue, start: int, count: int
) -> Iterator[Message]:
    """Return the messages for some parts of a value."""
    for name, value in parts.value.children(start, count):
        expression = child_expression(parts.expression, name)
        yield {"name": name, **value_message(session, value, expression, parts.at)}


def _unfolded(value: Value, expression: str) -> tuple[Value, str]:
    """Return the value whose parts are shown: for a pointer to a struct, the struct."""
    if isinstance(value.type, PointerType) and isinstance(value.type.target, RecordType):
        for name, target in value.children():
            return target, child_expression(expression, name)
    return value, expression


def value_message(
    session: EditorSession,
    value: Value,
    expression: str,
    at: FrameHandle,
    *,
    text: str | None = None,
    key: str = "value",
) -> Message:
    """Return the message for a value.

    Args:
        session: the session.
        value: the value.
        expression: a C expression for it; empty for none.
        at: the scope of the expression.
        text: its text; by default its line.
        key: the protocol's name of the text.
    """
    whole, its_expression = _unfolded(value, expression)
    count = whole.child_count
    body: Message = {
        key: value.text if text is None else text,
        "variablesReference": 0,
    }
    if session.client.flag("supportsVariableType", default=False):
        body["type"] = str(value.type)
    if count:
        body["variablesReference"] = session.handles.add(ExpandableValue(whole, its_expression, at))
        indexed = isinstance(whole.type, ArrayType)
        body["indexedVariables" if indexed else "namedVariables"] = count
    if expression and key == "value":
        body["evaluateName"] = expression
    takes_memory = session.client.flag("supportsMemoryReferences", default=False)
    if takes_memory and value.address is not None:
        body["memoryReference"] = reference_of(at.robot, value.address)
    return body
