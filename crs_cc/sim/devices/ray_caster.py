"""Ray casting, for all sensors that measure distances.

One object has the poses of everything in the current cycle; each kind of sensor passes its beams
and gets distances.

>>> from crs_cc.sim.state.env_state import EnvState
>>> from crs_cc.sim.files.world_xml import parse_world
>>> world = parse_world(b'''<world version="1"><area length="4m" width="4m"/>
...   <robot x="1m" y="2m"/></world>''', "room")
>>> ahead = Fan.of([(0.2, 0.0, 0.0, 0.0, 5.0)])
>>> rays = RayCaster(Scene(world), [ahead])
>>> rays.distances_m(EnvState.at_start(world), ahead, np.array([[1.0, 2.0, 0.0]]), np.array([0]))
array([[2.8]])
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.geometry.cell_list import are_few
from crs_cc.sim.geometry.contact_mask import Pieces
from crs_cc.sim.geometry.height_occlusion import Outlook, is_needed
from crs_cc.sim.geometry.obstacles import Obstacles
from crs_cc.sim.geometry.rays import NO_THING, Fan, nearest
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.geometry.surfaces import Surfaces
from crs_cc.sim.kernels.beam_field import BeamField
from crs_cc.sim.kernels.program import kernels
from crs_cc.sim.kernels.surveys import Shapes, scan

if TYPE_CHECKING:
    from crs_cc.sim.geometry.outline_query import ObstacleQuery
    from crs_cc.sim.state.bodies import Bodies
    from crs_cc.sim.state.env_state import EnvState


_MIN_REACH_M: Final = 1.0


class RayCaster:
    """A ray caster over all objects, at their poses in the cycle of the last query.

    Attributes:
        surfaces: the optical and acoustic surfaces of all objects.
    """

    def __init__(self, scene: Scene, fans: Sequence[Fan], threads: int = 1) -> None:
        """Index the fixed objects.

        Args:
            scene: all objects.
            fans: the beams of all sensors.
            threads: how many threads may cast rays at the same time; no result depends on it.
        """
        reach_m = max((fan.reach_m for fan in fans), default=0.0)
        start_m = max((fan.start_m for fan in fans), default=0.0)
        moving = scene.moving(scene.start[:, :2], scene.start[:, 2])
        self._scene = scene
        self.surfaces = Surfaces.of(scene)
        reach_m = max(reach_m, _MIN_REACH_M)
        self._obstacles = Obstacles(scene.fixed, moving, reach_m, start_m)
        self._pieces = Pieces(scene, start_m)
        self._outlook = Outlook(scene, self._obstacles, reach_m) if is_needed(scene) else None
        self._placed = -1
        self._places = b""
        self._shapes: Shapes | None = None  # if they are few
        self._reach_m, self._threads = reach_m, threads
        self._field: BeamField | None = None  # if they are many
        self._is_sorted = self._has_no_room = False

    def forget(self) -> None:
        """Forget the poses of the last query: bodies may have moved within the cycle."""
        self._placed = -1

    def obstacles(self, state: EnvState) -> Obstacles:
        """Return the objects that beams can hit, at the start of the cycle."""
        if self._placed != state.cycle:
            self._place(state.bodies)
            self._placed = state.cycle
        return self._obstacles

    def _place(self, bodies: Bodies) -> None:
        """Index the moving objects, unless none has moved."""
        places = bodies.position_m.tobytes() + bodies.angle_rad.tobytes()
        if places == self._places:
            return
        self._places, self._shapes, self._is_sorted = places, None, False
        self._obstacles.place(self._scene.moving(bodies.position_m, bodies.angle_rad))
        self._pieces.place(bodies.position_m, bodies.angle_rad)
        if self._outlook is not None:
            self._outlook.place(bodies.position_m)

    def few_shapes(self, state: EnvState, robots: int) -> Shapes | None:
        """Return all shapes, None if they are too many to be tried for each of some robots."""
        obstacles = self.obstacles(state)
        if not are_few(robots, obstacles.count + len(self._pieces)):
            return None
        if self._shapes is None:
            self._shapes = Shapes.of(*obstacles.rows(), self._pieces.rows)
        return self._shapes

    @property
    def all_alike(self) -> bool:
        """Whether beams can hit the same objects at all heights."""
        return self._outlook is None

    def shapes_at_height(
        self, state: EnvState, z_m: FloatArray | float, spread: FloatArray | float
    ) -> ObstacleQuery:
        """Return what beams that start at a height can hit, see `Outlook.at`."""
        obstacles = self.obstacles(state)
        return obstacles if self._outlook is None else self._outlook.at(z_m, spread)

    def distances_m(
        self, state: EnvState, fan: Fan, poses: FloatArray, own: IndexArray
    ) -> FloatArray:
        """Return the measurements of all beams of robots at the start of the cycle.

        Args:
            state: has the poses of the bodies.
            fan: the robots' beams.
            poses: x, y [m] and heading [rad] that each robot measures from, shape (k, 3).
            own: the number of each robot's own body, which its beams pass through.

        Returns:
            distances from the beams' starts [m], 0 for a start in or on something, infinite where
            nothing is within range, shape (k, beams).
        """
        if self._outlook is not None:
            return self.seen(state, fan, poses, own)[0]
        obstacles = self.obstacles(state)
        shapes = self.few_shapes(state, len(poses))
        if shapes is not None:
            found_m = scan(kernels(), fan.table, poses, own, shapes)
            if found_m is not None:
                return found_m
        field = self._sorted(obstacles)
        if field is not None:
            return field.distances_m(fan.table, poses, own)
        distance_m = nearest(fan, poses, obstacles, own=own)
        if self._pieces:
            distance_m[self._pieces.cover(fan, poses)] = 0.0
        return distance_m

    def _sorted(self, obstacles: Obstacles) -> BeamField | None:
        """Return all shapes as they are now, None if they have no room in the kernels' memory."""
        if self._is_sorted or self._has_no_room:
            return self._field
        segments, moving_segments, circles, moving_circles = obstacles.tables()
        pieces, moving_pieces = self._pieces.tables
        if self._field is None:
            shapes = segments, circles, pieces
            self._field = BeamField(self._reach_m, shapes, self._threads)
        self._is_sorted = self._field.place((moving_segments, moving_circles, moving_pieces))
        if not self._is_sorted:
            self._field, self._has_no_room = None, True
        return self._field

    def seen(
        self, state: EnvState, fan: Fan, poses: FloatArray, own: IndexArray
    ) -> tuple[FloatArray, IndexArray]:
        """Return the distances, as `distances_m`, and the object that each beam hits.

        Returns:
            the distances, and the objects as in `Scene.names`, `NO_THING` where nothing is within
            range, both of shape (k, beams).
        """
        obj = np.empty((len(poses), len(fan)), dtype=np.intp)
        shapes = self.shapes_at_height(state, fan.z_m, 0.0)
        distance_m = nearest(fan, poses, shapes, own=own, objects=obj)
        covers = np.full_like(obj, NO_THING)
        covered = self._pieces.cover(fan, poses, covers)
        if self._outlook is not None:
            covered &= self._outlook.at(fan.z_m).tops_above(poses, covers)
            under = self._outlook.under_ground(fan.z_m, poses, fan.start, fan.order)
            covers[under], covered = self._outlook.ground, covered | under
        distance_m[covered], obj[covered] = 0.0, covers[covered]
        return distance_m, obj
