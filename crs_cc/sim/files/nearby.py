"""Files named by a world file: only those in its own folder or below are read.

Names are untrusted input: absolute paths, `..`, symbolic links in the folder, devices and pipes are
rejected.

>>> read_below(Path("."), "../secret.xml", ".xml", 100)
Traceback (most recent call last):
ValueError: must be a relative path to a file (.xml) in the world's folder or below
"""

from __future__ import annotations

import errno
import os
from pathlib import Path, PurePosixPath
from typing import Final

from crs_cc.core.file_names import from_text
from crs_cc.core.host_system import open_beneath
from crs_cc.core.input_files import note

_MAX_NAME: Final = 4096
_LINK: Final = "symbolic links are not allowed: copy the file into the world's folder"


def read_below(folder: Path, name: str, ending: str, most: int) -> bytes:
    """Return the contents of a file.

    Raises:
        ValueError: the name is not allowed, or the file cannot be read; the message is the reason.
    """
    path = PurePosixPath(from_text(name))
    outside = path.is_absolute() or ".." in path.parts or path.suffix.lower() != ending
    if outside or "\0" in name or len(name) > _MAX_NAME:
        raise ValueError(
            f"must be a relative path to a file ({ending}) in the world's folder or below"
        )
    try:
        content = _read(folder, path.parts, most)
    except OSError as error:
        # Which of these errors reports a link depends on the call.
        if error.errno in (errno.ELOOP, errno.EMLINK, errno.ENOTDIR):
            raise ValueError(_LINK) from None
        if error.errno == errno.ENOENT:
            raise ValueError("no such file") from None
        raise ValueError(f"cannot be read: {error.strerror or type(error).__name__}") from None
    note(folder / path, content)
    return content


def _read(folder: Path, parts: tuple[str, ...], most: int) -> bytes:
    with os.fdopen(open_beneath(folder, parts, os.O_RDONLY), "rb") as file:
        if os.fstat(file.fileno()).st_size > most:
            raise ValueError(f"larger than {most} bytes")
        return file.read(most)
