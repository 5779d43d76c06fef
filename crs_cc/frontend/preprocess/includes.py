"""Finds and reads header files, and rejects all other files.

A program may be hostile, and a compiler that reads any file that `#include` names shows its
contents in messages. So only regular files may be read that are, after all links are followed,
below the directory of the main file, a directory of `-I`, the directory of our own headers, or the
root of the project that the main file is in: the current directory, or that of `--root`.

>>> headers = Headers(Path("demo"), Options(root=Path("demo")))
>>> headers.find("../secret.h", quoted=True, folder=Path("demo")).text
"'../secret.h' is outside the directories that a program may read"
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Final

from crs_cc.core.file_names import from_text
from crs_cc.frontend.preprocess.missing_header import bundled_header, hint_for_missing
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.preprocess.regular_file import Refusal, digest, read_regular_file
from crs_cc.frontend.preprocess.tokens import shown

GENERATED: Final = "<generated>"
"""The folder of generated headers in messages."""
_OUTSIDE: Final = "lies outside"
"""Replaces the digest of a file that may not be read; it never compares equal to a stored one."""

_ROOT_HINT: Final = "run crs in a folder that contains both, or name that folder with --root"


@dataclass(frozen=True, slots=True)
class Header:
    """A header that was found.

    Attributes:
        path: its path, relative to the user's directories.
        file: its path with all links followed.
        root: the directory of the search path in which it was found.
        name: its name in the `#include`.
        is_beside: whether it was found in the including file's own directory.
        content: its content, if it is not a file but generated.
    """

    path: Path
    file: Path
    root: Path
    name: str
    is_beside: bool = False
    content: bytes | None = None

    def read(self) -> bytes | Refusal:
        """Return the contents of the header."""
        return read_regular_file(self.file) if self.content is None else self.content


class Headers:
    """The header directories of a run."""

    def __init__(
        self, main_folder: Path, options: Options, digests: dict[str, str] | None = None
    ) -> None:
        """Set the directories.

        Args:
            main_folder: the directory of the user's main file.
            options: the other directories.
            digests: receives the `digest` of each file that is looked for, found or not: a file
                that is added to a directory changes the program, too.
        """
        self.options = options
        self._digests = {} if digests is None else digests
        self.include_paths = options.include_paths
        self.system_paths = options.system_paths
        self._generated = dict(options.generated)
        folders = (main_folder, *self.include_paths, *self.system_paths)
        self._roots = [root for root in map(_resolved, folders) if root is not None]
        project, main = _resolved(options.root or Path.cwd()), _resolved(main_folder)
        is_inside = project and main and main.is_relative_to(project)
        if project and is_inside and (options.root or project != Path(project.anchor)):
            self._roots.append(project)

    def find(
        self, name: str, *, quoted: bool, folder: Path, after: Path | None = None
    ) -> Header | Refusal:
        """Return the file that an `#include` means (C17 6.10.2).

        Args:
            name: the name between the quotes or angle brackets.
            quoted: whether it is in quotes, so that the including file's directory is searched
                first.
            folder: the including file's directory.
            after: for `#include_next`, the directory in which the last search ended.
        """
        if not name or Path(name).is_absolute():
            return Refusal(
                f"'{shown(name)}' cannot be included", "include the header without its path"
            )
        folders = [*self.include_paths, *self.system_paths]
        starts_beside = quoted and after not in folders
        if after in folders:
            folders = folders[folders.index(after) + 1 :]
        elif starts_beside:
            folders.insert(0, folder)
        outside = False
        for index, each in enumerate(folders):
            path = each / from_text(name)
            file = _resolved(path)
            if file and not any(file.is_relative_to(root) for root in self._roots):
                outside = True  # without revealing whether it exists
                self._digests[str(path)] = _OUTSIDE
                continue
            if str(path) not in self._digests:
                self._digests[str(path)] = digest(path)
            if file and _exists(file):
                return Header(path, file, each, name, starts_beside and index == 0)
        if name in self._generated:
            path = Path(GENERATED, name)
            content = self._generated[name].encode()
            return Header(path, path, Path(GENERATED), name, content=content)
        if outside:
            text = f"'{shown(name)}' is outside the directories that a program may read"
            return Refusal(text, _ROOT_HINT)
        return self._missing(name, folders)

    def find_bundled(self, name: str, *, quoted: bool, folder: Path) -> tuple[str, Header] | None:
        """Return the bundled header that a name not found by `find` means, with its own name."""
        meant = bundled_header(name, self.system_paths)
        found = self.find(meant, quoted=quoted, folder=folder) if meant else None
        return (meant, found) if isinstance(found, Header) else None

    def _missing(self, name: str, folders: list[Path]) -> Refusal:
        own = [str(each) for each in folders if each not in self.system_paths]
        ours = ["the headers of crs"] if self.system_paths else []
        where = ", ".join([*dict.fromkeys(own), *ours]) or "no folder"
        return Refusal(
            f"'{shown(name)}' file not found; searched in: {where}",
            hint_for_missing(name, folders),
        )


def _resolved(path: Path) -> Path | None:
    try:
        return path.resolve()
    except (
        OSError,
        RuntimeError,
        ValueError,
    ):  # names too long, loops of links, invalid characters
        return None


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except (OSError, ValueError):
        return False
