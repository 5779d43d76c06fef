"""Rows of a name and a text, optionally with child rows.

>>> row = Row("pose", pose_text(1.0, -0.25, math.pi / 2), (Row("x", length(1.0)),))
>>> list(lines([row]))
['pose  1.000, -0.250 m, 90.0 deg', '  x  1.000 m']
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Row:
    """One row.

    Attributes:
        name: what differs.
        text: its value with units; one line.
        children: rows with details.
    """

    name: str
    text: str
    children: tuple[Row, ...] = ()


def lines(rows: Sequence[Row], depth: int = 0) -> Iterator[str]:
    """Return rows as aligned lines of text, children indented."""
    width = max((len(row.name) for row in rows), default=0)
    for row in rows:
        yield f"{'  ' * depth}{row.name:{width}}  {row.text}".rstrip()
        yield from lines(row.children, depth + 1)


def length(value_m: float) -> str:
    """Return a formatted length."""
    return f"{_zero(value_m, 3):.3f} m"


def angle(value_rad: float) -> str:
    """Return a formatted angle."""
    return f"{_zero(math.degrees(value_rad), 1):.1f} deg"


def instant(time_s: float) -> str:
    """Return a formatted time.

    >>> instant(0.05), instant(math.inf)
    ('0.050 s', 'never')
    """
    return f"{time_s:.3f} s" if math.isfinite(time_s) else "never"


def pose_text(x_m: float, y_m: float, heading_rad: float) -> str:
    """Return a formatted pose: x, y and the heading from 0 to 360 degrees."""
    heading_deg = round(math.degrees(heading_rad) % 360.0, 1) % 360.0
    return f"{_zero(x_m, 3):.3f}, {_zero(y_m, 3):.3f} m, {heading_deg:.1f} deg"


def _zero(value: float, places: int) -> float:
    """Return a number that is not shown as -0."""
    return round(value, places) + 0.0
