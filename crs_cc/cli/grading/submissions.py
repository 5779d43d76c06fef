"""Finding submissions, and copying them so that nothing else is read.

Each entry of a folder of submissions is a submission: a C file, or a folder with the C files and
headers of a program. Links are not followed, whatever they point to; nor are devices, pipes and the
like. An entry that is not a program is listed as such, so that none is forgotten.
"""

from __future__ import annotations

import os
import stat
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Final

from crs_cc.cli.messages import printable
from crs_cc.core.file_names import displayed
from crs_cc.ir.names import LIBRARY
from crs_cc.session.files import Disk

MAX_FILES: Final = 200
MAX_BYTES: Final = 512 * 2**10
MAX_DEPTH: Final = 6
_ENDINGS: Final = frozenset({".c", ".h", ".inc"})
_TEACHERS: Final = frozenset({".csv", ".html", ".json", ".md", ".txt", ".xml"})
"""Endings of files in a folder of submissions that are not handed in, such as a list of names."""
_NOBODYS: Final = frozenset({"__MACOSX"})
_O_NOFOLLOW: Final = getattr(os, "O_NOFOLLOW", 0)  # Windows has none, and hardly any links
_O_NONBLOCK: Final = getattr(os, "O_NONBLOCK", 0)


class UnusableError(Exception):
    """A submission that is not a program; the text is the reason."""


@dataclass(frozen=True, slots=True)
class Submission:
    """A submission.

    Attributes:
        name: its name for people, one printable line.
        path: the file or the folder.
    """

    name: str
    path: Path


@dataclass(frozen=True, slots=True)
class Copy:
    """What was copied of a submission, by names relative to the folder.

    Attributes:
        folder: where to.
        sources: its C files, sorted.
        data: the files that its program can read.
    """

    folder: Path
    sources: tuple[str, ...]
    data: tuple[str, ...]


def find(paths: Sequence[Path]) -> list[Submission]:
    """Return the submissions in folders, sorted, and the C files that are named themselves.

    Raises:
        OSError: a folder or a file cannot be read.
    """
    found: list[Submission] = []
    taken = Counter(path.name for path in paths)
    for path in paths:
        name = path.name if path.name and taken[path.name] == 1 else str(path)
        if path.is_dir():
            entries = sorted(path.iterdir(), key=lambda each: os.fsencode(each.name))
            prefix = f"{name}/" if len(paths) > 1 else ""
            found += [Submission(_shown(prefix + e.name), e) for e in entries if _counts(e)]
        else:
            path.stat()
            found.append(Submission(_shown(name), path))
    return found


def copy(submission: Submission, folder: Path, data: Sequence[str] = ()) -> Copy:
    """Copy the files of a submission to a folder; return their names.

    Args:
        submission: the submission.
        folder: an empty folder.
        data: patterns of the names of files that its program can read.

    Raises:
        UnusableError: there is no C file, there are too many files, or a link.
    """
    status = _status(submission.path)
    if stat.S_ISDIR(status.st_mode):
        files = list(_files(submission.path, Path(), MAX_DEPTH, data))
    else:
        files = [(submission.path, Path(submission.path.name))]
    names: list[Path] = []
    room = MAX_BYTES
    for path, name in files:
        content = _read(path, room)
        room -= len(content)
        names.append(name)
        target = folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(content)
    sources = [str(name) for name in names if name.suffix.lower() == ".c"]
    if not sources:
        raise UnusableError("no C file (.c)")
    read = [str(name) for name in names if _matches(name, data)]
    disk = Disk({})
    for each in read:
        if disk.put(each, b""):
            raise UnusableError(f"{_shown(each)}: programs cannot read files of that name")
    return Copy(folder, tuple(sorted(sources, key=os.fsencode)), tuple(read))


def _matches(name: Path, patterns: Iterable[str]) -> bool:
    return any(fnmatchcase(name.name, pattern) for pattern in patterns)


def _counts(path: Path) -> bool:
    """Return whether an entry of a folder is a submission."""
    if path.name.startswith(".") or path.name in _NOBODYS:
        return False
    return path.suffix.lower() not in _TEACHERS or path.is_symlink() or path.is_dir()


def _shown(name: str) -> str:
    return printable(displayed(name))


def _status(path: Path) -> os.stat_result:
    try:
        status = path.lstat()
    except (OSError, ValueError) as error:
        raise UnusableError(f"cannot be read: {getattr(error, 'strerror', None)}") from None
    if stat.S_ISLNK(status.st_mode):
        raise UnusableError(f"{_shown(path.name)} is a link; links are not followed")
    if not (stat.S_ISREG(status.st_mode) or stat.S_ISDIR(status.st_mode)):
        raise UnusableError(f"{_shown(path.name)} is neither a file nor a folder")
    return status


def _files(
    folder: Path, name: Path, depth: int, data: Sequence[str]
) -> Iterator[tuple[Path, Path]]:
    """Yield the C files, headers and data below a folder, each with its name there."""
    try:
        entries = sorted(folder.iterdir(), key=lambda each: os.fsencode(each.name))
    except OSError as error:
        raise UnusableError(f"cannot be read: {error.strerror}") from None
    if len(entries) > MAX_FILES:
        raise UnusableError(f"more than {MAX_FILES} files in a folder")
    for path in entries:
        status = _status(path)
        if stat.S_ISDIR(status.st_mode):
            if depth == 0:
                raise UnusableError(f"folders are nested more than {MAX_DEPTH} deep")
            if f"{path.name}/" == LIBRARY:
                raise UnusableError(f"a folder must not be called {path.name}")
            yield from _files(path, name / path.name, depth - 1, data)
        elif path.suffix.lower() in _ENDINGS or _matches(path, data):
            yield path, name / path.name


def _read(path: Path, room: int) -> bytes:
    """Return the content of a regular file; one that has become something else is refused."""
    try:
        number = os.open(path, os.O_RDONLY | _O_NOFOLLOW | _O_NONBLOCK)
        with open(number, "rb") as file:  # noqa: PTH123 - it is open already
            if not stat.S_ISREG(os.fstat(number).st_mode):
                raise UnusableError(f"{_shown(path.name)} is not a regular file")
            content = file.read(room + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None)
        raise UnusableError(f"{_shown(path.name)} cannot be read: {reason}") from None
    if len(content) > room:
        raise UnusableError(f"more than {MAX_BYTES >> 10} KiB of source and data")
    return content
