"""Drawings of programs in the simulator's window."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import Int32Array, Int64Array


@dataclass(slots=True)
class DrawingState:
    """All drawings, later ones on top.

    Attributes:
        marks: each in the form of `engine.drawings.Drawing.of`, shape (marks, 8).
        robots: the robot whose program drew it, (marks,).
    """

    marks: Int32Array
    robots: Int64Array

    @classmethod
    def at_start(cls) -> Self:
        """Return an empty picture."""
        return cls(np.zeros((0, 8), dtype=np.int32), np.zeros(0, dtype=np.int64))
