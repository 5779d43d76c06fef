"""The environment: the changing state of the world, cycle after cycle, for all robots at once.

In a cycle [k dt, (k + 1) dt), the session first passes on the programs' requests (`serve`), each
with its own time: the wheels of that robot are advanced to that time, then the command changes
their motion or the sensors are read. Then `step` ends the cycle: all wheels are advanced to its
end, which completes each robot's slice of the cycle; the physics moves the bodies along these
slices; contacts press bumpers; time advances. Cycles in which nothing can happen may be skipped
(`skip`): they are executed when the state is read, see `quiet_time`.

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

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, Records
from crs_cc.core.host_system import available_cores
from crs_cc.sim.comms.control import CommunicationControl
from crs_cc.sim.comms.message_log import take
from crs_cc.sim.devices import drive
from crs_cc.sim.devices.bumper.state import bumper_state
from crs_cc.sim.devices.degradation.control import DegradationControl
from crs_cc.sim.devices.drive.constants import Drives
from crs_cc.sim.devices.foraging import NestResult, SourceResult
from crs_cc.sim.devices.sensor_board import state_vector
from crs_cc.sim.engine.calm_time import CalmOutcome, CalmTime
from crs_cc.sim.engine.dispatch import Dispatcher
from crs_cc.sim.engine.goals import GoalResult
from crs_cc.sim.engine.motion import move
from crs_cc.sim.engine.quiet_time import catch_up, quiet_until
from crs_cc.sim.engine.step import Step
from crs_cc.sim.engine.world_data import Snapshot, WorldData
from crs_cc.sim.geometry.scene import Outlines
from crs_cc.sim.kernels.calm import CalmKernel
from crs_cc.sim.model.registry import device, devices
from crs_cc.sim.model.world import Pose, Robot, Solid, WorldModel
from crs_cc.sim.state.env_state import EnvState


class Environment:
    """A running world.

    Attributes:
        skips_quiet_time: whether cycles may be skipped; only tests switch it off.
    """

    skips_quiet_time = True

    def __init__(self, world: WorldModel, seed: int, threads: int | None = None) -> None:
        """Set up a world before its first cycle.

        Args:
            world: the world.
            seed: the random seed; not negative.
            threads: how many threads may measure at the same time; by default as many as there
                are processors. No result depends on it.

        Raises:
            ValueError: the seed is negative.
        """
        self._running = WorldData(world, seed, available_cores() if threads is None else threads)
        self._dispatcher = Dispatcher(self._running)
        self._skipped = 0  # cycles that are not executed yet
        self._quiet_until: int | None = None  # None: not known
        self._is_untouched = False  # since before the last cycle
        self._is_as_calm = False  # as calm time has left it

    @property
    def _data(self) -> WorldData:
        """The running world at the current time, to be read and changed."""
        self._catch_up()
        return self._running

    def _catch_up(self) -> None:
        """Execute the skipped cycles before something may change."""
        self._quiet_until, self._is_untouched, self._is_as_calm = None, False, False
        if self._skipped:
            skipped, self._skipped = self._skipped, 0
            self._running.is_weary = True  # charges fall meanwhile
            catch_up(self._running, skipped)

    # -- requests and time ---------------------------------------------------------------------

    def link_s(
        self, codes: npt.ArrayLike, robots: npt.ArrayLike = 0, sizes: npt.ArrayLike = 0
    ) -> FloatArray:
        """Return the time that requests take on the line between host and robot [s].

        Args:
            codes: the requests' codes.
            robots: their robots.
            sizes: bytes of their data.

        Returns:
            the times, in the broadcast shape of the three arguments.
        """
        data = self._running
        return data.line.time_s(data.state.link, codes, robots, sizes)

    def serve(
        self, code: int, robots: IndexArray, messages: Records, clock_s: FloatArray
    ) -> FloatArray:
        """Answer one kind of request of all robots that posted it.

        Invalid requests are refused (result 0) or clipped to the limits.

        Args:
            code: the request's code.
            robots: the robots, in ascending order, k of them.
            messages: their requests, of dtype `MESSAGE`; changed in place into the replies.
            clock_s: when each request reaches the robot, within the current cycle.

        Returns:
            the time at which each program continues, shape (k,): the current time, the end of a
            wait that ends in this cycle, or infinity for a longer wait, which a later `step`
            reports.
        """
        self._catch_up()
        return self._dispatcher.serve(code, robots, messages, clock_s)

    def calm_time(self, kernel: CalmKernel) -> CalmTime:
        """Return an object that runs cycles in a kernel, in turn with the programs."""
        return CalmTime(self._running, self._dispatcher, kernel)

    def begin_calm(self, calm: CalmTime, cycles: int, *, keeps: bool, most: FloatArray) -> bool:
        """Prepare calm time, if it is calm now, see `CalmTime.begin`; `end_calm` is to follow."""
        is_new = bool(self._skipped) or not self._is_as_calm
        self._catch_up()
        return calm.begin(cycles, is_new=is_new, keeps=keeps, most=most)

    def end_calm(self, calm: CalmTime) -> CalmOutcome:
        """Take over what has happened in calm time, and return it."""
        outcome = calm.end()
        self._is_untouched, self._is_as_calm = outcome.is_untouched, True
        return outcome

    def step(self, *, tells_slices: bool = True) -> Step:
        """End the cycle; return what happened in it and which waits end in the next.

        Args:
            tells_slices: whether the result has the slices of motion commands.
        """
        data = self._data
        state, end_s, time_s = data.state, data.end_s, data.time_s
        present = state.presence.present.nonzero()[0]
        data.advance_to(present, np.full(len(present), end_s))
        data.rolling.add(state, data.constants)
        slices, contacts, empty = move(data, tells_slices=tells_slices)
        # Motors without power are limp from the next cycle on.
        if empty:
            drive.go_limp(state, data.constants, np.array(empty))
        # Contacts use the numbers of objects before robots join or leave below.
        now, names = bumper_state(state).pressed, data.names
        before = now.copy()
        began = data.devices.bumpers.touch(state, data.constants, contacts, end_s)
        changed = now ^ before
        # Degradations that begin are logged before the devices' work at the end of the cycle.
        cycle, served = state.cycle, tuple(self._dispatcher.served)
        if state.degradation.next_s < end_s:
            self.degradations.log_changes(end_s)
        data.devices.end_cycle(state, data.constants, time_s, end_s)
        data.goals.judge(state, began, end_s, data.log)
        traffic = take(state.messages)
        self._begin_cycle()
        # Part of the next cycle: waits that end in it, and robots that join or leave at its start.
        ended, at_s, messages = self._dispatcher.end_waits()
        is_due = data.has_pending_joins()
        if is_due:
            data.update_roster()
        self._is_untouched = not (served or len(ended) or is_due)
        return Step(
            cycle=cycle,
            time_s=time_s,
            robots=ended,
            at_s=at_s,
            messages=messages,
            contacts=began,
            pressed=changed & now,
            released=changed & before,
            names=names,
            slices=slices,
            served=served,
            events=data.log.take(end_s),
            traffic=traffic,
            posted=data.devices.messenger.take_posted(),
        )

    @property
    def is_quiet(self) -> bool:
        """Whether nothing can happen in this cycle without a request, see `quiet_until`."""
        return self._is_untouched and self.quiet_until() > self._running.state.cycle

    def quiet_until(self) -> int:
        """Return the number of a cycle before which nothing can happen without a request.

        The current cycle if something can happen in it, or if the state may have been changed
        since a whole cycle was executed.
        """
        if not (self._is_untouched and self.skips_quiet_time):
            return self.cycle
        if self._quiet_until is None:
            self._quiet_until = quiet_until(self._running)
        return self._quiet_until

    def skip(self, cycles: int) -> None:
        """Advance by cycles before `quiet_until`, without notifying listeners."""
        self._running.state.cycle += cycles
        self._skipped += cycles

    def _begin_cycle(self) -> None:
        self._running.state.cycle += 1
        self._dispatcher.served = []

    # -- contents ------------------------------------------------------------------------------

    @property
    def state(self) -> EnvState:
        """The mutable state; to be read by others, changed only here."""
        return self._data.state

    @property
    def last_state(self) -> EnvState:
        """The state since the last cycle that was executed, for callers that only read what moves.

        Nothing moves in skipped cycles; timers and what they fill are not up to date.
        """
        return self._running.state

    def last_readings(self, rows: IndexArray) -> Int32Array:
        """Return `State` of robots after the last cycle that was executed, shape (k, 45)."""
        return state_vector(self._running.state, self._running.constants, rows)

    @property
    def world(self) -> WorldModel:
        """The world; it changes only when a robot is added or dismissed."""
        return self._running.world

    @property
    def world_now(self) -> WorldModel:
        """The world with the obstacles that programs have added and removed."""
        return self._data.world_now

    @property
    def names(self) -> tuple[str, ...]:
        """The names of all objects: contacts refer to objects by index into them."""
        return self._running.names

    @property
    def pushables(self) -> tuple[str, ...]:
        """The names of pushable objects, in the order of the bodies after the robots."""
        return self._running.pushables

    @property
    def objects(self) -> tuple[Robot | Solid, ...]:
        """All objects in the order of their names; the ground has a name only."""
        return self._data.constants.scene.objects

    def outlines(self) -> tuple[Outlines, Outlines]:
        """Return the outlines of what never moves, and of the bodies where they are now."""
        scene, bodies = self._data.constants.scene, self.state.bodies
        return scene.fixed, scene.moving(bodies.position_m, bodies.angle_rad)

    @property
    def degradations(self) -> DegradationControl:
        """The degradations of devices, to be read and changed between two steps."""
        return DegradationControl(self, self._data.log)

    @property
    def goals(self) -> tuple[GoalResult, ...]:
        """The current status of the goals."""
        return self._data.goals.results(self.state)

    @property
    def sources(self) -> tuple[SourceResult, ...]:
        """The current status of the sources."""
        return self._data.devices.foraging.sources(self.state)

    @property
    def nests(self) -> tuple[NestResult, ...]:
        """The current status of the nests."""
        return self._data.devices.foraging.nests(self.state)

    @property
    def communication(self) -> CommunicationControl:
        """The communication links, to be shut and opened between two steps, and counts."""
        return CommunicationControl(self)

    @property
    def cycle(self) -> int:
        """The number of the current cycle, from 0."""
        return self._running.state.cycle

    @property
    def present(self) -> BoolArray:
        """Which robots are in the world; replaced whenever that changes, see `PresenceState`."""
        return self._running.state.presence.present

    @property
    def timestep_s(self) -> float:
        """The length of a cycle [s]."""
        return self.world.timestep_s

    @property
    def time_s(self) -> float:
        """The start of the current cycle [s]."""
        return self._running.time_s

    @property
    def end_s(self) -> float:
        """The end of the current cycle [s], the start of the next."""
        return self._running.end_s

    @property
    def expects_robots(self) -> bool:
        """True if robots are still to join in the future."""
        return self._running.expects_robots

    @property
    def drives(self) -> Drives:
        """The constants of all drives."""
        return self._running.constants.drives

    def charges(self, number: int) -> tuple[float, float]:
        """Return the state of charge of a robot's computer and motor batteries, 0 to 1."""
        return self._data.charges(number)

    def device_number(self, name: str, robot: int) -> int:
        """Return the number of a robot's device among all of its kind; -1 without one."""
        return int(self._data.constants.numbers[name][robot])

    def field(self, name: str) -> FloatArray:
        """Return all amounts of a pheromone field, by rows from the smallest y, (rows, columns)."""
        fields = self._data.devices.fields
        return fields.picture(self.state, fields.number(name))

    def field_sketch(self, name: str, most: int) -> tuple[FloatArray, float]:
        """Return a coarse picture of a pheromone field, see `Fields.sketch`."""
        fields = self._data.devices.fields
        return fields.sketch(self.state, fields.number(name), most)

    def device_rows(self, number: int) -> list[tuple[str, str]]:
        """Return name and state of each device of a robot, for inspectors."""
        numbers = self._data.constants.numbers
        return [
            (row.name, row.inspect(self.state, numbers[row.name][number]))
            for row in devices()
            if row.inspect is not None and numbers[row.name][number] >= 0
        ]

    # -- robots without a program --------------------------------------------------------------

    def drive(self, robots: IndexArray, speed: FloatArray) -> None:
        """Set the speeds of robots' axes now, as `vm` does, with no resolution and no link.

        Args:
            robots: the robots, in ascending order, k of them.
            speed: of each axis [m/s or rad/s], clipped to its limit, (k, 3).
        """
        data, state = self._data, self.state
        at_s = np.maximum(state.drive.clock_s[robots], self.time_s)
        if (state.drive.clock_s[robots] != at_s).any():  # some may be in the middle of a cycle
            data.advance_to(robots, at_s)
        drive.renew_deadline(state, robots)
        drive.run_at(state, data.constants, robots, speed)
        state.commands[robots] += 1
        data.go_limp_if_empty(robots, at_s)

    def measure(self, device: str, robots: IndexArray) -> None:
        """Measure with a device of robots now, at most at its rate; sonars measure by themselves.

        Args:
            device: its name.
            robots: robots that have it, in ascending order.
        """
        data, timed = self._data, self._running.devices.installed[device].timed
        if timed is not None:
            at_s = np.full(len(robots), self.time_s)
            timed.read(self.state, data.constants, data.rays, robots, at_s)

    def device_numbers(self, name: str) -> IndexArray:
        """Return each robot's number among those with a device, -1 without it, (robots,)."""
        return self._running.constants.numbers[name]

    def reading(self, name: str, robot: int) -> npt.NDArray[np.generic] | None:
        """Return the last reading of a robot's device [SI unit], see `Device.reading`.

        None if there is no such device, or the robot does not have it.
        """
        numbers = self._data.constants.numbers
        if name not in numbers:
            return None
        row, number = device(name), int(numbers[name][robot])
        if row.reading is None or number < 0:
            return None
        model = self.world.robots[robot].model.device(name)
        return row.reading(self.state, model, robot if row.dense else number)

    # -- changes between two steps: see `WorldData` --------------------------------------------

    def add_robot(self, robot: Robot) -> int:
        """Add a robot, which joins now or at its time; return its number."""
        return self._data.add_robot(robot)

    def admit_robots(self, numbers: Sequence[int]) -> None:
        """Let robots join now that are to join later."""
        self._data.admit_robots(numbers)

    def delay_robots(self, numbers: Sequence[int]) -> None:
        """Start again without some robots, which join when they are admitted."""
        self._data.delay_robots(numbers)

    def remove_robot(self, number: int) -> None:
        """Remove a robot, or make sure that it never joins."""
        self._data.remove_robot(number)

    def dismiss_robot(self, number: int) -> None:
        """Make a robot leave at the end of the current cycle."""
        self._data.dismiss_robot(number)

    def teleport(self, name: str, place: Pose) -> None:
        """Move a robot or a pushable object to another pose."""
        self._data.teleport(name, place)

    def remove_obstacle(self, name: str) -> None:
        """Remove an obstacle."""
        self._data.remove_obstacle(name)

    def charge(self, number: int, share: float) -> None:
        """Set the state of charge of a robot's motor battery, 0 to 1."""
        self._data.charge(number, share)

    def set_heat(self, name: str, heat: float) -> None:
        """Set the heat of a robot or an object, 0 or more."""
        self._data.set_heat(name, heat)

    def set_evaporation(self, field: str, evaporation_s: float) -> None:
        """Set the evaporation time of a pheromone field, infinite for never."""
        fields = self._data.devices.fields
        fields.set_evaporation(self.state, fields.number(field), evaporation_s)

    # -- snapshots -----------------------------------------------------------------------------

    def snapshot(self) -> Snapshot:
        """Return all that is needed to come back to this time."""
        return self._data.snapshot(self._dispatcher.served)

    def restore(self, snapshot: Snapshot) -> None:
        """Go back to a snapshot of an environment with the same world and seed.

        Robots that had been added before the snapshot are present again, later ones are not.
        """
        self._data.restore(snapshot)
        self._dispatcher.served = list(snapshot.served)

    def hash(self) -> str:
        """Return the SHA-256 of the whole state."""
        return self.state.sha256()
