"""Contacts: what happens when robots and things get in each other's way.

This file and `shapes` alone know pymunk.

Seen from above, bodies do not fall. A robot is drawn to the velocity of its wheels, a thing rests
with at most the friction of the floor, and contacts push back. What draws a robot is the smaller of
its motors' force and its wheels' grip; the whole grip holds one that stands. Limp wheels hold the
robot across, and hardly along. Contacts never turn a robot. The cycle is cut into substeps so short
that nothing gets deep into anything.

The arrays of `Bodies` are the only truth about positions and velocities; pymunk's space is loaded
with them at the start of each cycle. A robot that nothing hindered is put exactly where its wheels
took it, so robots that never meet never change each other's results, not even in the last bit.

What a robot carries is a part of it (`carrying`): where that touches something, the robot is held
up or pushed aside, and still not turned. So a load that is turned into a wall slides along it with
its robot; one that cannot, and gets deeper into something than `TORN_M`, is torn out of the
fingers.

What is left inside pymunk, and cannot be read, is the history of its search tree and of its
contacts. It matters where several bodies touch at once. So the space is made anew from the arrays
every `REBUILD` cycles, and a snapshot is the arrays of that moment and the ways of the cycles
since: to restore is to make the space anew and to run these cycles again, to the same bits.
"""

from __future__ import annotations

import math
import weakref
from dataclasses import replace
from typing import Final

import numpy as np
import numpy.typing as npt
import pymunk
from pymunk import batch

from crs_cc.garbage import without_collector
from crs_cc.sim.bodies import NO_CONTACTS, Bodies, Contacts, PhysicsSnapshot, Pull
from crs_cc.sim.geometry.clearance import clearance_m
from crs_cc.sim.geometry.rigid import Rigid
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.ground.inclines import Incline, Inclines
from crs_cc.sim.ground.ledges import Ledges
from crs_cc.sim.handling.carrying import Load
from crs_cc.sim.model import Thing, WorldModel
from crs_cc.sim.shapes import add, add_ground, fixed_shapes, floor_friction, shapes_of, thing_shapes

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]
IndexArray = npt.NDArray[np.intp]

REBUILD: Final = 100
"""Cycles after which the space is made anew."""

SUBSTEP_M: Final = 0.008
"""The furthest that a robot gets in a substep, and so into a wall."""

TORN_M: Final = 0.02
"""How deep a load gets into something before it is torn out of the fingers; chosen by us."""

STRETCH_M: Final = 0.05
"""How far a load that several hold slips out of one's fingers before it is lost; chosen by us."""

MOST_SUBSTEPS: Final = 256
"""How many substeps a cycle has for loads that are swung around."""

_SLOP_M: Final = 0.0005  # overlap that is left alone, so that things at rest stay in contact
_BIAS: Final = 1e-6  # share of a deeper overlap that is left after a second
_SAME: Final = 1e-9  # [m], [m/s]: smaller differences are rounding errors
_FEW_BODIES: Final = 64  # for so few it pays to look first whether anything is near

_MOTION: Final = (
    batch.BodyFields.POSITION | batch.BodyFields.ANGLE
    | batch.BodyFields.VELOCITY | batch.BodyFields.ANGULAR_VELOCITY
)  # fmt: skip
_CONTACT: Final = (
    batch.ArbiterFields.BODY_A_ID | batch.ArbiterFields.BODY_B_ID
    | batch.ArbiterFields.CONTACT_COUNT
    | batch.ArbiterFields.POINT_A_1 | batch.ArbiterFields.DISTANCE_1
)  # fmt: skip
_NO_PAIRS: Final = (np.zeros((0, 2), dtype=np.intp), np.zeros((0, 3)))


