"""The options of `crs debug`, as data."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from crs_cc.cli.program_options import ProgramOptions


@dataclass(frozen=True, slots=True)
class DebugOptions(ProgramOptions):
    """Options of `crs debug`: the program, the world, and how to debug.

    Attributes:
        scripts: files of commands to execute first.
        commands: commands to execute after them.
        batch: exit after these.
        input: the programs' standard input; None for the terminal.
        tui: show the full-screen interface; None to decide by whether there is a terminal.
        at_s: the time to go to first, in a recording [s].
        dap: serve an editor instead: `stdio` or a port number.
    """

    scripts: tuple[Path, ...] = ()
    commands: tuple[str, ...] = ()
    batch: bool = False
    input: Path | None = None
    tui: bool | None = None
    dap: str | None = None
    at_s: float | None = None
