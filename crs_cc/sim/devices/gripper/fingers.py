"""The objects between the fingers of grippers, and their widths there.

The fingers span a strip of the floor, from the palm to their tips. The part of an object in the
strip is bounded by its sides, clipped to the strip, and, if it is round, by an arc: so the lowest
and the highest y of these bound the object's width between the fingers.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.geometry.cell_list import CellList
from crs_cc.sim.geometry.frames import relative
from crs_cc.sim.geometry.scene import Outlines

_Parts: TypeAlias = tuple[IndexArray, IndexArray, FloatArray, FloatArray, FloatArray]
"""Gripper, object, lowest and highest y, lowest x [m] of parts of outlines."""


@dataclass(frozen=True, slots=True)
class Between:
    """Objects between fingers, a row for each gripper and object, in ascending order of both.

    Attributes:
        object: the object, as in `Scene.names`.
        right_m: y of its right side in the gripper's frame; mostly negative.
        left_m: y of its left side.
        near_m: x of its nearest point between the fingers, from the mount's centre.
    """

    gripper: IndexArray
    object: IndexArray
    right_m: FloatArray
    left_m: FloatArray
    near_m: FloatArray

    @property
    def width_m(self) -> FloatArray:
        """Return the objects' widths between the fingers."""
        return self.left_m - self.right_m


def between(moving: Outlines, robots: int, mounts: FloatArray, strip_m: FloatArray) -> Between:
    """Return the pushable objects between the fingers of grippers, of any width.

    Args:
        moving: the outlines of the bodies.
        robots: number of robots, which are ignored.
        mounts: x, y [m] and direction [rad] of the grippers' mounts, (k, 3).
        strip_m: x of palm and tips, from the mount's centre, (k, 2).
    """
    rows = [_sides(moving, mounts, strip_m), _circles(moving, robots, mounts, strip_m)]
    gripper, obj, right_m, left_m, near_m = map(np.concatenate, zip(*rows, strict=True))
    objects = int(obj.max(initial=0)) + 1
    keys, place = np.unique(gripper * objects + obj, return_inverse=True)
    low, high, near = (np.full(len(keys), end) for end in (np.inf, -np.inf, np.inf))
    np.minimum.at(low, place, right_m)
    np.maximum.at(high, place, left_m)
    np.minimum.at(near, place, near_m)
    return Between(keys // objects, keys % objects, low, high, near)


def _sides(moving: Outlines, mounts: FloatArray, strip_m: FloatArray) -> _Parts:
    """Return the parts of sides in the strips."""
    sides = moving.segments
    middle_m = (sides[:, 0:2] + sides[:, 2:4]) / 2
    reach_m = float(strip_m[:, 1].max(initial=0.0) + sides[:, 4].max(initial=0.0) / 2)
    gripper, side = _pairs(middle_m, reach_m, mounts)
    start, end = (_seen(sides[side, each : each + 2], mounts[gripper]) for each in (0, 2))
    along_m = end[:, 0] - start[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        cuts = (strip_m[gripper] - start[:, [0]]) / along_m[:, None]
    low, high = cuts.min(axis=1), cuts.max(axis=1)
    across = along_m == 0.0  # parallel to the y axis: inside as a whole, or not at all
    inside = (start[:, 0] >= strip_m[gripper, 0]) & (start[:, 0] <= strip_m[gripper, 1])
    low = np.where(across, np.where(inside, 0.0, 2.0), np.maximum(low, 0.0))
    high = np.where(across, 1.0, np.minimum(high, 1.0))
    keep = np.flatnonzero(low <= high)
    first = start[keep] + low[keep, None] * (end - start)[keep]
    last = start[keep] + high[keep, None] * (end - start)[keep]
    y_m, x_m = np.stack([first[:, 1], last[:, 1]]), np.stack([first[:, 0], last[:, 0]])
    obj = moving.segment_owners[side[keep]]
    return gripper[keep], obj, y_m.min(axis=0), y_m.max(axis=0), x_m.min(axis=0)


def _circles(moving: Outlines, robots: int, mounts: FloatArray, strip_m: FloatArray) -> _Parts:
    """Return the parts of round objects in the strips."""
    round_ones = np.flatnonzero(moving.owners >= robots)
    circles = moving.circles[round_ones]
    reach_m = float(strip_m[:, 1].max(initial=0.0) + circles[:, 2].max(initial=0.0))
    gripper, which = _pairs(circles[:, :2], reach_m, mounts)
    middle, radius_m = _seen(circles[which, :2], mounts[gripper]), circles[which, 2]
    near_m, far_m = strip_m[gripper].T
    widest_m = np.minimum(np.maximum(middle[:, 0], near_m), far_m)
    half2 = np.square(radius_m) - np.square(widest_m - middle[:, 0])
    keep = np.flatnonzero(half2 >= 0.0)
    half_m, y_m = np.sqrt(half2[keep]), middle[keep, 1]
    x_m = np.maximum(middle[keep, 0] - radius_m[keep], near_m[keep])
    obj = moving.owners[round_ones[which[keep]]]
    return gripper[keep], obj, y_m - half_m, y_m + half_m, x_m


def _pairs(
    points_m: FloatArray, reach_m: float, mounts: FloatArray
) -> tuple[IndexArray, IndexArray]:
    cells = CellList(points_m[:, 0].copy(), points_m[:, 1].copy(), reach_m)
    return cells.near(mounts[:, 0], mounts[:, 1])


def _seen(points_m: FloatArray, mounts: FloatArray) -> FloatArray:
    """Return points in the frames of mounts, (k, 2)."""
    poses = np.column_stack([points_m, np.zeros(len(points_m))])
    return relative(mounts, poses)[:, :2]
