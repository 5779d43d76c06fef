"""The gripper: two fingers that close on an object between them, and carry it.

    distance of the fingers = distance at the command + or - opening * time since / closing time

`crs_gripper` returns at once, while the fingers move. They are no bodies: they pass through
everything. When, at the end of a cycle, their distance has reached the width of an object between
them, they hold it: the nearest pushable object to the palm that is not too heavy, whose part
between palm and tips is within the opening, and that is not in any hand. From then on it moves with
the robot (`carrying`), and the distance of the fingers is its width. After the command to open, it
is at rest where it is.

A beam from finger to finger, half-way between palm and tips, detects objects. All of this was
chosen by us, after the gripper of the Pioneer, whose fingers close in parallel and have such beams.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.core.quantity import RATIO
from crs_cc.core.units import m_to_tenths_inch
from crs_cc.requests import LARGEST, device_request
from crs_cc.requests.request import fields
from crs_cc.robot_api.row import OURS, Function
from crs_cc.sim.devices.grasp_choice import COMMANDS, can_be_taken, nearest
from crs_cc.sim.devices.gripper.fingers import between
from crs_cc.sim.devices.gripper.model import Gripper, read
from crs_cc.sim.devices.gripper.state import GripperState, gripper_of
from crs_cc.sim.devices.installed import Installed
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.model.degradable import Degradable, elements_of
from crs_cc.sim.model.device import Device
from crs_cc.sim.physics.carrying import recompute_grasps
from crs_cc.sim.state.holds import GRIPPER

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.bodies import Contacts
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.events import EventLog


_CLOSE: Final = 0.5
_SAME_M: Final = 1e-9
_GRAMS: Final = 1000.0


class Grippers:
    """The grippers of all robots that have one.

    Attributes:
        fans: the beams between their fingers.
    """

    def __init__(self, world: WorldModel, log: EventLog) -> None:
        self._log = log
        models = [robot.model.device("gripper") for robot in world.robots]
        found: list[Gripper] = [model for model in models if model is not None]
        kinds = list(dict.fromkeys(found))
        self._rows = np.flatnonzero([model is not None for model in models])
        self._opening_m = np.array([each.opening_m for each in found], dtype=np.float64)
        self._speed_mps = np.array([each.opening_m / each.closing_s for each in found])
        self._most_kg = np.array([each.most_kg for each in found])
        strips = [(each.place_m, each.place_m + each.reach_m) for each in found]
        self._strip_m = np.array(strips, dtype=np.float64).reshape(-1, 2)
        self._grip = np.array([(each.middle_m, each.force_n) for each in found]).reshape(-1, 2)
        self._kind = np.array([kinds.index(each) for each in found], dtype=np.intp)
        self.fans = [_beam(kind) for kind in kinds]

    def move(self, context: RequestContext) -> BoolArray:
        """Answer GRIPPER: open or close; refuse robots without one, and invalid values."""
        mine, close = context.constants.numbers["gripper"][context.rows], context["close"]
        good = (mine >= 0) & (close >= 0) & (close <= 1)
        which, at_s = mine[good], context.at_s[good]
        state, gripper = context.state, gripper_of(context.state)
        commanded = context.constants.degradations.alter(
            state, "gripper", context.rows[good], close[good, None].astype(np.float64), at_s
        )[:, 0]
        closing = commanded >= _CLOSE
        new = (gripper.closing[which] != closing) & np.isfinite(commanded)
        which, at_s, closing = which[new], at_s[new], closing[new]
        gripper.from_m[which] = self._current_opening_m(state, which, at_s)
        gripper.since_s[which], gripper.closing[which] = at_s, closing
        return np.asarray(good)

    def get_gripper(self, context: RequestContext) -> BoolArray:
        """Answer GET_GRIPPER with the distance of the fingers, their beam and the weight."""
        mine = context.constants.numbers["gripper"][context.rows]
        has = np.asarray(mine >= 0)
        which, rows = mine[has], context.rows[has]
        apart_m = self._current_opening_m(context.state, which, context.at_s[has])
        context.put("opening", np.rint(m_to_tenths_inch(apart_m)), has)
        context.put("beam", self._broken(context, which, rows), has)
        weight_g = np.rint(_weight_kg(context.state, context.constants, rows) * _GRAMS)
        context.put("weight", np.minimum(weight_g, LARGEST), has)
        return has

    def __len__(self) -> int:
        return len(self._rows)

    def end_cycle(
        self, state: EnvState, constants: RobotConstants, contacts: Contacts, end_s: float
    ) -> bool:
        """Make grippers grasp, release and lose objects; return whether any did."""
        if not len(self._rows):
            return False
        gripper, held = gripper_of(state), state.bodies.holds.object[self._rows, GRIPPER]
        torn, opens = np.isin(self._rows, contacts.torn), (held >= 0) & ~gripper.closing
        gone = np.flatnonzero(torn | opens)
        if len(gone):
            self._release(state, constants, gone, torn[gone], end_s)
        free = state.bodies.holds.object[self._rows, GRIPPER] < 0
        gripper.width_m[free] = 0.0
        apart_m = self._current_opening_m(
            state, np.arange(len(self._rows)), np.full(len(self._rows), end_s)
        )
        closed = free & gripper.closing & (apart_m < gripper.before_m)
        taken = self._take(state, constants, np.flatnonzero(closed), apart_m, end_s)
        gripper.before_m = np.where(gripper.width_m > 0.0, gripper.width_m, apart_m)
        return bool(len(gone)) or taken

    def _current_opening_m(
        self, state: EnvState, which: IndexArray, at_s: FloatArray
    ) -> FloatArray:
        """Return the distance between the fingers of grippers."""
        gripper = gripper_of(state)
        travel_m = (at_s - gripper.since_s[which]) * self._speed_mps[which]
        closing = gripper.closing[which]
        apart_m = gripper.from_m[which] + np.where(closing, -travel_m, travel_m)
        least_m = np.where(closing, gripper.width_m[which], 0.0)
        return np.asarray(np.minimum(np.maximum(apart_m, least_m), self._opening_m[which]))

    def _broken(self, context: RequestContext, which: IndexArray, rows: IndexArray) -> BoolArray:
        broken = np.zeros(len(rows), dtype=np.bool_)
        kinds = self._kind[which]
        for kind in sorted(set(kinds.tolist())):
            mine = kinds == kind
            poses = mount_poses(context.state, context.constants, rows[mine])
            seen = context.rays.distances_m(context.state, self.fans[kind], poses, rows[mine])
            broken[mine] = np.isfinite(seen[:, 0])
        return broken

    def _take(
        self,
        state: EnvState,
        constants: RobotConstants,
        closing: IndexArray,
        apart_m: FloatArray,
        end_s: float,
    ) -> bool:
        """Grasp the objects that closing fingers have reached."""
        if not len(closing):
            return False
        bodies, scene, robots = state.bodies, constants.scene, len(state.heading_rad)
        fingers = gripper_of(state)
        moving = scene.moving(bodies.position_m, bodies.angle_rad)
        rows = self._rows[closing]
        mounts = np.column_stack([bodies.position_m[rows], state.mount_rad[rows]])
        found = between(moving, robots, mounts, self._strip_m[closing])
        which, obj = closing[found.gripper], found.object - robots
        half_m = self._opening_m[which] / 2 + _SAME_M
        fits = (found.right_m >= -half_m) & (found.left_m <= half_m)
        fits &= found.width_m >= apart_m[which] - _SAME_M
        fits &= found.width_m <= fingers.before_m[which] + _SAME_M
        fits &= can_be_taken(scene, obj, self._most_kg[which])
        fits &= ~np.isin(obj, bodies.holds.in_hands()[1])
        first = nearest(which, found.near_m, fits)
        if not len(first):
            return False
        takers, objects = which[first], obj[first]
        fingers.width_m[takers] = np.maximum(found.width_m[first], _SAME_M)
        bodies.holds.take(self._rows[takers], GRIPPER, objects, np.zeros((len(first), 3)))
        bodies.holds.grip[self._rows[takers]] = self._grip[takers]
        recompute_grasps(state, objects)
        for gripper, number in zip(takers.tolist(), objects.tolist(), strict=True):
            name = scene.pushables[number].id
            self._log.say(end_s, "grip", f"took {name}", int(self._rows[gripper]))
        return True

    def _release(
        self,
        state: EnvState,
        constants: RobotConstants,
        gone: IndexArray,
        torn: BoolArray,
        end_s: float,
    ) -> None:
        """Release objects from grippers; they rest where they are."""
        rows, bodies, gripper = self._rows[gone], state.bodies, gripper_of(state)
        objects = bodies.holds.object[rows, GRIPPER].astype(np.intp)
        bodies.holds.drop(rows, GRIPPER)
        still = objects[~np.isin(objects, bodies.holds.in_grippers()[1])] + len(state.heading_rad)
        bodies.velocity_mps[still] = bodies.spin_radps[still] = 0.0
        recompute_grasps(state, objects)
        for robot, obj, lost in zip(rows.tolist(), objects.tolist(), torn.tolist(), strict=True):
            name = constants.scene.pushables[obj].id
            kind, text = ("lost", f"lost {name}") if lost else ("release", f"released {name}")
            self._log.say(end_s, kind, text, robot)
        lost = gone[torn]
        gripper.from_m[lost], gripper.since_s[lost] = gripper.width_m[lost], end_s


def _weight_kg(state: EnvState, constants: RobotConstants, rows: IndexArray) -> FloatArray:
    """Return the weights in the grippers; several that hold one object share it equally."""
    holds, pushables = state.bodies.holds, constants.scene.pushables
    held = holds.object[rows, GRIPPER]
    together = np.bincount(holds.in_grippers()[1], minlength=len(pushables) + 1)[held]
    mass_kg = [pushables[obj].mass_kg if obj >= 0 else 0.0 for obj in held.tolist()]
    return np.asarray(np.array(mass_kg) / np.maximum(together, 1))


def _beam(gripper: Gripper) -> Fan:
    half_m = gripper.opening_m / 2
    return Fan.of([(gripper.middle_m, half_m, -math.pi / 2, 0.0, gripper.opening_m)])


def install(_row: Device, world: WorldModel, _seed: int, log: EventLog) -> Installed:
    """Return the grippers of a world's robots."""
    grippers = Grippers(world, log)
    handlers = {"GRIPPER": grippers.move, "GET_GRIPPER": grippers.get_gripper}
    return Installed(handlers=handlers, fans=grippers.fans, device=grippers)


