"""What the source pane shows: where a program stands, its stack and variables, and breakpoints."""

from __future__ import annotations

from pathlib import PurePath
from typing import TYPE_CHECKING, Any, Final

from crs_cc.debug.errors import DebugError

if TYPE_CHECKING:
    from collections.abc import Iterator

    from crs_cc.debug.engine import Debugger
    from crs_cc.workbench.context import Context

_MAX_FRAMES: Final = 100
_MAX_VARIABLES: Final = 200


def where(debugger: Debugger) -> dict[str, Any]:
    """Return where the selected robot's program stands."""
    view = debugger.view
    program = debugger.run.programs[view.robot]
    place, own = view.location(), [each for each in view.frames() if not each.is_library]
    if place is None and own:
        place = own[0].location
    return {
        "robot": view.robot,
        "file": place.file if place else str(program.paths[0]),
        "line": place.line if place else 0,
        "files": list(program.executable.detail().lines),
        "innermost": not own or own[0].number == view.frame,
        "frames": [
            {
                "number": each.number,
                "function": each.function,
                "file": PurePath(each.location.file).name,
                "line": each.location.line,
                "library": each.is_library,
                "current": each.number == view.frame,
            }
            for each in view.frames()[:_MAX_FRAMES]
        ],
        "variables": list(_variables(debugger)),
        "breakpoints": list(_breakpoints(debugger)),
    }


def _variables(debugger: Debugger) -> Iterator[dict[str, str]]:
    try:
        found = [*debugger.view.variables(), *debugger.view.globals_()]
    except DebugError:  # the source has changed since
        return
    for each in found[:_MAX_VARIABLES]:
        yield {
            "name": each.name,
            "value": each.value.text,
            "type": str(each.value.type),
            "scope": each.scope,
        }


def _breakpoints(debugger: Debugger) -> Iterator[dict[str, Any]]:
    for each in debugger.stop_points.breakpoints:
        place = each.place.location if each.place else None
        yield {
            "number": each.number,
            "kind": each.kind,
            "text": each.text,
            "condition": each.condition,
            "enabled": each.enabled,
            "log": each.log,
            "hits": each.hits,
            "file": place.file if place else "",
            "line": place.line if place else 0,
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
        for site in program.executable.detail().compiled.statements
        if site.location.file == file
    }
    return {"file": file, "lines": list(lines), "code": sorted(code)}


def toggle_breakpoint(screen: Context, file: str, line: int) -> dict[str, Any]:
    """Set a breakpoint at a line, or remove the one that is there."""
    points = screen.run.debugger().stop_points
    for each in points.breakpoints:
        place = each.place.location if each.place else None
        if place is not None and (place.file, place.line) == (file, line):
            points.remove(each.number)
            return {"removed": each.number}
    made = points.add_breakpoint(f"{file}:{line}")
    return {"added": made.number, "note": made.place.note if made.place else ""}
