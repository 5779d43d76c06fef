"""Means beside medians: of shares of which most are near 0 or 1."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy.stats import bootstrap

from crs_cc.sweeps.report.findings import Table, medians
from crs_cc.sweeps.report.results import Results


def with_means(results: Results) -> Table:
    """Return the table of medians, with means and their bootstrapped intervals."""
    table = medians(results)
    means = [_mean(group.values) for group in results.groups]
    heading = (*table.heading, "mean", "95% interval of the mean")
    rows = [(*cells, *more) for cells, more in zip(table.rows, means, strict=True)]
    return replace(table, heading=heading, rows=tuple(rows))


def _mean(values: Sequence[float]) -> tuple[str, str]:
    array = np.array(values)
    interval = bootstrap(
        (array,), np.mean, n_resamples=5000, method="percentile", rng=np.random.default_rng(1)
    ).confidence_interval
    return f"{array.mean():.3g}", f"{interval.low:.3g} to {interval.high:.3g}"
