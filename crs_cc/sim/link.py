"""The serial line between host and robot: how long commands and replies are on their way.

A byte is ten bits on the line: a start bit, eight of data, a stop bit. How many bytes a command and
its reply have says the robot's definition; one that is not named there takes no time. What only a
simulator does, and what devices of `crs.h` do, goes over the network instead, which takes the same
time for all.
"""

from __future__ import annotations

from typing import Final

import numpy as np
import numpy.typing as npt

from crs_cc.requests import CODES, DATA_SIZE, REQUESTS
from crs_cc.sim.equipment import Equipment
from crs_cc.sim.model import WorldModel
from crs_cc.sim.state import EnvState
from crs_cc.sim.states.link import LinkState

IndexArray = npt.NDArray[np.intp]
Messages = npt.NDArray[np.void]

_BITS_PER_BYTE: Final = 10
_SPEEDS_BAUD: Final = (4800, 9600, 19200, 38400)  # vendor source `Ndirect.c` 2.7
_CARRIED: Final = frozenset({CODES["TK"], CODES["SPECIAL"]})  # their data goes over the line


_TO_SIMULATOR: Final = frozenset(
    CODES[name]
    for name in (
        "PLACE_ROBOT", "ADD_OBSTACLE", "DELETE_OBSTACLE", "MOVE_OBSTACLE", "NEW_WORLD", "GET_RPX",
        "PREDICT", "MOTION_CHECK", "GET_CONF", "REAL_ROBOT", "SIMULATED_ROBOT", "DRAW", "REFRESH",
        "QUIT_SERVER",
    )
)  # fmt: skip
_OVER_NETWORK: Final = _TO_SIMULATOR | {
    code for code, request in REQUESTS.items() if request.server == "device"
} - {CODES["READINGS"]}  # they came with the reply


class SerialLine:
    """The lines to all robots of a world."""

    def __init__(self, world: WorldModel) -> None:
        """Reads the definitions.

        Args:
            world: the world.
        """
        self._byte_counts = [
            {CODES[name]: count for name, count in robot.model.link.byte_counts}
            for robot in world.robots
        ]
        self._network_s = [robot.model.link.network_s for robot in world.robots]

    def time_s(self, state: LinkState, code: int, robot: int, size: int) -> float:
        """Gives how long a request and its reply are on the line, or on the network [s].

        Args:
            state: the speeds.
            code: the request's code.
            robot: whose it is.
            size: bytes of its data.
        """
        if code in _OVER_NETWORK:
            return self._network_s[robot]
        count = self._byte_counts[robot].get(code, 0)
        if count and code in _CARRIED:
            count += min(max(size, 0), DATA_SIZE)
        return count * _BITS_PER_BYTE / int(state.baud[robot])


def set_speed(state: EnvState, rows: IndexArray, baud: npt.NDArray[np.int32]) -> None:
    """Sets the speed of lines; a speed that no line has changes nothing."""
    known = np.isin(baud, _SPEEDS_BAUD)
    state.link.baud[rows[known]] = baud[known]


def conf_ser(
    state: EnvState, _equipment: Equipment, rows: IndexArray, messages: Messages
) -> npt.NDArray[np.bool_]:
    """Sets the speed of the line, whatever the port: which one is the host's, nothing tells."""
    baud = messages["i"][:, 1].copy()
    set_speed(state, rows, baud)
    return np.isin(baud, _SPEEDS_BAUD)
