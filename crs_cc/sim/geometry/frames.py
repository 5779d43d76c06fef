"""Transforms of poses between frames: rows of x [m], y [m] and direction [rad].

>>> desk, cup = np.array([[2.0, 1.0, math.pi / 2]]), np.array([[1.0, 0.0, 0.0]])
>>> compose(desk, cup).round(3).tolist()                    # the cup in the room
[[2.0, 2.0, 1.571]]
>>> relative(desk, compose(desk, cup)).round(3).tolist()    # the cup on the desk
[[1.0, 0.0, 0.0]]
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.kernels import exact

_TURN: Final = 2 * math.pi


def compose(frames: FloatArray, poses: FloatArray) -> FloatArray:
    """Transform poses from frames to the frame in which these are given, all (k, 3)."""
    cos, sin = exact.cos(frames[:, 2]), exact.sin(frames[:, 2])
    return np.column_stack([
        frames[:, 0] + (cos * poses[:, 0] - sin * poses[:, 1]),
        frames[:, 1] + (sin * poses[:, 0] + cos * poses[:, 1]),
        frames[:, 2] + poses[:, 2],
    ])  # fmt: skip


def relative(frames: FloatArray, poses: FloatArray) -> FloatArray:
    """Transform poses to frames, with directions between -pi and pi, all (k, 3)."""
    x_m, y_m = poses[:, 0] - frames[:, 0], poses[:, 1] - frames[:, 1]
    cos, sin = exact.cos(frames[:, 2]), exact.sin(frames[:, 2])
    return np.column_stack([
        cos * x_m + sin * y_m, cos * y_m - sin * x_m, wrapped(poses[:, 2] - frames[:, 2])
    ])  # fmt: skip


def wrapped(angle_rad: FloatArray) -> FloatArray:
    """Return angles [rad] wrapped to -pi to pi."""
    return np.asarray((angle_rad + math.pi) % _TURN - math.pi)
