"""Sources of items and nests: round places on the floor that robots carry items between."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

MAX_PLACES: Final = 1000
"""Largest number of sources, and of nests, in a world; our choice."""

MAX_ITEMS: Final = 1_000_000_000
"""Largest number of items in a source with a limit; our choice."""

NEVER_S: Final = math.inf
"""Time for a new item in a source that is not refilled."""


@dataclass(frozen=True, slots=True)
class Source:
    """A place where robots take items.

    Attributes:
        id: its name.
        x_m: its centre.
        y_m: its centre.
        radius_m: a robot takes items while its centre is within this distance.
        items: the items at the start, which are the most that it holds; None for unlimited.
        refill_s: time after which a new item appears while there are fewer.
    """

    id: str
    x_m: float
    y_m: float
    radius_m: float = 0.3
    items: int | None = None
    refill_s: float = NEVER_S


@dataclass(frozen=True, slots=True)
class Nest:
    """A place where robots drop items; the attributes are those of a source."""

    id: str
    x_m: float
    y_m: float
    radius_m: float = 0.3
