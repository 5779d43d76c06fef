"""Tables of `docs/debugger.md`: the commands, from the debugger's command table."""

from __future__ import annotations

from crs_cc.debug.commands.command import Command
from crs_cc.debug.commands.table import GROUPS
from docs.generate import Fillers, cell, table


def commands() -> str:
    """Return a section with a table for each group of commands."""
    return "\n\n".join(
        f"## {group.name.capitalize()}\n\n{group.summary}\n\n"
        + table(("command", "aliases", "description"), [_row(each) for each in group.commands])
        for group in GROUPS
    )


def _row(command: Command) -> tuple[str, ...]:
    aliases = ", ".join(f"`{each}`" for each in command.aliases)
    description = " ".join(filter(None, [command.summary, command.text]))
    return f"`{cell(command.usage)}`", aliases, cell(description)


FILLERS: Fillers = {"commands": commands}
