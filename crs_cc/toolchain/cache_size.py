"""The size limit of the cache: the least recently used entries are evicted.

The time of an entry's last use is its file's modification time. The folder is scanned
when a process first stores an entry, and again after it has stored a sixteenth of the limit, so
that neither hits nor most stores depend on its size. Several processes may evict at once:
an entry that another one has removed is skipped, and each stays within its sixteenth.
"""

from __future__ import annotations

import contextlib
import os
import re
import stat
from dataclasses import dataclass
from pathlib import Path
from typing import Final

LIMIT_VARIABLE: Final = "CRS_CACHE_SIZE"
DEFAULT_LIMIT: Final = 2**30
"""The default limit of the cache [bytes]."""

TEMPORARY: Final = ("crs-", ".tmp")
"""Prefix and suffix of the name of an entry that is being written."""

_OURS: Final = re.compile(r"[0-9a-f]{32}|crs-\w{8}\.tmp")
_SIZE: Final = re.compile(r"(\d{1,15}) *([KMG]?)(?:iB|B)?", re.IGNORECASE)
_UNITS: Final = {"": 1, "K": 2**10, "M": 2**20, "G": 2**30}


@dataclass(frozen=True, slots=True, order=True)
class StoredEntry:
    """An entry on disk.

    Attributes:
        used_ns: time of its last use [ns since the epoch].
        name: its file name.
        size: its size [bytes].
    """

    used_ns: int
    name: str
    size: int


def limit_bytes() -> int:
    """Return the size limit of the cache: `$CRS_CACHE_SIZE`, or the default if that is invalid."""
    chosen = _size(os.environ.get(LIMIT_VARIABLE, ""))
    return DEFAULT_LIMIT if chosen is None else chosen


def invalid_limit() -> str:
    """Return the value of `$CRS_CACHE_SIZE` if it is invalid, else ""."""
    text = os.environ.get(LIMIT_VARIABLE, "")
    return text if text and _size(text) is None else ""


def _size(text: str) -> int | None:
    """Parse a size to a number of bytes.

    >>> _size("500M"), _size("2 GiB"), _size("0"), _size("much")
    (524288000, 2147483648, 0, None)
    """
    match = _SIZE.fullmatch(text.strip())
    return int(match[1]) * _UNITS[match[2].upper()] if match else None


def stored_entries(folder: Path) -> list[StoredEntry]:
    """Return the entries in a folder, the least recently used first; ignore other files.

    Raises:
        OSError: the folder cannot be read.
    """
    found = []
    with os.scandir(folder) as files:
        for file in files:
            if not _OURS.fullmatch(file.name):
                continue
            with contextlib.suppress(FileNotFoundError):  # evicted meanwhile
                status = file.stat(follow_symlinks=False)
                if stat.S_ISREG(status.st_mode):
                    found.append(StoredEntry(status.st_mtime_ns, file.name, status.st_size))
    return sorted(found)


def remove(folder: Path, entry: StoredEntry) -> None:
    """Remove an entry, unless it is already gone; raise OSError if it cannot be removed."""
    (folder / entry.name).unlink(missing_ok=True)


class StoreQuota:
    """The amount that may be stored in a folder before it has to be scanned again."""

    def __init__(self) -> None:
        self._left: dict[tuple[Path, int], int] = {}

    def make(self, folder: Path, size: int) -> bool:
        """Make room for an entry of a size, and return whether there is room for it.

        Raises:
            OSError: the folder cannot be read.
        """
        limit = limit_bytes()
        if size > limit:
            return False
        left = self._left.get((folder, limit), 0) - size
        if left < 0:
            total = _evict(folder, limit - size)
            left = min(limit - size - total, limit // 16)
        self._left[folder, limit] = left
        return left >= 0


def _evict(folder: Path, most: int) -> int:
    """Evict entries if they exceed a total size, and return the size of the rest.

    An eighth is freed, so that the next entries are stored without another scan.
    """
    entries = stored_entries(folder)
    total = sum(entry.size for entry in entries)
    if total <= most:
        return total
    for entry in entries:
        if total <= most - most // 8:
            break
        with contextlib.suppress(OSError):
            remove(folder, entry)
            total -= entry.size
    return total
