"""`crs sweep`: run an experiment over parameters and seeds, and report on its results."""

from __future__ import annotations

import os
import sys
import time
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Final

import click

from crs_cc.cli.messages import is_terminal, say
from crs_cc.cli.sweep_report import report

if TYPE_CHECKING:
    from crs_cc.sweeps.sweep import Progress, Sweep

_EXAMPLES: Final = """
\b
Examples:
  crs sweep speeds.toml --out speeds
  crs sweep speeds.toml --out speeds --resume
  crs sweep speeds.toml --out speeds --jobs 8 --parquet
  crs sweep report speeds --measure distance_m
"""
_EVERY_S: Final = 0.2
_MAX_ERRORS: Final = 5


class _RunByDefault(click.Group):
    """A group in which `run` may be left out."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Put in `run` where an experiment is named instead of a command."""
        is_named = bool(args) and args[0] not in (*self.commands, *ctx.help_option_names)
        return super().parse_args(ctx, ["run", *args] if is_named else args)


@click.group(
    cls=_RunByDefault,
    epilog=_EXAMPLES,
    short_help="Run an experiment for all combinations of parameter values and seeds.",
    no_args_is_help=True,
)
def sweep() -> None:
    """Run an experiment for all combinations of parameter values and seeds, and report the results.

    `crs sweep EXPERIMENT.toml` is short for `crs sweep run EXPERIMENT.toml`.
    """


@sweep.command("run", epilog=_EXAMPLES, short_help="Run an experiment.")
@click.argument("experiment", type=click.Path(dir_okay=False, path_type=Path),
                metavar="EXPERIMENT.toml")  # fmt: skip
@click.option(
    "--out",
    required=True,
    type=click.Path(file_okay=False, path_type=Path),
    metavar="DIR",
    help="Folder for the results: rows.jsonl during the sweep, then the table runs.csv.",
)
@click.option(
    "--jobs",
    type=click.IntRange(1, 1024),
    default=lambda: os.cpu_count() or 1,
    metavar="N",
    help="Run N at a time. Default: the number of processors.",
)
@click.option(
    "--dask",
    default="",
    metavar="ADDRESS",
    help="Run on the Dask cluster with this scheduler, such as tcp://hall:8786, instead of on "
    "this machine (requires the 'cluster' extra).",
)
@click.option("--resume", is_flag=True, help="Continue an interrupted sweep.")
@click.option(
    "--parquet", is_flag=True, help="Also write runs.parquet (requires the 'arrow' extra)."
)
@click.option("-q", "--quiet", is_flag=True, help="Report errors only.")
def run_sweep(
    *,
    experiment: Path,
    out: Path,
    jobs: int,
    dask: str,
    resume: bool,
    parquet: bool,
    quiet: bool,
) -> int:
    """Run an experiment over all combinations of its parameters, with all its seeds.

    EXPERIMENT.toml names a world, programs and the parameters to vary; docs/experiments.md
    describes it. Everything is checked and compiled before the first run. Each run is a row of
    DIR/runs.csv with its parameters, seed, status, goals and measures; a failed run is a row with
    its error, and is recorded for crs debug in DIR/failed. The table does not depend on --jobs or
    --dask, nor on interruptions.

    The exit status is 0 if no run failed, otherwise 1.
    """
    from crs_cc.cli.columnar import check_pyarrow, write_records
    from crs_cc.jobs.cluster import ClusterError
    from crs_cc.sweeps.rows import heading, records
    from crs_cc.sweeps.sweep import Sweep

    if parquet:
        check_pyarrow("--parquet")
    if dask and not find_spec("distributed"):
        raise click.UsageError("--dask needs distributed: pip install 'crs_cc[cluster]'.")
    wanted = Sweep(experiment, out)
    line = _ProgressLine(shown=not quiet and is_terminal(sys.stderr))
    try:
        wanted.run(jobs, dask=dask, resume=resume, report=line.draw)
    except (KeyboardInterrupt, OSError, ClusterError):
        line.clear()
        if wanted.rows:
            say(f"crs: {len(wanted.rows)} runs have a row in {out}: continue with --resume")
        raise
    line.clear()
    if parquet:
        rows = list(wanted.rows.values())
        write_records(out / "runs.parquet", heading(rows), list(records(rows)))
    return _summary(wanted, quiet=quiet)


sweep.add_command(report)


def _summary(wanted: Sweep, *, quiet: bool) -> int:
    """Report the outcome of the runs; return the exit status."""
    from crs_cc.sweeps.plan import shown
    from crs_cc.sweeps.rows import TABLE, failures
    from crs_cc.sweeps.search import best

    wrong = failures(wanted.rows.values())
    failed = sum(len(rows) for _, _, rows in wrong)
    if quiet:
        return int(failed > 0)
    runs = f"{len(wanted.rows)} runs" if len(wanted.rows) != 1 else "1 run"
    say(f"{runs}, {failed} failed: {wanted.folder / TABLE}")
    for status, text, rows in wrong[:_MAX_ERRORS]:
        first = rows[0].get("recording") or f"run {rows[0]['run']}"
        say(f"  {len(rows)} x {status}: {text} ({first})")
    if len(wrong) > _MAX_ERRORS:
        say(f"  and {len(wrong) - _MAX_ERRORS} other errors")
    for number, text in sorted(wanted.unrecorded.items())[:1]:
        say(f"{len(wanted.unrecorded)} failed runs are not recorded, the first is {number}: {text}")
    search = wanted.experiment.search
    found = best(search, wanted.rows.values()) if search else None
    if search and found:
        say(f"best median of {search.measure}: {found[1]:.6g} with {shown(found[0])}")
    return int(failed > 0)


class _ProgressLine:
    """The last line of a terminal: how far a sweep is."""

    def __init__(self, *, shown: bool) -> None:
        self._shown, self._drawn_s, self._length = shown, 0.0, 0

    def draw(self, progress: Progress) -> None:
        """Draw it, if it is shown and was not just drawn."""
        now_s = time.monotonic()
        if not self._shown or now_s - self._drawn_s < _EVERY_S:
            return
        self._drawn_s = now_s
        text = progress_text(progress)
        print(f"\r{text:{self._length}}", end="", file=sys.stderr, flush=True)
        self._length = len(text)

    def clear(self) -> None:
        """Remove it."""
        if self._length:
            print(f"\r{'':{self._length}}\r", end="", file=sys.stderr, flush=True)
            self._length = 0


def progress_text(progress: Progress) -> str:
    """Return the progress of a sweep, in one line."""
    text = f"{progress.done} of {progress.runs} runs, {progress.per_s:.1f}/s"
    if progress.failed:
        text += f", {progress.failed} failed"
    left_s = round(progress.left_s)
    if left_s:
        hours, rest = divmod(left_s, 3600)
        text += f", {hours}:{rest // 60:02d}:{rest % 60:02d} left"
    return text
