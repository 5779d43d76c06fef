"""The table of `docs/warnings.md`: the names of all warnings."""

from __future__ import annotations

from crs_cc.core.warning_names import WARNINGS
from docs.generate import Fillers, cell, table


def warnings() -> str:
    """Return the table of names and their meanings."""
    rows = [(f"`-W{name}`", cell(WARNINGS[name])) for name in sorted(WARNINGS)]
    return table(("name", "meaning"), rows)


FILLERS: Fillers = {"warnings": warnings}
