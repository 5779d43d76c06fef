"""Bumper switches, and the time of the last contact."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Self

import numpy as np

from crs_cc.core.arrays import Int32Array
from crs_cc.sim.state.last_measurement import LastMeasurement

if TYPE_CHECKING:
    from crs_cc.sim.state.env_state import EnvState


@dataclass(slots=True)
class BumperState:
    """The switches of all robots.

    Attributes:
        pressed: the pressed ones, as bits as in `State[33]`, (robots,).
        hit: the last time at which another switch was pressed.
    """

    pressed: Int32Array
    hit: LastMeasurement

    @classmethod
    def released(cls, count: int) -> Self:
        """Return the released switches of a number of robots."""
        return cls(np.zeros(count, dtype=np.int32), LastMeasurement.never(count))


def bumper_state(state: EnvState) -> BumperState:
    """Return the bumpers' part of the state."""
    return state.device("bumper", BumperState)
