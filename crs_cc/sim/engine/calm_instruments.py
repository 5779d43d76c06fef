"""Infrared rings and compasses in calm time: the exchange of their data with the kernel.

They measure when a reply contains their readings: if the request is about them, or is for all of
`State`, and the program's mask selects them. See `kernels/instruments.c`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import FloatArray, Records
from crs_cc.requests import CODES as CODE_OF
from crs_cc.requests import REQUESTS
from crs_cc.requests.request import ALL_SENSORS
from crs_cc.sim.devices.compass import Compasses
from crs_cc.sim.devices.infrared import MAX_INFRARED, InfraredRing
from crs_cc.sim.devices.sensor_board import GROUPS, selects
from crs_cc.sim.kernels.calm import CODES
from crs_cc.sim.kernels.draws import Draws
from crs_cc.sim.kernels.tables import COMPASS, RING
from crs_cc.sim.model import registry

if TYPE_CHECKING:
    from crs_cc.sim.engine.world_data import WorldData
    from crs_cc.sim.kernels.calm import CalmKernel

_RINGS, _COMPASSES, _MASKED = 1, 2, 4  # what requests make measure, as in `calm.h`
_NUMBER: Final = 8  # bytes


class _Kind:
    """One kind of instruments, which some robots have.

    Attributes:
        name: the name of the device.
        draws: the random errors; their name is that in the kernel's tables.
    """

    def __init__(
        self,
        data: WorldData,
        name: str,
        table: tuple[str, npt.DTypeLike],
        instruments: InfraredRing | Compasses,
        draws: tuple[str, int],
    ) -> None:
        self.name, self._data = name, data
        self._table, self._type = table[0], np.dtype(table[1])
        self._instruments = instruments
        self._robots = np.flatnonzero(data.constants.numbers[name] >= 0)
        draw = instruments.draw if instruments.is_noisy else None
        self.draws = Draws(draws[0], self._robots, draws[1], draw)

    def __bool__(self) -> bool:
        """Return whether any robot has one."""
        return bool(len(self._robots))

    def tables(self) -> dict[str, npt.NDArray[Any]]:
        """Return the tables of what does not change in calm time."""
        numbers = self._data.constants.numbers[self.name].astype(np.int64)
        return {f"{self.draws.name}_of": numbers, **self.draws.tables()}

    def spaces(self) -> dict[str, int]:
        """Return the spaces for what changes."""
        size = len(self._robots) * self._type.itemsize // _NUMBER
        return {self._table: size, **self.draws.spaces()}

    def enter(self, kernel: CalmKernel) -> None:
        """Copy the last measurements, and the data on which the next ones depend."""
        state, number = self._data.state, registry.device(self.name).number
        assert number is not None
        table = self._instruments.table(state)
        table["on_request"] = state.timers.on_request(self._robots, number)
        table["masked"] = selects(state, self._robots, GROUPS[self.name])
        self._view(kernel)[:] = table

    def renew(self, kernel: CalmKernel) -> None:
        """Draw the errors of the next measurements, where these are not known."""
        if self.draws.ahead:
            self.draws.renew(kernel, self._view(kernel)["count"])

    def leave(self, kernel: CalmKernel) -> None:
        """Copy back what has been measured."""
        self._instruments.load_measurements(self._data.state, self._view(kernel))

    def _view(self, kernel: CalmKernel) -> Records:
        found: Records = kernel.table(self._table, len(self._robots), self._type)
        return found


class CalmInstruments:
    """The instruments of a world's robots.

    Attributes:
        names: the names of those that any robot has.
    """

    def __init__(self, data: WorldData) -> None:
        """Find them.

        Args:
            data: the world.
        """
        board = data.devices.sensor_board
        self._data, self._fans = data, [fan.table for fan in board.infrared.fans]
        self._kinds = (
            _Kind(data, "infrared", ("rings", RING), board.infrared, ("ring", MAX_INFRARED)),
            _Kind(data, "compass", ("compasses", COMPASS), board.compasses, ("compass", 1)),
        )
        self._used = [kind for kind in self._kinds if kind]
        self.names = tuple(kind.name for kind in self._used)

    @property
    def are_simple(self) -> bool:
        """Whether kernels know all that they measure."""
        return self._data.devices.sensor_board.infrared.is_simple(self._data.rays)

    def tables(self) -> dict[str, npt.NDArray[Any]]:
        """Return the tables of what does not change in calm time."""
        found = {"measures": _measures(), "fans": np.concatenate([np.zeros(0), *self._fans])}
        for kind in self._kinds:
            found |= kind.tables()
        return found

    def spaces(self) -> dict[str, int]:
        """Return the spaces for what changes."""
        return {name: size for kind in self._kinds for name, size in kind.spaces().items()}

    def draws(self) -> dict[str, int]:
        """Return the number of measurements of each kind with known errors, for the kernel."""
        return {f"{kind.draws.name}_draws": kind.draws.ahead for kind in self._kinds}

    def enter(self, kernel: CalmKernel) -> None:
        """Copy the last measurements, and the data on which the next ones depend."""
        for kind in self._used:
            kind.enter(kernel)

    def renew(self, kernel: CalmKernel) -> None:
        """Draw the errors of the next measurements, where these are not known."""
        for kind in self._used:
            kind.renew(kernel)

    def leave(self, kernel: CalmKernel) -> None:
        """Copy back what has been measured."""
        for kind in self._used:
            kind.leave(kernel)


def _measures() -> FloatArray:
    """Return which instruments each request makes measure, by its code."""
    found = np.zeros(CODES)
    for code, request in REQUESTS.items():
        if code < CODES and request.sensors == ALL_SENSORS:
            found[code] = _MASKED
    found[CODE_OF["GET_IR"]], found[CODE_OF["GET_CP"]] = _RINGS, _COMPASSES
    return found
