"""The files that programs wrote: kept in the folder that the user names, and nowhere else.

The names come from the programs. They are relative and without `..` (`session.files`); links that
lie in the folder are not followed, so that nothing outside can be written.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final

from crs_cc.core.source import Diagnostic, Location

if TYPE_CHECKING:
    from crs_cc.session.result import RobotResult

_NAMED: Final = 3
_FOLDER: Final = os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW
_FILE: Final = os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_NOFOLLOW | os.O_NONBLOCK


def keep(folder: Path, files: Mapping[bytes, bytes]) -> None:
    """Writes files below a folder, whose last part is made when it is not there.

    Raises:
        OSError: one of them cannot be written.
    """
    folder.mkdir(exist_ok=True)
    top = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    try:
        for name, content in files.items():
            try:
                _write(top, name.split(b"/"), content)
            except OSError as error:
                shown = str(folder / os.fsdecode(name))
                raise OSError(error.errno, error.strerror, shown) from None
    finally:
        os.close(top)


def _write(top: int, parts: Sequence[bytes], content: bytes) -> None:
    with contextlib.ExitStack() as opened:
        folder = top
        for part in parts[:-1]:
            with contextlib.suppress(FileExistsError):
                os.mkdir(part, dir_fd=folder)
            folder = os.open(part, _FOLDER, dir_fd=folder)
            opened.callback(os.close, folder)
        with os.fdopen(os.open(parts[-1], _FILE, 0o666, dir_fd=folder), "wb") as file:
            file.write(content)


def dropped(robot: RobotResult, files: Mapping[bytes, bytes]) -> Diagnostic:
    """Gives the warning that a program's files are not kept."""
    names = [name.decode(errors="replace") for name in files]
    text = ", ".join(names[:_NAMED])
    if len(names) > _NAMED:
        text += f" and {len(names) - _NAMED} more"
    place, hint = Location(robot.program), "keep what programs write with --files DIR"
    return Diagnostic("warning", place, f"'{robot.id}' wrote {text}, which is not kept", hint=hint)


def missed(robot: RobotResult, names: Sequence[bytes]) -> Diagnostic | None:
    """Gives the warning that a program looked for files which are here, but which it cannot see."""
    here = [name for name in map(os.fsdecode, names) if Path(name).is_file()]
    if not here:
        return None
    hint = "let it read them with " + " ".join(f"--file {name}" for name in here[:_NAMED])
    text = f"'{robot.id}' looked for {', '.join(here[:_NAMED])}, which programs do not see"
    return Diagnostic("warning", Location(robot.program), text, hint=hint)
