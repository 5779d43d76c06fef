"""Detection of a program's dialect.

A program that includes the vendor's header or defines `main` is in the vendor's dialect; one that
defines `runcode` instead, without that header, is in the dialect of the CRS report.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Final

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.body import items_of
from crs_cc.frontend.parse.lexer import lex
from crs_cc.frontend.preprocess.options import Dialect, Options
from crs_cc.frontend.preprocess.preprocessor import preprocess
from crs_cc.frontend.preprocess.regular_file import Refusal, read_regular_file

_RUNCODE: Final = "runcode"
_VENDORS_HEADER: Final = "nclient.h"
_VENDORS_GUARDS: Final = frozenset({"_HOST_CLIENT_NCLIENT_H_", "_HOST_CLIENT_H_"})


def dialect_of(paths: Sequence[Path], options: Options) -> Dialect:
    """Return the dialect of a program."""
    if not any(_mentions_runcode(path) for path in paths):
        return "nomad"
    found = [form(path, options) for path in paths]
    return "report" if "report" in found and "nomad" not in found else "nomad"


def form(path: Path, options: Options) -> Dialect | None:
    """Return the dialect of a single file; None if it may belong to either."""
    source = preprocess(path, options, Diagnostics())
    is_vendors = any(Path(file).name.lower() == _VENDORS_HEADER for file in source.files)
    if is_vendors or not _VENDORS_GUARDS.isdisjoint(source.macros):
        return "nomad"
    tokens = lex(source.text, source.location, Diagnostics(), options.standard)
    names = {item.name for item in items_of(tokens)}
    if "main" in names:
        return "nomad"
    return "report" if _RUNCODE in names else None


def _mentions_runcode(path: Path) -> bool:
    content = read_regular_file(path)
    return not isinstance(content, Refusal) and _RUNCODE.encode() in content
