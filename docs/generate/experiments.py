"""Tables of `docs/experiments.md`: what can be varied, and what a run comes to."""

from __future__ import annotations

from crs_cc.sweeps.measures import OURS
from crs_cc.sweeps.single_run import STATUSES
from crs_cc.sweeps.targets import TARGETS
from docs.generate import Fillers, cell, table


def targets() -> str:
    """Return the table of what parameters vary."""
    rows = [(f"`{name}`", cell(text)) for name, text in TARGETS.items()]
    return table(("parameter", "varies"), rows)


def statuses() -> str:
    """Return the table of how runs end."""
    return table(("status", "meaning"), [(f"`{name}`", text) for name, text in STATUSES.items()])


def measures() -> str:
    """Return the table of the measures that every run has."""
    return table(("column", "content"), [(f"`{name}`", text) for name, (text, _) in OURS.items()])


FILLERS: Fillers = {"targets": targets, "statuses": statuses, "measures": measures}
