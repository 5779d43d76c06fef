"""A fingerprint of a program, equal for programs that differ in names and comments only.

Each name that the program chose is replaced by its number, in the order of first use, for each file
on its own; names of the library and of C itself stay. So do numbers and strings: two solutions of
one task may well have the same structure, but rarely the same numbers, too.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from functools import cache
from typing import Final

from crs_cc.cli.grading.source_tokens import SourceTokens
from crs_cc.frontend.parse.keywords import keywords
from crs_cc.frontend.preprocess.tokens import NAME
from crs_cc.robot_api import CONSTANTS, STATE, VARIABLES
from crs_cc.session.library import library

_STANDARD: Final = "gnu17"
MIN_TOKENS: Final = 60
"""Shorter programs are not compared: what little they do can only be done so."""


def fingerprint(files: Sequence[SourceTokens]) -> str:
    """Return the fingerprint of a program of several files, empty for a very short one."""
    if sum(len(file.tokens) for file in files) < MIN_TOKENS:
        return ""
    parts = sorted(_digest(file) for file in files)
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def _digest(file: SourceTokens) -> str:
    known, own = _known_names(), dict[str, str]()
    words = [
        token.text
        if token.kind != NAME or token.text in known
        else own.setdefault(token.text, f"${len(own)}")
        for token in file.tokens
    ]
    return hashlib.sha256("\n".join(words).encode("utf-8", "surrogateescape")).hexdigest()


@cache
def _known_names() -> frozenset[str]:
    """Return the names that a program has not chosen."""
    ours = {name.name for names in (CONSTANTS, STATE, VARIABLES) for name in names}
    return frozenset({*keywords(_STANDARD), *library().names(), *ours, "main", "runcode"})
