r"""Grades as CSV and as text.

>>> [safe(text) for text in ("anna", "=1+2", "-1", "x\ty")]
['anna', "'=1+2", "'-1", 'x y']
"""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from typing import Final

from crs_cc.cli.csv_cells import text_cell
from crs_cc.cli.grading.grades import Grade
from crs_cc.cli.messages import printable
from crs_cc.sim.engine.goals import GoalResult

_COLUMNS: Final = ("submission", "points", "of", "percent", "result", "message", "like")
_MAX_WIDTH: Final = 28


def safe(text: str) -> str:
    """Return a text as a cell that no spreadsheet evaluates, in one line."""
    return text_cell(printable(text))


def as_csv(grades: Sequence[Grade]) -> str:
    """Return a line for each submission, with a column for each goal."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    cases = grades[0].cases
    goals = [f"{case.name}: {goal.title}" for case in cases for goal in case.goals]
    writer.writerow([*_COLUMNS, *map(safe, goals)])
    for grade in grades:
        figures = f"{grade.earned:g}", f"{grade.possible:g}", f"{grade.percent:.1f}"
        words = grade.result, grade.message, ", ".join(grade.identical)
        found = [each for case in range(len(cases)) for each in grade.outcomes(case)]
        name = safe(grade.submission.name)
        writer.writerow([name, *figures, *map(safe, words), *map(_cell, found)])
    return out.getvalue()


def as_lines(grades: Sequence[Grade]) -> list[str]:
    """Return a line for each submission, for a terminal."""
    width = min(_MAX_WIDTH, max(len(grade.submission.name) for grade in grades))
    return [_line(grade, width) for grade in grades]


def _line(grade: Grade, width: int) -> str:
    name = grade.submission.name
    name = name if len(name) <= width else f"{name[: width - 3]}..."
    points = f"{grade.earned:g} of {grade.possible:g}"
    line = f"{name:{width}}  {points:>12}  {grade.message or grade.result}"
    return f"{line}  (same program as {', '.join(grade.identical)})" if grade.identical else line


def _cell(goal: GoalResult | None) -> str:
    if goal is None:
        return ""
    return goal.status if goal.at_s is None else f"{goal.status} {goal.at_s:.2f} s"
