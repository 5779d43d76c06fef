"""Runs real C control programs of the Nomadic Scout in a simulated, shared world.

The public names: `compile_c` makes a program, `load_world` a world, `Session` runs programs in a
world, a `Degradation` says what goes wrong with a device, and the errors say who is to blame.
README.md shows how they go together.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from pathlib import Path

    from crs_cc.core.errors import CompileError, CrsError, InternalError, ProgramError, WorldError
    from crs_cc.frontend.preprocess.options import Dialect
    from crs_cc.runtime.executable import Executable
    from crs_cc.session.session import Session
    from crs_cc.sim.files.world_xml import load_world
    from crs_cc.sim.model.degradation import Degradation

__version__ = "0.1.0"

__all__ = [
    "CompileError",
    "CrsError",
    "Degradation",
    "InternalError",
    "ProgramError",
    "Session",
    "WorldError",
    "compile_c",
    "load_world",
]

_HOMES: Final = {
    "Degradation": "crs_cc.sim.model.degradation",
    "Session": "crs_cc.session.session",
    "load_world": "crs_cc.sim.files.world_xml",
    **dict.fromkeys(
        ("CompileError", "CrsError", "InternalError", "ProgramError", "WorldError"),
        "crs_cc.core.errors",
    ),
}


def compile_c(*paths: str | Path, dialect: Dialect | None = None) -> Executable:
    """Gives the program made of some C files; warnings are what `crs check` shows.

    Args:
        paths: the C files.
        dialect: whose functions they call, the vendor's (`nomad`) or those of the CRS report
            (`report`); by default what they look like.

    Raises:
        CompileError: the files do not make a program.
    """
    from pathlib import Path

    from crs_cc.core.source import Diagnostics
    from crs_cc.session.build import build_executable

    return build_executable([Path(path) for path in paths], Diagnostics(), dialect=dialect)


def __getattr__(name: str) -> object:
    """Imports a public name when it is first asked for: `import crs_cc` loads nothing heavy."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(_HOMES[name]), name)
