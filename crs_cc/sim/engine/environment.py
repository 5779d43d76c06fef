"""The environment: the world as it changes, cycle after cycle, for all robots at once.

A cycle [k dt, (k + 1) dt) goes like this. First the session hands over what the programs ask for
(`serve`), each request at its own instant: the wheels of that robot are turned on to the instant,
then the command changes their motion or the sensors are read. Then `step` ends the cycle: all
wheels are turned on to its end, which makes each robot's slice of the cycle; the physics moves the
bodies along these slices; contacts press bumpers; time goes on.

>>> from crs_cc.requests import CODES, MESSAGE
>>> from crs_cc.sim.files.world_xml import empty_world
>>> environment = Environment(empty_world(), seed=1)
>>> robots, messages = np.array([0]), np.zeros(1, MESSAGE)
>>> environment.serve(CODES["CONNECT"], robots, messages, np.array([0.0]))
array([0.])
>>> messages["i"][0, :2] = 100, 100                       # a move of 10 inches
>>> environment.serve(CODES["PR"], robots, messages, np.array([0.02]))
array([0.02])
>>> for _ in range(40):
...     step = environment.step()
>>> round(float(environment.state.x_m[0]), 6), environment.time_s
(0.254, 2.0)
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import FloatArray, IndexArray, Records
from crs_cc.sim.comms.control import CommunicationControl
from crs_cc.sim.comms.message_log import take
from crs_cc.sim.devices import drive
from crs_cc.sim.devices.degradation.control import DegradationControl
from crs_cc.sim.devices.drive import traction
from crs_cc.sim.engine.dispatch import Dispatcher
from crs_cc.sim.engine.falls import tell_falls
from crs_cc.sim.engine.step import Slices, Step, slices_of
from crs_cc.sim.engine.world_data import Snapshot, WorldData
from crs_cc.sim.geometry.scene import Outlines
from crs_cc.sim.model.world import Pose, Robot, Solid, WorldModel
from crs_cc.sim.state.bodies import Contacts
from crs_cc.sim.state.env_state import EnvState


class Environment:
    """A world while it runs."""

    def __init__(self, world: WorldModel, seed: int) -> None:
        """Set up a world before its first cycle.

        Args:
            world: the world.
            seed: decides all that is random; not negative.

        Raises:
            ValueError: the seed is negative.
        """
        self._data = WorldData(world, seed)
        self._dispatcher = Dispatcher(self._data)

    # -- requests and time ---------------------------------------------------------------------

    def link_s(
        self, codes: npt.ArrayLike, robots: npt.ArrayLike = 0, sizes: npt.ArrayLike = 0
    ) -> FloatArray:
        """Return the time that requests take on the line between host and robot [s].

        Args:
            codes: the requests' codes.
            robots: whose they are.
            sizes: bytes of their data.

        Returns:
            the times, in the shape that the three give when they are broadcast.
        """
        return self._data.line.time_s(self.state.link, codes, robots, sizes)

    def serve(
        self, code: int, robots: IndexArray, messages: Records, clock_s: FloatArray
    ) -> FloatArray:
        """Answer one kind of request of all robots that posted it.

        What is asked may be nonsense: it is refused (result 0) or brought within limits.

        Args:
            code: the request's code.
            robots: who asks, rising, k of them.
            messages: what each asks, of dtype `MESSAGE`; changed in place into the replies.
            clock_s: when each request reaches the robot, within the current cycle.

        Returns:
            when each program goes on, shape (k,): at once, or at the end of a wait that ends in
            this cycle, or infinite for a wait that goes on (`step` says when it ends).
        """
        return self._dispatcher.serve(code, robots, messages, clock_s)

    def step(self) -> Step:
        """End the cycle; return what happened in it and which waits end in the next."""
        data, state, end_s = self._data, self.state, self.end_s
        present = np.flatnonzero(state.presence.present)
        data.advance_to(present, np.full(len(present), end_s))
        data.rolling.add(state, data.constants)
        slices, contacts = self._move()
        # Motors that lack force are limp from the next cycle on.
        worked = data.devices.sensor_board.batteries.drain(state, self.timestep_s)
        data.let_go_if_empty(worked, end_s)
        # Contacts number things as they still are: whoever comes or goes below changes that.
        before = state.bumpers.pressed
        began = data.bumpers.touch(state, data.constants, contacts, end_s)
        now, names = state.bumpers.pressed, data.names
        pressed, released = now & ~before, before & ~now
        # Degradations that begin are told before the devices that work at the end.
        cycle, time_s, served = state.cycle, self.time_s, tuple(self._dispatcher.served)
        if state.degradation.next_s < end_s:
            self.degradations.tell(end_s)
        data.devices.end_cycle(state, data.constants, time_s, end_s)
        traffic = take(state.messages)
        self._begin_cycle()
        # In the next cycle already: waits that end in it, and who comes or goes at its start.
        ended, at_s, messages = self._dispatcher.end_waits()
        if data.is_anybody_due():
            data.come_and_go()
        return Step(
            cycle=cycle,
            time_s=time_s,
            robots=ended,
            at_s=at_s,
            messages=messages,
            contacts=began,
            pressed=pressed,
            released=released,
            names=names,
            slices=slices,
            served=served,
            events=data.log.take(self.time_s),
            traffic=traffic,
        )

    def _move(self) -> tuple[Slices, Contacts]:
        """Move the bodies along the slices of the cycle, which are complete now."""
        data, state, constants = self._data, self.state, self._data.constants
        before_m = state.bodies.position_m[: len(self.world.robots)].copy()
        handling, pull = data.devices.handling, traction.pull(state, constants)
        pull = handling.pull(state, constants, pull, self.end_s)
        contacts = data.physics.step(state.bodies, pull)
        # Wheels that were held up have not turned; only then is known what the robots did.
        went_m = state.bodies.position_m[: len(before_m)] - before_m
        traction.feel(state, constants, went_m)
        slices = slices_of(state, data.axes, self.timestep_s)
        tell_falls(constants, data.log, self.end_s, before_m, went_m)
        state.distance_m += traction.ways_m(constants, before_m, went_m)
        drive.face(state, constants)
        # Hands close on what is there now; what is held makes other bodies.
        if handling.end_cycle(state, constants, contacts, self.end_s):
            data.physics.start_from(state.bodies)
        return slices, contacts

    def _begin_cycle(self) -> None:
        state = self.state
        state.cycle += 1
        state.drive.moved_m = np.zeros_like(state.drive.moved_m)  # the physics keeps the old array
        state.drive.slice[:] = 0.0
        state.drive.facing_rad[:] = state.heading_rad
        self._dispatcher.served = []

    # -- what there is -------------------------------------------------------------------------

    @property
    def state(self) -> EnvState:
        """All that changes; to be read by others, changed only here."""
        return self._data.state

    @property
    def world(self) -> WorldModel:
        """The world; it changes only when a robot is added or dismissed."""
        return self._data.world

    @property
    def world_now(self) -> WorldModel:
        """The world with what programs have put into it and taken out of it."""
        return self._data.world_now

    @property
    def names(self) -> tuple[str, ...]:
        """The names of all things: contacts number things by them."""
        return self._data.names

    @property
    def pushables(self) -> tuple[str, ...]:
        """The names of what can be pushed, in the order of the bodies behind the robots."""
        return self._data.pushables

    @property
    def things(self) -> tuple[Robot | Solid, ...]:
        """All things in the order of their names; the ground has a name only."""
        return self._data.constants.scene.things

    def outlines(self) -> tuple[Outlines, Outlines]:
        """Return the outlines of what never moves, and of the bodies where they are now."""
        scene, bodies = self._data.constants.scene, self.state.bodies
        return scene.fixed, scene.moving(bodies.position_m, bodies.angle_rad)

    @property
    def degradations(self) -> DegradationControl:
        """What is wrong with devices, to be read and changed between two steps."""
        return DegradationControl(self._data, self._data.log)

    @property
    def communication(self) -> CommunicationControl:
        """The links of messages, to be shut and opened between two steps, and counts."""
        return CommunicationControl(self._data)

    @property
    def timestep_s(self) -> float:
        """The length of a cycle [s]."""
        return self.world.timestep_s

    @property
    def time_s(self) -> float:
        """The start of the current cycle [s]."""
        return self._data.time_s

    @property
    def end_s(self) -> float:
        """The end of the current cycle [s], the start of the next."""
        return self._data.end_s

    @property
    def awaits(self) -> bool:
        """Whether robots are still to join, at a time that has not come yet."""
        return self._data.awaits

    def charges(self, number: int) -> tuple[float, float]:
        """Return what is left in the batteries of a robot's computers and motors, 0 to 1."""
        return self._data.charges(number)

    # -- changes between two steps: see `WorldData` --------------------------------------------

    def add_robot(self, robot: Robot) -> int:
        """Add a robot, which joins now or at its time; return its number."""
        return self._data.add_robot(robot)

    def remove_robot(self, number: int) -> None:
        """Remove a robot, or make sure that it never joins."""
        self._data.remove_robot(number)

    def dismiss_robot(self, number: int) -> None:
        """Make a robot leave at the end of the current cycle."""
        self._data.dismiss_robot(number)

    def carry(self, name: str, place: Pose) -> None:
        """Move a robot, or something that can be pushed, to another pose."""
        self._data.carry(name, place)

    def take_away(self, name: str) -> None:
        """Remove a thing that a robot can run into."""
        self._data.take_away(name)

    def charge(self, number: int, share: float) -> None:
        """Set the state of charge of the battery of a robot's motors, 0 to 1."""
        self._data.charge(number, share)

    def warm(self, name: str, heat: float) -> None:
        """Set the heat of a robot or a thing, 0 or more."""
        self._data.warm(name, heat)

    # -- snapshots -----------------------------------------------------------------------------

    def snapshot(self) -> Snapshot:
        """Return all that is needed to come back to this instant."""
        return self._data.snapshot(self._dispatcher.served)

    def restore(self, snapshot: Snapshot) -> None:
        """Go back to a snapshot of an environment with the same world and seed.

        Robots that had been added when it was made are there again, others are not.
        """
        self._data.restore(snapshot)
        self._dispatcher.served = list(snapshot.served)

    def hash(self) -> str:
        """Return the SHA-256 of the whole state."""
        return self.state.sha256()
