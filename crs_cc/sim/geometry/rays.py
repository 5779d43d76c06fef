"""Ray casting against segments and circles, vectorised over all robots and beams of a kind.

A beam is a cone with a half angle; a ray is a cone with half angle 0. A beam measures the distance
from its start to the nearest point of any object inside the cone: exactly, where a few rays would
miss a thin pillar. The nearest point of a segment is found by clipping the segment to the cone
(Liang and Barsky, "A new concept and method for line clipping", 1984) and projecting the start on
the rest; that of a circle is towards its centre, or on the nearer side of the cone.

Most shapes are never tested: `obstacles` returns those within reach of a robot, and of a robot's
beams, sorted by direction, only those are tested that can point at the shape. That is done by a
kernel, `kernels/rays.c`.

Points in the plane are complex numbers, x + i y [m], so that rotations are products.

>>> from crs_cc.sim.model.world import Area, Cylinder, Pose, WorldModel
>>> from crs_cc.sim.geometry.obstacles import Obstacles
>>> from crs_cc.sim.geometry.scene import NOTHING, Scene
>>> world = WorldModel("w", Area(0, 0, 9, 9, 0), cylinders=(Cylinder("c", Pose(3, 1), 0.5),))
>>> fan = Fan.of([(0.2, 0.0, 0.0, 0.0, 5.0), (0.2, 0.0, math.pi, 0.0, 5.0)])
>>> nearest(fan, np.array([[1.0, 1.0, 0.0]]), Obstacles(Scene(world).fixed, NOTHING, 6, 1))
array([[1.3, inf]])
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import ComplexArray, FloatArray, IndexArray
from crs_cc.sim.geometry.cell_list import parts
from crs_cc.sim.geometry.outline_query import ObstacleQuery
from crs_cc.sim.kernels import exact, surveys
from crs_cc.sim.kernels.program import kernels
from crs_cc.sim.kernels.tables import RAY_BINS

NO_THING: Final = -1
"""The object of a beam that hits nothing."""

_TURN: Final = 2 * math.pi
_THIN_RAD: Final = 1e-9  # minimum half angle of a cone
_SHARE: Final = 8  # one in this many numbers of the kernels' memory is for distances


@dataclass(frozen=True, slots=True)
class Fan:
    """The beams of one kind of robot, in the robot frame, by rising direction.

    Attributes:
        start: the start of each beam.
        order: the index of each beam in the list that the fan was made from.
        start_m: the largest distance of a beam's start from the robot's origin.
        reach_m: the largest distance from the robot's origin that can be measured.
        table: what the kernel needs to know, see `kernels/rays.c`.
        z_m: the height of the beams above the ground.
    """

    start: ComplexArray
    order: IndexArray
    start_m: float
    reach_m: float
    table: FloatArray
    z_m: float = 0.0

    @classmethod
    def of(
        cls, beams: Iterable[tuple[float, float, float, float, float]], z_m: float = 0.0
    ) -> Self:
        """Create a fan from beams: x [m], y [m], direction, half angle [rad], range [m]."""
        table = np.array(list(beams), dtype=np.float64).reshape(-1, 5)
        table[:, 2] %= _TURN
        order = np.argsort(table[:, 2], kind="stable")
        x_m, y_m, direction, half, range_m = np.ascontiguousarray(table[order].T)
        half = np.maximum(half, _THIN_RAD)
        away_m = exact.hypot(x_m, y_m)
        tilt = (exact.arctan2(y_m, x_m) - direction) % math.pi  # of the axis relative to the origin
        tilt = np.minimum(tilt, math.pi - tilt) + half
        aside_m = away_m * exact.sin(np.minimum(tilt, math.pi / 2))
        axis = exact.turn(direction)
        sides = exact.cos(half), exact.sin(half)
        rows = np.column_stack([x_m, y_m, axis.real, axis.imag, *sides, range_m, order])
        columns = (range_m + away_m, away_m, aside_m, half)
        reach_m, start_m, *others = (float(each.max(initial=0.0)) for each in columns)
        head = (len(order), reach_m, start_m, *others, 0.0)
        table = np.concatenate([head, rows.ravel(), _beams_behind(axis)])
        return cls(x_m + 1j * y_m, order, start_m, reach_m, table, z_m)

    def __len__(self) -> int:
        return len(self.order)


def nearest(
    fan: Fan,
    poses: FloatArray,
    obstacles: ObstacleQuery,
    own: IndexArray | None = None,
    objects: IndexArray | None = None,
) -> FloatArray:
    """Return the measured distance of each beam of each robot.

    A beam that starts inside a circle measures 0. One that starts behind a segment, in its solid,
    measures a wrong distance: see `contact_mask`.

    Args:
        fan: the robots' beams.
        poses: x, y [m] and heading [rad] of each robot, shape (k, 3).
        obstacles: the outlines.
        own: the number of each robot's own body, which its beams pass through.
        objects: receives the object that each beam hits, as in `Scene.names`, -1 if there is none
            within range; shape (k, beams). None if they are not needed.

    Returns:
        distances from the beams' starts [m], infinite if there is no object within range, shape
        (k, beams), in the order of the list that the fan was made from.
    """
    if own is None:
        own = np.full(len(poses), NO_THING, dtype=np.intp)
    place = poses[:, 0] + 1j * poses[:, 1]
    most, is_named = max(1, kernels().room // (_SHARE * max(len(fan), 1))), objects is not None
    found = []
    for block, outlines in obstacles.blocks(place):
        for part in parts(block, most):
            rows = outlines.segment_rows(place[part]), outlines.circle_rows(place[part], own[part])
            results = surveys.rays(
                kernels(), fan.table, poses[part], own[part], rows, wants_objects=is_named
            )
            found.append(results[0])
            if objects is not None:
                objects[part] = results[1]
    return found[0] if len(found) == 1 else np.concatenate([np.zeros((0, len(fan))), *found])


def _beams_behind(axis: ComplexArray) -> IndexArray:
    """Return the number of beams before each bin of directions, for two turns.

    The bins are those of the diamond angle, 0 to 4, which rises with the true one.
    """
    share = axis.imag / (np.abs(axis.real) + np.abs(axis.imag))
    angle = np.where(axis.real < 0, 2 - share, np.where(axis.imag < 0, 4 + share, share))
    bins = np.arange(2 * RAY_BINS + 1) * (4 / RAY_BINS)
    return np.searchsorted(np.concatenate([angle, angle + 4]), bins, side="left")
