"""Examples of `docs/errors.md`: programs of `tests/c/errors` with their reports."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Final

from docs.generate import ROOT, Fillers

CASES: Final = ROOT / "tests" / "c" / "errors"


def example(name: str) -> str:
    """Return a program and its report, without the comments that state what is expected."""
    case = CASES / f"{name}.c"
    return f"```c\n{_text(case)}```\n\n```\n{_text(case.with_suffix('.report'))}```"


def _text(path: Path) -> str:
    return re.sub(r" *// error:.*", "", path.read_text(encoding="utf-8"))


FILLERS: Fillers = {"example": example}
