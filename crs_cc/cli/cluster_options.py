"""The options of `crs serve` that place hosts on a Dask cluster."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

import click

_OPTIONS: Final = (
    click.option(
        "--hosts", default="", metavar="ADDRESS",
        help="Run the programs on the Dask cluster with this scheduler, such as dask://hall:8786 "
        "(requires the 'cluster' extra). Give the programs before the world file, or name them "
        "in it. Lost hosts are restarted. See docs/cluster.md.",
    ),
    click.option(
        "--per-host", type=click.IntRange(1, 100_000), metavar="N",
        help="Assign N robots to each host on the cluster. Default: divide the robots among "
        "as many hosts as the cluster has worker threads.",
    ),
)  # fmt: skip


def cluster_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add these options to a command, which receives `hosts` and `per_host`."""
    for option in reversed(_OPTIONS):
        command = option(command)
    return command
