"""Messages for unknown names, with the known ones.

>>> unknown("robot", "r", ["a", "b"])
"unknown robot 'r' (known: a, b)"
>>> unknown("robot", "r", [])
"unknown robot 'r' (known: none)"
>>> unknown("robot", "r", [f"robot{number}" for number in range(1000)])[-30:]
'robot18, robot19 and 980 more)'
"""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from typing import Final

_MAX_KNOWN_SHOWN: Final = 20
_MAX_NAME_LENGTH: Final = 64
_MAX_COMPARED: Final = 5000
_MAX_RANKED: Final = 8
_CUTOFF: Final = 0.6


def closest(name: str, known: Sequence[str]) -> str | None:
    """Return the known name that an unknown one most likely means, None if none resembles it.

    Names that differ in case only come first, then those with the fewest letters to change.

    >>> closest("scout_vn", ["scout_ws", "scout_pr", "scout_vm"]), closest("min", ["main", "MIN"])
    ('scout_vm', 'MIN')
    """
    for each in known:
        if each.lower() == name.lower():
            return each
    near = difflib.get_close_matches(name, known[:_MAX_COMPARED], n=_MAX_RANKED, cutoff=_CUTOFF)
    ranked = sorted((_changes(name, each), order, each) for order, each in enumerate(near))
    most = max(1, len(name) // 3)
    return ranked[0][2] if ranked and ranked[0][0] <= most else None


def _changes(left: str, right: str) -> int:
    """Return the edit distance of two words with adjacent swaps (Damerau 1964)."""
    before, row = [0] * (len(right) + 1), list(range(len(right) + 1))
    for i, a in enumerate(left, start=1):
        older, before, row = before, row, [i]
        for j, b in enumerate(right, start=1):
            cost = min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (a != b))
            if i > 1 and j > 1 and a == right[j - 2] and b == left[i - 2]:
                cost = min(cost, older[j - 2] + 1)
            row.append(cost)
    return row[-1]


def unknown(kind: str, name: str, known: Sequence[str]) -> str:
    """Return the message for a name that is not known."""
    names = ", ".join(known[:_MAX_KNOWN_SHOWN]) or "none"
    more = f" and {len(known) - _MAX_KNOWN_SHOWN} more" if len(known) > _MAX_KNOWN_SHOWN else ""
    return f"unknown {kind} {name[:_MAX_NAME_LENGTH]!r} (known: {names}{more})"
