"""The body of a robot definition, which its devices must not exceed."""

from __future__ import annotations

import math
from typing import Final

from crs_cc.core.quantity import LENGTH
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.kernels import exact

_ROUNDING_M: Final = 1e-4  # resolution of the positions of sensors on the shell


def body_radius_m(root: Element, reader: Reader) -> float:
    """Return the radius of a definition's body; infinite if that was reported as invalid."""
    body = root.first("body")
    return math.inf if body.broken else reader.positive(body, "radius", LENGTH)


def is_outside(root: Element, x_m: float, y_m: float, reader: Reader) -> bool:
    """Return whether a position in the robot frame is outside of the body."""
    return exact.hypot(x_m, y_m) > body_radius_m(root, reader) + _ROUNDING_M
