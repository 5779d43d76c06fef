"""Files that a world file names: read from its own folder and below, and from nowhere else.

Names may come from anybody: absolute ones, `..`, links that lie in the folder, devices and pipes
are refused.

>>> read_below(Path("."), "../secret.xml", ".xml", 100)
Traceback (most recent call last):
ValueError: must be a file (.xml) in the world's folder or below, by a path relative to it
"""

from __future__ import annotations

import contextlib
import errno
import os
import stat
from pathlib import Path, PurePosixPath
from typing import Final

from crs_cc.core.file_names import from_text

_FOLDER: Final = os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW
_FILE: Final = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK
_LONGEST: Final = 4096
_LINK: Final = "is, or lies behind, a link: take the file itself into the world's folder"


def read_below(folder: Path, name: str, ending: str, most: int) -> bytes:
    """Gives what is in a file.

    Args:
        folder: the folder of the world file.
        name: the file, relative to it.
        ending: what its name must end with, such as `.png`.
        most: how large it may be [bytes].

    Raises:
        ValueError: the name is not allowed, or the file cannot be read; says why.
    """
    path = PurePosixPath(from_text(name))
    outside = path.is_absolute() or ".." in path.parts or path.suffix.lower() != ending
    if outside or "\0" in name or len(name) > _LONGEST:
        raise ValueError(
            f"must be a file ({ending}) in the world's folder or below, by a path relative to it"
        )
    try:
        return _read(folder, path.parts, most)
    except OSError as error:
        # The system tells a link by one of these, depending on what was to be opened.
        if error.errno in (errno.ELOOP, errno.EMLINK, errno.ENOTDIR):
            raise ValueError(_LINK) from None
        if error.errno == errno.ENOENT:
            raise ValueError("there is no such file") from None
        raise ValueError(f"cannot be read: {error.strerror or type(error).__name__}") from None


def _read(folder: Path, parts: tuple[str, ...], most: int) -> bytes:
    """Opens part after part relative to the folder before, so that no link can lead out of it."""
    with contextlib.ExitStack() as opened:
        place = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
        opened.callback(os.close, place)
        for part in parts[:-1]:
            place = os.open(part, _FOLDER, dir_fd=place)
            opened.callback(os.close, place)
        with os.fdopen(os.open(parts[-1], _FILE, dir_fd=place), "rb") as file:
            status = os.fstat(file.fileno())
            if not stat.S_ISREG(status.st_mode):
                raise ValueError("is not a regular file")
            if status.st_size > most:
                raise ValueError(f"is larger than {most} bytes")
            return file.read(most)
