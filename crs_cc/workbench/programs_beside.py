"""The C programs in the folder of a world that is edited, from which its user chooses."""

from __future__ import annotations

import os
from itertools import islice
from pathlib import Path
from typing import Final

MAX_ENTRIES: Final = 2000
"""Files of a folder that are looked at."""

MAX_PROGRAMS: Final = 200


def programs_beside(world: Path | None) -> list[str]:
    """Return the names of the C files in the folder of a world, or in that where crs runs."""
    folder = Path() if world is None else world.parent
    try:
        with os.scandir(folder) as entries:
            names = [each.name for each in islice(entries, MAX_ENTRIES)]
    except OSError:
        return []
    return sorted(name for name in names if name.endswith(".c") and name.isprintable())[
        :MAX_PROGRAMS
    ]
