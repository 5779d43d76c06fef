"""Robots that wait for the end of a request."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int64Array, Records
from crs_cc.requests import MESSAGE
from crs_cc.sim.model.axis import AXES
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class WaitState:
    """The waits; arrays have a row for each robot.

    Attributes:
        code: the code of the request that the robot waits for, 0 for none.
        asked: its message, of dtype `MESSAGE`, zero for none.
        until_s: timeout of the wait, infinite for never; valid during the wait.
        axes: the axes that must come to rest, (robots, 3).
    """

    code: Int64Array
    asked: Records
    until_s: FloatArray
    axes: BoolArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return robots that do not wait."""
        count = len(world.robots)
        return cls(
            np.zeros(count, dtype=np.int64),
            np.zeros(count, MESSAGE),
            np.full(count, np.inf),
            np.zeros((count, AXES), dtype=np.bool_),
        )

    def begin(self, code: int, rows: IndexArray, messages: Records) -> None:
        """Start the wait of robots for their requests."""
        self.code[rows], self.asked[rows] = code, messages

    def end(self, rows: IndexArray) -> None:
        """End the wait of robots."""
        self.code[rows], self.asked[rows] = 0, np.zeros((), MESSAGE)
        self.axes[rows] = False
