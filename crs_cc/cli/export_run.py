"""What is made of a run from its recording: tables and an animation."""

from __future__ import annotations

from typing import TYPE_CHECKING

from crs_cc.cli.inputs import is_animation

if TYPE_CHECKING:
    from crs_cc.cli.run_options import RunOptions


def is_exported(options: RunOptions) -> bool:
    """Return whether anything is wanted for which a run must be recorded."""
    return options.tables is not None or (options.plot is not None and is_animation(options.plot))


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
