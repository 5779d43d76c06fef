"""The options of `crs debug`, as data."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from crs_cc.cli.program_options import ProgramOptions


@dataclass(frozen=True, slots=True)
class DebugOptions(ProgramOptions):
    """What to debug, and how.

    Attributes:
        scripts: files of commands that are done first.
        commands: commands that are done behind them.
        batch: end when these are done.
        input: what the programs read from their standard input; None for what is typed.
        tui: show the full screen; None for on a terminal.
        dap: serve an editor instead: `stdio`, or the number of a port.
    """

    scripts: tuple[Path, ...] = ()
    commands: tuple[str, ...] = ()
    batch: bool = False
    input: Path | None = None
    tui: bool | None = None
    dap: str | None = None
