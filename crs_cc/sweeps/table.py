"""Sweeps from Python: `crs_cc.sweep` and the table that it returns."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from crs_cc.sweeps.rows import heading, records
from crs_cc.sweeps.sweep import Sweep


@dataclass(frozen=True, slots=True)
class SweepTable:
    """The results of a sweep.

    Attributes:
        folder: the folder with its files.
        columns: the columns.
        records: a record for each run, in their order: values by column.
    """

    folder: Path
    columns: tuple[str, ...]
    records: tuple[dict[str, Any], ...]

    @property
    def failed(self) -> int:
        """How many runs did not just end."""
        return sum(record["status"] != "ended" for record in self.records)

    def frame(self) -> Any:
        """Return the table as a frame of pandas, or of polars where only that is installed.

        Raises:
            ImportError: neither is.
        """
        values = {name: [each.get(name) for each in self.records] for name in self.columns}
        try:
            import pandas as pd
        except ImportError:
            import polars as pl

            return pl.DataFrame(values, strict=False)
        return pd.DataFrame(values)

    def __repr__(self) -> str:
        return f"<SweepTable of {len(self.records)} runs in {self.folder}>"


def sweep(
    experiment: str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    jobs: int | None = None,
    dask: str = "",
    resume: bool = False,
) -> SweepTable:
    """Run an experiment, as `crs sweep` does; return its table.

    Args:
        experiment: its TOML file, see docs/experiments.md.
        out: the folder of the results.
        jobs: how many runs at a time; by default as many as there are processors.
        dask: the address of the scheduler of a Dask cluster to run on instead.
        resume: continue a sweep that was interrupted; the table of one that is complete is
            returned as it is.

    Raises:
        ValueError: `jobs` is not positive.
        CrsError: the experiment is invalid, or does not fit to the folder.
        OSError: a result cannot be written; the rows so far are kept.
    """
    if jobs is not None and jobs < 1:
        raise ValueError(f"jobs must be 1 or more, not {jobs!r}")
    wanted = Sweep(Path(experiment), Path(out))
    wanted.run(jobs or os.cpu_count() or 1, dask=dask, resume=resume)
    rows = list(wanted.rows.values())
    return SweepTable(Path(out), tuple(heading(rows)), tuple(records(rows)))
