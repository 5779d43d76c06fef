"""Grades as an HTML page: one offline file, with a picture of each run.

Whatever comes from submissions is escaped; pictures are images, in which nothing runs; and the
page's own policy lets it load nothing and run nothing but the script that sorts its table.
"""

from __future__ import annotations

import base64
import hashlib
import os
from collections.abc import Iterator, Sequence
from html import escape
from pathlib import Path
from string import Template
from typing import Final
from urllib.parse import quote

from crs_cc import __version__
from crs_cc.cli.grading.grades import Grade
from crs_cc.cli.grading.job import RESULTS, GradedRun
from crs_cc.cli.messages import printable
from crs_cc.sim.engine.goals import GoalResult

_TEMPLATES: Final = Path(__file__).parents[1] / "templates"
_MARKS: Final = {"met": "✓", "holds": "✓", "failed": "✗", "open": "\u2013"}


def link_to(runs: Path, page: Path) -> str:
    """Return the link from a page to the folder of runs, relative if there is such a path.

    >>> link_to(Path("some runs"), Path("html/grades.html"))
    '../some%20runs'
    """
    try:
        path = Path(os.path.relpath(runs, page.absolute().parent))
    except ValueError:  # on another drive
        return runs.resolve().as_uri()
    return quote(os.fsencode(path.as_posix()))


def as_page(grades: Sequence[Grade], title: str, runs: str | None) -> str:
    """Return the page.

    Args:
        grades: the grades.
        title: what they are of.
        runs: the link to the folder of runs; None for none.
    """
    script = (_TEMPLATES / "grades.js").read_text("utf-8")
    policy = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    earned = [grade.percent for grade in grades]
    values = {
        "title": _text(title),
        "policy": f"sha256-{policy}",
        "script": script,
        "summary": f"{len(grades)} submissions, {sum(earned) / len(grades):.0f}% on average",
        "head": "".join(_head(grades[0])),
        "rows": "\n".join(_row(grade, number) for number, grade in enumerate(grades)),
        "details": "\n".join(_details(grade, n, runs) for n, grade in enumerate(grades)),
        "results": "".join(f"<dt>{word}</dt><dd>{text}.</dd>" for word, text in RESULTS.items()),
        "version": __version__,
    }
    return Template((_TEMPLATES / "grades.html").read_text("utf-8")).substitute(values)


def _text(text: str) -> str:
    return escape(printable(text))


def _head(grade: Grade) -> Iterator[str]:
    """Yield the heading of a column for each goal."""
    for case in grade.cases:
        for goal in case.goals:
            about = f"{case.name}: {goal.title}, {goal.points:g} points"
            yield f'<th class="goal" title="{_text(about)}"><span>{_text(goal.title)}</span></th>'


def _row(grade: Grade, number: int) -> str:
    marks = "".join(
        _mark(run, goal) for case, run in enumerate(grade.runs) for goal in grade.outcomes(case)
    )
    like = f'<div class="like">same program: {_text(", ".join(grade.identical))}</div>'
    return (
        f'<tr class="{grade.result.replace(" ", "-")}">'
        f'<td><a href="#s{number}">{_text(grade.submission.name)}</a></td>'
        f'<td class="number">{grade.earned:g}</td>'
        f'<td class="number" data-key="{grade.percent:.4f}">{grade.percent:.0f}%</td>{marks}'
        f"<td>{grade.result}</td>"
        f"<td>{_text(grade.message)}{like if grade.identical else ''}</td></tr>"
    )


def _mark(run: GradedRun, goal: GoalResult | None) -> str:
    if goal is None:
        return '<td class="goal" data-key="3"></td>'
    status, at = goal.status, "" if goal.at_s is None else f" at {goal.at_s:.2f} s"
    counts = run.counts(goal)
    key = 0 if counts else {"open": 1}.get(status, 2)
    about = _text(f"{goal.title}: {status}{at}{', ' if goal.progress else ''}{goal.progress}")
    kind = "yes" if counts else "no"
    mark = _MARKS[status] if counts or status in {"failed", "open"} else "(✓)"
    return f'<td class="goal {kind}" data-key="{key}" title="{about}">{mark}</td>'


def _details(grade: Grade, number: int, runs: str | None) -> str:
    parts = [f'<section id="s{number}"><h2>{_text(grade.submission.name)}</h2>']
    points = f"{grade.earned:g} of {grade.possible:g} points"
    parts.append(f"<p>{points}. {_text(grade.message)}</p>")
    if grade.identical:
        names = _text(", ".join(grade.identical))
        parts.append(f"<p>Same program, names and comments aside: {names}.</p>")
    for case, run, file in zip(grade.cases, grade.runs, grade.files, strict=True):
        if run.picture:
            parts.append(_figure(case.name, run, f"{runs}/{file}" if runs is not None else ""))
    return "".join([*parts, "</section>"])


def _figure(name: str, run: GradedRun, recording: str) -> str:
    picture = base64.b64encode(run.picture.encode()).decode()
    rows = "".join(_goal_row(run, goal) for goal in run.goals)
    link = f', <a href="{recording}">recording</a>' if recording else ""
    return (
        f'<figure><img alt="the world from above with the path of the robot" loading="lazy"'
        f' src="data:image/svg+xml;base64,{picture}"><figcaption>{_text(name)},'
        f" {run.simulated_s:.2f} s: {run.result}{link}"
        f"<table><tbody>{rows}</tbody></table>{_printed(run)}</figcaption></figure>"
    )


def _printed(run: GradedRun) -> str:
    if not run.printed:
        return ""
    return f"<details><summary>printed</summary><pre>{escape(run.printed)}</pre></details>"


def _goal_row(run: GradedRun, goal: GoalResult) -> str:
    at = "" if goal.at_s is None else f"{goal.at_s:.2f} s"
    points = goal.points if run.counts(goal) else 0.0
    cells = goal.title, goal.status, at, f"{points:g} of {goal.points:g}", goal.progress
    return f"<tr>{''.join(f'<td>{_text(cell)}</td>' for cell in cells)}</tr>"
