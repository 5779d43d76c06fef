"""Instants on the command line."""

from __future__ import annotations

import click


def parse_time(_ctx: click.Context, _option: click.Parameter, text: str | None) -> float | None:
    """Return the seconds of `12.5s`, `300ms`, or a number of seconds.

    Raises:
        click.BadParameter: it is none of these.
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
