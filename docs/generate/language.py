"""Rows of `docs/language.md`: what crs does with a feature of C, and the case that shows it."""

from __future__ import annotations

import re
from typing import Final

from docs.generate import ROOT, Fillers, cell

CASES: Final = ROOT / "tests" / "c"
RESULTS: Final = {"valid": "supported", "warned": "warning", "refused": "error"}
UNSUPPORTED: Final = "not supported"


def case(name: str, unsupported: str = "") -> str:
    """Return two cells: what crs does with the feature, and a link to the case that shows it.

    Args:
        name: the case.
        unsupported: `unsupported` for a feature that is rejected though it is no mistake.
    """
    text = (CASES / f"{name}.c").read_text(encoding="utf-8", errors="replace")
    comment = re.match(r"/\*\s*(.*?)\s*\*/", text, re.DOTALL)
    shows = cell(" ".join(comment[1].split())).removesuffix(".") if comment else ""
    link = f"[{name}](../tests/c/{name}.c)"
    result = UNSUPPORTED if unsupported else RESULTS[name.partition("/")[0]]
    return f"{result} | {link}{': ' if shows else ''}{shows}"


FILLERS: Fillers = {"case": case}
