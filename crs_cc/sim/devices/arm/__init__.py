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

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, any_of
from crs_cc.core.quantity import ANGLE
from crs_cc.core.units import m_to_tenths_inch, rad_to_tenths_deg, tenths_deg_to_rad
from crs_cc.requests import LARGEST, device_request
from crs_cc.requests.request import fields
from crs_cc.robot_api.row import OURS, Function
from crs_cc.sim.devices.arm.model import Arm, read
from crs_cc.sim.devices.arm.state import ArmState, arm_of
from crs_cc.sim.devices.collision_free import is_space_free
from crs_cc.sim.devices.grasp_choice import COMMANDS, can_be_taken, nearest
from crs_cc.sim.devices.installed import Installed
from crs_cc.sim.geometry.cell_list import CellList
from crs_cc.sim.geometry.frames import compose, relative
from crs_cc.sim.model.degradable import Degradable, elements_of
from crs_cc.sim.model.device import Device
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
        models = [robot.model.device("arm") for robot in world.robots]
        found: list[Arm] = [model for model in models if model is not None]
        self._rows = np.flatnonzero([model is not None for model in models])
        self._shoulder_m = _table([(arm.x_m, arm.y_m) for arm in found])
        self._link_m = _table([(arm.upper_m, arm.fore_m) for arm in found])
        self._least_rad = _table([(arm.shoulder_least_rad, arm.elbow_least_rad) for arm in found])
        self._most_rad = _table([(arm.shoulder_most_rad, arm.elbow_most_rad) for arm in found])
        self._speed_radps = _table([(arm.shoulder_radps, arm.elbow_radps) for arm in found])
        self._hand_m = np.array([arm.hand_m for arm in found])
        self._most_kg = np.array([arm.most_kg for arm in found])

    def move(self, context: RequestContext) -> BoolArray:
        """Answer ARM: turn joints to angles, or by angles; refuse robots without an arm."""
        state, arm = context.state, arm_of(context.state)
        mine = context.constants.numbers["arm"][context.rows]
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
        mine = context.constants.numbers["arm"][context.rows]
        has = np.asarray(mine >= 0)
        which = mine[has]
        angles_rad = self._angles_rad(context.state, which, context.at_s[has])
        angles = np.rint(rad_to_tenths_deg(angles_rad))
        tip = np.rint(m_to_tenths_inch(self._hands(which, angles_rad)[:, :2]))
        pushables = context.constants.scene.pushables
        held = context.state.bodies.holds.object[self._rows[which], HAND].tolist()
        mass_kg = [pushables[obj].mass_kg if obj >= 0 else 0.0 for obj in held]
        weight_g = np.array(mass_kg) * _GRAMS
        columns = (*angles.T, *tip.T, np.minimum(np.rint(weight_g), LARGEST))
        for name, column in zip(("shoulder", "elbow", "x", "y", "weight"), columns, strict=True):
            context.put(name, column, has)
        return has

    def hand(self, context: RequestContext) -> BoolArray:
        """Answer HAND: close or open it; refuse robots without an arm, and invalid values."""
        mine, close = context.constants.numbers["arm"][context.rows], context["close"]
        good = (mine >= 0) & (close >= 0) & (close <= 1)
        which, closed, arm = mine[good], close[good] == 1, arm_of(context.state)
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

    def act(self, state: EnvState) -> bool:
        """Return whether any hand is to grasp or release at the end of this cycle."""
        return bool(arm_of(state).acts.any())

    def end_cycle(self, state: EnvState, constants: RobotConstants, end_s: float) -> bool:
        """Make hands grasp and release objects; return whether any did."""
        rows, arm = self._rows, arm_of(state)
        if not any_of(arm.acts):
            return False
        held = state.bodies.holds.object[rows, HAND] >= 0
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
        arm = arm_of(state)
        most_rad = self._speed_radps[which] * (at_s - arm.since_s[which])[:, None]
        turn_rad = arm.to_rad[which] - arm.from_rad[which]
        return np.asarray(
            arm.from_rad[which] + np.minimum(np.maximum(turn_rad, -most_rad), most_rad)
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
        bodies, objects = state.bodies, constants.shapes
        hands = self._in_world(state, end_s)[closing]
        pushables = np.arange(robots, robots + len(scene.pushables))
        poses = objects.poses(bodies)
        reach_m = float(self._hand_m[closing].max() + objects.reach_m[pushables].max())
        cells = CellList(poses[pushables, 0], poses[pushables, 1], reach_m)
        hand, found = cells.near(hands[:, 0], hands[:, 1])
        away_m = objects.distance_m(poses, pushables[found], hands[hand, 0], hands[hand, 1])
        good = can_be_taken(scene, found, self._most_kg[closing[hand]])
        good &= away_m <= self._hand_m[closing[hand]]
        good &= ~np.isin(found, bodies.holds.object)
        taken: list[int] = []
        for pair in nearest(hand, away_m, good).tolist():
            obj, robot = int(found[pair]), int(self._rows[closing[hand[pair]]])
            if obj not in taken:
                taken.append(obj)
                grasp = relative(hands[[hand[pair]]], poses[[robots + obj]])
                bodies.holds.take(np.array([robot]), HAND, np.array([obj]), grasp)
                self._log.say(end_s, "grip", f"took {scene.pushables[obj].id}", robot)
        return bool(taken)

    def _open(self, state: EnvState, constants: RobotConstants, which: int, end_s: float) -> bool:
        """Release a hand's object if the space below is free; return whether it did."""
        row, scene = self._rows[which], constants.scene
        obj = int(state.bodies.holds.object[row, HAND])
        if not is_space_free(constants, state.bodies, obj):
            return False
        state.bodies.holds.drop(self._rows[[which]], HAND)
        arm_of(state).acts[which] = False
        self._log.say(end_s, "release", f"released {scene.pushables[obj].id}", int(row))
        return True

    def _in_world(self, state: EnvState, at_s: float) -> FloatArray:
        """Return the world poses of the hands of all arms at the end of a cycle, (n, 3)."""
        rows = self._rows
        mounts = np.column_stack([state.bodies.position_m[rows], state.mount_rad[rows]])
        return compose(mounts, self.poses(state, at_s)[rows])


def _table(rows: list[tuple[float, float]]) -> FloatArray:
    return np.array(rows, dtype=np.float64).reshape(-1, 2)


def install(_row: Device, world: WorldModel, _seed: int, log: EventLog) -> Installed:
    """Return the arms of a world's robots."""
    arms = Arms(world, log)
    handlers = {"ARM": arms.move, "GET_ARM": arms.get_arm, "HAND": arms.hand}
    return Installed(handlers=handlers, device=arms)


def inspect(state: EnvState, number: int) -> str:
    """Return the commanded joint angles, and the command of the hand."""
    arm = arm_of(state)
    shoulder, elbow = map(ANGLE.show, arm.to_rad[number].tolist())
    command = "close" if arm.closed[number] else "open"
    return f"shoulder to {shoulder}, elbow to {elbow}, hand: {command}"


_DEG: Final = "0.1 deg"

DEVICE = Device(
    name="arm",
    title="Arm",
    element="arm",
    summary="Two links that rotate in a plane above all objects, with a hand at the end;"
    " programs control them with crs_arm_move() and crs_hand() (crs.h).",
    model=Arm,
    read=read,
    state=ArmState.at_start,
    install=install,
    requests=(
        device_request(
            "ARM", 222, "int crs_arm_move(int shoulder, int elbow)", "turns the joints of the arm",
            fields(
                ("relative", "i[0]", "1", "0 to angles, else on by angles"),
                ("shoulder", "i[1]", _DEG, "shoulder"), ("elbow", "i[2]", _DEG, "elbow"),
            ),
        ),
        device_request(
            "GET_ARM", 223, "int crs_arm_get(int *shoulder, int *elbow, int *x, int *y)",
            "reads the position of the arm and what is in its hand",
            results=fields(
                ("shoulder", "i[0]", _DEG, "shoulder"), ("elbow", "i[1]", _DEG, "elbow"),
                ("x", "i[2]", "0.1 in", "tip, ahead of the robot's middle"),
                ("y", "i[3]", "0.1 in", "tip, to the left of it"),
                ("weight", "i[4]", "g", "weight of what is in the hand, 0 for nothing"),
            ),
        ),
        device_request(
            "HAND", 224, "int crs_hand(int what)", "opens or closes the hand",
            fields(("close", "i[0]", "1", "0 to open, 1 to close")),
        ),
    ),
    functions=(
        Function(
            "int crs_arm_move(int shoulder, int elbow)",
            "turns the joints of the arm to these angles, and returns immediately; 0, 0 is straight"
            " ahead", units=_DEG, posts=("ARM",), source=(OURS,),
        ),
        Function(
            "int crs_arm_turn(int shoulder, int elbow)",
            "turns the joints by these angles, relative to their current position, and returns"
            " immediately", units=_DEG, posts=("ARM",), source=(OURS,),
        ),
        Function(
            "int crs_arm_get(int *shoulder, int *elbow, int *x, int *y)",
            "returns the joint angles, and the position of the tip: forward of the robot's centre,"
            " and to the left. Pointers may be NULL", units="0.1 deg, 0.1 in",
            posts=("GET_ARM",), source=(OURS,),
        ),
        Function(
            "int crs_hand(int what)",
            "closes the hand (CRS_CLOSE) on the object at the tip, or opens it (CRS_OPEN) as soon"
            " as there is room below; returns immediately", posts=("HAND",), source=(OURS,),
        ),
        Function(
            "int crs_get_hand(int *weight)",
            "returns the weight of the object in the hand, 0 for none",
            units="g", posts=("GET_ARM",), source=(OURS,),
        ),
    ),
    declarations=COMMANDS,
    degradables=(
        Degradable(
            "arm", "commanded angle of a joint", ANGLE,
            elements_of("arm", lambda _model: ("shoulder", "elbow")), 2,
            "the command is not received",
            acts=True,
        ),
    ),
    inspect=inspect,
    source=__file__,
)  # fmt: skip
