"""Run real C control programs of the Nomadic Scout in a simulated, shared world.

The public names: `compile_c` returns a program, `load_world` a world, `Session` runs programs in a
world, `Degradation` describes a device fault, and the error classes tell C, world and run-time
errors apart. README.md has an example.
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
    """Compile C files to a program; `crs check` shows the warnings.

    Args:
        paths: the C files.
        dialect: the API that they call, the vendor's (`nomad`) or that of the CRS report
            (`report`); by default it is detected.

    Raises:
        CompileError: the files are not a valid program.
    """
    from pathlib import Path

    from crs_cc.core.source import Diagnostics
    from crs_cc.session.build import build_executable

    return build_executable([Path(path) for path in paths], Diagnostics(), dialect=dialect)


def __getattr__(name: str) -> object:
    """Import a public name on first access: `import crs_cc` loads nothing heavy."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(_HOMES[name]), name)
