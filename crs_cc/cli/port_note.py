"""The file that a server leaves for other commands of the same user, with its address.

It is a file in the user's cache that only the user can read, because it contains a token.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Final

from crs_cc.toolchain.cache import folder

_PRIVATE: Final = 0o600


def read_note(kind: str, port: int) -> str:
    """Return the note of a kind for a port; raise OSError if there is none."""
    return _file(kind, port).read_text("utf-8").strip()


@contextmanager
def publish_note(kind: str, port: int, text: str) -> Iterator[None]:
    """Keep a note for a port inside a `with` block; without one if there is no room for it.

    Args:
        kind: what the note is; a port has one of each kind.
        port: the port.
        text: its content.
    """
    with suppress(OSError):
        path = _file(kind, port)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)
        handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, _PRIVATE)
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(text)
    try:
        yield
    finally:
        with suppress(OSError):
            _file(kind, port).unlink(missing_ok=True)


def _file(kind: str, port: int) -> Path:
    """Return the file of a note; raise OSError if this user has no folder for it."""
    place = folder()
    if place is None:
        raise OSError("no folder")
    return place / kind / str(port)
