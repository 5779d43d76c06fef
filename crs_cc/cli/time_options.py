"""The options that limit the duration of a run: simulated and real time."""

from __future__ import annotations

import math
from typing import Final

import click


def _time(_ctx: click.Context, _option: click.Parameter, time_s: float | None) -> float | None:
    if time_s is not None and math.isnan(time_s):
        raise click.BadParameter("nan is not a valid time.")
    return time_s


def _speed(_ctx: click.Context, _option: click.Parameter, text: str) -> float:
    is_number = text.replace(".", "", 1).isdecimal() and len(text) < 10
    speed = math.inf if text == "max" else float(text) if is_number else 0.0
    if not speed >= 0.001:
        raise click.BadParameter(f"'{text}' is neither max nor a number of at least 0.001.")
    return speed


MAX_TIME: Final = click.option(
    "--max-time",
    "max_time_s",
    type=click.FloatRange(min=0, min_open=True),
    callback=_time,
    metavar="S",
    help="Stop at the first timestep that ends at or after S seconds of simulated time. "
    "Default: the world file's duration.",
)

SPEED: Final = click.option(
    "--speed",
    default="max",
    show_default=True,
    metavar="N|max",
    callback=_speed,
    help="Run at most N times as fast as real time; 1 is real time.",
)
