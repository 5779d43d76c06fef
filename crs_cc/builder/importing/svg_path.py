"""Paths of SVG that consist of straight segments (SVG 1.1, 8.3).

>>> chains("M 0 0 h 2 v 1 z m 5,5 L 6 6")
[([(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 0.0)], True), ([(5.0, 5.0), (6.0, 6.0)], False)]
>>> chains("M0 0 C 1 1 2 2 3 3")
Traceback (most recent call last):
ValueError: it has curves
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Final

from crs_cc.builder.importing.drawn import Point

MAX_POINTS: Final = 200_000
"""Maximum number of points of a plan."""

_TOKEN: Final = re.compile(r"[\s,]*(?:([A-Za-z])|([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d{1,3})?))")
_TAKES: Final = {"M": 2, "L": 2, "H": 1, "V": 1, "Z": 0}


def chains(text: str) -> list[tuple[list[Point], bool]]:
    """Return the points of each part of a path, and whether it is closed.

    Raises:
        ValueError: it has curves, or is no path.
    """
    found: list[tuple[list[Point], bool]] = []
    x = y = 0.0
    for command, numbers in _commands(text):
        letter, relative = command.upper(), command.islower()
        if letter == "Z":
            if found:
                points, _ = found[-1]
                points.append(points[0])
                found[-1] = (points, True)
                x, y = points[0]
            continue
        base_x, base_y = (x, y) if relative else (0.0, 0.0)
        if letter == "H":
            x = base_x + numbers[0]
        elif letter == "V":
            y = base_y + numbers[0]
        else:
            x, y = base_x + numbers[0], base_y + numbers[1]
        if letter == "M":
            found.append(([(x, y)], False))
        elif not found:
            raise ValueError("it does not begin with a point")
        elif found[-1][1]:
            found.append(([found[-1][0][0], (x, y)], False))
        else:
            found[-1][0].append((x, y))
    return [(points, closed) for points, closed in found if len(points) > 1]


def _commands(text: str) -> Iterator[tuple[str, list[float]]]:
    """Yield each command with its numbers, also one whose letter is not repeated."""
    command, numbers, place, count = "", list[float](), 0, 0
    text = text.rstrip(" \t\r\n,")
    while place < len(text):
        token = _TOKEN.match(text, place)
        count += 1
        if token is None or count > 2 * MAX_POINTS:
            raise ValueError("invalid path" if token is None else "it has too many points")
        place = token.end()
        if token[1]:
            command = token[1]
            if command.upper() not in _TAKES:
                raise ValueError("it has curves")
            if numbers:
                raise ValueError("invalid path")
            if command.upper() == "Z":
                yield command, []
            continue
        numbers.append(float(token[2]))
        if not command or command.upper() == "Z":
            raise ValueError("invalid path")
        if len(numbers) == _TAKES[command.upper()]:
            yield command, numbers
            numbers = []
            command = {"M": "L", "m": "l"}.get(command, command)
