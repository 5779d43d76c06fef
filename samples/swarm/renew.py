"""Run the experiments of this folder, and renew the tables and figures of docs/swarms.md.

    python samples/swarm/renew.py            # all of them
    python samples/swarm/renew.py heat       # one

It goes on with runs that were interrupted, in build/swarm, and needs the extra 'analysis'.
"""

from __future__ import annotations

import csv
import os
import sys
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Final

import maze_model
import tour_model
from bridge_results import of_leader, of_short, of_very_short
from clustering_results import of_clusters
from foraging_results import from_none, with_faults, with_losses, with_trails
from means import with_means
from path_results import of_paths
from ways_results import over_shortest

from crs_cc.sweeps.report.findings import medians
from crs_cc.sweeps.report.page import draw_figures
from crs_cc.sweeps.report.results import Group, Results, results
from crs_cc.sweeps.rows import Row
from crs_cc.sweeps.sweep import Sweep

FOLDER: Final = Path(__file__).parent
ROOT: Final = FOLDER.parents[1]
RESULTS: Final = FOLDER / "results"
FIGURES: Final = ROOT / "docs" / "images"
RUNS: Final = ROOT / "build" / "swarm"


def _beside(model: ModuleType) -> Callable[[Sequence[Row]], Results]:
    """Return what shows the ways of robots beside those of a model's ants without bodies."""
    return partial(
        over_shortest,
        lengths_m=model.lengths_m,
        unmarked_m=partial(model.lengths_m, marks=0.0),
        shortest_m=model.shortest_m(),
    )


SHOWN: Final[dict[str, tuple[Callable[[Sequence[Row]], Results], str]]] = {
    "aggregation": (partial(results, measure="largest_group"), "curve"),
    "bridge": (of_leader, "curve"),
    "clustering": (of_clusters, "values"),
    "detour": (of_short, "curve"),
    "far_detour": (of_very_short, "curve"),
    "faults": (with_faults, "curve"),
    "foraging": (partial(results, measure="items_per_min"), "curve"),
    "heat": (partial(results, measure="goal.cool.at_s"), "survival"),
    "maze": (_beside(maze_model), "curve"),
    "path": (of_paths, "survival"),
    "radio": (with_losses, "values"),
    "tour": (_beside(tour_model), "curve"),
    "trails": (with_trails, "curve"),
}
"""Of each experiment: what its rows show, and the figure that shows it."""

WITH_MEANS: Final = {"detour", "far_detour"}
"""Experiments in which most values are at either end, so that medians say little."""

FROM_NONE: Final = {"faults"}
"""Experiments in whose figures each line begins where nothing is wrong."""

_COLLISIONS: Final = "collisions_per_robot_min"


def renew(name: str, runs: Path = RUNS) -> None:
    """Run an experiment, and write its table and its figure.

    Args:
        name: its name.
        runs: the folder of the results of all runs.
    """
    sweep = Sweep(FOLDER / f"{name}.toml", runs / name)
    sweep.run(os.cpu_count() or 1, resume=True)
    write(name, [sweep.rows[number] for number in sorted(sweep.rows)])


def write(name: str, rows: Sequence[Row]) -> None:
    """Write the table and the figure of an experiment.

    Args:
        name: its name.
        rows: its rows, by their numbers.
    """
    summarize, figure = SHOWN[name]
    found = summarize(rows)
    table = with_means(found) if name in WITH_MEANS else medians(found)
    RESULTS.mkdir(exist_ok=True)
    with (RESULTS / f"{name}.csv").open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([*table.heading, "collisions per robot and minute"])
        for cells, group in zip(table.rows, found.groups, strict=True):
            writer.writerow([*cells, collisions(group)])
    shown = from_none(found) if name in FROM_NONE else found
    (FIGURES / f"swarm-{name}.svg").write_text(draw_figures(shown)[figure], "utf-8")


def collisions(group: Group) -> str:
    """Return how many collisions robots began per minute, the mean of the runs; "" for none."""
    values = [row["measures"][_COLLISIONS] for row in group.rows]
    return f"{sum(values) / len(values):.3f}" if values else ""


if __name__ == "__main__":
    for each in sys.argv[1:] or SHOWN:
        renew(each)
