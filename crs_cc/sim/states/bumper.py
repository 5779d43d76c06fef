"""Which switches are pressed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np
import numpy.typing as npt

from crs_cc.sim.model import WorldModel


@dataclass(slots=True)
class BumperState:
    """The switches of all robots.

    Attributes:
        pressed: which are pressed, bit n for switch n, (robots,).
    """

    pressed: npt.NDArray[np.int32]

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Gives switches that nothing presses."""
        return cls(np.zeros(len(world.robots), dtype=np.int32))
