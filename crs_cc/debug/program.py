"""What the debugger needs of a program: how it runs, and what its source says."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from crs_cc.frontend.preprocess.options import Options
from crs_cc.runtime.executable import Executable


@dataclass(frozen=True, slots=True)
class DebugProgram:
    """A program of one robot or of several.

    Attributes:
        executable: its debug build.
        paths: its C files.
        options: what they were compiled with, so that expressions mean the same.
    """

    executable: Executable
    paths: Sequence[Path]
    options: Options
