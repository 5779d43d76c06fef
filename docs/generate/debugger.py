"""Tables of `docs/debugger.md`: commands and values of the world, from the debugger's tables."""

from __future__ import annotations

from crs_cc.debug.commands.command import Command
from crs_cc.debug.commands.gdb_names import LACKING, gdb_name
from crs_cc.debug.commands.table import COMMANDS, GROUPS
from crs_cc.debug.world.world_values import (
    OBJECT_VALUES,
    ROBOT_VALUES,
    WORLD_VALUES,
    WorldValue,
)
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


def gdb_names() -> str:
    """Return the commands whose names are gdb's."""
    return ", ".join(
        sorted(f"`{each.name}`" for each in COMMANDS if gdb_name(each.name) == each.name)
    )


def gdb_commands() -> str:
    """Return a table of gdb's commands that have another name here, or none."""
    rows = sorted(
        (f"`{name}`", f"`{each.name}`", cell(each.summary))
        for each in COMMANDS
        if (name := gdb_name(each.name)) and name != each.name
    )
    lacking = [(cell(names), "none", cell(reason)) for names, reason in LACKING]
    return table(("gdb", "crs", "description"), [*rows, *lacking])


def world_values() -> str:
    """Return a table of the values of the world that expressions can use."""
    rows = [
        *(_value("$world.", each) for each in WORLD_VALUES),
        *(_value("$world.OBJECT.", each) for each in OBJECT_VALUES),
        *(_value("$world.ROBOT.", each) for each in ROBOT_VALUES if each not in OBJECT_VALUES),
        ("`$world.distance(A, B)`", "m", "", "the true distance between two objects' centres"),
    ]
    return table(("value", "unit", "frame", "meaning"), rows)


def _value(before: str, value: WorldValue) -> tuple[str, ...]:
    return f"`{before}{value.name}`", cell(value.unit), value.frame, cell(value.meaning)


FILLERS: Fillers = {
    "commands": commands,
    "gdb_names": gdb_names,
    "gdb_commands": gdb_commands,
    "world_values": world_values,
}
