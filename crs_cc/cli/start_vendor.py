"""Serve a world to programs that are linked with the vendor's client libraries."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from crs_cc.cli.inputs import Inputs
from crs_cc.cli.simulate import simulate
from crs_cc.net.vendor.relay import RELAY

if TYPE_CHECKING:
    from crs_cc.cli.run_options import RunOptions


def start_vendor(options: RunOptions) -> int:
    """Run a world whose robots such programs drive; return the exit status.

    Raises:
        CrsError: the world is not valid.
        OSError: a port is in use.
    """
    return simulate(replace(options, inputs=Inputs((RELAY,), options.inputs.world)))
