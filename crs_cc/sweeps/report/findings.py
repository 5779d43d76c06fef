"""The findings of a report on a sweep's results, as tables of texts."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from crs_cc.sweeps.plan import shown
from crs_cc.sweeps.report.results import Group, Results
from crs_cc.sweeps.report.statistics import adjusted_p_values, comparison, kruskal_wallis_p, summary
from crs_cc.sweeps.rows import Row, failures

MAX_COMPARED: Final = 10
"""Limit of the combinations that are compared in pairs: larger tables are unreadable."""


@dataclass(frozen=True, slots=True)
class Table:
    """A table of a report.

    Attributes:
        title: its title.
        heading: its columns.
        rows: its cells.
        note: what to know of it.
    """

    title: str
    heading: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    note: str = ""


def tables(results: Results) -> Iterator[Table]:
    """Yield the tables of the findings."""
    yield medians(results)
    if _scales(results):
        yield scaling(results)
    if 2 <= len(results.groups) <= MAX_COMPARED:
        yield comparisons(results)


def failed(rows: Sequence[Row]) -> Table:
    """Return the errors: each once, the most frequent first."""
    return Table(
        "Failures",
        ("status", "error", "runs", "first", "with"),
        tuple(
            (status, text, str(len(each)), str(each[0]["run"]), _what(each[0]))
            for status, text, each in failures(rows)
        ),
        "The recording of run 17 is failed/0017.mcap, for crs debug; the first hundred have one.",
    )


def _what(row: Row) -> str:
    return ", ".join(filter(None, (shown(row["parameters"]), f"seed {row['seed']}")))


def medians(results: Results) -> Table:
    """Return each combination's median, quartiles and interval."""
    rows = []
    for group in results.groups:
        found = summary(group.values)
        ends = [end for end, is_met in zip(group.values, group.reached, strict=True) if not is_met]
        bound = min(ends, default=math.inf)
        rows.append(
            (
                *(str(each) for each in group.parameters.values()),
                str(found.n),
                *((str(sum(group.reached)),) if results.is_time else ()),
                *(
                    _at_least(each, bound)
                    for each in (found.median, found.low_quartile, found.high_quartile)
                ),
                f"{_at_least(found.low, bound)} to {_at_least(found.high, bound)}",
            )
        )
    met = ("met",) if results.is_time else ()
    heading = (*results.varied, "runs", *met, "median", "lower quartile", "upper quartile",
               "95% interval of the median")  # fmt: skip
    note = "The interval is a bootstrap confidence interval (percentiles of 5,000 resamples)."
    if results.is_time:
        note += " Where a goal was not met, the value is the end of the run: ≥ marks such bounds."
    if results.failed:
        runs = f"{results.failed} runs have" if results.failed != 1 else "1 run has"
        note += f" {runs} no {results.measure}: see the failures."
    return Table(f"{results.measure} over the seeds", heading, tuple(rows), note)


def scaling(results: Results) -> Table:
    """Return speedup and efficiency by the number of robots, against the fewest."""
    groups = sorted(results.groups, key=_robots)
    first = groups[0]
    rows = []
    for group in groups:
        ratio = summary(first.values).median / summary(group.values).median
        rows.append(
            (str(_robots(group)), f"{ratio:.2f}", f"{ratio * _robots(first) / _robots(group):.2f}")
        )
    is_open = not all(is_met for group in groups for is_met in group.reached)
    note = (
        "The speedup is the ratio of the medians; the efficiency is the speedup divided by the "
        "ratio of the numbers of robots."
    )
    if is_open:
        note += " Some runs ended before the goal was met: where ≥ marks a median, it is a bound."
    return Table("Scaling", ("robots", "speedup", "efficiency"), tuple(rows), note)


def comparisons(results: Results) -> Table:
    """Return the differences between combinations, in pairs."""
    named = zip(results.labels, results.groups, strict=True)
    pairs = list(itertools.combinations(named, 2))
    found = [comparison(first.values, second.values) for (_, first), (_, second) in pairs]
    p = adjusted_p_values([each.p for each in found])
    rows = tuple(
        (
            first_label,
            second_label,
            _p(p[number]),
            f"{found[number].effect:+.2f}",
            _needed(found[number].needed, min(len(first.values), len(second.values))),
        )
        for number, ((first_label, first), (second_label, second)) in enumerate(pairs)
    )
    overall = _p(kruskal_wallis_p([group.values for group in results.groups]))
    note = (
        f"All together: p = {overall} (Kruskal-Wallis). Pairs: Mann-Whitney U, two-sided, p "
        "corrected for their number (Benjamini-Hochberg). The effect is Cliff's delta: how much "
        "more often a value of the first is larger than one of the second than smaller. The last "
        "column says how many seeds would show such an effect in four of five cases at p = 0.05 "
        "(Noether 1987)."
    )
    heading = ("first", "second", "p", "effect", "seeds for 80% power")
    return Table("Differences", heading, rows, note)


def _scales(results: Results) -> bool:
    return results.is_time and results.varied == ("robots",)


def _robots(group: Group) -> int:
    return int(group.parameters["robots"])


def _at_least(value: float, bound: float) -> str:
    return f"≥ {value:.4g}" if value >= bound else f"{value:.4g}"


def _p(p: float) -> str:
    return "< 0.001" if p < 0.001 else f"{p:.3f}"


def _needed(needed: int | None, had: int) -> str:
    if needed is None:
        return "no effect"
    return f"{needed:,}" if needed <= had else f"{needed:,} (there are {had})"
