"""The files from which a run was loaded: recordings keep a copy of each.

>>> with logged() as files:
...     note(Path("room.xml"), b"<world/>")
>>> files
{PosixPath('room.xml'): b'<world/>'}
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from typing import Final

_LOG: Final[ContextVar[dict[Path, bytes] | None]] = ContextVar("input_files", default=None)


@contextmanager
def logged() -> Iterator[dict[Path, bytes]]:
    """Collect the contents of files that are read in the block, by path."""
    files: dict[Path, bytes] = {}
    token = _LOG.set(files)
    try:
        yield files
    finally:
        _LOG.reset(token)


def note(path: Path, content: bytes) -> None:
    """Note a file that has been read."""
    files = _LOG.get()
    if files is not None:
        files[path] = content
