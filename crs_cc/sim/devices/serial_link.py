"""The serial line between host and robot: transmission times of commands and replies.

A byte is ten bits on the line: a start bit, eight of data, a stop bit. The robot's definition has
the numbers of bytes of commands and replies; a command that is missing there takes no time.
Requests to the simulator only, and to devices of `crs.h`, use the network instead, with the same
time for all; so do all commands to a robot whose definition names none.
"""

from __future__ import annotations

from typing import Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, any_of
from crs_cc.requests import CODES, DATA_SIZE, DEVICE_CODES, REQUESTS
from crs_cc.sim.devices.request_context import RequestContext
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.env_state import EnvState
from crs_cc.sim.state.link import LinkState

_BITS_PER_BYTE: Final = 10
_SPEEDS_BAUD: Final = (4800, 9600, 19200, 38400)  # vendor source `Ndirect.c` 2.7
_CODES: Final = DEVICE_CODES.stop


class SerialLine:
    """The serial lines to all robots of a world."""

    def __init__(self, world: WorldModel) -> None:
        """Create the lines of a world's robots."""
        links = [robot.model.link for robot in world.robots]
        kinds = {link: kind for kind, link in enumerate(dict.fromkeys(links))}
        places = [kinds[link] * (_CODES + 1) for link in links]
        self._first = np.array(places, dtype=np.intp)  # of each robot's link
        # By kind of link and code; one additional code represents all others.
        shape = len(kinds), _CODES + 1
        byte_count, sends_data = np.zeros(shape, dtype=np.int64), np.zeros(shape, dtype=np.bool_)
        network_s = np.zeros(shape)
        for link, kind in kinds.items():
            counts = {CODES[name]: count for name, count in link.byte_counts}
            network_s[kind, DEVICE_CODES.start : DEVICE_CODES.stop] = link.network_s
            for code, row in REQUESTS.items():
                networked = row.link == "network" or (row.link == "serial" and not counts)
                network_s[kind, code] = link.network_s if networked else 0.0
                count = 0 if networked else counts.get(code, 0)
                byte_count[kind, code] = count
                sends_data[kind, code] = row.sends_data and count > 0
        self._network_s, self._bits = network_s.ravel(), byte_count.ravel() * _BITS_PER_BYTE
        self._sends_data = sends_data.ravel()

    def time_s(
        self, state: LinkState, codes: npt.ArrayLike, robots: npt.ArrayLike, sizes: npt.ArrayLike
    ) -> FloatArray:
        """Return the transmission time of requests and replies on the line or network [s].

        Args:
            state: has the lines' speeds.
            codes: the requests' codes.
            robots: their robots.
            sizes: bytes of their data.

        Returns:
            the times, in the broadcast shape of the three arguments.
        """
        robot = np.asarray(robots)
        codes = np.minimum(np.asarray(codes).astype(np.uint32), _CODES)
        place = self._first.take(robot) + codes
        bits, sends_data = self._bits.take(place), self._sends_data.take(place)
        if any_of(np.asarray(sends_data)):
            bits = bits + np.where(sends_data, np.clip(sizes, 0, DATA_SIZE) * _BITS_PER_BYTE, 0)
        return np.asarray(self._network_s.take(place) + bits / state.baud.take(robot))


def set_speed(state: EnvState, rows: IndexArray, baud: Int32Array) -> None:
    """Set the speed of lines; ignore a speed that no line has."""
    known = np.isin(baud, _SPEEDS_BAUD)
    state.link.baud[rows[known]] = baud[known]


def conf_ser(context: RequestContext) -> BoolArray:
    """Set the speed of the line for any port, as it is unknown which one is the host's."""
    baud = context["baud"]
    set_speed(context.state, context.rows, baud)
    return np.isin(baud, _SPEEDS_BAUD)
