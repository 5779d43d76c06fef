"""The robots that are built in."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Final

ROBOTS: Final = Path(__file__).parent / "robots"

SCOUT: Final = "scout"
"""The default kind of robot."""


@cache
def known_robots() -> tuple[str, ...]:
    """Return the names of the built-in robot definitions."""
    return tuple(sorted(path.stem for path in ROBOTS.glob("*.xml")))
