"""The options of `crs debug`, as data."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from crs_cc.cli.program_options import ProgramOptions
from crs_cc.cli.record_options import Sensors


@dataclass(frozen=True, slots=True)
class DebugOptions(ProgramOptions):
    """Options of `crs debug`: the program, the world, and how to debug.

    Attributes:
        scripts: files of commands to execute first.
        commands: commands to execute after them.
        batch: exit after these.
        input: the file of what is typed at simulated times; None for none.
        stdin: the programs' standard input; None for the terminal.
        tui: show the full-screen interface; None to decide by whether there is a terminal.
        record: the file to which the run is recorded when the debugger ends.
        record_every_s: simulated time between two recorded frames [s].
        record_sensors: which readings are recorded.
        foxglove: add messages by Foxglove's schemas.
        foxglove_robots: the robots whose scans and pictures are among them.
        at_s: the time to go to first, in a recording [s].
        max_time_s: stop at the first timestep that ends at or after it [s]; None for the world's.
        dap: serve an editor instead: `stdio` or a port number.
    """

    scripts: tuple[Path, ...] = ()
    commands: tuple[str, ...] = ()
    batch: bool = False
    input: Path | None = None
    stdin: Path | None = None
    tui: bool | None = None
    dap: str | None = None
    at_s: float | None = None
    max_time_s: float | None = None
    record: Path | None = None
    record_every_s: float = 0.05
    record_sensors: Sensors = "read"
    foxglove: bool = False
    foxglove_robots: tuple[str, ...] = ()
