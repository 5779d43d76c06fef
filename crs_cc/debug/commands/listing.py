"""What `list` has shown."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Listing:
    """The lines that were shown last: a file, the first line and the last."""

    file: str
    first: int
    last: int
