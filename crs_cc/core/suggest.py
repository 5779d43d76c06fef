"""How what a name does not name is told.

>>> unknown("robot", "r", ["a", "b"])
"there is no robot 'r': there are a, b"
>>> unknown("robot", "r", [])
"there is no robot 'r': there are none"
>>> unknown("robot", "r", [f"robot{number}" for number in range(1000)])[-29:]
'robot18, robot19 and 980 more'
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

_MOST: Final = 20
_LONGEST: Final = 64


def unknown(kind: str, name: str, known: Sequence[str]) -> str:
    """Return the words for it.

    Args:
        kind: what it should name.
        name: the name.
        known: the names that there are.
    """
    names = ", ".join(known[:_MOST]) or "none"
    more = f" and {len(known) - _MOST} more" if len(known) > _MOST else ""
    return f"there is no {kind} {name[:_LONGEST]!r}: there are {names}{more}"
