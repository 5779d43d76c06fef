"""Where the run stops: breakpoints, watchpoints and catchpoints as the page sets them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from crs_cc.core.suggest import unknown
from crs_cc.debug.errors import DebugError
from crs_cc.debug.world.events import KINDS
from crs_cc.workbench.allowed import check_allowed

if TYPE_CHECKING:
    from collections.abc import Iterator

    from crs_cc.debug.breakpoints import Breakpoint
    from crs_cc.debug.commands.shell import Shell
    from crs_cc.workbench.context import Context

_MAX_COMMANDS: Final = 50


def breakpoints(shell: Shell) -> Iterator[dict[str, Any]]:
    """Yield all that the run stops at."""
    for each in shell.debugger.stop_points.breakpoints:
        place = each.location.location if each.location else None
        yield {
            "number": each.number,
            "kind": each.kind,
            "text": each.text,
            "access": each.watch.watched.kind if each.watch else "",
            "condition": each.condition,
            "enabled": each.enabled,
            "log": each.log,
            "hits": each.hits,
            "ignore": each.ignore,
            "temporary": each.temporary,
            "robot": -1 if each.robot is None else each.robot,
            "commands": "\n".join(shell.context.scripts.get(each.number, ())),
            "file": place.file if place else "",
            "line": place.line if place else 0,
        }


def toggle(screen: Context, file: str, line: int) -> dict[str, Any]:
    """Set a breakpoint at a line, or remove the one that is there."""
    points = screen.run.debugger().stop_points
    found = _at(screen, file, line)
    if found is not None:
        points.remove(found.number)
        return {"removed": found.number}
    made = points.add_breakpoint(f"{file}:{line}")
    return {"added": made.number, "note": made.location.note if made.location else ""}


def change(
    screen: Context, *, file: str, line: int, condition: str, log: str, robot: int, ignore: int,
    commands: str, enabled: bool,
) -> dict[str, Any]:  # fmt: skip
    """Change the breakpoint at a line, or set one.

    Args:
        screen: the screen.
        file: the file.
        line: the line.
        condition: stop only if this is true; empty to stop always.
        log: print this instead of stopping; empty to stop.
        robot: the only robot that it stops; -1 for all.
        ignore: how many hits do not count.
        commands: what to do there, a command in each line.
        enabled: whether it is enabled.

    Raises:
        DebugError: something is not valid; nothing has changed.
    """
    debugger = screen.run.debugger()
    if not -1 <= robot < len(debugger.names):
        raise DebugError(unknown("robot", str(robot), debugger.names))
    lines = tuple(each.strip() for each in commands.split("\n") if each.strip())
    if len(lines) > _MAX_COMMANDS:
        raise DebugError(f"at most {_MAX_COMMANDS} commands")
    for each in lines:
        if each != "silent":
            check_allowed(each)
    own = _at(screen, file, line)
    points = debugger.stop_points
    if own is None:
        own = points.add_breakpoint(f"{file}:{line}", condition=condition.strip())
    else:
        points.set_condition(own.number, condition.strip())
    own.log, own.enabled, own.ignore = " ".join(log.split("\n")).strip(), enabled, max(0, ignore)
    own.robot = None if robot < 0 else robot
    shell = screen.run.shell()
    shell.context.scripts.pop(own.number, None)
    if lines:
        shell.context.scripts[own.number] = lines
    return {"number": own.number}


def events(_screen: Context) -> list[tuple[str, str]]:
    """Return the kinds of events that can be caught, with their meanings."""
    return [("exit", "a program ended"), *KINDS.items()]


def _at(screen: Context, file: str, line: int) -> Breakpoint | None:
    """Return the breakpoint at a line; None if there is none."""
    for each in screen.run.debugger().stop_points.breakpoints:
        place = each.location.location if each.location else None
        if place is not None and (place.file, place.line) == (file, line):
            return each
    return None
