"""Commands for notes, and for saving the run with them."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Final

from crs_cc.core.file_names import from_text
from crs_cc.core.host_system import open_regular
from crs_cc.debug.commands.answer import Answer
from crs_cc.debug.commands.arguments import require_argument
from crs_cc.debug.commands.command import Command
from crs_cc.debug.commands.context import CommandContext, ListedInstant
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.note import Note

_ENDING: Final = ".mcap"
_MAGIC: Final = b"\x89MCAP0\r\n"
"""The first bytes of an MCAP file (https://mcap.dev/spec, "Magic")."""


def _note(context: CommandContext, text: str) -> Answer:
    debugger, view = context.debugger, context.debugger.view
    said = require_argument(text, "a note, such as: here it turns the wrong way").strip('"')
    debugger.notes.append(Note(view.position, view.robot, view.time_s, said))
    yield from ()


def _info_notes(context: CommandContext, _text: str) -> Answer:
    notes = sorted(context.debugger.notes, key=lambda each: each.position)
    context.instants = [ListedInstant(each.position, each.robot) for each in notes]
    if not notes:
        yield "No notes."
    for number, each in enumerate(notes, 1):
        yield f"{f'@{number}':<6} t = {each.time_s:8.3f} s  {each.text}"


def _save_run(context: CommandContext, text: str) -> Answer:
    debugger = context.debugger
    if debugger.save is None:
        raise DebugError("this run cannot be saved here: use crs debug, or --record")
    name = require_argument(text, "a file, such as crash.mcap")
    path = Path(from_text(f"run{name}" if name == _ENDING else name))
    _check(path)
    try:
        debugger.save(debugger, path)
    except OSError as error:
        raise DebugError(f"'{path}' cannot be written: {error.strerror}") from None
    yield f"Saved to '{path}': the run up to t = {debugger.session.time_s:.3f} s."


def _check(path: Path) -> None:
    """Check that a recording may be written; raise DebugError if another file would be lost.

    Scripts come with other people's programs, so no other file may be at risk.
    """
    if path.suffix != _ENDING:
        raise DebugError(f"the name of a recording must end with {_ENDING}")
    if path.is_symlink():
        raise DebugError(f"'{path}' is a symbolic link: not overwritten")
    if not path.exists():
        return
    try:
        with os.fdopen(open_regular(path, os.O_RDONLY, follow=False), "rb") as file:
            if file.read(len(_MAGIC)) != _MAGIC:
                raise DebugError(f"'{path}' is not a recording: not overwritten")
    except OSError as error:
        raise DebugError(f"'{path}' cannot be written: {error.strerror}") from None


NOTES: Final[tuple[Command, ...]] = (
    Command(
        "note", "TEXT", "Attach a note to the current position.", _note,
        text='"save run" keeps it in the recording.',
    ),
    Command(
        "info notes", "", "List the notes.", _info_notes, text='"goto @3" goes to the third.',
    ),
    Command(
        "save run", "FILE.mcap", "Save the run up to here as a recording.", _save_run,
        text="The recording contains the changes, input, notes and breakpoints; crs debug "
        "FILE.mcap opens it. Only recordings are overwritten. \"save run.mcap\" is enough to "
        "save to run.mcap.",
        completes="file",
    ),
)  # fmt: skip
