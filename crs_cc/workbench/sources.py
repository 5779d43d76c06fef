"""The contents of the source pane: the current line of a program, its stack, and its error."""

from __future__ import annotations

from pathlib import PurePath
from typing import TYPE_CHECKING, Any, Final

from crs_cc.core.source import underline
from crs_cc.debug.commands.stop_text import frame_text
from crs_cc.debug.errors import DebugError
from crs_cc.workbench.positions import position_text
from crs_cc.workbench.stops import breakpoints

if TYPE_CHECKING:
    from collections.abc import Iterator

    from crs_cc.debug.commands.shell import Shell
    from crs_cc.debug.engine import Debugger
    from crs_cc.workbench.context import Context

_MAX_FRAMES: Final = 200  # a runaway recursion has ten thousand


def where(shell: Shell) -> dict[str, Any]:
    """Return the current location of the selected robot's program."""
    debugger = shell.debugger
    view = debugger.view
    program = debugger.run.programs[view.robot]
    place, own = view.location(), [each for each in view.frames() if not each.is_library]
    if place is None and own:
        place = own[0].location
    return {
        "robot": view.robot,
        "place": position_text(debugger.position),
        "statement": debugger.run.sites_passed(view.robot),
        "file": place.file if place else next(iter(program.files)),
        "line": place.line if place else 0,
        "files": list(program.executable.detail().lines),
        "innermost": not own or own[0].number == view.frame,
        "frames": list(_frames(debugger)),
        "breakpoints": list(breakpoints(shell)),
        "error": _error(debugger),
    }


def _frames(debugger: Debugger) -> Iterator[dict[str, Any]]:
    """Yield the stack; of library frames only those that the user's code has called."""
    frames = debugger.view.frames()
    for each in frames[:_MAX_FRAMES]:
        caller = frames[each.number + 1] if each.number + 1 < len(frames) else None
        if each.is_library and caller is not None and caller.is_library:
            continue
        _, _, arguments = frame_text(debugger, each).partition(" at ")[0].partition(" ")
        yield {
            "number": each.number,
            "function": each.function,
            "arguments": "" if each.is_library else arguments,
            "file": PurePath(each.location.file).name,
            "line": each.location.line,
            "library": each.is_library,
            "current": each.number == debugger.view.frame,
        }


def _error(debugger: Debugger) -> dict[str, Any] | None:
    """Return the error that stopped the selected robot's program, and the expression at fault."""
    robot = debugger.view.robot
    if not debugger.run.has_failed(robot):
        return None
    found = debugger.session.fleet.report(robot)
    place, line = found.location, found.source_line
    return {
        "kind": found.kind,
        "text": found.text,
        "values": list(found.values),
        "notes": list(found.notes),
        "file": place.file,
        "line": place.line,
        "column": place.column,
        "length": len(underline(line, place)) if line and place.column else 0,
    }


def source(screen: Context, file: str) -> dict[str, Any]:
    """Return the lines of a C file of a program, and which of them have code."""
    debugger = screen.run.debugger()
    lines = debugger.view.source(file)
    if not lines:
        raise DebugError(f"no source '{file}' in this run")
    code = {
        site.location.line
        for program in {id(each): each for each in debugger.run.programs}.values()
        for _, site in program.executable.detail().compiled.breakable()
        if site.location.file == file
    }
    return {"file": file, "lines": list(lines), "code": sorted(code)}
