"""The options of `crs run`, as data."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from pathlib import Path

from crs_cc.cli.network_options import Forward, ReachableMachine
from crs_cc.cli.program_options import ProgramOptions
from crs_cc.cli.record_options import Sensors
from crs_cc.cli.vendor_options import VendorOptions


@dataclass(frozen=True, slots=True)
class RunOptions(ProgramOptions):
    """Options of `crs run`: the program, the world, and what to show.

    Attributes:
        max_time_s: stop at the first timestep that ends at or after it [s]; None for the world's,
            else no end.
        input: the file of what is typed at simulated times; None for our standard input.
        changes: the file of what is changed at simulated times; None for nothing.
        plot: the SVG file of the plot.
        plot_sensors: whether the plot shows the last sensor readings.
        trace: what to show of each timestep: `requests`, the request queue, or `messages`.
        as_json: write the results to stdout as JSON.
        threads: how many threads may run programs; None for as many as there are processors.
        record: the file of the recording.
        tables: the folder for tables of the run.
        speed: the highest multiple of real time; infinite for as fast as possible.
        machines: the computers of the real network that programs can reach.
        forwards: the ports of this machine that lead to robots.
        live: draw a map on the terminal while the programs run.
        view: the port on which a browser is shown the run, 0 for any; None for none.
        record_every_s: simulated time between two recorded frames [s].
        record_sensors: which readings are recorded: `none`, those that programs `read`, or `all`.
        foxglove: add messages by Foxglove's schemas.
        foxglove_robots: the robots whose scans and pictures are among them.
        vendor: which programs outside drive robots.
        summary: show the summary; None to decide by whether stderr is a terminal.
    """

    max_time_s: float | None = None
    input: Path | None = None
    changes: Path | None = None
    plot: Path | None = None
    plot_sensors: bool = False
    trace: str | None = None
    as_json: bool = False
    threads: int | None = None
    summary: bool | None = None
    record: Path | None = None
    record_every_s: float = 0.05
    tables: Path | None = None
    speed: float = math.inf
    machines: tuple[ReachableMachine, ...] = ()
    forwards: tuple[Forward, ...] = ()
    live: bool = False
    view: int | None = None
    record_sensors: Sensors = "read"
    foxglove: bool = False
    foxglove_robots: tuple[str, ...] = ()
    vendor: VendorOptions = field(default_factory=VendorOptions)
