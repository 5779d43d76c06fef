"""What sonars told last."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np
import numpy.typing as npt

from crs_cc.sim.model import WorldModel
from crs_cc.sim.robot_elements import MAX_SONARS

BoolArray = npt.NDArray[np.bool_]

NO_ECHO: Final = 255
"""A sonar's reading in inches when it hears nothing, the largest that the byte on the line holds
(vendor source `Ndirect.c` 2.7)."""


@dataclass(slots=True)
class SonarState:
    """What the sonars of all robots told last.

    Attributes:
        on: the sonars in the firing order, (robots, 16).
        reading_in: what each told last [in], (robots, 16).
        echo_m: how far away its last echo came from [m], infinite for none, (robots, 16).
        cycle: the cycle of these readings, -1 before the first, (robots,).
        count: how many readings were taken, (robots,).
    """

    on: BoolArray
    reading_in: npt.NDArray[np.int32]
    echo_m: npt.NDArray[np.float64]
    cycle: npt.NDArray[np.int64]
    count: npt.NDArray[np.int64]

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Gives sonars that have not fired yet."""
        count = len(world.robots)
        on = np.zeros((count, MAX_SONARS), dtype=np.bool_)
        for row, robot in zip(on, world.robots, strict=True):
            row[list(robot.model.sonar_order)] = True
        return cls(
            on,
            np.full((count, MAX_SONARS), NO_ECHO, dtype=np.int32),
            np.full((count, MAX_SONARS), np.inf),
            np.full(count, -1, dtype=np.int64),
            np.zeros(count, dtype=np.int64),
        )
