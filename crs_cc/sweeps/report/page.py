"""A report on a sweep as one HTML file, which needs nothing else."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from typing import Final

from crs_cc.sweeps.report import figures
from crs_cc.sweeps.report.findings import Table, failed, tables
from crs_cc.sweeps.report.results import Results
from crs_cc.sweeps.rows import Row

_STYLE: Final = """
body { font: 16px/1.5 sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem }
table { border-collapse: collapse; margin: 1rem 0; display: block; overflow-x: auto }
th, td { padding: .25rem .8rem; border-bottom: 1px solid #ccc; text-align: left }
td { font-variant-numeric: tabular-nums }
svg { max-width: 100%; height: auto }
figcaption, .note { color: #555; font-size: .9rem }
"""


def draw_figures(results: Results) -> dict[str, str]:
    """Return the figures that suit the results, as SVG by their names."""
    found = {"values": figures.box_and_strip(results)}
    levels = [len({repr(g.parameters[name]) for g in results.groups}) for name in results.varied]
    if levels and levels[0] > 2 and _is_numeric(results, results.varied[0]):
        found["curve"] = figures.curve(results)
    if len(results.varied) == 2 and min(levels) > 1:
        found["heat-map"] = figures.heat_map(results)
    if results.is_time:
        found["survival"] = figures.survival_curves(results)
    if max(len(group.values) for group in results.groups) > 1:
        found["convergence"] = figures.convergence(results)
    return found


def _is_numeric(results: Results, name: str) -> bool:
    return figures.is_numeric([group.parameters[name] for group in results.groups])


_CAPTIONS: Final = {
    "values": "Every run; boxes from quartile to quartile, with the median.",
    "curve": "Medians, with the bootstrap 95% confidence interval.",
    "heat-map": "Medians over two parameters.",
    "survival": "Runs in which the goal is not yet met (Kaplan-Meier), with the 95% confidence"
    " interval.",
    "convergence": "The medians of the first seeds: with enough seeds, they no longer change.",
    "visits": "Where the robots were in the median run.",
}
_FIELD: Final = "What lies in a pheromone field at the end of the median run."


def page(
    title: str,
    rows: Sequence[Row],
    results: Results,
    svg: Mapping[str, str],
    replays: Mapping[str, str],
) -> str:
    """Return the page.

    Args:
        title: what the experiment is about.
        rows: all rows.
        results: the results.
        svg: the figures, by their names.
        replays: links to runs, by what they are.
    """
    parts = [f"<h1>{escape(title)}</h1>", _counts(rows)]
    wrong = failed(rows)
    parts += [_table(wrong)] if wrong.rows else []
    for name, text in svg.items():
        caption = escape(_CAPTIONS.get(name, _FIELD))
        parts.append(f"<figure>{text}<figcaption>{caption}</figcaption></figure>")
    parts += [_table(each) for each in tables(results)]
    if replays:
        items = "".join(
            f'<li><a href="{escape(link)}">{escape(what)}</a></li>'
            for what, link in replays.items()
        )
        parts.append(f"<h2>Replays</h2><ul>{items}</ul>")
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width">'
        f"<title>{escape(title)}</title><style>{_STYLE}</style></head>\n<body>\n"
        + "\n".join(parts)
        + "\n</body></html>\n"
    )


def _counts(rows: Sequence[Row]) -> str:
    counts: dict[str, int] = {}
    for row in rows:
        counts[row["status"]] = counts.get(row["status"], 0) + 1
    words = ", ".join(f"{count} {status}" for status, count in sorted(counts.items()))
    runs = f"{len(rows)} runs" if len(rows) != 1 else "1 run"
    return f"<p>{runs}: {escape(words)}.</p>"


def _table(table: Table) -> str:
    head = "".join(f"<th>{escape(each)}</th>" for each in table.heading)
    body = "".join(
        "<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in table.rows
    )
    return (
        f"<h2>{escape(table.title)}</h2><table><thead><tr>{head}</tr></thead>"
        f'<tbody>{body}</tbody></table><p class="note">{escape(table.note)}</p>'
    )
