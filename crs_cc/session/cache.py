"""What was compiled before, on disk, so that a program starts at once the second time.

Entries are pickles in the user's own cache folder (mode 0700); whoever can write there can run
code as the user anyway. Every name contains the fingerprint of the compiler, so a changed compiler
never meets an old entry.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import importlib.metadata
import os
import pickle
import sys
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any

PACKAGE = Path(__file__).parent.parent
COMPILER = ("ir", "frontend", "runtime", "session")


def folder() -> Path:
    """Gives the cache folder: `$CRS_CACHE`, or `crs_cc` in the user's cache folder."""
    chosen = os.environ.get("CRS_CACHE")
    if chosen:
        return Path(chosen)
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "crs_cc"


@functools.cache
def fingerprint() -> str:
    """Gives a hash of everything that decides what the compiler makes of a source."""
    digest = hashlib.sha256()
    digest.update(f"{sys.version_info[:2]} {sys.platform} {os.uname().machine}".encode())
    for package in ("pycparser", "wasmtime"):
        digest.update(importlib.metadata.version(package).encode())
    files = [PACKAGE / "requests.py", PACKAGE / "source.py"]
    for part in COMPILER:
        files += sorted((PACKAGE / part).rglob("*.[pch]*"))
    for file in files:
        if file.suffix in (".py", ".c", ".h"):
            digest.update(f"{file.relative_to(PACKAGE)}\0".encode() + file.read_bytes())
    return digest.hexdigest()


def key(*parts: str | bytes | Iterable[str]) -> str:
    """Gives the name of the entry for these inputs to the compiler."""
    digest = hashlib.sha256(fingerprint().encode())
    for part in parts:
        rows = [part] if isinstance(part, str | bytes) else list(part)
        digest.update(f"{len(rows)}:".encode())
        for row in rows:
            raw = row.encode() if isinstance(row, str) else row
            digest.update(f"{len(raw)}:".encode() + raw)
    return digest.hexdigest()[:32]


def load(name: str) -> Any:
    """Gives an entry, or None when there is none that can be read."""
    try:
        with (folder() / name).open("rb") as file:
            return pickle.load(file)  # noqa: S301 - see the module's docstring
    except (OSError, pickle.UnpicklingError, EOFError, AttributeError, ImportError, IndexError):
        return None


def store(name: str, entry: Any) -> None:
    """Keeps an entry; does nothing where the folder cannot be written."""
    with contextlib.suppress(OSError):
        folder().mkdir(mode=0o700, parents=True, exist_ok=True)
        handle, temporary = tempfile.mkstemp(dir=folder())
        with os.fdopen(handle, "wb") as file:
            pickle.dump(entry, file, protocol=pickle.HIGHEST_PROTOCOL)
        Path(temporary).replace(folder() / name)
