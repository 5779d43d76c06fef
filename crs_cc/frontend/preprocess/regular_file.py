"""Reads source files and headers; a digest detects changes of a file.

Nothing here needs the compiler: a program that is in the cache is compared with its files.
"""

from __future__ import annotations

import hashlib
import stat
from dataclasses import dataclass
from pathlib import Path
from typing import Final

MAX_FILE_SIZE: Final = 4 << 20
"""The maximum size of a source file [bytes]."""


@dataclass(frozen=True, slots=True)
class Refusal:
    """The reason why a file is not read.

    Attributes:
        text: the error.
        hint: a hint for the user.
    """

    text: str
    hint: str = ""


def read_regular_file(path: Path) -> bytes | Refusal:
    """Return the content of a file if it is a regular one that is not too large."""
    try:
        status = path.stat()
        if stat.S_ISDIR(status.st_mode):
            return Refusal("is a directory")
        if not stat.S_ISREG(status.st_mode):
            return Refusal("is not a regular file")
        with path.open("rb") as stream:
            content = stream.read(MAX_FILE_SIZE + 1)
    except FileNotFoundError:
        return Refusal("no such file")
    except (OSError, ValueError) as error:
        return Refusal(f"cannot be read: {getattr(error, 'strerror', None) or error}")
    if len(content) > MAX_FILE_SIZE:
        return Refusal(f"is larger than {MAX_FILE_SIZE >> 20} MiB")
    return content


def digest(path: Path) -> str:
    """Return a digest of a file's content, or of its absence.

    It must be computed before the file is read: if the file changes in between, the digest then
    does not match the new content.
    """
    content = read_regular_file(path)
    return content.text if isinstance(content, Refusal) else hashlib.sha256(content).hexdigest()
