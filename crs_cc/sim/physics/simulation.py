"""Simulation of bodies through the cycles of a world.

The simulation is in the horizontal plane. A robot is accelerated to the velocity of its wheels
(`drive_force`), floor friction brakes objects (`mass_properties`), and contacts push back. Contacts
never turn a robot. The cycle is divided into substeps that are short enough to limit penetration.

The arrays of `Bodies` are the only state of positions and velocities; pymunk's space is loaded
from them at the start of each cycle. A robot without contacts is placed exactly where its wheels
move it, so robots that never meet do not affect each other's results, not even in the last bit.

A load is a part of its robot (`carrying`): its contacts stop the robot or push it aside, but do not
turn it. So a load that is turned into a wall slides along it with its robot; one that cannot, and
penetrates an object by more than `TORN_M`, is torn from the gripper.

Among many robots, those that are near nothing (`nearness`) are moved as their wheels turn, which is
what the space would do. It has only the others, and all objects.

The only state inside pymunk that cannot be read is the history of its search tree and of its
contacts. It matters if several bodies touch at the same time. So the space is rebuilt from the
arrays every `REBUILD` cycles, and a snapshot is the arrays of that time and the drives' motions in
the cycles since then in which the space was stepped: restoring rebuilds the space and repeats these
cycles, which gives the same bits. As nothing else depends on the space, this is done when the space
is next needed: while no bodies are near each other, there is none.
"""

from __future__ import annotations

import math
import weakref
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, any_of
from crs_cc.core.gc_pause import gc_paused
from crs_cc.sim.geometry.clearance import clearance_m
from crs_cc.sim.geometry.ledges import Ledges
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.physics.carrying import Load
from crs_cc.sim.physics.contacts import (
    SLOP_M,
    first_contacts,
    is_settled,
    separate_loads,
    with_slipped,
)
from crs_cc.sim.physics.drive_force import DriveForce
from crs_cc.sim.physics.inclines import Incline, Inclines
from crs_cc.sim.physics.nearness import Nearness
from crs_cc.sim.physics.rigid import Rigid
from crs_cc.sim.state.bodies import (
    NO_CONTACTS,
    Bodies,
    Contacts,
    PhysicsSnapshot,
    Pull,
    Ran,
)

if TYPE_CHECKING:
    import pymunk

    from crs_cc.sim.physics.batches import Batches
    from crs_cc.sim.physics.space import Space, SpaceBuilder

REBUILD: Final = 100
"""Number of cycles after which the space is rebuilt."""

SUBSTEP_M: Final = 0.008
"""Maximum displacement of a robot in a substep, which limits its penetration of a wall."""

MAX_SUBSTEPS: Final = 256
"""Maximum number of substeps of a cycle with turning loads."""

_MARGIN_M: Final = SLOP_M + 2 * SUBSTEP_M
"""Room that robots need besides their motions: overlaps are corrected meanwhile."""

_SAME: Final = 1e-9  # [m], [m/s]: smaller differences are rounding errors
_FEW_BODIES: Final = 64  # up to this number the space has all of them, or none is near


