"""`crs sweep report`: statistics and figures of a sweep, as a page with replays."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Final

import click

from crs_cc.cli.messages import say

if TYPE_CHECKING:
    from crs_cc.recording.recording import Recording
    from crs_cc.sim.model.world import Area
    from crs_cc.sweeps.report.results import Results
    from crs_cc.sweeps.rows import Row
    from crs_cc.sweeps.sweep import Sweep

_NEEDED: Final = ("scipy", "matplotlib")
_CELL_M: Final = 0.1


@click.command(short_help="Report the results of an experiment.")
@click.argument("folder", type=click.Path(exists=True, file_okay=False, path_type=Path),
                metavar="DIR")  # fmt: skip
@click.option(
    "--measure",
    default="",
    metavar="COLUMN",
    help="The column of the table to report on. Default: the measure of a search, else the time "
    "of the first goal that was met, else the points.",
)
@click.option(
    "--replays/--no-replays",
    default=True,
    help="Repeat three runs, and link pages that replay them (default).",
)
def report(*, folder: Path, measure: str, replays: bool) -> int:
    """Report on the sweep in DIR: write DIR/report.html, DIR/summary.csv and DIR/figures.

    The report has medians with quartiles and bootstrap confidence intervals over the seeds, tests
    and effect sizes, figures, and replays of the runs with the smallest, the median and the largest
    value. Requires the 'analysis' extra.
    """
    if not all(map(find_spec, _NEEDED)):
        raise click.UsageError(
            "a report needs scipy and matplotlib: pip install 'crs_cc[analysis]'."
        )
    from crs_cc.sweeps.report.findings import medians
    from crs_cc.sweeps.report.page import draw_figures, page
    from crs_cc.sweeps.report.results import results
    from crs_cc.sweeps.rows import replace_text
    from crs_cc.sweeps.sweep import Sweep

    sweep = Sweep.of(folder)
    rows = list(sweep.rows.values())
    if not measure and sweep.experiment.search is not None:
        measure = sweep.experiment.search.measure
    try:
        found = results(rows, measure)
    except ValueError as error:
        raise click.UsageError(f"{error}.") from None
    svg = draw_figures(found)
    links = _replayed(sweep, found, svg) if replays else {}
    figures = folder / "figures"
    figures.mkdir(exist_ok=True)
    for name, text in svg.items():
        replace_text(figures / f"{name}.svg", text)
    summary = medians(found)
    replace_text(folder / "summary.csv", _csv([summary.heading, *summary.rows]))
    title = sweep.experiment.title or sweep.experiment.path.stem
    replace_text(folder / "report.html", page(title, rows, found, svg, links))
    runs = f"{len(rows)} runs" if len(rows) != 1 else "1 run"
    say(f"{folder / 'report.html'}: {found.measure} of {runs}")
    return 0


def _csv(rows: Sequence[Sequence[str]]) -> str:
    target = io.StringIO()
    csv.writer(target, lineterminator="\n").writerows(rows)
    return target.getvalue()


def _replayed(sweep: Sweep, found: Results, svg: dict[str, str]) -> dict[str, str]:
    """Record the smallest, the median and the largest run; return the links to their pages."""
    from crs_cc.cli.recording_plot import world_of
    from crs_cc.recording.recording import Recording
    from crs_cc.sweeps.plan import shown
    from crs_cc.workbench.page import html_page

    chosen = extremes(found)
    names = {what: f"replays/{row['run']:04d}.mcap" for what, row in chosen.items()}
    wrong = sweep.record_again(list(dict.fromkeys(zip(
        (row["run"] for row in chosen.values()), names.values(), strict=True))))  # fmt: skip
    if wrong:
        say(f"no replays: {wrong}")
        return {}
    links = {}
    for what, row in chosen.items():
        path = sweep.folder / names[what]
        recording = Recording(path)
        page = path.with_suffix(".html")
        world = world_of(recording)
        page.write_text(html_page(recording, world), "utf-8", errors="replace")
        combination = shown(row["parameters"])
        links[f"{what}: run {row['run']}, {combination}, seed {row['seed']}"] = (
            f"replays/{page.name}"
        )
        if what == "median":
            svg |= _maps(recording, world.area)
    return links


def _maps(recording: Recording, area: Area) -> dict[str, str]:
    """Return maps of the robots' positions in a run, and of each field at its end."""
    import numpy as np

    from crs_cc.recording.field_sketches import sketches_in
    from crs_cc.sweeps.report.figures import field_map, visits

    places = [frame.values[:2].T for frame in recording.frames()]
    found = {"visits": visits(np.concatenate(places), _CELL_M, area)}
    last = {sketch.name: (time_ns, sketch) for time_ns, sketch in sketches_in(recording)}
    for number, (time_ns, sketch) in enumerate(last.values(), 1):
        age_s = (recording.end_ns - time_ns) * 1e-9
        found[f"field-{number}"] = field_map(sketch, age_s, area)
    return found


def extremes(found: Results) -> dict[str, Row]:
    """Return the runs with the smallest, the median and the largest value."""
    ordered = sorted(
        (
            (value, row["run"], row)
            for group in found.groups
            for value, row in zip(group.values, group.rows, strict=True)
        ),
        key=lambda each: each[:2],
    )
    middle = (len(ordered) - 1) // 2
    return {
        "smallest": ordered[0][2],
        "median": ordered[middle][2],
        "largest": ordered[-1][2],
    }
