"""Where all robots of the world really are: `get_rpx`.

The third number of each robot is its heading, as the vendor's header does not say; chosen by us.
Robots come in the order of the world file, and are where they were at the start of the timestep.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import IndexArray, Records
from crs_cc.core.units import m_to_tenths_inch, rad_to_tenths_deg
from crs_cc.requests import DATA_SIZE

if TYPE_CHECKING:
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


_TURN: Final = 3600
_ROW_BYTES: Final = 12
_PAGE: Final = DATA_SIZE // _ROW_BYTES


def get_rpx(
    state: EnvState, _constants: RobotConstants, _rows: IndexArray, messages: Records
) -> None:
    """Answers with the poses of up to twenty robots, from the one that is asked for on."""
    heading = np.rint(rad_to_tenths_deg(state.heading_rad)) % _TURN
    x, y = np.rint(m_to_tenths_inch(state.x_m)), np.rint(m_to_tenths_inch(state.y_m))
    poses = np.column_stack([x, y, heading]).astype("<i4")
    messages["result"] = len(poses)
    for message in messages:
        first = max(int(message["i"][0]), 0)
        page = poses[first : first + _PAGE].tobytes()
        message["size"] = len(page)
        message["data"][: len(page)] = np.frombuffer(page, dtype=np.uint8)
