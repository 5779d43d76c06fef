"""Penetration depth of two objects.

Polygons are decomposed into convex parts. Convex parts are disjoint if they are separated along the
normal of one of their sides (separating axis theorem; Gottschalk, "Separating axis theorem",
1996); else their depth is the least of the overlaps along these.

>>> from crs_cc.sim.model.world import Box, Pose, Wall
>>> crate = Box("crate", Pose(1.0, 1.0), 1.0, 1.0)
>>> round(overlap_m(crate, Wall("screen", 1.6, 0.0, 1.6, 4.0, thickness_m=0.3)), 6)
0.05
>>> overlap_m(crate, Box("other", Pose(2.0, 1.0), 1.0, 1.0))  # they touch
0.0
"""

from __future__ import annotations

import numpy as np

from crs_cc.core import segment
from crs_cc.core.arrays import FloatArray
from crs_cc.sim.geometry.scene import convex_parts_of, corners_m
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.world import Box, Cylinder, Solid, Wall


def overlap_m(obj: Solid, other: Solid) -> float:
    """Return the depth of overlap of two objects, at most one a wall; negative for a gap [m]."""
    return max(
        margin_m + other_margin_m - _gap_m(part, other_part)
        for part, margin_m in _convex(obj)
        for other_part, other_margin_m in _convex(other)
    )


def _convex(solid: Solid) -> list[tuple[FloatArray, float]]:
    """Return the corners of convex parts, counter-clockwise, and the margins around them [m]."""
    if isinstance(solid, Cylinder):
        return [(np.array([(solid.pose.x_m, solid.pose.y_m)]), solid.radius_m)]
    if isinstance(solid, Wall):
        ends = [(solid.x1_m, solid.y1_m), (solid.x2_m, solid.y2_m)]
        return [(np.array(ends), solid.thickness_m / 2)]
    corners = corners_m(solid)
    if isinstance(solid, Box):
        return [(corners, 0.0)]
    return [(corners[part], 0.0) for part in convex_parts_of(solid)]


def _gap_m(one: FloatArray, other: FloatArray) -> float:
    """Return the distance of convex parts; negative for the depth of their overlap."""
    apart_m = [_apart_m(one, other), _apart_m(other, one)]
    least_m = max(apart_m)
    if least_m > 0.0 or np.isinf(least_m):
        return min(_distance_m(one, other), _distance_m(other, one))
    return least_m


def _apart_m(one: FloatArray, other: FloatArray) -> float:
    """Return the largest separation along a normal of the first part's sides."""
    if len(one) < 2:
        return -np.inf
    sides = np.roll(one, -1, axis=0) - one
    normals = np.column_stack([sides[:, 1], -sides[:, 0]])
    normals /= exact.hypot(sides[:, 0], sides[:, 1])[:, None]
    return float(
        ((other[:, None] * normals).sum(axis=2).min(axis=0) - (one * normals).sum(axis=1)).max()
    )


def _distance_m(corners: FloatArray, other: FloatArray) -> float:
    """Return the shortest distance from corners to the sides of another part."""
    sides, across = np.roll(other, -1, axis=0) - other, corners[:, None] - other
    return float(segment.distance(across[..., 0], across[..., 1], *sides.T).min())