def inspect(state: EnvState, number: int) -> str:
    """Return the last command, and the distance of the fingers at the end of the last cycle."""
    gripper = gripper_of(state)
    command = "close" if gripper.closing[number] else "open"
    return f"{command}, fingers {100 * gripper.before_m[number]:.1f} cm apart"


DEVICE = Device(
    name="gripper",
    title="Gripper",
    element="gripper",
    summary="Two fingers in front of the robot that grip and carry objects; programs control them"
    " with crs_gripper() (crs.h).",
    model=Gripper,
    read=read,
    state=GripperState.at_start,
    install=install,
    requests=(
        device_request(
            "GRIPPER", 220, "int crs_gripper(int what)", "opens or closes the gripper",
            fields(("close", "i[0]", "1", "0 to open, 1 to close")),
        ),
        device_request(
            "GET_GRIPPER", 221, "int crs_get_gripper(int *opening, int *beam, int *weight)",
            "reads the position of the gripper's fingers and what they hold",
            results=fields(
                ("opening", "i[0]", "0.1 in", "distance between the fingers"),
                ("beam", "i[1]", "1", "whether anything is between them"),
                ("weight", "i[2]", "g", "weight of what they hold, 0 for nothing"),
            ),
        ),
    ),
    functions=(
        Function(
            "int crs_gripper(int what)",
            "opens (CRS_OPEN) or closes (CRS_CLOSE) the gripper; returns immediately",
            posts=("GRIPPER",), source=(OURS,),
        ),
        Function(
            "int crs_get_gripper(int *opening, int *beam, int *weight)",
            "returns the distance between the fingers, which is the width of a held object;"
            " whether the beam between them is interrupted; and the weight of the object, 0 for"
            " none. Pointers may be NULL", units="0.1 in, g",
            posts=("GET_GRIPPER",), source=(OURS,),
        ),
    ),
    declarations=COMMANDS,
    degradables=(
        Degradable(
            "gripper",
            "command to the gripper: 0.5 or more to close (normally 1), otherwise to open",
            RATIO,
            elements_of("gripper", lambda _model: ("0",)), 1,
            "the command is not received", acts=True,
        ),
    ),
    inspect=inspect,
    source=__file__,
)  # fmt: skip
