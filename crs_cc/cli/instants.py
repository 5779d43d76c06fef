"""Times on the command line."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from crs_cc.recording.recording import Recording


def parse_time(_ctx: click.Context, _option: click.Parameter, text: str | None) -> float | None:
    """Return the seconds of `12.5s`, `300ms`, or a number of seconds.

    Raises:
        click.BadParameter: it is not one of these.
    """
    if text is None:
        return None
    from crs_cc.core.quantity import TIME  # not needed for help

    if text.replace(".", "", 1).isdecimal() and len(text) < 20:
        return float(text)
    try:
        time_s = TIME.parse(text)
    except ValueError as wrong:
        raise click.BadParameter(f"{wrong}.") from None
    if time_s < 0.0:
        raise click.BadParameter(f"'{text}' is before the start.")
    return time_s


def recorded_instant(recording: Recording, time_s: float) -> float:
    """Return a time of a recording: its end, and a note, for a time after it."""
    from crs_cc.cli.messages import show
    from crs_cc.core.source import Diagnostic, Location
    from crs_cc.core.time_grid import ROUNDING_S

    end_s = recording.end_ns / 1e9
    if time_s <= end_s + ROUNDING_S:
        return time_s
    text = f"the recording ends at {end_s:g} s, before {time_s:g} s: this is its end"
    show([Diagnostic("note", Location(str(recording.path)), text)])
    return end_s
