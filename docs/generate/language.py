"""Rows of `docs/language.md`: whether a feature of C is accepted, and the case that shows it."""

from __future__ import annotations

import re
from typing import Final

from docs.generate import ROOT, Fillers, cell

CASES: Final = ROOT / "tests" / "c"
STATUS: Final = {"valid": "yes", "warned": "with a warning", "refused": "no"}


def case(name: str) -> str:
    """Return two cells: whether the feature is accepted, and a link to the case that shows it."""
    text = (CASES / f"{name}.c").read_text(encoding="utf-8", errors="replace")
    comment = re.match(r"/\*\s*(.*?)\s*\*/", text, re.DOTALL)
    shows = cell(" ".join(comment[1].split())).removesuffix(".") if comment else ""
    link = f"[{name}](../tests/c/{name}.c)"
    return f"{STATUS[name.partition('/')[0]]} | {link}{': ' if shows else ''}{shows}"


FILLERS: Fillers = {"case": case}
