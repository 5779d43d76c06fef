"""Save the files that programs wrote in the folder that the user names, and nowhere else.

The names come from the programs. They are relative and without `..` (`session.files`); links in
the folder are not followed, so that nothing outside it can be written.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final

from crs_cc.cli.messages import show
from crs_cc.core.host_system import open_beneath
from crs_cc.core.source import Diagnostic, Location

if TYPE_CHECKING:
    from crs_cc.session.result import RobotResult

_NAMED: Final = 3
_FLAGS: Final = os.O_WRONLY | os.O_CREAT


def save_files(folder: Path, files: Mapping[bytes, bytes]) -> list[Diagnostic]:
    """Write files below a folder, made if only its last part is missing; return the errors."""
    try:
        folder.mkdir(exist_ok=True)
    except OSError as error:
        return [_not_saved(folder, error)]
    failed = []
    for name, content in files.items():
        try:
            _write(folder, os.fsdecode(name), content)
        except OSError as error:
            failed.append(_not_saved(folder / os.fsdecode(name), error))
    return failed


def save_all(folder: Path, robots: Sequence[tuple[str, Mapping[bytes, bytes]]]) -> bool:
    """Write the files of robots below a folder, and report each that cannot be written.

    Args:
        folder: the target; several robots get a subfolder each.
        robots: the name of each robot and the files that its program wrote.

    Returns:
        Whether all of them were written.
    """
    failed = []
    for name, files in robots:
        failed += save_files(folder / name if len(robots) > 1 else folder, files)
    show(failed)
    return not failed


def _not_saved(path: Path, error: OSError) -> Diagnostic:
    return Diagnostic("error", Location(str(path)), f"cannot be written: {error.strerror}")


def _write(folder: Path, name: str, content: bytes) -> None:
    with os.fdopen(open_beneath(folder, name.split("/"), _FLAGS, make=True), "wb") as file:
        file.truncate()  # only now is it known to be a file
        file.write(content)


def discarded_warning(robot: RobotResult, files: Mapping[bytes, bytes]) -> Diagnostic:
    """Return the warning that a program's files are not saved."""
    names = [name.decode(errors="replace") for name in files]
    text = ", ".join(names[:_NAMED])
    if len(names) > _NAMED:
        text += f" and {len(names) - _NAMED} more"
    place, hint = Location(robot.program), "save the files of programs with --files DIR"
    text = f"'{robot.id}' wrote {text}, which is not saved"
    return Diagnostic("warning", place, text, hint=hint, flag="unsaved-files")


def missed_warning(robot: RobotResult, names: Sequence[bytes]) -> Diagnostic | None:
    """Return the warning that a program did not find files which exist here, if any."""
    here = [name for name in map(os.fsdecode, names) if Path(name).is_file()]
    if not here:
        return None
    hint = "make them readable with " + " ".join(f"--file {name}" for name in here[:_NAMED])
    text = f"'{robot.id}' looked for {', '.join(here[:_NAMED])}, which programs cannot read"
    return Diagnostic("warning", Location(robot.program), text, hint=hint, flag="missing-file")
