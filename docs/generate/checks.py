"""Number of programs in the tables of `docs/checks.md`."""

from __future__ import annotations

from docs.generate import ROOT, Fillers


def programs(folder: str) -> str:
    """Return the number of programs with planted errors in a folder."""
    return str(len(list((ROOT / "tests" / "c" / "planted" / folder).glob("*.c"))))


FILLERS: Fillers = {"programs": programs}
