"""The files of a run as attachments, and back on a disk.

Attachments are named by the path from the deepest folder that holds all files, so nothing of the
recording machine is in them besides that. Names in a recording are not trusted: a file is only ever
written below the folder that is given.

>>> tree = SourceTree.of({Path("/home/me/wander.c"): b"int x;", Path("/home/me/a/room.xml"): b""})
>>> sorted(tree.contents), tree.name(Path("/home/me/a/room.xml"))
(['a/room.xml', 'wander.c'], 'a/room.xml')
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Final, Self

from crs_cc.core.host_system import is_plain_file_name

SOURCES: Final = "source/"
"""Begins the names of attachments that programs and worlds were loaded from."""

INPUTS: Final = "input/"
"""Begins the names of attachments that programs could read."""

MAX_FILES: Final = 10_000
_MAX_NAME: Final = 1000


@dataclass(frozen=True, slots=True)
class SourceTree:
    """Files below one folder, or below several that become folders of it.

    Attributes:
        roots: the folders on the recording machine, with their names in the tree.
        contents: their contents, by the path from there.
    """

    roots: Mapping[Path, str]
    contents: Mapping[str, bytes]

    @classmethod
    def of(
        cls,
        files: Mapping[Path, bytes],
        folders: Iterable[Path] = (),
        roots: Mapping[Path, str] | None = None,
    ) -> Self:
        """Return the tree of files.

        Args:
            files: the files.
            folders: folders for headers.
            roots: the folders that hold all of these, with their names in the tree; by default
                the deepest one.
        """
        absolute = {Path(os.path.abspath(path)): content for path, content in files.items()}  # noqa: PTH100 - links stay
        if roots is None:
            parents = {path.parent for path in absolute}
            parents |= {Path(os.path.abspath(folder)) for folder in folders}  # noqa: PTH100
            roots = {Path(os.path.commonpath(parents)) if parents else Path("/"): ""}
        named = {_name(path, roots): each for path, each in absolute.items()}
        return cls(roots, dict(sorted(named.items())))

    def name(self, path: Path) -> str:
        """Return the name of a file or folder in the tree."""
        return _name(Path(os.path.abspath(path)), self.roots)  # noqa: PTH100


def _name(path: Path, roots: Mapping[Path, str]) -> str:
    root = next(each for each in roots if path.is_relative_to(each))
    return (PurePosixPath(roots[root]) / path.relative_to(root).as_posix()).as_posix()


def is_safe(name: str) -> bool:
    """Return whether a name leads to a place below a folder.

    >>> is_safe("maps/room.xml"), is_safe("../room.xml"), is_safe("/etc/passwd")
    (True, False, False)
    """
    path = PurePosixPath(name)
    is_plain = name.isprintable() and "\\" not in name and len(name) <= _MAX_NAME
    is_plain &= all(map(is_plain_file_name, path.parts))
    return bool(path.parts) and is_plain and not path.is_absolute() and ".." not in path.parts


def write_tree(contents: Mapping[str, bytes], folder: Path) -> None:
    """Write files below a folder that is empty.

    Raises:
        ValueError: a name is not safe, or two names do not go together.
        OSError: a file cannot be written.
    """
    if len(contents) > MAX_FILES:
        raise ValueError(f"more than {MAX_FILES} files")
    for name, content in contents.items():
        if not is_safe(name):
            raise ValueError(f"{name[:80]!r} is not a name of a file below a folder")
        path = folder / name
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            with path.open("xb") as file:
                file.write(content)
        except (FileExistsError, NotADirectoryError):
            raise ValueError(f"{name[:80]!r} occurs twice") from None
