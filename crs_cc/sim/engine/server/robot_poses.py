"""The true poses of all robots of the world: `get_rpx`.

The third number of each robot is its heading: chosen by us, as the vendor's header does not say.
Robots come in the order of the world file, and are where they were at the start of the timestep.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.units import m_to_tenths_inch, rad_to_tenths_deg
from crs_cc.requests import DATA_SIZE

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext


_TURN: Final = 3600
_ROW_BYTES: Final = 12
_PAGE: Final = DATA_SIZE // _ROW_BYTES


def get_rpx(context: RequestContext) -> None:
    """Answer GET_RPX with the poses of up to twenty robots, starting with the requested one."""
    state = context.state
    heading = np.rint(rad_to_tenths_deg(state.heading_rad)) % _TURN
    x, y = np.rint(m_to_tenths_inch(state.x_m)), np.rint(m_to_tenths_inch(state.y_m))
    poses = np.column_stack([x, y, heading])
    context["robots"] = len(poses)
    for place, number in enumerate(context["first"].tolist()):
        first = max(number, 0)
        context.put_data(poses[first : first + _PAGE].ravel(), place)
