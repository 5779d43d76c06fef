"""Composite bodies: the parts of a movable object as one rigid body.

Everywhere else each part is a body of its own, but in the physics the first part's body has the
shapes, the mass and the friction of all parts, and is at their centre of mass. The others' have no
shapes. After a cycle every part is moved with that body. No gripper grips a part.

A part's share of the mass presses on the floor under the part. So an object's friction torque is
the sum over its parts, each with the lever of its distance from the centre of mass.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.geometry.frames import compose, relative
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.mass_properties import friction_n, friction_nm, moment_kgm2
from crs_cc.sim.model.world import WorldObject
from crs_cc.sim.state.bodies import Bodies


@dataclass(frozen=True, slots=True)
class CompositeBody:
    """The body of a composite object.

    Attributes:
        parts: the parts, and their poses in its frame: x, y [m], direction [rad].
        moment_kgm2: its moment of inertia about the centre of mass.
        friction_n: the friction force, below which it does not slide.
        friction_nm: the friction torque, below which it does not turn.
    """

    parts: tuple[tuple[WorldObject, FloatArray], ...]
    mass_kg: float
    moment_kgm2: float
    friction_n: float
    friction_nm: float

    @classmethod
    def of(cls, parts: list[tuple[WorldObject, FloatArray]]) -> Self:
        """Combine parts, given with their poses in the frame of the centre of mass."""
        off_m = [exact.hypot(place[0], place[1]) for _, place in parts]
        pairs = [(obj, away_m) for (obj, _), away_m in zip(parts, off_m, strict=True)]
        return cls(
            tuple(parts),
            sum(obj.mass_kg for obj, _ in pairs),
            sum(moment_kgm2(obj) + obj.mass_kg * (away_m * away_m) for obj, away_m in pairs),
            sum(friction_n(obj) for obj, _ in pairs),
            sum(exact.hypot(friction_nm(obj), friction_n(obj) * away_m) for obj, away_m in pairs),
        )


class Rigid:
    """The movable objects of a scene.

    Attributes:
        wholes: the contents of each movable body: all parts of its object for the first part, the
            body itself for a single object, only a mass for the other parts.
        others: the numbers of the other parts.
        lever_m: the largest distance of a part from its object's centre of mass.
    """

    def __init__(self, scene: Scene) -> None:
        groups: dict[str, list[int]] = {}
        for number, obj in enumerate(scene.pushables):
            if obj.part_of:
                groups.setdefault(obj.part_of, []).append(number)
        self.wholes = [CompositeBody.of([(obj, np.zeros(3))]) for obj in scene.pushables]
        rows: list[int] = []
        first: list[int] = []
        places = [np.zeros((0, 3))]
        for numbers in groups.values():
            objects = [scene.pushables[number] for number in numbers]
            start = scene.start[scene.robots + np.array(numbers)]
            mass_kg = np.array([obj.mass_kg for obj in objects])
            middle = np.zeros((len(objects), 3))
            middle[:, :2] = (mass_kg[:, None] * start[:, :2]).sum(axis=0) / mass_kg.sum()
            place = relative(middle, start)
            self.wholes[numbers[0]] = CompositeBody.of(list(zip(objects, place, strict=True)))
            first += [len(rows)] * len(numbers)
            rows += numbers
            places.append(place)
        self.others = frozenset(rows) - {numbers[0] for numbers in groups.values()}
        self._rows = np.array(rows, dtype=np.intp)  # among the objects
        self._first = np.array(first, dtype=np.intp)
        self._place = np.concatenate(places)
        lever_m = exact.hypot(self._place[:, 0], self._place[:, 1])
        self.lever_m = float(lever_m.max(initial=0.0))
        self._loaded = np.zeros((0, 3))
        self._poses = np.zeros((0, 3))

    def load(self, motion: FloatArray) -> None:
        """Move the bodies of objects to their centres of mass.

        Args:
            motion: x, y [m], angle [rad], velocity [m/s] and spin [rad/s] of all objects, (n, 6);
                changed in place.
        """
        if not len(self._rows):
            return
        own = self._place[self._first]
        self._poses = motion[self._rows, :3].copy()
        frames = compose(self._poses[self._first], relative(own, np.zeros_like(own)))
        motion[self._rows, :3] = self._loaded = frames

    def place(self, bodies: Bodies) -> None:
        """Move all parts with the bodies of their objects; those that did not move are unchanged.

        Args:
            bodies: the result of the physics; changed in place.
        """
        if not len(self._rows):
            return
        rows = self._rows + len(bodies.slipping)
        first = rows[self._first]
        frames = np.column_stack([bodies.position_m[first], bodies.angle_rad[first]])
        still = (frames == self._loaded).all(axis=1)
        poses = np.where(still[:, None], self._poses, compose(frames, self._place))
        bodies.position_m[rows], bodies.angle_rad[rows] = poses[:, :2], poses[:, 2]
        bodies.velocity_mps[rows] = bodies.velocity_mps[first]
        bodies.spin_radps[rows] = bodies.spin_radps[first]
