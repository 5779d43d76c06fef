"""The compile cache on disk.

An entry is a pickle preceded by its SHA-256, so that a corrupt one is detected before it is
loaded. A pickle can run any code: the folder must belong to the user and not be writable by
others; otherwise the cache is disabled. Every name contains the fingerprint of
the compiler, so a changed compiler never loads an old entry. `cache_size` bounds the folder.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import os
import pickle
from collections.abc import Iterable
from pathlib import Path
from typing import TypeVar

from crs_cc.core import host_system
from crs_cc.toolchain.cache_size import TEMPORARY, StoreQuota
from crs_cc.toolchain.fingerprint import COMPILER, PACKAGE, fingerprint, stamp

_DIGEST_SIZE = hashlib.sha256().digest_size
_Entry = TypeVar("_Entry")
_quota = StoreQuota()


def folder() -> Path | None:
    """Return the cache folder: `$CRS_CACHE`, or `crs_cc` in the user's cache folder, if any."""
    chosen = os.environ.get("CRS_CACHE")
    if chosen:
        return Path(chosen)
    try:
        return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "crs_cc"
    except RuntimeError:  # no $HOME, and no passwd entry
        return None


@functools.cache
def version(folders: tuple[str, ...] = COMPILER) -> str:
    """Return the fingerprint of our sources in some folders, without reading them if possible."""
    name = hashlib.sha256(f"version {stamp(folders)}".encode()).hexdigest()[:32]
    found = load(name, str)
    if found is None:
        found = fingerprint(folders)
        store(name, found)
    return found


def key(*parts: str | bytes | Iterable[str]) -> str:
    """Return the name of the entry for these inputs of the compiler.

    Installations with the same sources have entries of their own: programs name their headers.
    """
    digest = hashlib.sha256(os.fsencode(PACKAGE) + b"\0" + version().encode())
    for part in parts:
        rows = [part] if isinstance(part, str | bytes) else list(part)
        digest.update(f"{len(rows)}:".encode())
        for row in rows:
            raw = row.encode("utf-8", "surrogatepass") if isinstance(row, str) else row
            digest.update(f"{len(raw)}:".encode() + raw)
    return digest.hexdigest()[:32]


def load(name: str, kind: type[_Entry]) -> _Entry | None:
    """Return an entry of a type, or None if it is missing or corrupt."""
    place = folder()
    try:
        if place is None or not is_private(place):
            return None
        content = (place / name).read_bytes()
    except OSError:
        return None
    with contextlib.suppress(OSError):  # a read-only folder is good enough
        os.utime(place / name)  # last use
    digest, pickled = content[:_DIGEST_SIZE], memoryview(content)[_DIGEST_SIZE:]
    if hashlib.sha256(pickled).digest() != digest:
        return None
    try:
        entry = pickle.loads(pickled)  # noqa: S301 - see the module's docstring
    except Exception:  # unpickling may raise anything
        return None
    return entry if isinstance(entry, kind) else None


def store(name: str, entry: object) -> None:
    """Store an entry; do nothing if the folder is not writable or not private.

    The least recently used entries are evicted to make room for it.
    """
    pickled = pickle.dumps(entry, pickle.HIGHEST_PROTOCOL)
    _store(name, hashlib.sha256(pickled).digest(), pickled)


def file_of(text: str) -> Path:
    """Return a file that holds a text: an entry, or without a cache a temporary file.

    The compiler reads files only. The same text is always in the same file, so that the program
    is found in the cache.

    >>> file_of("int x;").read_text()
    'int x;'
    """
    import tempfile

    content = text.encode("utf-8", "surrogatepass")
    name = hashlib.sha256(b"text " + content).hexdigest()[:32]
    stored = _store(name, content)
    if stored is not None:
        return stored
    path = Path(tempfile.mkdtemp(prefix="crs-"), name)
    path.write_bytes(content)
    return path


def _store(name: str, *content: bytes) -> Path | None:
    """Write a file of the cache, and return its path; None if that is impossible."""
    place = folder()
    if place is None:
        return None
    with contextlib.suppress(OSError):
        place.mkdir(mode=0o700, parents=True, exist_ok=True)
        if is_private(place) and _quota.make(place, sum(map(len, content))):
            _write(place / name, content)
            return place / name
    return None


def is_private(place: Path) -> bool:
    """Return whether a folder belongs to the user and is not writable by others.

    Raises:
        OSError: there is no such folder.
    """
    return host_system.is_private(place.stat())


def _write(path: Path, content: Iterable[bytes]) -> None:
    """Write the parts of a file, atomically.

    Raises:
        OSError: it cannot be written; nothing is left behind.
    """
    import tempfile  # not needed if everything is in the cache

    begin, end = TEMPORARY
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=begin, suffix=end)
    temporary = Path(name)
    try:
        with os.fdopen(handle, "wb") as file:
            file.writelines(content)
        temporary.replace(path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
