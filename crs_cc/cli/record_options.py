"""The options that ask for a recording."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, Final, Literal

import click

Sensors = Literal["none", "read", "all"]

_MIN_PERIOD_S: Final = 1e-3


def _interval(_ctx: click.Context, _option: click.Parameter, text: str) -> float:
    from crs_cc.core.quantity import TIME  # not needed for help

    try:
        interval_s = TIME.parse(text)
    except ValueError as wrong:
        raise click.BadParameter(f"{wrong}.") from None
    if not _MIN_PERIOD_S <= interval_s <= 3600.0:
        raise click.BadParameter(f"'{text}' is not between 1 ms and 1 h.")
    return interval_s


_OPTIONS: Final = (
    click.option(
        "--record", type=click.Path(dir_okay=False, path_type=Path), metavar="FILE.mcap",
        help="Record the run, for crs replay and crs debug.",
    ),
    click.option(
        "--record-every", "record_every_s", default="50ms", show_default=True, metavar="TIME",
        callback=_interval, help="Simulated time between two recorded frames.",
    ),
    click.option(
        "--record-sensors", type=click.Choice(["none", "read", "all"]), default="read",
        show_default=True,
        help="Sensor readings to record: none, those that programs read, or all of them in every "
        "frame.",
    ),
    click.option(
        "--foxglove", is_flag=True,
        help="Also record scenes and logs, using the Foxglove schemas.",
    ),
    click.option(
        "--foxglove-robot", "foxglove_robots", multiple=True, metavar="NAME",
        help="Also record this robot's laser scans and camera images for Foxglove; may be "
        "repeated.",
    ),
)  # fmt: skip


def record_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add these options to a command."""
    for option in reversed(_OPTIONS):
        command = option(command)
    return command
