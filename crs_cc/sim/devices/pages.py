"""Pages of readings that do not fit into one reply, which programs request with READINGS."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import BoolArray
from crs_cc.sim.model.registry import devices

if TYPE_CHECKING:
    from crs_cc.sim.devices.installed import Installed
    from crs_cc.sim.devices.request_context import RequestContext


def page(context: RequestContext, *, installed: Mapping[str, Installed]) -> BoolArray:
    """Answer READINGS with a page of what an earlier reply announced; refuse other sensors."""
    sensor, first = context["sensor"].copy(), context["first"].copy()
    good = np.zeros(len(context), dtype=np.bool_)
    for row in devices():
        announced = installed[row.name].announced
        if announced is None:
            continue
        mine = context.constants.numbers[row.name][context.rows]
        places = np.flatnonzero((sensor == row.number) & (mine >= 0))
        if len(places):
            reply = announced(context.state)
            reply.page(mine[places], first[places], context.messages, places)
            good[places] = True
    return good
