"""The debugger's commands in the page: those of its table that touch no file of this machine."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from crs_cc.debug.commands.answer import Line
from crs_cc.debug.commands.completion import complete
from crs_cc.debug.commands.table import COMMANDS, find
from crs_cc.debug.errors import DebugError

if TYPE_CHECKING:
    from crs_cc.workbench.context import Context

REFUSED: Final = frozenset(
    {
        *("source", "save breakpoints", "quit", "shell", "jump"),  # files, the end, or nothing
        "commands",  # asks for further lines
        *("branch", "switch", "compare"),  # pages have buttons for them
    }
)
"""Commands that the page does not have."""

ALLOWED: Final = frozenset(each.name for each in COMMANDS) - REFUSED
MAX_LINES: Final = 1000


def check_allowed(line: str) -> None:
    """Raise DebugError if a line is no command of the page."""
    name = find(line)[0].name
    if name not in ALLOWED:
        raise DebugError(f"'{name}' is not available in the browser")


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
        for each in screen.run.shell().execute(line):
            if len(lines) < MAX_LINES:
                kind = each.kind if isinstance(each, Line) else "source"
                lines.append([kind, each.text])
    return {"lines": lines}


def completions(screen: Context, line: str) -> dict[str, Any]:
    """Return the completions of a line."""
    found = complete(screen.run.shell().context, line)
    words = [] if line.split(" ", maxsplit=1)[0] in REFUSED else list(found.words[:200])
    return {"start": found.start, "words": words}
