"""Commands for script files."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from crs_cc.core.file_names import from_text
from crs_cc.core.host_system import open_regular
from crs_cc.debug.breakpoints import Breakpoint
from crs_cc.debug.commands.answer import Answer, NestedCommand
from crs_cc.debug.commands.arguments import require_argument
from crs_cc.debug.commands.c_format import unescaped
from crs_cc.debug.commands.command import Command, Group
from crs_cc.debug.commands.context import CommandContext
from crs_cc.debug.errors import DebugError

MAX_SCRIPT_BYTES: Final = 1 << 20
_MAX_DEPTH: Final = 16
_HEAD: Final = "# breakpoints of crs debug"
_ENDING: Final = ".dbg"
_WATCHES: Final = {"change": "watch", "write": "wwatch", "read": "rwatch", "access": "awatch"}


def read_script(path: Path) -> list[str]:
    """Return the lines of a script; raise DebugError if it cannot be read, or is not text."""
    try:
        with os.fdopen(open_regular(path, os.O_RDONLY), "rb") as file:
            content = file.read(MAX_SCRIPT_BYTES + 1)
        if len(content) > MAX_SCRIPT_BYTES:
            raise DebugError(f"'{path}' is larger than {MAX_SCRIPT_BYTES >> 20} MiB")
        return content.decode().splitlines()
    except OSError as error:
        raise DebugError(f"'{path}' cannot be read: {error.strerror}") from None
    except ValueError:
        raise DebugError(f"'{path}' is not a text file") from None


def _source(context: CommandContext, text: str) -> Answer:
    if context.depth >= _MAX_DEPTH:
        raise DebugError(f"scripts are nested more than {_MAX_DEPTH} deep")
    lines = read_script(Path(from_text(require_argument(text, "a script file"))))
    context.depth += 1
    before = context.debugger.stop
    try:
        for line in lines:
            if context.has_ended:
                return
            yield NestedCommand(line or "#")
            stop = context.debugger.stop
            if stop is not before and stop.reason == "interrupt":
                raise DebugError("script interrupted")
    finally:
        context.depth -= 1


def _save_breakpoints(context: CommandContext, text: str) -> Answer:
    path = Path(from_text(require_argument(text, "a file")))
    breakpoints = list(context.debugger.stop_points.breakpoints)
    lines = [_HEAD, *(line for each in breakpoints for line in _written(context, each))]
    _write(path, "\n".join(lines) + "\n")
    yield f"Saved to '{path}': {len(breakpoints)} breakpoint{'s' * (len(breakpoints) != 1)}."


def _written(context: CommandContext, one: Breakpoint) -> Iterator[str]:
    """Return the commands that recreate a breakpoint."""
    yield _command(context, one)
    if one.condition:
        yield f"condition $ {one.condition}"
    if one.ignore:
        yield f"ignore $ {one.ignore}"
    if one.stops_left is not None:
        yield f"enable count {max(1, one.stops_left)} $"
    if not one.enabled:
        yield "disable $"
    if commands := context.scripts.get(one.number):
        yield from ("commands", *(f"  {each}" for each in commands), "end")


def _command(context: CommandContext, one: Breakpoint) -> str:
    robot = f" robot {context.debugger.names[one.robot]}" if one.robot is not None else ""
    if one.log:
        return f"log {one.text} {one.log}"
    if one.watch is not None and one.kind == "breakpoint":
        return f"{'t' * one.temporary}break{robot} if {one.text}"
    if one.watch is not None:
        location = "-location " * one.watch.is_location
        return f"{_WATCHES[one.watch.watched.kind]} {location}{one.text}{robot}"
    word = "catch" if one.kind == "catchpoint" else "break"
    return f"{'t' * one.temporary}{word} {one.text}{robot}"


def _write(path: Path, content: str) -> None:
    """Write a file of breakpoints; overwrite only such files.

    Scripts come with other people's programs, so no other file may be at risk.
    """
    if path.suffix != _ENDING:
        raise DebugError(f"the name of a breakpoint file must end with {_ENDING}")
    try:
        with os.fdopen(open_regular(path, os.O_RDWR | os.O_CREAT, follow=False), "r+b") as file:
            head = file.read(len(_HEAD))
            if head and head != _HEAD.encode():
                raise DebugError(f"'{path}' is not a file of saved breakpoints: not overwritten")
            file.seek(0)
            file.truncate()
            file.write(content.encode("utf-8", "surrogateescape"))
    except OSError as error:
        raise DebugError(f"'{path}' cannot be written: {error.strerror}") from None


def _echo(_context: CommandContext, text: str) -> Answer:
    yield unescaped(text).removesuffix("\n")


SCRIPTS: Final = Group(
    "scripts",
    "Command scripts.",
    (
        Command(
            "source", "FILE", "Execute the commands in a file.", _source,
            text="Execution continues after a command that fails.",
            completes="file",
        ),
        Command(
            "save breakpoints", "FILE.dbg", 'Save the breakpoints as a script for "source".',
            _save_breakpoints, text="Only files of saved breakpoints are overwritten.",
            completes="file",
        ),
        Command(
            "echo", "TEXT", "Print text.", _echo,
            text=r"C escape sequences, such as \n and \t, are supported.",
        ),
    ),
)  # fmt: skip
