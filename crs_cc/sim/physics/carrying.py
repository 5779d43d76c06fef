"""Motion of held objects with their robots, computed without pymunk.

- An object in a single gripper is a part of its robot: it moves and turns with it, and its weight
  adds to the robot's mass and to the traction of its wheels.
- An object in several grippers is a body of its own without floor friction, and each gripper holds
  it at the centre of its fingers, with a pivot, so that each robot can turn; the weight is shared.
- An object in the hand of an arm is above everything: it has no contacts, and its weight counts as
  that of an object in a gripper.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Self

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.geometry.frames import compose, relative, wrapped
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.geometry.shape_table import ShapeTable
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.bodies import Bodies, Pull
from crs_cc.sim.state.holds import GRIPPER, HAND, Holds

if TYPE_CHECKING:
    from crs_cc.sim.state.env_state import EnvState


_OWN_M: Final = 0.01
"""A contact further than this from a robot's body is one of its load."""


@dataclass(frozen=True, slots=True)
class Load:
    """The loads of all robots; objects are numbered among the movable ones.

    Attributes:
        carriers: robots that are the only ones to grip an object, rising, c of them.
        carried: the object of each, (c,).
        grasp: its pose in the frame of the robot's mount, (c, 3).
        sharers: robots that grip an object together with others, rising, s of them.
        shared: the object of each, (s,).
        grip_m: the distance of the grip point ahead of the mount's centre, (s,).
        grip_n: the force that pulls the object out of its fingers, (s,).
        point_m: the grip point in the frame of the object, (s, 2).
        lifters: robots with an object in their hand, rising.
        lifted: the object of each.
        lift: its pose in the frame of the hand.
        weight_kg: the mass whose weight each robot bears, (robots,).
        mass_kg: the mass that moves with each robot as a part of it, (robots,).
        reach_m: the largest extent of a carried object from a robot's centre.
        robots: number of robots.
        radius_m: their radii, (robots,).
    """

    carriers: IndexArray
    carried: IndexArray
    grasp: FloatArray
    sharers: IndexArray
    shared: IndexArray
    grip_m: FloatArray
    grip_n: FloatArray
    point_m: FloatArray
    lifters: IndexArray
    lifted: IndexArray
    lift: FloatArray
    weight_kg: FloatArray
    mass_kg: FloatArray
    reach_m: float
    robots: int
    radius_m: FloatArray

    @classmethod
    def of(cls, world: WorldModel, scene: Scene, holds: Holds) -> Self:
        """Return the load of robots that hold objects."""
        rows, objects = holds.in_grippers()
        hands, lifted = holds.in_hands()
        together = np.bincount(objects, minlength=len(scene.pushables))
        alone = together[objects] == 1
        sharers, grip_m = rows[~alone], np.zeros((int((~alone).sum()), 3))
        grip_m[:, 0], grip_n = holds.grip[sharers].T
        object_kg = np.array([obj.mass_kg for obj in scene.pushables])
        weight_kg, mass_kg = np.zeros(len(world.robots)), np.zeros(len(world.robots))
        weight_kg[rows] = object_kg[objects] / together[objects]
        mass_kg[rows[alone]] = object_kg[objects[alone]]
        weight_kg[hands] += object_kg[lifted]
        mass_kg[hands] += object_kg[lifted]
        grasp = holds.grasp[rows[alone], GRIPPER]
        size_m = ShapeTable.of(scene).reach_m[len(world.robots) + objects[alone]]
        return cls(
            rows[alone],
            objects[alone],
            grasp,
            sharers,
            objects[~alone],
            grip_m[:, 0],
            grip_n,
            relative(holds.grasp[sharers, GRIPPER], grip_m)[:, :2],
            hands,
            lifted,
            holds.grasp[hands, HAND],
            weight_kg,
            mass_kg,
            float((exact.hypot(grasp[:, 0], grasp[:, 1]) + size_m).max(initial=0.0)),
            len(world.robots),
            np.array([robot.model.radius_m for robot in world.robots]),
        )

    def __bool__(self) -> bool:
        return bool(len(self.carriers) + len(self.sharers) + len(self.lifters))

    def spin_radps(self, bodies: Bodies, pull: Pull, timestep_s: float) -> FloatArray:
        """Return the turn rates of mounts in a cycle, 0 for robots with empty grippers."""
        spin_radps = np.zeros(self.robots)
        if pull.mount_rad is not None:
            for rows in (self.carriers, self.sharers):
                turn_rad = wrapped(pull.mount_rad[rows] - bodies.angle_rad[rows])
                spin_radps[rows] = turn_rad / timestep_s
        return spin_radps

    def place(self, bodies: Bodies, pull: Pull) -> None:
        """Move carried objects to their poses at the end of a cycle.

        Args:
            bodies: changed in place; the robots have been moved already.
            pull: the motion of the drives in the cycle.
        """
        assert pull.mount_rad is not None
        robots = slice(self.robots)
        bodies.angle_rad[robots] = pull.mount_rad
        bodies.spin_radps[robots] = 0.0
        frames = np.column_stack([bodies.position_m[robots], pull.mount_rad])
        self._put(bodies, self.carried, compose(frames[self.carriers], self.grasp))
        if len(self.lifters):
            assert pull.hand is not None
            hands = compose(frames[self.lifters], pull.hand[self.lifters])
            self._put(bodies, self.lifted, compose(hands, self.lift))

    def slip_m(self, bodies: Bodies) -> FloatArray:
        """Return the slip of shared objects from the centre of the fingers, (s,)."""
        mounts = np.column_stack([bodies.position_m, bodies.angle_rad])
        fingers, points = np.zeros((2, len(self.sharers), 3))
        fingers[:, 0], points[:, :2] = self.grip_m, self.point_m
        fingers = compose(mounts[self.sharers], fingers)
        points = compose(mounts[self.robots + self.shared], points)
        return np.asarray(exact.hypot(*(fingers - points)[:, :2].T))

    def owned(
        self, pairs: IndexArray, places: FloatArray, position_m: FloatArray
    ) -> tuple[IndexArray, IndexArray]:
        """Assign contacts of robots' bodies to the objects that they carry.

        Args:
            pairs: the bodies in contact, (contacts, 2).
            places: x, y and distance [m] of each contact.
            position_m: the positions of all bodies.

        Returns:
            the pairs with carried objects in place of their carriers, and the rows that have one.
        """
        carries = np.full(len(position_m) + 1, -1, dtype=np.intp)
        carries[self.carriers] = self.robots + self.carried
        radius_m = np.append(self.radius_m, 0.0)
        given, by_load = pairs.copy(), np.zeros(len(pairs), dtype=np.bool_)
        for side in (0, 1):
            body = pairs[:, side]
            robot = np.minimum(body, self.robots)
            away_m = exact.hypot(*(places[:, :2] - position_m[body]).T)
            far = (body < self.robots) & (carries[robot] >= 0) & (away_m > radius_m[robot] + _OWN_M)
            given[far, side] = carries[robot[far]]
            by_load |= far
        return given, np.flatnonzero(by_load)

    def _put(self, bodies: Bodies, objects: IndexArray, poses: FloatArray) -> None:
        rows = self.robots + objects
        bodies.position_m[rows], bodies.angle_rad[rows] = poses[:, :2], wrapped(poses[:, 2])
        bodies.velocity_mps[rows] = bodies.spin_radps[rows] = 0.0


def release(state: EnvState, rows: IndexArray) -> None:
    """Release all objects from the grippers and hands of robots, at rest.

    The physics must be restarted from this state.
    """
    holds = state.bodies.holds
    objects = holds.object[rows]
    for kind in (GRIPPER, HAND):
        holds.drop(rows, kind)
    recompute_grasps(state, objects[objects >= 0].astype(np.intp))


def recompute_grasps(state: EnvState, objects: IndexArray) -> None:
    """Recompute the grasps of objects from the current poses."""
    bodies, holds = state.bodies, state.bodies.holds
    rows, held = holds.in_grippers()
    rows, held = rows[np.isin(held, objects)], held[np.isin(held, objects)]
    bodies.angle_rad[rows] = state.mount_rad[rows]
    poses = np.column_stack([bodies.position_m, bodies.angle_rad])
    holds.grasp[rows, GRIPPER] = relative(poses[rows], poses[len(state.heading_rad) + held])
