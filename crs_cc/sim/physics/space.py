"""Construction of the pymunk space of a world's bodies.

A load is a part of its robot's body; a shared load is attached to joints between the robots.
Composite objects are one body (`rigid`). All objects that no robot bears have floor friction. The
order in which bodies are added is significant.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Final, TypeAlias

import numpy as np
import pymunk

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.geometry.ledges import Ledges
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.world import WorldModel, WorldObject
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

BodyOf: TypeAlias = Callable[[int], pymunk.Body]

_BIAS: Final = 1e-6  # fraction of a deeper overlap that is left after a second


@dataclass(slots=True)
class Space:
    """A space and its contents.

    Attributes:
        inner: pymunk's space.
        bodies: the bodies in it: the robots, movable objects, fixed solids, the ground if it is not
            flat, the floor.
        numbers: those of the bodies, as in `Scene.names`.
        robots: number of robots in it.
        objects: number of movable objects.
        rubs: the joints that model floor friction, with their force [N] or torque [N m] on level
            ground, by the number of the object.
        joints: those that hold robots, in this cycle.
        grip: the factor on the friction of each object on a slope, (objects,).
        object_kg: the mass of each object that no robot bears and that is not a part, else 0,
            (objects,).
    """

    inner: pymunk.Space
    bodies: list[pymunk.Body]
    numbers: list[int]
    robots: int
    objects: int
    rubs: dict[int, list[tuple[pymunk.Constraint, float]]]
    object_kg: FloatArray
    grip: FloatArray
    joints: list[pymunk.Constraint] = field(default_factory=list)

    @property
    def floor(self) -> pymunk.Body:
        """The body of the floor."""
        return self.bodies[-1]

    @property
    def moving(self) -> int:
        """Return the number of bodies that move: robots, and objects."""
        return self.robots + self.objects

    def admit(self, robots: list[int], others: list[int], body_of: BodyOf) -> bool:
        """Have only some robots in it, and more of the fixed solids; return whether it changes.

        Args:
            robots: the numbers of the robots, rising.
            others: solids that have to be in it, too.
            body_of: returns a new body of a robot or a solid, with its shapes.
        """
        inside, new = self.numbers[: self.robots], sorted(self._solids_without(others))
        if inside == robots and not new:
            return False
        self.hold([])
        bodies = dict(zip(inside, self.bodies, strict=False))
        for number in sorted(set(inside).difference(robots)):
            body = bodies[number]
            self.inner.remove(body, *body.shapes)
        for number in sorted({*robots}.difference(inside)) + new:
            bodies[number] = body_of(number)
            add(self.inner, bodies[number], *bodies[number].shapes)
        self.bodies[: self.robots] = [bodies[number] for number in robots]
        self.numbers[: self.robots] = robots
        self.robots = len(robots)
        self.bodies[-1:-1], self.numbers[-1:-1] = [bodies[number] for number in new], new
        return True

    def _solids_without(self, others: list[int]) -> set[int]:
        return set(others).difference(self.numbers[self.moving :])

    def hold(self, joints: list[pymunk.Constraint]) -> None:
        """Hold robots with joints, which replace those of the cycle before."""
        self.inner.remove(*self.joints)
        self.joints = joints
        self.inner.add(*joints)

    def scale_friction(self, grip: FloatArray) -> None:
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

    def build(
        self,
        position_m: FloatArray,
        mass_kg: FloatArray,
        load: Load | None,
        *,
        is_whole: bool = True,
    ) -> Space:
        """Create the space.

        Args:
            position_m: approximate positions of the bodies, (bodies, 2); poses are loaded in each
                cycle.
            mass_kg: the mass of each robot with its load, (robots,).
            load: the robots' loads.
            is_whole: whether it has all robots; if not, nor has it the fixed solids, unless there
                are objects: see `Space.admit`.
        """
        inner = pymunk.Space()
        inner.collision_slop = SLOP_M
        inner.collision_bias = _BIAS
        inner.collision_persistence = 1  # with 0, contacts are forgotten before they can be read
        # All at one position would be O(n^2).
        places = iter(position_m[self._scene.robots :].tolist())
        parts, borne, apart = self._parts(load)
        bodies = self._add_robots(inner, position_m, mass_kg, parts) if is_whole else []
        robots = len(bodies)
        for number, whole in enumerate(self._rigid.wholes):
            body = pymunk.Body(whole.mass_kg, whole.moment_kgm2)
            body.position = next(places)
            bodies.append(body)
            add(inner, body, *(() if number in apart else shapes_of(body, whole)))
        first = len(self._scene.start)
        solids = len(self._scene.fixed_solids) if is_whole or self._scene.pushables else 0
        for number in range(first, first + solids):
            bodies.append(self.solid(number))
            add(inner, bodies[-1], *bodies[-1].shapes)
        if self._ledges is not None:
            bodies.append(add_ground(inner, bodies, self._ledges))
        space = self._on_floor(inner, bodies, robots, borne)
        if load is not None:
            inner.add(*self._shared_grips(bodies, load))
        return space

    def robot(self, number: int, position_m: FloatArray, mass_kg: FloatArray) -> pymunk.Body:
        """Return the body of a robot, in no space; an absent one has no shape.

        Args:
            number: its number.
            position_m: approximately where it is, (2,).
            mass_kg: the mass of each robot with its load, (robots,).
        """
        body = pymunk.Body(float(mass_kg[number]), math.inf)  # contacts do not turn it
        body.position = position_m[0].item(), position_m[1].item()
        if self._scene.present[number]:
            pymunk.Circle(body, self._world.robots[number].model.radius_m)
        return body

    def solid(self, number: int) -> pymunk.Body:
        """Return the body of a fixed solid, by its number in `Scene.names`, in no space."""
        body = pymunk.Body(body_type=pymunk.Body.STATIC)
        fixed_shapes(body, self._scene.fixed_solids[number - len(self._scene.start)])
        return body

    def _add_robots(
        self,
        inner: pymunk.Space,
        position_m: FloatArray,
        mass_kg: FloatArray,
        parts: dict[int, tuple[WorldObject, FloatArray]],
    ) -> list[pymunk.Body]:
        """Add the robots with their loads."""
        bodies = []
        for number in range(self._scene.robots):
            body = self.robot(number, position_m[number], mass_kg)
            bodies.append(body)
            if number in parts:
                object_shapes(body, *parts[number])
            add(inner, body, *body.shapes)
        return bodies

    def _on_floor(
        self, inner: pymunk.Space, bodies: list[pymunk.Body], robots: int, borne: set[int]
    ) -> Space:
        """Add the floor, with friction on all objects that no robot bears."""
        floor = pymunk.Body(body_type=pymunk.Body.STATIC)
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
        objects, first = len(object_kg), self._scene.robots - robots
        numbers = [*range(robots), *range(first + robots, first + len(bodies))]
        grip = np.ones(objects)
        return Space(inner, bodies, numbers, robots, objects, rubs, object_kg, grip)

    def _parts(
        self, load: Load | None
    ) -> tuple[dict[int, tuple[WorldObject, FloatArray]], set[int], set[int]]:
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
