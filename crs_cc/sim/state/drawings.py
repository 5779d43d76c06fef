"""What programs have drawn into the simulator's window."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import Int32Array, Int64Array


@dataclass(slots=True)
class DrawingState:
    """All that is in the picture, the later above the earlier.

    Attributes:
        marks: each as `drawings.Drawing.of` takes it, shape (marks, 8).
        robots: whose program drew it, (marks,).
    """

    marks: Int32Array
    robots: Int64Array

    @classmethod
    def at_start(cls) -> Self:
        """Return an empty picture."""
        return cls(np.zeros((0, 8), dtype=np.int32), np.zeros(0, dtype=np.int64))
