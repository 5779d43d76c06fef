"""Find and reads header files, and refuses every file that a program has no business with.

A program may be hostile, and a compiler that reads whatever `#include` names shows the content in
its messages. So only regular files may be read that lie, after all links are followed, below the
folder of the main file, a folder of `-I`, or the folder of our own headers.

>>> headers = Headers(Path("demo"), Options())
>>> headers.find("../secret.h", quoted=True, folder=Path("demo"))
Refusal(text="'../secret.h' lies outside the folders that a program may read", hint='')
"""

from __future__ import annotations

import hashlib
import stat
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from crs_cc.core.file_names import from_text
from crs_cc.frontend.preprocess.missing_header import header_of_ours, hint_for_missing
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.preprocess.tokens import shown

MAX_FILE_SIZE: Final = 4 << 20
"""The largest source file that is read [bytes]."""
GENERATED: Final = "<generated>"
"""The folder of generated headers in messages."""
_OUTSIDE: Final = "lies outside"
"""Stands for the digest of a file that is not read; it equals none, so nothing is taken as known.
"""


@dataclass(frozen=True, slots=True)
class Header:
    """A header that was found.

    Attributes:
        path: where, as the user's folders are named.
        file: the same file with all links followed.
        root: the folder of the search in which it was found.
        content: what is in it, where it is no file but generated.
    """

    path: Path
    file: Path
    root: Path
    content: bytes | None = None

    def read(self) -> bytes | Refusal:
        """Return what is in the header."""
        return read_regular_file(self.file) if self.content is None else self.content


@dataclass(frozen=True, slots=True)
class Refusal:
    """Why a file is not read.

    Attributes:
        text: the error.
        hint: what the user can do.
    """

    text: str
    hint: str = ""


class Headers:
    """The folders of a run."""

    def __init__(
        self, main_folder: Path, options: Options, digests: dict[str, str] | None = None
    ) -> None:
        """Takes the folder of the user's main file, and the options with the other folders.

        Args:
            main_folder: the folder of the user's main file.
            options: the other folders.
            digests: gets the `digest` of each file that is looked for, found or not: a file that
                appears in a folder where there was none changes the program too.
        """
        self._digests = {} if digests is None else digests
        self.include_paths = options.include_paths
        self.system_paths = options.system_paths
        self._generated = dict(options.generated)
        folders = (main_folder, *self.include_paths, *self.system_paths)
        self._roots = [root for root in map(_resolved, folders) if root is not None]

    def find(
        self, name: str, *, quoted: bool, folder: Path, after: Path | None = None
    ) -> Header | Refusal:
        """Return the file that an `#include` means (C17 6.10.2).

        Args:
            name: what stands between the quotes or angle brackets.
            quoted: whether it stands in quotes, and the including file's folder is searched first.
            folder: the including file's folder.
            after: for `#include_next`, the folder of the search at which the last one ended.
        """
        if not name or Path(name).is_absolute():
            return Refusal(f"'{shown(name)}' cannot be included", "name a header without its path")
        folders = [*self.include_paths, *self.system_paths]
        if after in folders:
            folders = folders[folders.index(after) + 1 :]
        elif quoted:
            folders.insert(0, folder)
        outside = False
        for each in folders:
            path = each / from_text(name)
            file = _resolved(path)
            if file and not any(file.is_relative_to(root) for root in self._roots):
                outside = True  # and whether it exists is not told
                self._digests[str(path)] = _OUTSIDE
                continue
            if str(path) not in self._digests:
                self._digests[str(path)] = digest(path)
            if file and _exists(file):
                return Header(path, file, each)
        if name in self._generated:
            path = Path(GENERATED, name)
            return Header(path, path, Path(GENERATED), self._generated[name].encode())
        if outside:
            return Refusal(f"'{shown(name)}' lies outside the folders that a program may read")
        return self._missing(name, folders)

    def find_ours(self, name: str, *, quoted: bool, folder: Path) -> tuple[str, Header] | None:
        """Return the header of ours that a name stands for which `find` refuses, with its name."""
        meant = header_of_ours(name, self.system_paths)
        found = self.find(meant, quoted=quoted, folder=folder) if meant else None
        return (meant, found) if isinstance(found, Header) else None

    def _missing(self, name: str, folders: list[Path]) -> Refusal:
        own = [str(each) for each in folders if each not in self.system_paths]
        ours = ["the headers of crs"] if self.system_paths else []
        where = ", ".join([*dict.fromkeys(own), *ours]) or "no folder"
        return Refusal(
            f"header '{shown(name)}' is not found; looked in: {where}",
            hint_for_missing(name, folders),
        )


def read_regular_file(path: Path) -> bytes | Refusal:
    """Read a file, if it is a regular one of bearable size."""
    try:
        status = path.stat()
        if stat.S_ISDIR(status.st_mode):
            return Refusal("is a folder, not a file")
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
    """Return what changes whenever the content of a file does, and when it appears or vanishes.

    Taken before the file is read: so when it is changed in between, what was read is never taken
    for what the file holds.
    """
    content = read_regular_file(path)
    return content.text if isinstance(content, Refusal) else hashlib.sha256(content).hexdigest()


def _resolved(path: Path) -> Path | None:
    try:
        return path.resolve()
    except (OSError, RuntimeError, ValueError):  # names too long, loops of links, odd characters
        return None


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except (OSError, ValueError):
        return False