class Physics:
    """Moves the bodies of a world through its cycles."""

    def __init__(self, world: WorldModel, scene: Scene, bodies: Bodies) -> None:
        self._world = world
        self._scene, self._robots, self._rigid = scene, scene.robots, Rigid(scene)
        drives = [robot.model.drive for robot in world.robots]
        limits_mps = np.array([drive.wheels.speed_limit for drive in drives])
        fastest_mps = float(limits_mps[scene.present].max(initial=0.0))
        self._fewest_substeps = max(1, math.ceil(world.timestep_s * fastest_mps / SUBSTEP_M))
        self._substep_s = world.timestep_s / self._fewest_substeps
        self._own_kg = np.array([robot.model.mass_kg for robot in world.robots])
        self._own_grip_n = np.array([drive.grip_n for drive in drives])
        self._force_n = np.array([drive.force_n for drive in drives])
        self._roll_out_mps2 = np.array([drive.roll_out_mps2 for drive in drives])
        self._inclines, self._ledges = None, None
        if not world.surface.is_flat:
            self._inclines = Inclines(world, scene)
            self._ledges = Ledges(self._inclines.terrain, scene)
        self._absent = np.flatnonzero(~scene.present)  # slopes move what touches nothing, too
        self._start = bodies.copy()
        self._pulls: list[Pull] = []
        self._room_m = 0.0
        # Made once: pymunk never gives the memory of a buffer back. Batches also write the bodies
        # that are fixed, among them the floor; their rows stay 0.
        self._read, self._touch = batch.Buffer(), batch.Buffer()
        self._write_motion, self._write_force = batch.Buffer(), batch.Buffer()
        self._motion = np.zeros((len(scene.names) + 1, 6))
        self._force = np.zeros((len(scene.names) + 1, 2))
        self._write_motion.set_float_buf(self._motion)
        self._write_force.set_float_buf(self._force)
        # pymunk cannot free a space while Python shuts down: it must be gone before.
        self._spaces: list[pymunk.Space] = []
        weakref.finalize(self, self._spaces.clear)
        self._make_space()

    @property
    def _space(self) -> pymunk.Space:
        return self._spaces[0]

    def step(self, bodies: Bodies, pull: Pull) -> Contacts:
        """Moves bodies through one cycle.

        Args:
            bodies: moved in place.
            pull: what the drives do; kept.

        Returns:
            what the robots touched.
        """
        if len(self._pulls) == REBUILD:
            self.start_from(bodies)
        self._pulls.append(pull)
        return self._step(bodies, pull)

    def start_from(self, bodies: Bodies) -> None:
        """Makes the space anew from bodies, which may be elsewhere than they were."""
        self._start, self._pulls = bodies.copy(), []
        self._make_space()

    def snapshot(self) -> PhysicsSnapshot:
        """Gives all that is needed to come back to here; it is never changed."""
        return PhysicsSnapshot(self._start, tuple(self._pulls))

    def restore(self, snapshot: PhysicsSnapshot) -> Bodies:
        """Goes back to a snapshot, and gives the bodies as they were then."""
        self._start, self._pulls = snapshot.start, list(snapshot.pulls)
        self._make_space()
        bodies = snapshot.start.copy()
        for pull in snapshot.pulls:
            self._step(bodies, pull)
        return bodies

    def _bear(self, load: Load | None) -> None:
        """Takes over what robots carry: what they weigh then, and what their wheels hold."""
        self._load = load
        self._borne_kg = self._own_kg + (load.weight_kg if load else 0.0)
        self._mass_kg = self._own_kg + (load.mass_kg if load else 0.0)
        self._grip_n = self._own_grip_n * (self._borne_kg / self._own_kg)
        self._drive_n = np.minimum(self._force_n, self._grip_n)
        self._roll_n = self._borne_kg * self._roll_out_mps2

    def _step(self, bodies: Bodies, pull: Pull) -> Contacts:
        robots, way_m = slice(self._robots), pull.way_m
        free_m = bodies.position_m[robots] + way_m
        wanted_mps = way_m / self._world.timestep_s
        incline = self._incline(bodies, pull)
        if (incline is None or incline.quiet) and self._nothing_near(bodies, way_m):
            bodies.position_m[robots] = free_m
            bodies.velocity_mps[robots] = wanted_mps
            bodies.touching[:] = False
            return NO_CONTACTS
        free = ~bodies.slipping
        bodies.velocity_mps[robots][free] = wanted_mps[free]
        contacts, touched = self._run_space(bodies, pull, wanted_mps, incline)
        bodies.position_m[self._absent] = free_m[self._absent]
        bodies.velocity_mps[self._absent] = 0.0
        lag_mps = np.abs(bodies.velocity_mps[robots] - wanted_mps)
        bodies.slipping[:] = (lag_mps > _SAME).any(axis=1)
        bodies.touching[:] = touched
        off_m = np.abs(bodies.position_m[robots] - free_m)
        unhindered = (off_m <= _SAME).all(axis=1)
        bodies.position_m[robots][unhindered] = free_m[unhindered]
        if self._load is None:
            return contacts
        self._load.place(bodies, pull)
        slipped = self._load.sharers[self._load.stretch_m(bodies) > STRETCH_M]
        return replace(contacts, torn=np.union1d(contacts.torn, slipped))

    def _incline(self, bodies: Bodies, pull: Pull) -> Incline | None:
        """Gives the slope under the bodies, None in a flat world."""
        if self._inclines is None or self._ledges is None:
            return None
        self._ledges.place(bodies.position_m, bodies.angle_rad)
        return self._inclines.under(bodies.position_m, pull.facing_rad, self._pulled_kg)

    def _nothing_near(self, bodies: Bodies, way_m: FloatArray) -> bool:
        """Tells whether nothing can touch in this cycle, so that the space need not run.

        `_room_m` is a distance that no robot can have used up since it was measured.
        """
        if len(bodies.position_m) > _FEW_BODIES or bodies.slipping.any():
            return False
        if self._load is not None:
            return False
        if not bodies.settled[0] or bodies.velocity_mps[self._robots :].any():
            return False
        # Two robots may come towards each other, each by the longest way.
        need_m = 2 * float(np.abs(way_m).sum(axis=1).max(initial=0.0)) + _SLOP_M
        if self._room_m < need_m:
            self._room_m = clearance_m(self._scene, bodies.position_m, bodies.angle_rad)
        self._room_m -= need_m
        return self._room_m > 0.0

    # -- pymunk ----------------------------------------------------------------------------------

    @without_collector()
    def _make_space(self) -> None:
        """Makes the space; the order in which bodies are added is part of the world."""
        space = pymunk.Space()
        holds = self._start.holds
        self._bear(Load.of(self._world, self._scene, holds) if holds.any() else None)
        space.collision_slop = _SLOP_M
        space.collision_bias = _BIAS
        space.collision_persistence = 1  # with 0 contacts are forgotten before they can be read
        bodies = []
        places = iter(self._start.position_m.tolist())  # all in one place would be O(n^2)
        parts, borne, apart = self._parts()
        for number, robot in enumerate(self._world.robots):
            body = pymunk.Body(float(self._mass_kg[number]), math.inf)  # only its wheels turn it
            body.position = next(places)
            bodies.append(body)
            carried = parts.get(number)
            load = () if carried is None else thing_shapes(body, *carried)
            own = [pymunk.Circle(body, robot.model.radius_m)] * bool(self._scene.present[number])
            add(space, body, *own, *load)
        for number, whole in enumerate(self._rigid.wholes):
            body = pymunk.Body(whole.mass_kg, whole.moment_kgm2)
            body.position = next(places)
            bodies.append(body)
            add(space, body, *(() if number in apart else shapes_of(body, whole)))
        for solid in self._scene.fixed_solids:
            body = pymunk.Body(body_type=pymunk.Body.STATIC)
            bodies.append(body)
            add(space, body, *fixed_shapes(body, solid))
        self._add_floor(space, bodies, borne)
        space.add(*self._shared_grips(bodies))
        self._spaces[:] = [space]
        self._floor, self._bodies = bodies[-1], bodies[: self._robots]
        self._joints: list[pymunk.Constraint] = []
        self._room_m = 0.0
        self._learn_ids([body.id for body in bodies])

    def _add_floor(self, space: pymunk.Space, bodies: list[pymunk.Body], borne: set[int]) -> None:
        """Adds the ground, and the floor, which rubs on all things that nobody bears."""
        if self._ledges is not None:
            bodies.append(add_ground(space, bodies, self._ledges))
        floor = pymunk.Body(body_type=pymunk.Body.STATIC)
        bodies.append(floor)
        space.add(floor)
        self._rubs: dict[int, list[tuple[pymunk.Constraint, float]]] = {}
        things_kg = np.zeros(len(self._scene.pushables))
        for number, whole in enumerate(self._rigid.wholes):
            if number not in borne:
                joints = floor_friction(floor, bodies[self._robots + number], whole)
                self._rubs[number] = [(joint, joint.max_force) for joint in joints]
                space.add(*joints)
                things_kg[number] = whole.mass_kg
        self._pulled_kg = np.concatenate([self._borne_kg, things_kg])
        self._grip = np.ones(len(things_kg))

    def _parts(self) -> tuple[dict[int, tuple[Thing, FloatArray]], set[int], set[int]]:
        """Gives how things are attached to robots.

        Returns:
            what each robot carries as a part of itself, and where; the things that no floor rubs
            on; and those of them that are not there for themselves.
        """
        load, others = self._load, self._rigid.others
        if load is None:
            return {}, set(others), set(others)
        things = [self._scene.pushables[thing] for thing in load.carried.tolist()]
        parts = dict(zip(load.carriers.tolist(), zip(things, load.grasp, strict=True), strict=True))
        apart = {*load.carried.tolist(), *load.lifted.tolist(), *others}
        return parts, apart | set(load.shared.tolist()), apart

    def _shared_grips(self, bodies: list[pymunk.Body]) -> list[pymunk.Constraint]:
        """Gives the joints between robots and what several of them hold."""
        load = self._load
        joints: list[pymunk.Constraint] = []
        if load is None:
            return joints
        rows = zip(load.sharers, load.shared, load.grip_m, load.point_m.tolist(), strict=True)
        for robot, thing, grip_m, point_m in rows:
            gripper = self._world.robots[robot].model.gripper
            body, held = bodies[robot], bodies[self._robots + thing]
            joint = pymunk.PivotJoint(body, held, (float(grip_m), 0.0), tuple(point_m))
            joint.max_force = gripper.force_n if gripper else 0.0
            joint.collide_bodies = False
            joints.append(joint)
        return joints

    def _learn_ids(self, ids: list[int]) -> None:
        """Learns which of pymunk's ids is which of our bodies."""
        self._read.clear()
        batch.get_space_bodies(self._space, batch.BodyFields.BODY_ID, self._read)
        # Batches list the dynamic bodies, then the static ones, each as they were added.
        assert np.frombuffer(self._read.int_buf(), dtype=np.uintp).tolist() == ids
        self._by_id = np.argsort(np.array(ids, dtype=np.uintp))
        self._ids = np.array(ids, dtype=np.uintp)[self._by_id]

    def _run_space(
        self, bodies: Bodies, pull: Pull, wanted_mps: FloatArray, incline: Incline | None
    ) -> tuple[Contacts, BoolArray]:
        """Lets pymunk move the bodies; gives the contacts, and which robots' bodies had any."""
        substeps = self._swing(bodies, pull)
        motion = self._motion[: len(bodies.position_m)]
        motion[:, 0:2], motion[:, 2] = bodies.position_m, bodies.angle_rad
        motion[:, 3:5], motion[:, 5] = bodies.velocity_mps, bodies.spin_radps
        self._rigid.load(motion)
        batch.set_space_bodies(self._space, _MOTION, self._write_motion)
        velocity_mps = bodies.velocity_mps
        stands = (wanted_mps[:, 0] == 0.0) & (wanted_mps[:, 1] == 0.0)
        limit_n = np.where(stands | pull.limp, self._grip_n, self._drive_n)
        held = np.flatnonzero(bodies.touching & (stands | pull.limp))
        limit_n[held] = np.where(pull.limp[held], self._roll_n[held], 0.0)
        self._hold(bodies, pull, held)
        if incline is not None:
            self._hold_less(held, incline)
            roll_n = self._roll_n * np.sqrt(incline.grip[: self._robots])
            limit_n = np.where(pull.limp, roll_n, limit_n)
            rolls = pull.limp & (incline.sloping | bodies.slipping)
            wanted_mps = np.where(rolls[:, None], 0.0, wanted_mps)
        found, torn = [], NO_CONTACTS.torn
        touched = np.zeros(len(self._scene.names), dtype=np.bool_)
        for _ in range(substeps):
            lag_mps = wanted_mps - velocity_mps[: self._robots]
            self._push(pull, limit_n, lag_mps, incline, held)
            self._space.step(self._substep_s)
            pairs, places = self._touching()
            touched[pairs] = True
            if self._load is not None:
                pairs, torn = self._told_apart(self._load, pairs, places)
            found.append((pairs, places))
            velocity_mps = self._read_bodies(batch.BodyFields.VELOCITY, 2)
        motion = self._read_bodies(_MOTION, 6)[: len(bodies.position_m)]
        bodies.position_m[:], bodies.angle_rad[:] = motion[:, 0:2], motion[:, 2]
        bodies.velocity_mps[:], bodies.spin_radps[:] = motion[:, 3:5], motion[:, 5]
        self._rigid.place(bodies)
        self._bring_to_rest(bodies)
        bodies.settled[0] = self._is_settled(*found[-1])
        self._room_m = 0.0
        contacts = replace(self._contacts(found), torn=torn)
        if self._load is not None:
            touched[self._load.sharers] = True  # what they hold pulls at them as contacts do
        return contacts, touched[: self._robots]

    def _swing(self, bodies: Bodies, pull: Pull) -> int:
        """Turns robots that carry something; gives how many substeps that takes."""
        substeps = self._fewest_substeps
        if self._load is not None:
            timestep_s = self._world.timestep_s
            spin_radps = self._load.spin_radps(bodies, pull, timestep_s)
            bodies.spin_radps[: self._robots] = spin_radps
            swing_m = float(np.abs(spin_radps).max()) * self._load.reach_m * timestep_s
            way_m = float(np.abs(pull.way_m).max())
            most = max(MOST_SUBSTEPS, substeps)
            substeps = min(max(substeps, math.ceil((swing_m + way_m) / SUBSTEP_M)), most)
        self._substep_s = self._world.timestep_s / substeps
        return substeps

    def _told_apart(
        self, load: Load, pairs: IndexArray, places: FloatArray
    ) -> tuple[IndexArray, IndexArray]:
        """Tells contacts of loads from their carriers'; gives the carriers of deep ones, too."""
        position_m = self._read_bodies(batch.BodyFields.POSITION, 2)
        owned, rows = load.owned(pairs, places, position_m)
        rows = rows[places[rows, 2] < -TORN_M]
        deep = pairs[rows][pairs[rows] != owned[rows]]
        return owned, np.unique(deep)

    def _hold(self, bodies: Bodies, pull: Pull, held: IndexArray) -> None:
        """Holds robots by joints, as their grip does: a force alone would let them creep.

        Limp ones are held across their wheels only.
        """
        self._space.remove(*self._joints)
        self._joints = []
        for robot in held.tolist():
            joint: pymunk.Constraint
            body = self._bodies[robot]
            if not pull.limp[robot]:
                joint = pymunk.PivotJoint(self._floor, body, (0.0, 0.0), (0.0, 0.0))
            else:
                x, y = bodies.position_m[robot].tolist()
                cos, sin = math.cos(pull.facing_rad[robot]), math.sin(pull.facing_rad[robot])
                ends = (x - cos, y - sin), (x + cos, y + sin)
                joint = pymunk.GrooveJoint(self._floor, body, *ends, (0.0, 0.0))
            joint.max_force, joint.max_bias = float(self._grip_n[robot]), 0.0
            self._joints.append(joint)
        self._space.add(*self._joints)

    def _hold_less(self, held: IndexArray, incline: Incline) -> None:
        """Takes the grip and the friction that a slope leaves."""
        for robot, joint in zip(held.tolist(), self._joints, strict=True):
            joint.max_force *= float(incline.hold[robot])
        grip = incline.grip[self._robots :]
        for number in np.flatnonzero(grip != self._grip).tolist():
            for joint, most in self._rubs.get(number, ()):
                joint.max_force = most * float(grip[number])
        self._grip = grip

    def _push_up(
        self, incline: Incline, along_n: FloatArray, lag_mps: FloatArray, held: IndexArray
    ) -> None:
        """Does what `_push` does where the ground may slope, and lets it pull everything down."""
        force_n = lag_mps * (self._mass_kg / self._substep_s)[:, None]
        across = np.zeros(self._robots, dtype=np.bool_)
        across[held] = True
        count = len(incline.pull_n)
        self._force[:count] = incline.pull_n
        self._force[: self._robots] += incline.drawn_n(force_n, along_n, self._grip_n, across)
        batch.set_space_bodies(self._space, batch.BodyFields.FORCE, self._write_force)

    def _push(
        self, pull: Pull, limit_n: FloatArray, lag_mps: FloatArray, incline: Incline | None,
        joined: IndexArray,
    ) -> None:  # fmt: skip
        """Draws robots to the velocity of their wheels, with the force that they have."""
        if incline is not None:
            self._push_up(incline, limit_n, lag_mps, joined)
            return
        held = np.flatnonzero((lag_mps[:, 0] != 0.0) | (lag_mps[:, 1] != 0.0))
        force_n = lag_mps.take(held, axis=0) * (self._mass_kg.take(held) / self._substep_s)[:, None]
        if pull.limp.any():
            force_n -= self._limp_n(pull, held, force_n)
        needed_n = np.hypot(force_n[:, 0], force_n[:, 1])
        share = np.minimum(1.0, limit_n.take(held) / np.maximum(needed_n, _SAME))
        self._force[: self._robots] = 0.0
        self._force[held] = force_n * share[:, None]
        batch.set_space_bodies(self._space, batch.BodyFields.FORCE, self._write_force)

    def _limp_n(self, pull: Pull, held: IndexArray, force_n: FloatArray) -> FloatArray:
        """Gives the force that limp wheels, because they roll, do not have along them."""
        facing_rad, roll_n = pull.facing_rad.take(held), self._roll_n.take(held)
        ahead = np.column_stack([np.cos(facing_rad), np.sin(facing_rad)])
        along_n = (force_n * ahead).sum(axis=1)
        lacks_n = np.where(pull.limp.take(held), along_n - np.clip(along_n, -roll_n, roll_n), 0.0)
        return np.asarray(lacks_n[:, None] * ahead)

    def _read_bodies(self, what: batch.BodyFields, columns: int) -> FloatArray:
        """Gives what pymunk knows of its bodies; valid until the next call."""
        self._read.clear()
        batch.get_space_bodies(self._space, what, self._read)
        return np.frombuffer(self._read.float_buf()).reshape(-1, columns)

    def _touching(self) -> tuple[IndexArray, FloatArray]:
        """Gives the pairs of bodies in contact, and x, y, distance [m] of each."""
        self._touch.clear()
        batch.get_space_arbiters(self._space, _CONTACT, self._touch)
        numbers = np.frombuffer(self._touch.int_buf(), dtype=np.uintp).reshape(-1, 3)
        touch = numbers[:, 2] > 0  # what is over a patch that does not block it touches nothing
        if not touch.any():
            return _NO_PAIRS
        pairs = self._by_id[np.searchsorted(self._ids, numbers[touch, :2])]
        places = np.frombuffer(self._touch.float_buf()).reshape(-1, 3)[touch]
        # pymunk lists the contacts of one body's shapes by where these lie in memory.
        order = np.lexsort((places[:, 1], places[:, 0], pairs[:, 1], pairs[:, 0]))
        return pairs[order], places[order]

    def _bring_to_rest(self, bodies: Bodies) -> None:
        """Takes away what rounding left of the velocity of things that stand."""
        velocity_mps = bodies.velocity_mps[self._robots :]
        spin_radps = bodies.spin_radps[self._robots :]
        rest = (np.abs(velocity_mps) < _SAME).all(axis=1) & (np.abs(spin_radps) < _SAME)
        velocity_mps[rest], spin_radps[rest] = 0.0, 0.0

    def _is_settled(self, pairs: IndexArray, places: FloatArray) -> bool:
        """Tells whether no thing presses into anything."""
        things = ((pairs >= self._robots) & (pairs < len(self._scene.start))).any(axis=1)
        return bool((places[things, 2] >= -2 * _SLOP_M).all())

    def _contacts(self, found: list[tuple[IndexArray, FloatArray]]) -> Contacts:
        """Gives the first place at which each robot touched each thing."""
        pairs = np.concatenate([pairs for pairs, _ in found])
        if not len(pairs):
            return NO_CONTACTS
        places = np.concatenate([places for _, places in found])
        pairs = np.concatenate([pairs, pairs[:, ::-1]])
        places = np.concatenate([places, places])
        names = len(self._scene.names)
        keys, first = np.unique(pairs[:, 0] * names + pairs[:, 1], return_index=True)
        mine = first[keys // names < self._robots]
        x_m, y_m = places[mine, 0], places[mine, 1]
        return Contacts(pairs[mine, 0], pairs[mine, 1], x_m, y_m, NO_CONTACTS.torn)
