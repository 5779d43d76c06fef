"""Random errors of the next sensor measurements, drawn in advance for the kernel of calm time."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final, TypeAlias

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray, Int64Array

if TYPE_CHECKING:
    from crs_cc.sim.kernels.calm import CalmKernel

Draw: TypeAlias = Callable[[IndexArray, Int64Array], FloatArray]
"""Returns the deviates of measurements of some robots' sensors, by their numbers, (k, width)."""

_AHEAD: Final = 64  # measurements of each sensor
_UNKNOWN: Final = -(2**53)


class Draws:
    """The random errors of all sensors of one kind.

    Attributes:
        name: the name of the kind, see `kernels.calm`.
    """

    def __init__(self, name: str, robots: IndexArray, width: int, draw: Draw | None) -> None:
        """Draw nothing yet.

        Args:
            name: the name of the kind.
            robots: the robot of each sensor.
            width: deviates of each measurement.
            draw: draws them; None if there are no random errors.
        """
        self.name = name
        self._robots, self._width, self._draw = robots, width, draw

    @property
    def ahead(self) -> int:
        """The number of measurements of each sensor that are drawn at once."""
        return 0 if self._draw is None else _AHEAD

    def tables(self) -> dict[str, Any]:
        """Return the initial table of the kernel: no errors are known."""
        return {f"{self.name}_first": np.full(len(self._robots), _UNKNOWN)}

    def spaces(self) -> dict[str, int]:
        """Return the space for the deviates."""
        return {f"{self.name}_deviates": len(self._robots) * self.ahead * self._width}

    def renew(self, kernel: CalmKernel, counts: Int64Array) -> None:
        """Draw the errors of the next measurements, unless they are known.

        Args:
            kernel: has those that are known.
            counts: the number of the next measurement of each sensor.
        """
        if self._draw is None:
            return
        first = kernel.table(f"{self.name}_first", len(counts), np.int64)
        known = counts - first
        if ((known >= 0) & (known < _AHEAD)).all():
            return
        first[:] = counts
        numbers = (counts[:, None] + np.arange(_AHEAD)).reshape(-1)
        deviates = self._draw(np.repeat(self._robots, _AHEAD), numbers)
        kernel.table(f"{self.name}_deviates", deviates.size)[:] = deviates.reshape(-1)
