"""A program in the debugger: its debug build and its source."""

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
        options: the options that they were compiled with, for expressions.
    """

    executable: Executable
    paths: Sequence[Path]
    options: Options

    @property
    def files(self) -> dict[str, Path]:
        """Return the C files by the names that messages and locations have."""
        return {self.options.name(path): path for path in self.paths}
