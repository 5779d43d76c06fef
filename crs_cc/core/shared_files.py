"""The locations of the samples, worlds and documentation pages.

In a checkout they are beside the package; a build copies them into it (`setup.py`).
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

from crs_cc.core.errors import InternalError
from crs_cc.core.source import Location

_PACKAGE: Final = Path(__file__).parents[1]
_PLACES: Final = (_PACKAGE / "share", _PACKAGE.parent)


def shared_folder(name: str) -> Path:
    """Return the folder `samples`, `worlds` or `docs`.

    Raises:
        InternalError: it was not installed.
    """
    for place in _PLACES:
        if (place / name).is_dir():
            return place / name
    missing = Location(str(_PLACES[0] / name))
    raise InternalError.at(missing, "the folder was not installed", "reinstall crs_cc")
