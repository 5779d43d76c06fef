"""The options of `crs serve` that place hosts on a Dask cluster."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

import click

_OPTIONS: Final = (
    click.option(
        "--hosts", default="", metavar="ADDRESS",
        help="Run the programs, named before the world or in it, on the Dask cluster with this "
        "scheduler, such as dask://hall:8786 (extra 'cluster'). Lost hosts are restarted. See "
        "docs/cluster.md.",
    ),
    click.option(
        "--per-host", type=click.IntRange(1, 100_000), metavar="N",
        help="Assign N robots to each host on the cluster. Default: one host per thread of its "
        "workers.",
    ),
)  # fmt: skip


def cluster_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add these options to a command, which receives `hosts` and `per_host`."""
    for option in reversed(_OPTIONS):
        command = option(command)
    return command
