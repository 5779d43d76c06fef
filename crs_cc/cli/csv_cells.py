"""Cells of CSV files that spreadsheets do not interpret as formulas."""

from __future__ import annotations

from typing import Final, TypeVar

T = TypeVar("T")

_FORMULA: Final = ("=", "+", "-", "@", "\t", "\r")
"""With these a cell starts that spreadsheets take for a formula (OWASP, "CSV Injection")."""


def text_cell(cell: T) -> T | str:
    """Return a cell as data: a text that would be a formula gets an apostrophe in front.

    >>> text_cell("=1+1"), text_cell(-1.5), text_cell("a,b")
    ("'=1+1", -1.5, 'a,b')
    """
    return f"'{cell}" if isinstance(cell, str) and cell.startswith(_FORMULA) else cell
