"""Line of sight: the number of objects between two points, for channels that walls attenuate.

An object is between two points if the line from one to the other intersects its outline, however
often. Robots do not count: their antennas are above their shells.

A kernel (`kernels/sight.c`) cuts long lines into pieces, so that each piece is tested only against
shapes near it.

Points in the plane are complex numbers, x + i y [m].

>>> from crs_cc.sim.model.world import Area, Box, Pose, Wall, WorldModel
>>> walls, boxes = (Wall("w", 2, 0, 2, 9),), (Box("b", Pose(4, 5), 1, 1),)
>>> scene = Scene(WorldModel("x", Area(0, 0, 9, 9, 0), walls, boxes))
>>> start, end = np.array([1 + 5j, 1 + 5j]), np.array([8 + 5j, 3 + 8j])
>>> Sight(scene).between(np.zeros((0, 2)), np.zeros(0), start, end).tolist()
[2, 1]
"""

from __future__ import annotations

import numpy as np

from crs_cc.core.arrays import ComplexArray, FloatArray, IndexArray, Int32Array
from crs_cc.sim.geometry.scene import Outlines, Scene
from crs_cc.sim.kernels.program import pairs
from crs_cc.sim.kernels.sight_field import MANY, SightField


class Sight:
    """The outlines of a scene, sorted by position."""

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._field = SightField(*_rows(scene.fixed))

    def between(
        self,
        position_m: FloatArray,
        angle_rad: FloatArray,
        start: ComplexArray,
        end: ComplexArray,
        enough: Int32Array | None = None,
    ) -> IndexArray:
        """Return the number of objects between points.

        Args:
            position_m: the positions of the movable bodies, as for `Scene.moving`.
            angle_rad: their headings.
            start: one point of each pair, shape (k,).
            end: the other one.
            enough: a number of objects for each pair, (k,): if there are more, the result may be
                any number from this one on.

        Returns:
            shape (k,).
        """
        lines = pairs(start), pairs(end)
        most = np.full(len(start), MANY) if enough is None else enough
        if not self._scene.pushables:
            return self._field.count(lines, most)
        moving = _rows(self._scene.moving(position_m, angle_rad), self._scene.robots)
        return self._field.count(lines, most, moving)


def _rows(outlines: Outlines, first: int = 0) -> tuple[FloatArray, FloatArray]:
    """Return the rows of segments and circles, see `beams.h`, of objects from one on."""
    tables = []
    owners = outlines.segment_owners, outlines.owners
    for shapes, objects in zip((outlines.segments, outlines.circles), owners, strict=True):
        rows = np.empty((len(shapes), 2 + shapes.shape[1]))
        rows[:, 0], rows[:, 1], rows[:, 2:] = -1.0, objects, shapes
        tables.append(rows[objects >= first])
    return tables[0], tables[1]
