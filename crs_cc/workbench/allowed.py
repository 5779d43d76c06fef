"""Which commands of the debugger pages may execute: those that touch no file of this machine."""

from __future__ import annotations

from typing import Final

from crs_cc.debug.commands.command import Command
from crs_cc.debug.commands.table import COMMANDS, find
from crs_cc.debug.errors import DebugError

_FILES: Final = frozenset(each.name for each in COMMANDS if each.completes == "file")

REFUSED: Final = _FILES | {
    *("quit", "shell", "jump"),  # the end, or nothing
    "commands",  # asks for further lines
    *("branch", "switch", "compare"),  # pages have buttons for them
}
"""Commands that the page does not have."""

ALLOWED: Final = frozenset(each.name for each in COMMANDS) - REFUSED


def check_command(command: Command) -> None:
    """Raise DebugError if a command is not permitted for pages, however it is called."""
    if command.name not in ALLOWED:
        raise DebugError(f"'{command.name}' is not available in the browser")


def may_complete(line: str) -> bool:
    """Return whether a line may be completed: a refused command would list files."""
    try:
        return find(line)[0].name in ALLOWED
    except DebugError:  # its command is not typed yet
        return True


def check_allowed(line: str) -> None:
    """Raise DebugError if a line is no command of the page."""
    check_command(find(line)[0])
