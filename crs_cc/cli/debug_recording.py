"""`crs debug run.mcap`: debug a recorded run, with its own files and input."""

from __future__ import annotations

from dataclasses import replace

import click

from crs_cc.cli.debug_options import DebugOptions
from crs_cc.cli.instants import recorded_instant
from crs_cc.cli.recorded_run import RecordedRunCheck
from crs_cc.cli.rerun import extracted_run
from crs_cc.cli.start_debugger import debug_programs
from crs_cc.recording.recording import Recording


def debug_recording(options: DebugOptions) -> int:
    """Debug the run in a recording, and return the exit status.

    Raises:
        CrsError: the recording is not valid.
        click.UsageError: other programs or worlds are named, too.
        OSError: the recording cannot be read.
    """
    if len(options.inputs.sources) != 1 or options.inputs.world is not None or options.arguments:
        raise click.UsageError("a recording is debugged alone: it has its own programs and world.")
    recording = Recording(options.inputs.sources[0])
    try:
        check = RecordedRunCheck(recording)
        go: tuple[str, ...] = ()
        if options.at_s is not None:
            go = (f"goto {recorded_instant(recording, options.at_s)!r}",)
        with extracted_run(recording, DebugOptions) as recorded:
            wanted = replace(
                recorded,
                scripts=options.scripts,
                commands=(*go, *options.commands),
                batch=options.batch,
                tui=options.tui,
                outputs=options.outputs,
                record=options.record,
                record_every_s=options.record_every_s,
                record_sensors=options.record_sensors,
                foxglove=options.foxglove,
                foxglove_robots=options.foxglove_robots,
            )
            return debug_programs(wanted, check)
    finally:
        recording.close()
