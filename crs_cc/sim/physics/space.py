"""Construction of the pymunk space of a world's bodies.

A load is a part of its robot's body; a shared load is attached to joints between the robots.
Composite objects are one body (`rigid`). All objects that no robot bears have floor friction. The
order in which bodies are added is significant.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Final

import numpy as np
import pymunk

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.geometry.ledges import Ledges
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.world import Thing, WorldModel
from crs_cc.sim.physics.carrying import Load
from crs_cc.sim.physics.contacts import SLOP_M
from crs_cc.sim.physics.rigid import Rigid
from crs_cc.sim.physics.shapes import (
    add,
    add_ground,
    fixed_shapes,
    floor_friction,
    object_shapes,
    shapes_of,
)

_BIAS: Final = 1e-6  # fraction of a deeper overlap that is left after a second


@dataclass(slots=True)
class Space:
    """A space and its contents.

    Attributes:
        inner: pymunk's space.
        bodies: the bodies in it: the robots, movable objects, fixed solids, the ground if it is not
            flat, the floor.
        robots: number of robots.
        rubs: the joints that model floor friction, with their force [N] or torque [N m] on level
            ground, by the number of the object.
        joints: those that hold robots, in this cycle.
        grip: the factor on the friction of each object on a slope, (objects,).
        object_kg: the mass of each object that no robot bears and that is not a part, else 0,
            (objects,).
    """

    inner: pymunk.Space
    bodies: list[pymunk.Body]
    robots: int
    rubs: dict[int, list[tuple[pymunk.Constraint, float]]]
    object_kg: FloatArray
    grip: FloatArray
    joints: list[pymunk.Constraint] = field(default_factory=list)

    @property
    def floor(self) -> pymunk.Body:
        """The body of the floor."""
        return self.bodies[-1]

    def hold(self, joints: list[pymunk.Constraint]) -> None:
        """Hold robots with joints, which replace those of the cycle before."""
        self.inner.remove(*self.joints)
        self.joints = joints
        self.inner.add(*joints)

    def rub(self, grip: FloatArray) -> None:
        """Scale the friction of each object by a factor, (objects,)."""
        for number in np.flatnonzero(grip != self.grip).tolist():
            for joint, most in self.rubs.get(number, ()):
                joint.max_force = most * float(grip[number])
        self.grip = grip


class SpaceBuilder:
    """Builds the spaces of a world."""

    def __init__(
        self, world: WorldModel, scene: Scene, rigid: Rigid, ledges: Ledges | None
    ) -> None:
        self._world, self._scene, self._rigid, self._ledges = world, scene, rigid, ledges

    def build(self, position_m: FloatArray, mass_kg: FloatArray, load: Load | None) -> Space:
        """Create the space.

        Args:
            position_m: approximate positions of the bodies, (bodies, 2); poses are loaded in each
                cycle.
            mass_kg: the mass of each robot with its load, (robots,).
            load: the robots' loads.
        """
        inner = pymunk.Space()
        inner.collision_slop = SLOP_M
        inner.collision_bias = _BIAS
        inner.collision_persistence = 1  # with 0, contacts are forgotten before they can be read
        places = iter(position_m.tolist())  # all at one position would be O(n^2)
        parts, borne, apart = self._parts(load)
        bodies = self._add_robots(inner, places, mass_kg, parts)
        for number, whole in enumerate(self._rigid.wholes):
            body = pymunk.Body(whole.mass_kg, whole.moment_kgm2)
            body.position = next(places)
            bodies.append(body)
            add(inner, body, *(() if number in apart else shapes_of(body, whole)))
        for solid in self._scene.fixed_solids:
            body = pymunk.Body(body_type=pymunk.Body.STATIC)
            bodies.append(body)
            add(inner, body, *fixed_shapes(body, solid))
        if self._ledges is not None:
            bodies.append(add_ground(inner, bodies, self._ledges))
        space = self._on_floor(inner, bodies, borne)
        if load is not None:
            inner.add(*self._shared_grips(bodies, load))
        return space

    def _add_robots(
        self,
        inner: pymunk.Space,
        places: Iterator[list[float]],
        mass_kg: FloatArray,
        parts: dict[int, tuple[Thing, FloatArray]],
    ) -> list[pymunk.Body]:
        """Add the robots with their loads; absent ones have no shape."""
        bodies = []
        for number, robot in enumerate(self._world.robots):
            body = pymunk.Body(float(mass_kg[number]), math.inf)  # contacts do not turn it
            x_m, y_m = next(places)
            body.position = x_m, y_m
            bodies.append(body)
            carried = parts.get(number)
            load = () if carried is None else object_shapes(body, *carried)
            own = [pymunk.Circle(body, robot.model.radius_m)] * bool(self._scene.present[number])
            add(inner, body, *own, *load)
        return bodies

    def _on_floor(self, inner: pymunk.Space, bodies: list[pymunk.Body], borne: set[int]) -> Space:
        """Add the floor, with friction on all objects that no robot bears."""
        floor, robots = pymunk.Body(body_type=pymunk.Body.STATIC), self._scene.robots
        bodies.append(floor)
        inner.add(floor)
        rubs: dict[int, list[tuple[pymunk.Constraint, float]]] = {}
        object_kg = np.zeros(len(self._scene.pushables))
        for number, whole in enumerate(self._rigid.wholes):
            if number not in borne:
                joints = floor_friction(floor, bodies[robots + number], whole)
                rubs[number] = [(joint, joint.max_force) for joint in joints]
                inner.add(*joints)
                object_kg[number] = whole.mass_kg
        return Space(inner, bodies, robots, rubs, object_kg, np.ones(len(object_kg)))

    def _parts(
        self, load: Load | None
    ) -> tuple[dict[int, tuple[Thing, FloatArray]], set[int], set[int]]:
        """Return how objects are attached to robots.

        Returns:
            the parts of each robot's body and their poses; the objects without floor friction; and
            those of them that have no body of their own.
        """
        others = self._rigid.others
        if load is None:
            return {}, set(others), set(others)
        objects = [self._scene.pushables[obj] for obj in load.carried.tolist()]
        parts = dict(
            zip(load.carriers.tolist(), zip(objects, load.grasp, strict=True), strict=True)
        )
        apart = {*load.carried.tolist(), *load.lifted.tolist(), *others}
        return parts, apart | set(load.shared.tolist()), apart

    def _shared_grips(self, bodies: list[pymunk.Body], load: Load) -> list[pymunk.Constraint]:
        """Return the joints between robots and their shared loads."""
        joints: list[pymunk.Constraint] = []
        grips = zip(load.grip_m.tolist(), load.grip_n.tolist(), load.point_m.tolist(), strict=True)
        rows = zip(load.sharers, load.shared, grips, strict=True)
        for robot, obj, (grip_m, grip_n, point_m) in rows:
            body, held = bodies[robot], bodies[self._scene.robots + obj]
            joint = pymunk.PivotJoint(body, held, (grip_m, 0.0), tuple(point_m))
            joint.max_force = grip_n
            joint.collide_bodies = False
            joints.append(joint)
        return joints
