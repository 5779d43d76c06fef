"""The public Python interface: worlds, programs, sessions, and robots steered from Python.

`crs_cc` exports it, and so does this package; each name is imported on first use. docs/python.md
describes them. Values are in SI units and radians, in the world's frame unless noted otherwise.

>>> from crs_cc.api import Session, load_world
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import crs_cc
from crs_cc import __all__ as __all__

if TYPE_CHECKING:
    from crs_cc import *  # noqa: F403 - what is public is listed there
else:

    def __getattr__(name: str) -> object:
        """Return a public name."""
        return getattr(crs_cc, name)
