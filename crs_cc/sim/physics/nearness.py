"""Robots that are near enough to another object to touch it in the next cycle.

Among many robots few are. How much room each has is measured when it has become too little, as far
as `LOOK` cycles at full speed, and until then reduced by what it and the others may have moved; so
in a cycle only some are measured. The result is that of measuring all.

>>> from crs_cc.sim.files.world_xml import parse_world
>>> world = parse_world(b'''<world version="1"><area length="9m" width="9m"/><robot x="1m" y="1m"/>
...   <robot x="1.5m" y="1m"/><robot x="8.75m" y="5m"/></world>''', "room")
>>> scene = Scene(world)
>>> nearness = Nearness(scene, need_m=0.1)
>>> [nearness.find(scene.start[:, :2], need_m).tolist() for need_m in (0.05, 0.2)]
[[2, 4], [0, 1, 2, 4]]
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.geometry.scene import Scene, own_corners_m
from crs_cc.sim.kernels import exact
from crs_cc.sim.kernels.room_field import RoomField
from crs_cc.sim.model.world import Cylinder, WorldObject

LOOK: Final = 8
"""Cycles for which room is measured."""


class Nearness:
    """The room of the robots of a scene.

    Movable objects count as the discs around them, since they may turn.
    """

    def __init__(self, scene: Scene, need_m: float) -> None:
        """Sort the fixed objects.

        Args:
            scene: the scene.
            need_m: the room that robots need in a cycle at full speed.
        """
        self._robots = np.flatnonzero(scene.present)
        radii_m = [scene.world.robots[robot].model.radius_m for robot in self._robots.tolist()]
        discs_m = radii_m + [_reach_m(obj) for obj in scene.pushables]
        self._radius_m = np.array(discs_m, dtype=np.float64)
        objects = np.arange(scene.robots, scene.robots + len(scene.pushables))
        self._bodies = np.concatenate([self._robots, objects])
        owners = scene.fixed.segment_owners, scene.fixed.owners
        self._owners = np.concatenate(owners)
        self._look_m = LOOK * need_m
        self._room_m = np.zeros(len(self._robots))
        circles = scene.fixed.circles
        ends_m = np.concatenate([scene.fixed.segments[:, :4], circles[:, [0, 1, 0, 1]]])
        thick_m = np.concatenate([np.zeros(len(scene.fixed.segments)), circles[:, 2]])
        self._field = RoomField(ends_m, thick_m, self._look_m)

    def find(self, position_m: FloatArray, need_m: float) -> IndexArray:
        """Return the present robots with less room than they need, and near fixed solids, rising.

        Args:
            position_m: the positions of all bodies, (bodies, 2).
            need_m: the room that each needs.
        """
        if need_m > self._look_m:
            self.forget()
            return np.concatenate([self._robots, np.unique(self._owners)])
        short = np.flatnonzero(self._room_m < need_m)
        if not len(short):
            return short
        solids = self._measure(position_m, short, need_m)
        near = self._robots[short[self._room_m[short] < need_m]]
        return np.concatenate([near, solids])

    def use(self, most_m: float) -> None:
        """Reduce the room by what two bodies may have moved towards each other."""
        self._room_m -= most_m

    def forget(self) -> None:
        """Measure again next time, as bodies may be anywhere."""
        self._room_m[:] = 0.0

    def _measure(self, position_m: FloatArray, which: IndexArray, need_m: float) -> IndexArray:
        """Measure the room of robots, by their places in `_robots`; return near solids, rising."""
        discs = np.empty((len(self._bodies), 3))
        discs[:, :2], discs[:, 2] = position_m.take(self._bodies, axis=0), self._radius_m
        self._room_m[which], near = self._field.measure(discs, which, need_m)
        return np.unique(self._owners[near])


def _reach_m(obj: WorldObject) -> float:
    """Return the reach of an object from the origin of its frame."""
    if isinstance(obj, Cylinder):
        return obj.radius_m
    corners_m = own_corners_m(obj)
    return float(exact.hypot(corners_m[:, 0], corners_m[:, 1]).max())
