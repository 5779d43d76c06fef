"""Requests for a program's memory; a memory reference names the robot and an address."""

from __future__ import annotations

import base64
import binascii
import re
from typing import Final

from crs_cc.debug.dap.arguments import Arguments, RefusalError
from crs_cc.debug.dap.framing import Message
from crs_cc.debug.dap.session import EditorSession

_REFERENCE: Final = re.compile(r"(\d{1,9}):0x([0-9a-f]{1,8})")
_MAX_READ: Final = 2**20  # bytes in one answer; chosen by us
_MAX_WRITTEN: Final = 128  # bytes at once, as each is a part of one expression; chosen by us


def reference_of(robot: int, address: int) -> str:
    """Return the memory reference of an address.

    >>> reference_of(1, 4096)
    '1:0x1000'
    """
    return f"{robot}:{address:#x}"


def _address(session: EditorSession, arguments: Arguments) -> tuple[int, int]:
    """Return the robot and the address of a request.

    Raises:
        RefusalError: its memory reference is invalid.
    """
    found = _REFERENCE.fullmatch(arguments.text("memoryReference"))
    if found is None or int(found[1]) >= len(session.require_debugger().names):
        raise RefusalError("unknown 'memoryReference'")
    return int(found[1]), int(found[2], 16) + arguments.integer("offset", 0)


def read_memory(session: EditorSession, arguments: Arguments) -> Message:
    """Return bytes, as many as exist."""
    robot, address = _address(session, arguments)
    count = arguments.natural("count")
    memory = session.require_stopped().session.fleet.memory(robot)
    if not 0 <= address < len(memory):
        return {"address": f"{max(address, 0):#x}", "unreadableBytes": count}
    content = memory[address : address + min(count, _MAX_READ)].tobytes()
    body: Message = {"address": f"{address:#x}", "data": base64.b64encode(content).decode()}
    if len(content) < count:
        body["unreadableBytes"] = count - len(content)
    return body


def write_memory(session: EditorSession, arguments: Arguments) -> Message:
    """Write bytes that C may write."""
    robot, address = _address(session, arguments)
    try:
        content = base64.b64decode(arguments.text("data"), validate=True)
    except (binascii.Error, ValueError):
        raise RefusalError("'data' is not valid base64") from None
    if len(content) > _MAX_WRITTEN:
        raise RefusalError(f"at most {_MAX_WRITTEN} bytes can be written at once")
    if content and address >= 0:
        parts = (f"((unsigned char *){address}u)[{n}] = {byte}" for n, byte in enumerate(content))
        session.require_stopped().evaluate(", ".join(parts), robot=robot)
        session.report_memory_written(reference_of(robot, address), len(content))
    return {"bytesWritten": len(content)}
