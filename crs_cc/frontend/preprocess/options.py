"""Options of the preprocessor, named after those of `cc`.

>>> Options(defines=("DEBUG", "SPEED=200", "TWICE(x)=((x)*2)")).defines[1]
'SPEED=200'
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Final, Literal, TypeAlias, get_args

STANDARDS: Final = {
    "c89": "", "c90": "", "ansi": "", "gnu89": "", "gnu90": "",
    "iso9899:199409": "199409L",
    "c99": "199901L", "gnu99": "199901L", "c9x": "199901L", "gnu9x": "199901L",
    "c11": "201112L", "gnu11": "201112L", "c1x": "201112L", "gnu1x": "201112L",
    "c17": "201710L", "gnu17": "201710L", "c18": "201710L", "gnu18": "201710L",
    "c23": "202311L", "gnu23": "202311L", "c2x": "202311L", "gnu2x": "202311L",
}  # fmt: skip
"""The names of `-std=`, each with its `__STDC_VERSION__`."""


def is_c90(standard: str) -> bool:
    """Return whether a key of `STANDARDS` means the language of 1990."""
    return STANDARDS[standard] in {"", "199409L"}


def is_c23(standard: str) -> bool:
    """Return whether a key of `STANDARDS` means the language of 2023."""
    return STANDARDS[standard] == "202311L"


Dialect: TypeAlias = Literal["nomad", "report"]

DIALECTS: Final[tuple[Dialect, ...]] = get_args(Dialect)

DIALECT_HEADERS: Final[dict[Dialect, str]] = {"report": "crs/report.h"}
"""The headers that a dialect includes before the first line."""


@dataclass(frozen=True, slots=True)
class Options:
    """Header directories, macro definitions and the language.

    Attributes:
        include_paths: directories of the user's headers, in the order of search (`-I`).
        system_paths: directories of the headers that come with crs_cc, searched last.
        defines: macros to define, as `NAME`, `NAME=value` or `NAME(a)=value` (`-D`).
        undefines: names to undefine after that (`-U`).
        standard: the C standard, a key of `STANDARDS` (`-std=`). It selects predefined macros,
            trigraphs, which words are keywords, and what C90 and C23 mean by the same text.
        dialect: the robot functions that the program calls: the vendor's, or those of the CRS
            report, which need no header; a program for these may consist of bare statements.
        trusted: whether the file is the allocator, see `ir.program.Function`.
        root: the folder of the user's whole project, whose files may be included from anywhere in
            it; None for the current directory.
        named_from: a folder that is left out of the names of files below it, in messages and in the
            debugger: files of a recording lie in a temporary one.
        generated: headers of ours that are in no file: the name of each, and its text.
    """

    include_paths: tuple[Path, ...] = ()
    system_paths: tuple[Path, ...] = ()
    defines: tuple[str, ...] = ()
    undefines: tuple[str, ...] = ()
    standard: str = "gnu17"
    trusted: bool = False
    dialect: Dialect = "nomad"
    root: Path | None = None
    named_from: Path | None = None
    generated: tuple[tuple[str, str], ...] = ()

    def name(self, path: Path) -> str:
        """Return the name of a file in messages.

        >>> Options(named_from=Path("run")).name(Path("run/a/drive.c"))
        'a/drive.c'
        """
        if self.named_from is not None and path.is_relative_to(self.named_from):
            return str(path.relative_to(self.named_from))
        return str(path)

    @property
    def is_strict(self) -> bool:
        """Return whether the standard is one of ISO's, without GNU extensions."""
        return not self.standard.startswith("gnu")
