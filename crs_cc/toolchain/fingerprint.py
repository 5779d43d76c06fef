"""Fingerprints of our own sources: what the cache holds is valid for one of them only."""

from __future__ import annotations

import hashlib
import os
import sys
from collections.abc import Iterator, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Final

from crs_cc.core.host_system import machine

PACKAGE: Final = Path(__file__).parent.parent

COMPILER: Final = (
    *("core", "requests", "robot_api", "ir", "frontend", "runtime", "toolchain", "session"),
)
"""The folders that determine what a C program is compiled to."""

WORLDS: Final = (*COMPILER, "sim")
"""The folders that determine what a world file is read as."""

_PACKAGES: Final = ("pycparser", "wasmtime")
_SUFFIXES: Final = (".py", ".c", ".h", ".txt", ".xml", ".xsd")


def sources(folders: Sequence[str] = COMPILER) -> list[Path]:
    """Return the files of our own in some folders that determine a result."""
    return [Path(entry.path) for entry in _entries(folders)]


def fingerprint(folders: Sequence[str]) -> str:
    """Return a hash of the contents of our sources, and of the packages that they use."""
    import importlib.metadata  # slow to import

    digest = hashlib.sha256(_platform())
    for package in _PACKAGES:
        digest.update(importlib.metadata.version(package).encode())
    for file in sources(folders):
        digest.update(f"{file.relative_to(PACKAGE)}\0".encode() + file.read_bytes())
    return digest.hexdigest()


def stamp(folders: Sequence[str]) -> str:
    """Return a hash of the sizes and times of these files: while it is the same, they are.

    The time of the last change of the inode is among them, which no program can set.
    """
    digest = hashlib.sha256(_platform())
    for package in _PACKAGES:
        found = find_spec(package)
        if found is not None and found.origin is not None:
            digest.update(_status(found.origin, os.stat(found.origin)))  # noqa: PTH116 - quicker
    for entry in _entries(folders):
        digest.update(_status(entry.path, entry.stat()))
    return digest.hexdigest()


def _platform() -> bytes:
    return f"{sys.version_info[:2]} {sys.platform} {machine()}".encode()


def _status(path: str, status: os.stat_result) -> bytes:
    times = f"{status.st_mtime_ns} {status.st_ctime_ns} {status.st_ino} {status.st_size}"
    return f"{path}\0{times}\0".encode("utf-8", "surrogateescape")


def _entries(folders: Sequence[str]) -> list[os.DirEntry[str]]:
    found = [entry for entry in _files(str(PACKAGE)) if entry.is_file()]
    for folder in folders:
        found += _below(str(PACKAGE / folder))
    return sorted(found, key=lambda entry: entry.path)


def _below(folder: str) -> Iterator[os.DirEntry[str]]:
    for entry in _files(folder):
        if entry.is_dir():
            yield from _below(entry.path)
        else:
            yield entry


def _files(folder: str) -> Iterator[os.DirEntry[str]]:
    """Yield the folders and sources in a folder; quicker than by `Path`."""
    with os.scandir(folder) as entries:
        yield from (each for each in entries if each.name.endswith(_SUFFIXES) or each.is_dir())
