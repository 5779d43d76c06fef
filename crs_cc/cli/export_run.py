"""Exports of a recorded run: tables and an animation."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TypeVar

from crs_cc.cli.inputs import is_animation
from crs_cc.cli.run_options import RunOptions

Options = TypeVar("Options", bound=RunOptions)


def is_exported(options: RunOptions) -> bool:
    """Return whether anything is wanted for which a run must be recorded."""
    return options.tables is not None or (options.plot is not None and is_animation(options.plot))


@contextmanager
def with_recording(options: Options) -> Iterator[Options]:
    """Yield the options with a recording, which is removed at the end if it is only for exports."""
    if options.record is not None or not is_exported(options):
        yield options
        return
    import tempfile  # slow to import

    with tempfile.TemporaryDirectory(prefix="crs-run-") as folder:
        yield replace(options, record=Path(folder, "run.mcap"))


def export_run(options: RunOptions) -> None:
    """Write the tables and the animation of a run, from its recording.

    Raises:
        OSError: they cannot be written.
    """
    from crs_cc.recording.recording import Recording

    assert options.record is not None
    recording = Recording(options.record)
    try:
        if options.tables is not None:
            from crs_cc.cli.tables import write_tables

            write_tables(recording, options.tables)
        if options.plot is not None and is_animation(options.plot):
            from crs_cc.cli.animation import write_animation

            write_animation(recording, options.plot)
    finally:
        recording.close()
