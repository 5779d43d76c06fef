"""Requests for sources and disassembly."""

from __future__ import annotations

from typing import Final

from crs_cc.debug.dap.arguments import Arguments, RefusalError
from crs_cc.debug.dap.disassembly import CodeAddress, CodeLine, code_of
from crs_cc.debug.dap.framing import Message
from crs_cc.debug.dap.session import EditorSession
from crs_cc.ir.names import plain_name
from crs_cc.ir.program import Function

_MAX_INSTRUCTIONS: Final = 10_000  # in one answer; chosen by us


def loaded_sources(session: EditorSession, _arguments: Arguments) -> Message:
    """Return the source files of the programs."""
    session.require_debugger()
    return {"sources": session.locations.sources()}


def source(session: EditorSession, arguments: Arguments) -> Message:
    """Return the text of a file that the client does not have: one of the C library."""
    asked = arguments.object("source") if "source" in arguments else arguments
    file = session.locations.file_at(session.locations.key(asked))
    if file is None:
        raise RefusalError("no program of this run was built from this file")
    lines = session.require_debugger().view.source(file)
    return {"content": session.locations.text(file, lines), "mimeType": "text/x-c"}


def disassemble(session: EditorSession, arguments: Arguments) -> Message:
    """Return lines of code; those outside of the function are marked as invalid."""
    start = CodeAddress.read(arguments.text("memoryReference"))
    count = arguments.natural("instructionCount")
    if count > _MAX_INSTRUCTIONS:
        raise RefusalError(f"'instructionCount' is more than {_MAX_INSTRUCTIONS}")
    function = _function(session, start)
    first = start.line + arguments.integer("offset", 0) + arguments.integer("instructionOffset", 0)
    if not start.reaches(first) or not start.reaches(first + count):
        raise RefusalError("the offset is too far from the function")
    rows = code_of(function)
    symbol = plain_name(function.name)
    made = []
    for line in range(first, first + count):
        row = rows[line] if 0 <= line < len(rows) else None
        address = CodeAddress(start.robot, start.function, line).encode()
        made.append(_instruction(session, address, row) | ({"symbol": symbol} if row else {}))
    return {"instructions": made}


def _instruction(session: EditorSession, address: int, row: CodeLine | None) -> Message:
    said: Message = {"address": f"{address:#x}", "instruction": row.text if row else ""}
    if row is None:
        return said | {"presentationHint": "invalid"}
    if row.location is None:
        return said
    place = session.locations.location(row.location)
    return said | {"location": place["source"], "line": place["line"], "column": place["column"]}


def _function(session: EditorSession, address: CodeAddress) -> Function:
    """Return the function that contains an address; raise RefusalError if there is none."""
    programs = session.require_debugger().run.programs
    if 0 <= address.robot < len(programs):
        functions = list(programs[address.robot].executable.program.functions.values())
        if address.function < len(functions):
            return functions[address.function]
    raise RefusalError("no code at this address")
