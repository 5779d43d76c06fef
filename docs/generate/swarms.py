"""Tables of `docs/swarms.md`: the results of the experiments in `samples/swarm`."""

from __future__ import annotations

import csv

from docs.generate import ROOT, Fillers, cell, table


def results(name: str) -> str:
    """Return the results of an experiment, as `make experiments` wrote them."""
    path = ROOT / "samples" / "swarm" / "results" / f"{name}.csv"
    with path.open(encoding="utf-8", newline="") as file:
        titles, *rows = csv.reader(file)
    return table(tuple(titles), [tuple(map(cell, row)) for row in rows])


FILLERS: Fillers = {"results": results}
