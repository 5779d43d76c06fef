"""Messages for unknown names, with the known ones.

>>> unknown("robot", "r", ["a", "b"])
"unknown robot 'r' (known: a, b)"
>>> unknown("robot", "r", [])
"unknown robot 'r' (known: none)"
>>> unknown("robot", "r", [f"robot{number}" for number in range(1000)])[-30:]
'robot18, robot19 and 980 more)'
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

_MAX_KNOWN_SHOWN: Final = 20
_MAX_NAME_LENGTH: Final = 64


def unknown(kind: str, name: str, known: Sequence[str]) -> str:
    """Return the message for a name that is not known.

    Args:
        kind: what the name should refer to.
        name: the unknown name.
        known: the names that would have been valid.
    """
    names = ", ".join(known[:_MAX_KNOWN_SHOWN]) or "none"
    more = f" and {len(known) - _MAX_KNOWN_SHOWN} more" if len(known) > _MAX_KNOWN_SHOWN else ""
    return f"unknown {kind} {name[:_MAX_NAME_LENGTH]!r} (known: {names}{more})"
