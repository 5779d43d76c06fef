"""Hints at the header that declares an undeclared name."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from typing import Final

_USUAL: Final = (
    "stddef.h", "stdio.h", "stdlib.h", "string.h", "math.h", "stdint.h", "stdbool.h", "limits.h",
    "ctype.h", "time.h", "unistd.h", "sys/types.h",
)  # fmt: skip
"""The preferred headers for names that several of them define, such as `NULL` and `size_t`."""

_BEFORE: Final = r"^[^\s#/](?:[^#\n/(]|\([^()\n]*\))*(?:[ *]|\(\*)"
"""What stands before a name that a header declares; members are indented, parameters in `(`."""


def header_hint(name: str, folders: Sequence[Path]) -> str:
    """Return a hint at the header that declares a name; "" if there is none."""
    pattern = re.compile(
        rf"^#define {re.escape(name)}\b|{_BEFORE}{re.escape(name)}(?:[([]|;$)", re.MULTILINE
    )
    for folder in folders:
        for header, text in _headers(folder):
            if name in text and pattern.search(text):
                return f"include <{header}>"
    return ""


@lru_cache(maxsize=4)
def _headers(folder: Path) -> tuple[tuple[str, str], ...]:
    """Return the names and texts of the headers in a directory, the preferred ones first."""
    paths = [*folder.glob("*.h"), *folder.glob("*/*.h")]
    paths.sort(key=lambda path: (len(path.parts), path.parent.name != "sys", path))
    named = {path.relative_to(folder).as_posix(): path for path in paths}
    own = {name: path for name, path in named.items() if not name.startswith("crs")}
    found = {name: path.read_text("utf-8") for name, path in own.items()}
    usual = {name: found.pop(name) for name in _USUAL if name in found}
    return tuple((usual | found).items())
