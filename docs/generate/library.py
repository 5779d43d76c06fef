"""Tables of `docs/library.md`: headers, unavailable functions, accuracy of `math.h`."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Final

from crs_cc.session.library import HEADERS, SOURCES
from docs.generate import ROOT, Fillers, table

ACCURACY: Final = ROOT / "tests" / "runtime" / "lib_math_errors.txt"
"""Measured errors in units in the last place, recorded by test_lib_math.py."""


def headers() -> str:
    """Return a paragraph for each header, with the functions that it declares."""
    names = {path.relative_to(HEADERS).as_posix(): path for path in sorted(HEADERS.rglob("*.h"))}
    return "\n\n".join(
        _header(name, path.read_text())
        for name, path in names.items()
        if not name.startswith("crs")
    )


def _header(name: str, text: str) -> str:
    comment = re.match(r"/\*\s*(.*?)\*/", text, re.DOTALL)
    assert comment is not None, name
    purpose = " ".join(comment[1].split()).split(". ")[0].removesuffix(".")
    functions = ", ".join(f"`{each}`" for each in _declared(text)) or "--"
    return f"**`<{name}>`** {purpose}.\n{functions}"


def _declared(text: str) -> Iterator[str]:
    """Yield the functions that a header declares for programs."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    text = re.sub(r"^#(?:.*\\\n)*.*", "", text, flags=re.MULTILINE)
    text = re.sub(r"^__CRS_COMPLEX\((\w+)\)$", r"\1(z);", text, flags=re.MULTILINE)
    for name in re.findall(r"(\w+)\((?!\*)[^;{}]*\);", text):
        if not name.startswith("__"):
            yield name


def unavailable() -> str:
    """Return the names of the functions that always fail."""
    found = ["system"]
    for path in SOURCES.rglob("*.c"):
        found += re.findall(r"^UNAVAILABLE\(.*?, (\w+),", path.read_text(), re.MULTILINE)
    return ", ".join(f"`{name}`" for name in sorted(found))


def accuracy() -> str:
    """Return the table of the errors of mathematical functions."""
    rows = [line.split("\t") for line in ACCURACY.read_text().splitlines()[1:]]
    return table(
        ("function", "guaranteed", "measured"),
        [(f"`{name}`", guaranteed, measured) for name, guaranteed, measured in rows],
    )


FILLERS: Fillers = {"headers": headers, "unavailable": unavailable, "accuracy": accuracy}
