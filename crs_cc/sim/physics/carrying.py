"""How what robots hold moves with them, without pymunk: who carries what, and where it gets.

- What one gripper holds is a part of its robot: it moves and turns with it, and its weight counts
  for the robot's mass and for the grip of its wheels.
- What several grippers hold is a body of its own that no floor rubs on, and each gripper holds it
  at the middle of its fingers. There it may turn, so that each robot can; the weight is shared.
- What is in the hand of an arm is lifted above everything: it touches nothing, and its weight
  counts as that of what is in a gripper.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Self

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.geometry.frames import compose, relative, wrapped
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.geometry.shape_table import Things
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.bodies import Bodies, Pull
from crs_cc.sim.state.holds import GRIPPER, HAND, Holds

if TYPE_CHECKING:
    from crs_cc.sim.state.env_state import EnvState


_OWN_M: Final = 0.01
"""A contact that is further than this from a robot's body is its load's."""


@dataclass(frozen=True, slots=True)
class Load:
    """What the robots of a world carry; things are numbered among those that can be pushed.

    Attributes:
        carriers: robots whose grippers alone hold something, rising, c of them.
        carried: what each of them holds, (c,).
        grasp: where it is in the frame of the robot's mount, (c, 3).
        sharers: robots that hold something together with others, rising, s of them.
        shared: what each of them holds, (s,).
        grip_m: where it holds that, ahead of the middle of its mount, (s,).
        point_m: the same place in the frame of the thing, (s, 2).
        lifters: robots that have something in their hand, rising.
        lifted: what each of them has.
        lift: where it is in the frame of the hand.
        weight_kg: what each robot bears the weight of, (robots,).
        mass_kg: what moves with each robot as a part of it, (robots,).
        reach_m: how far from the middle of any robot what it carries reaches.
        robots: how many robots there are.
        radius_m: their radii, (robots,).
    """

    carriers: IndexArray
    carried: IndexArray
    grasp: FloatArray
    sharers: IndexArray
    shared: IndexArray
    grip_m: FloatArray
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
        """Return the load of robots that hold something."""
        rows, things = holds.in_grippers()
        hands, lifted = holds.in_hands()
        together = np.bincount(things, minlength=len(scene.pushables))
        alone = together[things] == 1
        sharers, grip_m = rows[~alone], np.zeros((int((~alone).sum()), 3))
        models = [world.robots[robot].model for robot in sharers.tolist()]
        grip_m[:, 0] = [each.gripper.middle_m if each.gripper else 0.0 for each in models]
        thing_kg = np.array([thing.mass_kg for thing in scene.pushables])
        weight_kg, mass_kg = np.zeros(len(world.robots)), np.zeros(len(world.robots))
        weight_kg[rows] = thing_kg[things] / together[things]
        mass_kg[rows[alone]] = thing_kg[things[alone]]
        weight_kg[hands] += thing_kg[lifted]
        mass_kg[hands] += thing_kg[lifted]
        grasp = holds.grasp[rows[alone], GRIPPER]
        size_m = Things.of(scene).reach_m[len(world.robots) + things[alone]]
        return cls(
            rows[alone],
            things[alone],
            grasp,
            sharers,
            things[~alone],
            grip_m[:, 0],
            relative(holds.grasp[sharers, GRIPPER], grip_m)[:, :2],
            hands,
            lifted,
            holds.grasp[hands, HAND],
            weight_kg,
            mass_kg,
            float((np.hypot(grasp[:, 0], grasp[:, 1]) + size_m).max(initial=0.0)),
            len(world.robots),
            np.array([robot.model.radius_m for robot in world.robots]),
        )

    def __bool__(self) -> bool:
        return bool(len(self.carriers) + len(self.sharers) + len(self.lifters))

    def spin_radps(self, bodies: Bodies, pull: Pull, timestep_s: float) -> FloatArray:
        """Return how fast the mounts of robots turn in a cycle, 0 for those with empty fingers."""
        spin_radps = np.zeros(self.robots)
        if pull.mount_rad is not None:
            for rows in (self.carriers, self.sharers):
                turn_rad = wrapped(pull.mount_rad[rows] - bodies.angle_rad[rows])
                spin_radps[rows] = turn_rad / timestep_s
        return spin_radps

    def place(self, bodies: Bodies, pull: Pull) -> None:
        """Puts what robots carry where it is at the end of a cycle.

        Args:
            bodies: changed in place; the robots are there already.
            pull: what their drives did in the cycle.
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

    def stretch_m(self, bodies: Bodies) -> FloatArray:
        """Return how far what sharers hold has slipped out of the middle of their fingers, (s,)."""
        mounts = np.column_stack([bodies.position_m, bodies.angle_rad])
        fingers, points = np.zeros((2, len(self.sharers), 3))
        fingers[:, 0], points[:, :2] = self.grip_m, self.point_m
        fingers = compose(mounts[self.sharers], fingers)
        points = compose(mounts[self.robots + self.shared], points)
        return np.asarray(np.hypot(*(fingers - points)[:, :2].T))

    def owned(
        self, pairs: IndexArray, places: FloatArray, position_m: FloatArray
    ) -> tuple[IndexArray, IndexArray]:
        """Tells contacts of robots from those of what is a part of them.

        Args:
            pairs: the bodies that touch, (contacts, 2).
            places: x, y and distance [m] of each contact.
            position_m: where all bodies are.

        Returns:
            the pairs with the carried things in place of their carriers, and in which rows one is.
        """
        carries = np.full(len(position_m) + 1, -1, dtype=np.intp)
        carries[self.carriers] = self.robots + self.carried
        radius_m = np.append(self.radius_m, 0.0)
        given, by_load = pairs.copy(), np.zeros(len(pairs), dtype=np.bool_)
        for side in (0, 1):
            body = pairs[:, side]
            robot = np.minimum(body, self.robots)
            away_m = np.hypot(*(places[:, :2] - position_m[body]).T)
            far = (body < self.robots) & (carries[robot] >= 0) & (away_m > radius_m[robot] + _OWN_M)
            given[far, side] = carries[robot[far]]
            by_load |= far
        return given, np.flatnonzero(by_load)

    def _put(self, bodies: Bodies, things: IndexArray, poses: FloatArray) -> None:
        rows = self.robots + things
        bodies.position_m[rows], bodies.angle_rad[rows] = poses[:, :2], wrapped(poses[:, 2])
        bodies.velocity_mps[rows] = bodies.spin_radps[rows] = 0.0


def release(state: EnvState, rows: IndexArray) -> None:
    """Takes everything out of the fingers and hands of robots; it rests where it is.

    The physics must start from there.
    """
    holds = state.bodies.holds
    things = holds.thing[rows]
    for kind in (GRIPPER, HAND):
        holds.drop(rows, kind)
    grasp_anew(state, things[things >= 0].astype(np.intp))


def grasp_anew(state: EnvState, things: IndexArray) -> None:
    """Record how grippers hold things, as robots and things stand now."""
    bodies, holds = state.bodies, state.bodies.holds
    rows, held = holds.in_grippers()
    rows, held = rows[np.isin(held, things)], held[np.isin(held, things)]
    bodies.angle_rad[rows] = state.mount_rad[rows]
    poses = np.column_stack([bodies.position_m, bodies.angle_rad])
    holds.grasp[rows, GRIPPER] = relative(poses[rows], poses[len(state.heading_rad) + held])
