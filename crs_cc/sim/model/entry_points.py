"""Fast lookup of entry points in installed packages.

`importlib.metadata` takes as long to import as numpy's half, and there is hardly ever an entry.
"""

from __future__ import annotations

import os
import sys
from importlib.machinery import PathFinder
from typing import Final

_METADATA: Final = (".dist-info", ".egg-info", ".egg")


def may_have_entries(group: str) -> bool:
    """Return whether `importlib.metadata` may find entry points of a group.

    False is certain: all packages are below folders of `sys.path`, and none names the group.
    """
    finders = (each for each in sys.meta_path if each is not PathFinder)
    if any(hasattr(finder, "find_distributions") for finder in finders):
        return True
    return any(_names(path or ".", group.encode()) for path in sys.path)


def _names(path: str, group: bytes) -> bool:
    """Return whether a package in a folder names a group; True for what is no folder."""
    try:
        with os.scandir(path) as entries:
            names = [each.name for each in entries if each.name.lower().endswith(_METADATA)]
    except FileNotFoundError:
        return False
    except OSError:  # an archive
        return True
    return any(name.lower().endswith(".egg") or group in _text(f"{path}/{name}") for name in names)


def _text(package: str) -> bytes:
    try:
        with open(f"{package}/entry_points.txt", "rb") as file:  # noqa: PTH123 - quicker
            return file.read()
    except OSError:  # most have none
        return b""
