"""The arm: two links that turn in a plane, and a hand that grasps and releases objects.

    joint angle = angle at the command + rest of the turn, at most speed * time since
    elbow       = shoulder position + upper * (cos s, sin s)
    tip         = elbow + fore * (cos (s + e), sin (s + e))      direction of the hand: s + e

s and e are the angles of shoulder and elbow, counter-clockwise, 0 for straight; all in the frame of
the mount. Both joints turn at the same time, each at a constant speed, until they reach their
targets; targets beyond the limits are clipped.

The arm moves above everything, and so does the object in its hand: it touches nothing, but beams
see it. At the end of the cycle in which it receives the command to close, the hand grasps the
pushable object that is not too heavy, not held by anybody, and has its nearest point nearest to the
tip, within the reach of the hand; from then on the object moves with the hand. After the command to
open, it releases the object as soon as the space below is free: the object is at rest there. All of
this was chosen by us.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.core.units import m_to_tenths_inch, rad_to_tenths_deg, tenths_deg_to_rad
from crs_cc.requests import LARGEST
from crs_cc.sim.devices.collision_free import is_space_free
from crs_cc.sim.devices.grasp_choice import can_be_taken, nearest
from crs_cc.sim.geometry.cell_list import CellList
from crs_cc.sim.geometry.frames import compose, relative
from crs_cc.sim.state.holds import HAND

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.events import EventLog


_GRAMS: Final = 1000.0


class Arms:
    """The arms of all robots that have one."""

    def __init__(self, world: WorldModel, log: EventLog) -> None:
        self._log = log
        has = [number for number, robot in enumerate(world.robots) if robot.model.arm]
        found = [arm for robot in world.robots if (arm := robot.model.arm) is not None]
        joints = [(arm.shoulder, arm.elbow) for arm in found]
        self._rows = np.array(has, dtype=np.intp)
        self._shoulder_m = _table([(arm.x_m, arm.y_m) for arm in found])
        self._link_m = _table([(arm.upper_m, arm.fore_m) for arm in found])
        self._least_rad = _table([(one.least_rad, two.least_rad) for one, two in joints])
        self._most_rad = _table([(one.most_rad, two.most_rad) for one, two in joints])
        self._speed_radps = _table([(one.speed_radps, two.speed_radps) for one, two in joints])
        self._hand_m = np.array([arm.hand_m for arm in found])
        self._most_kg = np.array([arm.most_kg for arm in found])

    def move(self, context: RequestContext) -> BoolArray:
        """Answer ARM: turn joints to angles, or by angles; refuse robots without an arm."""
        state, arm = context.state, context.state.arm
        mine = context.constants.arm[context.rows]
        has = mine >= 0
        which, at_s = mine[has], context.at_s[has]
        now_rad = self._angles_rad(state, which, at_s)
        angles = context.columns("shoulder", "elbow")[has]
        to_rad = tenths_deg_to_rad(angles.astype(np.float64))
        to_rad += np.where(context["relative"][has, None] != 0, now_rad, 0.0)
        to_rad = context.constants.degradations.alter(state, "arm", context.rows[has], to_rad, at_s)
        to_rad = np.where(np.isfinite(to_rad), to_rad, arm.to_rad[which])
        arm.from_rad[which], arm.since_s[which] = now_rad, at_s
        within_rad = np.minimum(np.maximum(to_rad, self._least_rad[which]), self._most_rad[which])
        arm.to_rad[which] = within_rad
        return np.asarray(has)

    def get_arm(self, context: RequestContext) -> BoolArray:
        """Answer GET_ARM with joint angles, position of the tip and weight of the held object."""
        mine = context.constants.arm[context.rows]
        has = np.asarray(mine >= 0)
        which = mine[has]
        angles_rad = self._angles_rad(context.state, which, context.at_s[has])
        angles = np.rint(rad_to_tenths_deg(angles_rad))
        tip = np.rint(m_to_tenths_inch(self._hands(which, angles_rad)[:, :2]))
        pushables = context.constants.scene.pushables
        held = context.state.bodies.holds.thing[self._rows[which], HAND].tolist()
        mass_kg = [pushables[thing].mass_kg if thing >= 0 else 0.0 for thing in held]
        weight_g = np.array(mass_kg) * _GRAMS
        columns = (*angles.T, *tip.T, np.minimum(np.rint(weight_g), LARGEST))
        for name, column in zip(("shoulder", "elbow", "x", "y", "weight"), columns, strict=True):
            context.put(name, column, has)
        return has

    def hand(self, context: RequestContext) -> BoolArray:
        """Answer HAND: close or open it; refuse robots without an arm, and invalid values."""
        mine, close = context.constants.arm[context.rows], context["close"]
        good = (mine >= 0) & (close >= 0) & (close <= 1)
        which, closed, arm = mine[good], close[good] == 1, context.state.arm
        arm.acts[which] |= arm.closed[which] != closed
        arm.closed[which] = closed
        return np.asarray(good)

    def poses(self, state: EnvState, at_s: float) -> FloatArray:
        """Return the poses of all robots' hands in the frames of their mounts, (robots, 3).

        x, y [m] and direction [rad]; 0 for robots without an arm.
        """
        poses, which = np.zeros((len(state.heading_rad), 3)), np.arange(len(self._rows))
        angles_rad = self._angles_rad(state, which, np.full(len(which), at_s))
        poses[self._rows] = self._hands(which, angles_rad)
        return poses

    def end_cycle(self, state: EnvState, constants: RobotConstants, end_s: float) -> bool:
        """Make hands grasp and release objects; return whether any did."""
        if not state.arm.acts.any():
            return False
        rows, arm = self._rows, state.arm
        held = state.bodies.holds.thing[rows, HAND] >= 0
        opening = np.flatnonzero(arm.acts & ~arm.closed)
        closing = np.flatnonzero(arm.acts & arm.closed & ~held)
        arm.acts[arm.closed] = False
        arm.acts[opening[~held[opening]]] = False
        opened = [
            self._open(state, constants, arm, end_s) for arm in opening[held[opening]].tolist()
        ]
        took = self._close(state, constants, closing, end_s)
        return any(opened) or took

    def _angles_rad(self, state: EnvState, which: IndexArray, at_s: FloatArray) -> FloatArray:
        arm = state.arm
        most_rad = self._speed_radps[which] * (at_s - arm.since_s[which])[:, None]
        way_rad = arm.to_rad[which] - arm.from_rad[which]
        return np.asarray(
            arm.from_rad[which] + np.minimum(np.maximum(way_rad, -most_rad), most_rad)
        )

    def _hands(self, which: IndexArray, angles_rad: FloatArray) -> FloatArray:
        """Return the poses of hands in the frames of the mounts, (k, 3)."""
        nothing = np.zeros(len(which))
        upper, fore = (np.column_stack([each, nothing, nothing]) for each in self._link_m[which].T)
        shoulders = np.column_stack([self._shoulder_m[which], angles_rad[:, 0]])
        elbows = compose(shoulders, upper)
        elbows[:, 2] += angles_rad[:, 1]
        return compose(elbows, fore)

    def _close(
        self, state: EnvState, constants: RobotConstants, closing: IndexArray, end_s: float
    ) -> bool:
        """Grasp the objects at the hands' tips; of two hands at one object the first gets it."""
        scene, robots = constants.scene, len(state.heading_rad)
        if not len(closing) or not scene.pushables:
            return False
        bodies, things = state.bodies, constants.shapes
        hands = self._in_world(state, end_s)[closing]
        pushables = np.arange(robots, robots + len(scene.pushables))
        poses = things.poses(bodies)
        reach_m = float(self._hand_m[closing].max() + things.reach_m[pushables].max())
        cells = CellList(poses[pushables, 0], poses[pushables, 1], reach_m)
        hand, found = cells.near(hands[:, 0], hands[:, 1])
        away_m = things.distance_m(poses, pushables[found], hands[hand, 0], hands[hand, 1])
        good = can_be_taken(scene, found, self._most_kg[closing[hand]])
        good &= away_m <= self._hand_m[closing[hand]]
        good &= ~np.isin(found, bodies.holds.thing)
        taken: list[int] = []
        for pair in nearest(hand, away_m, good).tolist():
            thing, robot = int(found[pair]), int(self._rows[closing[hand[pair]]])
            if thing not in taken:
                taken.append(thing)
                grasp = relative(hands[[hand[pair]]], poses[[robots + thing]])
                bodies.holds.take(np.array([robot]), HAND, np.array([thing]), grasp)
                self._log.say(end_s, "grip", f"took {scene.pushables[thing].id}", robot)
        return bool(taken)

    def _open(self, state: EnvState, constants: RobotConstants, which: int, end_s: float) -> bool:
        """Release a hand's object if the space below is free; return whether it did."""
        row, scene = self._rows[which], constants.scene
        thing = int(state.bodies.holds.thing[row, HAND])
        if not is_space_free(constants, state.bodies, thing):
            return False
        state.bodies.holds.drop(self._rows[[which]], HAND)
        state.arm.acts[which] = False
        self._log.say(end_s, "release", f"released {scene.pushables[thing].id}", int(row))
        return True

    def _in_world(self, state: EnvState, at_s: float) -> FloatArray:
        """Return the world poses of the hands of all arms at the end of a cycle, (n, 3)."""
        rows = self._rows
        mounts = np.column_stack([state.bodies.position_m[rows], state.mount_rad[rows]])
        return compose(mounts, self.poses(state, at_s)[rows])


def _table(rows: list[tuple[float, float]]) -> FloatArray:
    return np.array(rows, dtype=np.float64).reshape(-1, 2)
