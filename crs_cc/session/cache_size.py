"""How large the cache may grow: the entries that were used the longest time ago give way.

The time of an entry's last use is its file's time of modification. The folder is looked through
when a process first stores an entry, and again after it has stored a sixteenth of the limit, so
that neither hits nor most stores depend on how much there is. Several processes may evict at once:
an entry that another one has removed is gone, and each of them stays within its sixteenth.
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
"""How large the cache may be where the user says nothing else [bytes]."""

TEMPORARY: Final = ("crs-", ".tmp")
"""How the name of an entry that is being written begins and ends."""

_OURS: Final = re.compile(r"[0-9a-f]{32}|crs-\w{8}\.tmp")
_SIZE: Final = re.compile(r"(\d{1,15}) *([KMG]?)(?:iB|B)?", re.IGNORECASE)
_UNITS: Final = {"": 1, "K": 2**10, "M": 2**20, "G": 2**30}


@dataclass(frozen=True, slots=True, order=True)
class StoredEntry:
    """An entry as it lies on disk.

    Attributes:
        used_ns: when it was last used, in nanoseconds of the system's clock.
        name: its name in the folder.
        size: how large it is [bytes].
    """

    used_ns: int
    name: str
    size: int


def limit_bytes() -> int:
    """Return how large the cache may be: `$CRS_CACHE_SIZE`, or the default if that is no size."""
    chosen = _size(os.environ.get(LIMIT_VARIABLE, ""))
    return DEFAULT_LIMIT if chosen is None else chosen


def bad_limit() -> str:
    """Return what stands in `$CRS_CACHE_SIZE` if it is not a size, else nothing."""
    text = os.environ.get(LIMIT_VARIABLE, "")
    return text if text and _size(text) is None else ""


def _size(text: str) -> int | None:
    """Return a number of bytes.

    >>> _size("500M"), _size("2 GiB"), _size("0"), _size("much")
    (524288000, 2147483648, 0, None)
    """
    match = _SIZE.fullmatch(text.strip())
    return int(match[1]) * _UNITS[match[2].upper()] if match else None


def stored_entries(folder: Path) -> list[StoredEntry]:
    """Return the entries in a folder, the least recently used first; other files are not ours.

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
    """Remove an entry, unless somebody else was faster.

    Raises:
        OSError: it cannot be removed.
    """
    (folder / entry.name).unlink(missing_ok=True)


class Room:
    """How much may be stored in a folder before somebody has to look how much there is."""

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
    """Remove entries, if they are larger than so many bytes together; return what is left.

    Then an eighth is made free, so that the next ones are stored without another look.
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
