"""The file of an edited world: reading, detecting changes by others, replacing atomically.

The new text is written beside the old file, brought to the disk, and then takes its name in one
step. So at any instant, also after `kill -9` or a power failure, the name refers to all of the old
text or all of the new one.
"""

from __future__ import annotations

import contextlib
import os
import secrets
import stat
from pathlib import Path

from crs_cc.core.errors import WorldError
from crs_cc.core.source import Location
from crs_cc.sim.files.xml_document import read_file


def replace_file(path: Path, text: bytes, before: bytes | None) -> None:
    """Replace a file by a text, or make it.

    Args:
        path: the file; a link stays, and the file that it leads to is replaced.
        text: the new contents.
        before: what is expected to be there; None for no file.

    Raises:
        WorldError: the file is not what was expected.
        OSError: it cannot be written.
    """
    target = path.resolve()
    _require_unchanged(path, target, before)
    new = target.with_name(f".{target.name}.{secrets.token_hex(4)}.new")
    try:
        with new.open("xb") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        if before is not None:
            new.chmod(stat.S_IMODE(target.stat().st_mode))
        _require_unchanged(path, target, before)
        new.replace(target)
    except BaseException:
        with contextlib.suppress(OSError):
            new.unlink()
        raise
    _sync_folder(target.parent)


def _require_unchanged(path: Path, target: Path, before: bytes | None) -> None:
    if before is None:
        if target.exists():
            raise WorldError.at(Location(str(path)), "the file exists already", "use another name")
    elif not target.exists():
        raise WorldError.at(
            Location(str(path)), "the file has been removed since it was read",
            "save it under another name",
        )  # fmt: skip
    elif read_file(target) != before:
        raise WorldError.at(
            Location(str(path)), "the file has been changed by another program since it was read",
            "read it again, or save under another name",
        )  # fmt: skip


def _sync_folder(folder: Path) -> None:
    """Bring a new name to the disk, where folders can be opened."""
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
