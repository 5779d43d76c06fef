"""Clearance: the shortest distance between a robot and any other object."""

from __future__ import annotations

import math

import numpy as np

from crs_cc.core import segment
from crs_cc.core.arrays import FloatArray
from crs_cc.sim.geometry.scene import Outlines, Scene
from crs_cc.sim.kernels import exact


def clearance_m(scene: Scene, position_m: FloatArray, angle_rad: FloatArray) -> float:
    """Return the shortest distance between a robot and any other object [m].

    All pairs are tried, so it is meant for few bodies. Inside an object it is 0 or less, without a
    robot infinite.
    """
    moving = scene.moving(position_m, angle_rad)
    x_m, y_m, radii_m = moving.circles[: np.count_nonzero(scene.present), :, None].transpose(
        1, 0, 2
    )
    room = [
        _to_segments(x_m, y_m, np.concatenate([scene.fixed.segments, moving.segments])),
        _to_circles(x_m, y_m, scene.fixed),
        _to_others(x_m, y_m, moving),
    ]
    return float((np.concatenate(room, axis=1) - radii_m).min(initial=math.inf))


def _to_segments(x_m: FloatArray, y_m: FloatArray, segments: FloatArray) -> FloatArray:
    ax, ay, bx, by, _ = segments.T
    return segment.distance(x_m - ax, y_m - ay, bx - ax, by - ay)


def _to_circles(x_m: FloatArray, y_m: FloatArray, outlines: Outlines) -> FloatArray:
    x, y, radius = outlines.circles.T
    return np.asarray(exact.hypot(x_m - x, y_m - y) - radius)


def _to_others(x_m: FloatArray, y_m: FloatArray, moving: Outlines) -> FloatArray:
    distance = _to_circles(x_m, y_m, moving)
    robots = np.arange(len(x_m))
    distance[robots, robots] = math.inf
    return distance
