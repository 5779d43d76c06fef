"""The debugger's commands in the page, as far as `allowed` has them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from crs_cc.debug.commands.answer import Line
from crs_cc.debug.commands.completion import complete
from crs_cc.debug.errors import DebugError
from crs_cc.workbench.allowed import check_allowed, may_complete
from crs_cc.workbench.positions import position_text

if TYPE_CHECKING:
    from crs_cc.workbench.context import Context

MAX_LINES: Final = 1000
MAX_PLACES: Final = 5000


def execute(screen: Context, line: str) -> dict[str, Any]:
    """Execute a line of the console; return the lines of its answer."""
    line = line.strip()
    if "\n" in line:
        raise DebugError("one line at a time")
    if line:
        check_allowed(line)
    screen.player.pause()
    lines: list[list[str]] = []
    with screen.working():
        shell = screen.run.shell()
        before = shell.context.instants
        for each in shell.execute(line):
            if len(lines) < MAX_LINES:
                kind = each.kind if isinstance(each, Line) else "source"
                lines.append([kind, each.text])
        listed = shell.context.instants
    # The numbers of a list, @3, are places to which a page can go later, too.
    new = [] if listed is before else listed
    places = [[position_text(each.position), each.robot] for each in new[:MAX_PLACES]]
    return {"lines": lines, "places": places}


def completions(screen: Context, line: str) -> dict[str, Any]:
    """Return the completions of a line."""
    found = complete(screen.run.shell().context, line)
    return {"start": found.start, "words": list(found.words[:200]) if may_complete(line) else []}
