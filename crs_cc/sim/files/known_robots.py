"""The robots that are built in."""

from __future__ import annotations

from pathlib import Path
from typing import Final

ROBOTS: Final = Path(__file__).parent / "robots"

SCOUT: Final = "scout"
"""The default kind of robot."""


def known_robots() -> list[str]:
    """Return the names of the built-in robot definitions."""
    return sorted(path.stem for path in ROBOTS.glob("*.xml"))
