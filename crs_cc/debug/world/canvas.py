"""A canvas of characters: braille cells of 2 by 4 dots, each in one style.

A cell of a terminal is twice as high as it is wide, so dots lie as far apart in both directions.
Coordinates are in dots from the upper left corner, x to the right and y down; anything outside
is clipped. If objects of different styles share a cell, the one with the highest rank determines
its style.

>>> canvas = Canvas(columns=3, rows=1)
>>> canvas.lines(np.array([[0.0, 3.0, 5.0, 3.0]]), "red", rank=1)
>>> canvas.put(2, 0, "x", "bold", rank=2)
>>> canvas.pieces()
[[('⣀⣀', 'red'), ('x', 'bold')]]
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray

Styles = str | Sequence[str]
"""One style for all, or one for each."""

Pieces = list[list[tuple[str, str]]]
"""Rows of pieces: each a text and its style."""

ACROSS: Final = 2
DOWN: Final = 4
"""Dots of a cell."""

_BITS: Final = np.array([[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]], np.uint8)
"""The bit of each dot in a braille pattern (Unicode 15, 21.1), by row and column."""

_BLANK: Final = 0x2800
_POINT: Final = 0.5  # a smaller circle is a dot
_MIN_CORNERS: Final = 8
_MAX_CORNERS: Final = 1024
_MAX_DOTS: Final = 2_000_000  # of one call; more are indistinguishable


class Canvas:
    """A drawing, empty at first.

    Attributes:
        columns: its width [cells].
        rows: its height [cells].
    """

    def __init__(self, columns: int, rows: int) -> None:
        self.columns, self.rows = columns, rows
        self._bits = np.zeros((rows, columns), np.uint8)
        self._rank = np.full((rows, columns), -1, np.int64)
        self._style = np.zeros((rows, columns), np.intp)
        self._known = {"": 0}
        self._characters: dict[tuple[int, int], str] = {}

    def dots(self, x: FloatArray, y: FloatArray, style: Styles, rank: int) -> None:
        """Draw dots, shape (n,) each, in one style or each in its own."""
        self._dots(x, y, self._numbers(style, len(x)), rank)

    def lines(self, ends: FloatArray, style: Styles, rank: int, *, gap: int = 1) -> None:
        """Draw lines.

        Args:
            ends: x and y of both ends of each, (n, 4).
            style: their style, or that of each.
            rank: their rank.
            gap: draw only one in this many dots.
        """
        numbers = self._numbers(style, len(ends))
        seen, ends = clipped(ends, ACROSS * self.columns, DOWN * self.rows)
        numbers = numbers[seen]
        spans = ends[:, 2:] - ends[:, :2]
        counts = np.ceil(np.abs(spans).max(axis=1, initial=0.0)).astype(np.intp) + 1
        line = np.repeat(np.arange(len(ends)), counts)[:_MAX_DOTS]
        number = np.arange(len(line)) - (np.cumsum(counts) - counts)[line]
        drawn = number % gap == 0
        line, number = line[drawn], number[drawn]
        share = number / np.maximum(counts[line] - 1, 1)
        places = ends[line, :2] + share[:, None] * spans[line]
        self._dots(places[:, 0], places[:, 1], numbers[line], rank)

    def circles(self, circles: FloatArray, style: Styles, rank: int) -> None:
        """Draw circles: x, y and radius of each, (n, 3), as polygons."""
        styles = [style] * len(circles) if isinstance(style, str) else style
        radius = np.where(circles[:, 2] < _POINT, 0.0, circles[:, 2])
        sizes = np.log2(np.clip(4 * radius, _MIN_CORNERS, _MAX_CORNERS))
        corners = 2 ** np.ceil(sizes).astype(np.intp)
        for count in np.unique(corners).tolist():
            alike = np.flatnonzero(corners == count)
            angles = np.linspace(0.0, 2 * np.pi, count + 1)
            around = radius[alike, None, None] * np.column_stack([np.cos(angles), np.sin(angles)])
            points = circles[alike, None, :2] + around
            ends = np.concatenate([points[:, :-1], points[:, 1:]], axis=2).reshape(-1, 4)
            self.lines(ends, [styles[circle] for circle in np.repeat(alike, count).tolist()], rank)

    def _dots(self, x: FloatArray, y: FloatArray, numbers: IndexArray, rank: int) -> None:
        column, row = np.floor(x).astype(np.intp), np.floor(y).astype(np.intp)
        inside = (column >= 0) & (column < ACROSS * self.columns)
        inside &= (row >= 0) & (row < DOWN * self.rows)
        column, row = column[inside], row[inside]
        cells = (row // DOWN, column // ACROSS)
        np.bitwise_or.at(self._bits, cells, _BITS[row % DOWN, column % ACROSS])
        higher = self._rank[cells] <= rank
        cells = (cells[0][higher], cells[1][higher])
        self._rank[cells], self._style[cells] = rank, numbers[inside][higher]

    def put(self, column: int, row: int, text: str, style: str, rank: int) -> None:
        """Write a text over cells, from left to right, where nothing has a higher rank."""
        for place, character in enumerate(text, column):
            if (
                0 <= place < self.columns
                and 0 <= row < self.rows
                and self._rank[row, place] <= rank
            ):
                self._characters[row, place] = character
                self._rank[row, place], self._style[row, place] = rank, self._number(style)

    def is_free(self, column: int, row: int, length: int) -> bool:
        """Return whether cells are free for a text."""
        inside = 0 <= row < self.rows and 0 <= column <= self.columns - length
        return inside and bool((self._rank[row, column : column + length] < 0).all())

    def pieces(self) -> Pieces:
        """Return the drawing, row by row."""
        styles = list(self._known)
        return [
            [
                ("".join(character for character, _ in cells), styles[style])
                for style, cells in groupby(self._row(row), key=lambda cell: cell[1])
            ]
            for row in range(self.rows)
        ]

    def _row(self, row: int) -> list[tuple[str, int]]:
        """Return the character and the style of each cell."""
        bits, styles = self._bits[row].tolist(), self._style[row].tolist()
        cells = []
        for column, (pattern, style) in enumerate(zip(bits, styles, strict=True)):
            character = chr(_BLANK + pattern) if pattern else " "
            cells.append((self._characters.get((row, column), character), style))
        return cells

    def _number(self, style: str) -> int:
        return self._known.setdefault(style, len(self._known))

    def _numbers(self, style: Styles, count: int) -> IndexArray:
        if isinstance(style, str):
            return np.full(count, self._number(style), np.intp)
        return np.array([self._number(each) for each in style], np.intp)


def clipped(ends: FloatArray, width: float, height: float) -> tuple[IndexArray, FloatArray]:
    """Return the parts of lines inside the rectangle from 0, 0 to width, height.

    Source: Liang and Barsky, "A new concept and method for line clipping", 1984.

    Args:
        ends: x and y of both ends of each, (n, 4).
        width: the rectangle's.
        height: the rectangle's.

    Returns:
        which lines have any, (m,), and the ends of these, (m, 4).

    >>> seen, ends = clipped(np.array([[0.0, 9.0, 4.0, 9.0], [-5.0, 1.0, 5.0, 1.0]]), 4.0, 4.0)
    >>> seen.tolist(), ends.tolist()
    ([1], [[0.0, 1.0, 4.0, 1.0]])
    """
    span = ends[:, 2:] - ends[:, :2]
    towards = np.concatenate([-span, span], axis=1)  # left, top, right, bottom
    room = np.concatenate([ends[:, :2], np.array([width, height]) - ends[:, :2]], axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        share = room / towards
    enter = np.where(towards < 0.0, share, 0.0).max(axis=1, initial=0.0)
    leave = np.where(towards > 0.0, share, 1.0).min(axis=1, initial=1.0)
    seen = np.flatnonzero((enter <= leave) & ~((towards == 0.0) & (room < 0.0)).any(axis=1))
    start, span = ends[seen, :2], span[seen]
    parts = [start + enter[seen, None] * span, start + leave[seen, None] * span]
    return seen, np.column_stack(parts)