class Physics:
    """Simulates the bodies of a world.

    Attributes:
        leaves_out: whether spaces may be without robots that are near nothing; only tests switch
            it off.
    """

    leaves_out = True

    def __init__(self, world: WorldModel, scene: Scene, bodies: Bodies) -> None:
        self._world = world
        self._scene, self._robots, self._rigid = scene, scene.robots, Rigid(scene)
        limits_mps = np.array([robot.model.drive.wheels.speed_limit for robot in world.robots])
        fastest_mps = float(limits_mps[scene.present].max(initial=0.0))
        self._most_m = world.timestep_s * fastest_mps
        self._fewest_substeps = max(1, math.ceil(self._most_m / SUBSTEP_M))
        self._inclines, self._ledges = None, None
        self._slope: Incline | None = None  # in the current cycle
        if not world.surface.is_flat:
            self._inclines = Inclines(world, scene)
            self._ledges = Ledges(self._inclines.terrain, scene)
        self._absent = np.flatnonzero(~scene.present)  # slopes move bodies without contacts, too
        self._drive_force = DriveForce(world)
        # pymunk cannot free a space during the shutdown of Python: it must be freed before.
        self._spaces: list[Space] = []
        weakref.finalize(self, self._spaces.clear)
        self.start_from(bodies)

    @cached_property
    def _nearness(self) -> Nearness:
        return Nearness(self._scene, 2 * self._most_m + _MARGIN_M)

    @cached_property
    def _builder(self) -> SpaceBuilder:
        from crs_cc.sim.physics.space import SpaceBuilder  # loads pymunk

        return SpaceBuilder(self._world, self._scene, self._rigid, self._ledges)

    @cached_property
    def _batches(self) -> Batches:
        from crs_cc.sim.physics.batches import Batches  # loads pymunk

        return Batches(len(self._scene.names))

    @property
    def _space(self) -> Space:
        if not self._spaces:
            self._make_space()
            self._catch_up()
        return self._spaces[0]

    def may_skip_cycle(self, bodies: Bodies, way_m: FloatArray, facing_rad: FloatArray) -> bool:
        """Return whether no contact is possible in this cycle, which is then over.

        The robots are then to be moved as their wheels have turned. Otherwise call `step`.

        Args:
            bodies: the bodies at the start of the cycle.
            way_m: the displacement of each robot by its wheels in it, (robots, 2).
            facing_rad: their rolling directions, (robots,).
        """
        if self._cycles == REBUILD:
            self._restart(bodies)
        self._slope = None
        if self._inclines is not None:
            self._slope = self._incline(bodies, facing_rad)
        is_level = self._slope is None or self._slope.quiet
        if not (is_level and self._nothing_near(bodies, way_m)):
            return False
        bodies.touching[:] = False
        self._cycles += 1
        return True

    def calm_cycles(self, bodies: Bodies) -> tuple[int, float]:
        """Return for how many cycles `skip_cycles` may be called, and how much room robots have."""
        if self._inclines is not None or not self._is_settled(bodies) or bodies.touching.any():
            return 0, 0.0
        return REBUILD - self._cycles, self._room_m

    def skip_cycles(self, cycles: int, room_m: float) -> None:
        """Count cycles in which no contact was possible, as if `may_skip_cycle` had been called.

        Args:
            cycles: how many, see `calm_cycles`.
            room_m: the room that is left.
        """
        self._cycles += cycles
        self._room_m = room_m

    def step(self, bodies: Bodies, pull: Pull) -> Contacts:
        """Move bodies through a cycle in which contacts are possible.

        Args:
            bodies: moved in place.
            pull: the motion of the drives; kept.

        Returns:
            the contacts of the robots.
        """
        if self._leaves_some_out:
            return self._step_some(bodies, pull)
        follows = bool(self._ran) and self._ran[-1].cycle == self._cycles - 1
        before = None if follows else bodies.copy()
        contacts = self._run(bodies, pull, self._slope)
        self._ran.append(Ran(self._cycles, pull, before))
        self._cycles += 1
        return contacts

    def _step_some(self, bodies: Bodies, pull: Pull) -> Contacts:
        """Run a cycle in which robots that are near nothing move as their wheels turn."""
        near, robots = self._find_near(bodies, pull.way_m), slice(self._robots)
        mine = self._robots_of(near)
        rows = np.concatenate([mine, np.arange(self._robots, len(bodies.position_m))])
        before, drawn = bodies.part(rows, mine), pull.part(mine)
        some, contacts = before.copy(), NO_CONTACTS
        if len(near) or not (bodies.settled[0] and self._is_at_rest(bodies)):
            contacts = self._run(some, drawn, None, near)
            self._ran.append(Ran(self._cycles, drawn, before, near))
        self._cycles += 1
        bodies.position_m[robots] += pull.way_m
        bodies.velocity_mps[robots] = pull.way_m / self._world.timestep_s + 0.0  # pymunk has no -0
        bodies.velocity_mps[self._absent] = 0.0
        bodies.slipping[:] = bodies.touching[:] = False
        bodies.put(rows, mine, some)
        displacement_m = np.abs(some.position_m - before.position_m).sum(axis=1).max(initial=0.0)
        self._nearness.use(max(self._need_m, 2 * float(displacement_m)))
        return contacts

    def _robots_of(self, near: IndexArray) -> IndexArray:
        return near[: np.searchsorted(near, self._robots)]

    def is_idle(self, bodies: Bodies) -> bool:
        """Return whether another step with all bodies at rest changes only the count of steps.

        The space was not stepped in the last one, nor will it be.
        """
        stepped = bool(self._ran) and self._ran[-1].cycle == self._cycles - 1
        if stepped or self._inclines is not None or not self._is_settled(bodies):
            return False
        if self._room_m >= SLOP_M:
            return True
        return clearance_m(self._scene, bodies.position_m, bodies.angle_rad) >= SLOP_M

    def skip(self, bodies: Bodies, cycles: int) -> None:
        """Count steps during which the physics was idle, see `is_idle`."""
        begun = self._cycles + cycles - 1  # by the last of them
        if begun >= REBUILD:
            self.start_from(bodies)
            cycles = begun % REBUILD + 1
        for _ in range(cycles):
            self._use_room(bodies, SLOP_M)
        self._cycles += cycles

    def start_from(self, bodies: Bodies) -> None:
        """Rebuild the space from bodies, whose poses may have changed."""
        self._restart(bodies)
        self._forget_room()

    def snapshot(self) -> PhysicsSnapshot:
        """Return the state apart from the bodies."""
        return PhysicsSnapshot(self._start, self._cycles, tuple(self._ran), self._room_m)

    def restore(self, snapshot: PhysicsSnapshot) -> None:
        """Restore a snapshot; the bodies must be those of that time."""
        self._begin(snapshot)
        self._forget_room()

    def _restart(self, bodies: Bodies) -> None:
        self._begin(PhysicsSnapshot(bodies.copy(), 0, (), 0.0))

    def _forget_room(self) -> None:
        if self._leaves_some_out:
            self._nearness.forget()

    def _begin(self, snapshot: PhysicsSnapshot) -> None:
        """Discard the space; it is rebuilt from a snapshot when it is next needed."""
        self._spaces.clear()
        self._start, self._cycles = snapshot.start, snapshot.cycles
        self._ran, self._room_m = list(snapshot.ran), snapshot.room_m
        holds = self._start.holds
        self._load = Load.of(self._world, self._scene, holds) if holds.any() else None
        self._drive_force.set_loads(self._load)
        is_plain = self._load is None and self._inclines is None
        self._leaves_some_out = (
            self.leaves_out and is_plain and len(self._start.position_m) > _FEW_BODIES
        )

    def _catch_up(self) -> None:
        """Repeat in a new space the cycles in which the one before it was stepped."""
        room_m, bodies = self._room_m, self._start
        for ran in self._ran:
            if ran.bodies is not None:
                bodies = ran.bodies.copy()
            incline = self._incline(bodies, ran.pull.facing_rad)
            self._run(bodies, ran.pull, incline, ran.near)
        self._room_m = room_m

    def _run(
        self,
        bodies: Bodies,
        pull: Pull,
        incline: Incline | None,
        near: IndexArray | None = None,
    ) -> Contacts:
        """Step the space, which moves the bodies: all, or some robots and all objects."""
        robots, way_m = slice(len(bodies.slipping)), pull.way_m
        free_m = bodies.position_m[robots] + way_m
        wanted_mps = way_m / self._world.timestep_s
        free = ~bodies.slipping
        bodies.velocity_mps[robots][free] = wanted_mps[free]
        mine = None if near is None else self._admit(near, bodies)
        contacts, touched = self._run_space(bodies, pull, wanted_mps, incline, mine)
        if near is None:
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
        return with_slipped(contacts, self._load, bodies)

    def _incline(self, bodies: Bodies, facing_rad: FloatArray) -> Incline | None:
        """Return the slope under the bodies, None in a flat world."""
        if self._inclines is None or self._ledges is None:
            return None
        pulled_kg = np.concatenate([self._drive_force.borne_kg, self._space.object_kg])
        self._ledges.place(bodies.position_m, bodies.angle_rad)
        return self._inclines.slope_under(bodies.position_m, facing_rad, pulled_kg)

    def _nothing_near(self, bodies: Bodies, way_m: FloatArray) -> bool:
        """Return whether no contact is possible in this cycle, so that no step is needed.

        `_room_m` is a distance that no robot can have moved since it was measured.
        """
        if not self._is_settled(bodies):
            return False
        # Two robots may approach each other, each by the longest displacement.
        need_m = 2 * max((abs(x) + abs(y) for x, y in way_m.tolist()), default=0.0) + SLOP_M
        return self._use_room(bodies, need_m)

    def _find_near(self, bodies: Bodies, way_m: FloatArray) -> IndexArray:
        """Return the robots that may touch something in this cycle, and the solids, rising."""
        x_m, y_m = way_m.T
        way2_m2 = np.maximum.reduce(x_m * x_m + y_m * y_m, initial=0.0)
        velocity_mps = np.abs(bodies.velocity_mps[self._robots :]).sum(axis=1).max(initial=0.0)
        spin_radps = np.abs(bodies.spin_radps[self._robots :]).max(initial=0.0)
        moved_m = (velocity_mps + spin_radps * self._rigid.lever_m) * self._world.timestep_s
        self._need_m = 2 * max(math.sqrt(float(way2_m2)), float(moved_m)) + _MARGIN_M
        near = self._nearness.find(bodies.position_m, self._need_m)
        pushed = np.flatnonzero(bodies.slipping | bodies.touching)
        return np.union1d(near, pushed) if len(pushed) else near

    def _is_settled(self, bodies: Bodies) -> bool:
        """Return whether the bodies are few, and none but robots can move by themselves."""
        if len(bodies.position_m) > _FEW_BODIES or any_of(bodies.slipping):
            return False
        if self._load is not None or not bodies.settled[0]:
            return False
        return self._is_at_rest(bodies)

    def _is_at_rest(self, bodies: Bodies) -> bool:
        """Return whether all objects are."""
        if len(bodies.position_m) == len(bodies.slipping):
            return True
        robots = len(bodies.slipping)
        return not (bodies.velocity_mps[robots:].any() or bodies.spin_radps[robots:].any())

    def _use_room(self, bodies: Bodies, need_m: float) -> bool:
        """Return whether robots have this much room, and reserve it."""
        if self._room_m < need_m:
            self._room_m = clearance_m(self._scene, bodies.position_m, bodies.angle_rad)
        self._room_m -= need_m
        return self._room_m >= 0.0

    @gc_paused()
    def _make_space(self) -> None:
        mass_kg, position_m = self._drive_force.mass_kg, self._start.position_m
        is_whole = not self._leaves_some_out
        space = self._builder.build(position_m, mass_kg, self._load, is_whole=is_whole)
        self._spaces[:] = [space]
        self._batches.map_bodies(space)

    def _admit(self, near: IndexArray, bodies: Bodies) -> IndexArray:
        """Have some robots only in the space, whose bodies are the first; return which."""
        robots, mass_kg = self._robots_of(near), self._drive_force.mass_kg

        def body_of(number: int) -> pymunk.Body:
            if number >= self._robots:
                return self._builder.solid(number)
            place = int(np.searchsorted(robots, number))
            return self._builder.robot(number, bodies.position_m[place], mass_kg)

        others = near[len(robots) :].tolist()
        if self._space.admit(robots.tolist(), others, body_of):
            self._batches.map_bodies(self._space)
        return robots

    def _run_space(
        self,
        bodies: Bodies,
        pull: Pull,
        wanted_mps: FloatArray,
        incline: Incline | None,
        mine: IndexArray | None,
    ) -> tuple[Contacts, BoolArray]:
        """Step pymunk's space, with some robots or all.

        Return the contacts, and which of the robots' bodies had any.
        """
        space, batches, load = self._space, self._batches, self._load
        robots = slice(self._robots) if mine is None else mine
        drive_force = self._drive_force if mine is None else self._drive_force.part(mine)
        substeps = self._swing(bodies, pull)
        substep_s = self._world.timestep_s / substeps
        batches.write(space, bodies, self._rigid)
        drawn = drive_force.begin(space, bodies, pull, wanted_mps, incline)
        velocity_mps, glides = bodies.velocity_mps, load is None and self._is_at_rest(bodies)
        found, torn = [], NO_CONTACTS.torn
        touched = np.zeros(len(self._scene.names), dtype=np.bool_)
        for _ in range(substeps):
            had_mps = velocity_mps[: len(wanted_mps)]
            forced = drive_force.write(batches.force_n, drawn, had_mps, substep_s)
            if forced:
                batches.push(space)
            space.inner.step(substep_s)
            pairs, places = batches.touching(space)
            touched[pairs] = True
            if load is not None:
                pairs, torn = separate_loads(load, pairs, places, batches.position_m(space))
            found.append((pairs, places))
            glides = glides and not (forced or len(pairs))
            if not glides:  # else nothing has changed a velocity
                velocity_mps = batches.velocity_mps(space)
        batches.read(space, bodies, self._rigid)
        self._bring_to_rest(bodies)
        bodies.settled[0] = is_settled(self._scene, *found[-1])
        self._room_m = 0.0
        contacts = replace(first_contacts(self._scene, found), torn=torn)
        if load is not None:
            touched[load.sharers] = True  # shared loads pull at them as contacts do
        return contacts, touched[robots]

    def _swing(self, bodies: Bodies, pull: Pull) -> int:
        """Turn robots with loads; return the number of substeps that this needs."""
        substeps = self._fewest_substeps
        if self._load is not None:
            timestep_s = self._world.timestep_s
            spin_radps = self._load.spin_radps(bodies, pull, timestep_s)
            bodies.spin_radps[: self._robots] = spin_radps
            swing_m = float(np.abs(spin_radps).max()) * self._load.reach_m * timestep_s
            way_m = float(np.abs(pull.way_m).max())
            most = max(MAX_SUBSTEPS, substeps)
            substeps = min(max(substeps, math.ceil((swing_m + way_m) / SUBSTEP_M)), most)
        return substeps

    def _bring_to_rest(self, bodies: Bodies) -> None:
        """Clear the velocities of resting objects that are rounding errors."""
        robots = len(bodies.slipping)
        velocity_mps, spin_radps = bodies.velocity_mps[robots:], bodies.spin_radps[robots:]
        rest = (np.abs(velocity_mps) < _SAME).all(axis=1) & (np.abs(spin_radps) < _SAME)
        velocity_mps[rest], spin_radps[rest] = 0.0, 0.0
