"""Opening the connections of a run to the real network, from its options."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from crs_cc.cli.real_network import RealNetwork
    from crs_cc.cli.run_options import RunOptions
    from crs_cc.debug.timeline.change import Change
    from crs_cc.session.session import Session


def open_real_network(
    session: Session, options: RunOptions, noted: Callable[[Change], None]
) -> RealNetwork | None:
    """Open the connections of a run to the real network, if it has any, see `RealNetwork`."""
    if not (options.machines or options.forwards):
        return None
    from crs_cc.cli.real_network import RealNetwork

    return RealNetwork(session, options.machines, options.forwards, noted)
