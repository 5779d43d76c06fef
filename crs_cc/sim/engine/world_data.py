"""A world's state with all that is derived from it, rebuilt when that changes.

A snapshot contains only the state. What is derived from the set of robots (their constants and
devices), and from the poses of objects (outlines, physics), is rebuilt when a robot joins or
leaves, a program adds an obstacle, or a snapshot is restored.

>>> from crs_cc.sim.model.world import Pose, Robot
>>> from crs_cc.sim.files.world_xml import empty_world
>>> data = WorldData(empty_world(), seed=1)
>>> scout = data.world.robots[0].model
>>> data.add_robot(Robot("late", scout, Pose(2.0, 0.0)))
1
>>> data.remove_robot(0)
>>> data.state.presence.present.tolist()
[False, True]
>>> data.add_robot(Robot("later", scout, Pose(2.1, 0.0)))
Traceback (most recent call last):
ValueError: robot 'later' cannot join: it would overlap 'late'
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.core.suggest import unknown
from crs_cc.core.time_grid import ROUNDING_S
from crs_cc.sim.devices import drive
from crs_cc.sim.devices.drive.rolling import RollingNoise
from crs_cc.sim.devices.ray_caster import RayCaster
from crs_cc.sim.devices.robot_constants import RobotConstants
from crs_cc.sim.devices.serial_link import SerialLine
from crs_cc.sim.engine.device_board import DeviceBoard
from crs_cc.sim.engine.goal_floor import Floor
from crs_cc.sim.engine.goals import GoalJudge
from crs_cc.sim.engine.handlers import handlers_of, simple_commands, waits_of
from crs_cc.sim.engine.roster import Timetable, leave, obstructing_object, validation_error
from crs_cc.sim.engine.step import Served
from crs_cc.sim.engine.teleport import teleport_object, teleport_robot
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.geometry.shape_table import ShapeTable
from crs_cc.sim.kernels.tables import ADVANCED
from crs_cc.sim.model.world import Pose, Robot, WorldModel
from crs_cc.sim.physics.simulation import Physics
from crs_cc.sim.state.add_row import grown
from crs_cc.sim.state.bodies import PhysicsSnapshot
from crs_cc.sim.state.env_state import EnvState
from crs_cc.sim.state.events import Event, EventLog
from crs_cc.sim.state.obstacles import without
from crs_cc.sim.state.rows import ALL
from crs_cc.sim.state.snapshot_codec import Packed, packed


@dataclass(frozen=True, slots=True)
class Snapshot:
    """Everything that an environment needs to continue from a time; never changed."""

    world: WorldModel
    state: Packed
    physics: PhysicsSnapshot
    served: tuple[Served, ...]
    events: tuple[Event, ...]


class WorldData:
    """A world with its state.

    Attributes:
        world: the world; it changes only when a robot is added.
        state: the mutable state.
        log: receives all events besides requests.
        constants: the constants of all robots and objects.
        devices: the robots' devices.
        handlers: the handler of each request, by code.
        waits: the waits of requests, by code.
        simple: the requests that kernels can answer, see `simple_commands`.
        bumpers: the switches of the robots' bumpers.
        rolling: random errors of the wheels.
        line: the serial lines between hosts and robots.
        axes: the names of each robot's axes.
        names: the names of all objects: contacts refer to objects by index into them.
        physics: moves the bodies.
        rays: casts the rays of all sensors.
        goals: judges the goals.
        is_weary: whether a motor battery may be empty before the end of this cycle.
    """

    def __init__(self, world: WorldModel, seed: int, threads: int = 1) -> None:
        """Set up a world before its first cycle.

        Args:
            world: the world.
            seed: the random seed; not negative.
            threads: how many threads may measure at the same time.

        Raises:
            ValueError: the seed is negative.
        """
        if seed < 0:
            raise ValueError(f"the seed must not be negative: {seed}")
        self._seed, self._threads = seed, threads
        self.log = EventLog()
        self._packed: Packed | None = None
        self.is_weary = True
        self._floor = Floor(world)
        self._start(world)

    def _start(self, world: WorldModel) -> None:
        """Set up the state of a world before its first cycle."""
        self.state = EnvState.at_start(world)
        self._build_robot_data(world)
        self._begin(np.flatnonzero(self.state.presence.present))

    @property
    def world_now(self) -> WorldModel:
        """Return the world with the obstacles that programs have added and removed."""
        return self.state.obstacles.world_now(self.world)

    @property
    def pushables(self) -> tuple[str, ...]:
        """Return the names of pushable objects, in the order of the bodies after the robots."""
        first = len(self.world.robots)
        return self.names[first : len(self.state.bodies.angle_rad)]

    @property
    def _robot_ids(self) -> tuple[str, ...]:
        return self.names[: len(self.world.robots)]

    @property
    def timestep_s(self) -> float:
        """Return the length of a cycle [s]."""
        return self.world.timestep_s

    @property
    def time_s(self) -> float:
        """Return the start of the current cycle [s]."""
        return self.state.cycle * self.timestep_s

    @property
    def end_s(self) -> float:
        """Return the end of the current cycle [s], the start of the next."""
        return (self.state.cycle + 1) * self.timestep_s

    @property
    def expects_robots(self) -> bool:
        """Return whether robots are still to join in the future."""
        return self._timetable.has_pending_joins(self.state.presence, self.time_s)

    def add_robot(self, robot: Robot) -> int:
        """Add a robot to the world, between two cycles; return its number.

        Args:
            robot: the robot; it joins now, or at its time if that comes later.

        Raises:
            ValueError: it is invalid, or its place is occupied.
        """
        wrong = validation_error(robot, self.names, self.time_s)
        if not wrong and robot.join_s <= self.time_s:
            obj = obstructing_object(self.state, self.constants, robot.start, robot.model.radius_m)
            wrong = f"it would overlap {obj}" if obj else ""
        if wrong:
            raise ValueError(f"robot {robot.id!r} cannot join: {wrong}")
        world = replace(self.world, robots=(*self.world.robots, robot))
        self.state = grown(self.state, world)
        self._build_robot_data(world)
        self.update_roster()
        return len(world.robots) - 1

    def remove_robot(self, number: int) -> None:
        """Remove a robot from the world, or cancel its joining, between two cycles.

        Raises:
            ValueError: the robot does not exist, or has already left.
        """
        if not 0 <= number < len(self.world.robots):
            raise ValueError(f"no robot number {number}")
        if np.isfinite(self.state.presence.left_s[number]):
            raise ValueError(f"robot {self.world.robots[number].id!r} has already left")
        leave(self.state, np.array([number]), self.time_s, self.log)
        self.update_roster()

    def admit_robots(self, numbers: Sequence[int]) -> None:
        """Let robots join now that are to join later, or when their place is free, between cycles.

        Raises:
            ValueError: a robot does not exist, has joined, or has left.
        """
        robots, presence = list(self.world.robots), self.state.presence
        for number in numbers:
            if not 0 <= number < len(robots):
                raise ValueError(f"no robot number {number}")
            for done, times_s in (("left", presence.left_s), ("joined", presence.joined_s)):
                if np.isfinite(times_s[number]):
                    raise ValueError(f"robot {robots[number].id!r} has already {done}")
            robots[number] = replace(robots[number], join_s=self.time_s)
        self._build_robot_data(replace(self.world, robots=tuple(robots)))
        self.update_roster()

    def delay_robots(self, numbers: Sequence[int]) -> None:
        """Start again without some robots, which join when they are admitted.

        Raises:
            ValueError: a robot does not exist, or something has happened already.
        """
        robots = list(self.world.robots)
        for number in numbers:
            if not 0 <= number < len(robots):
                raise ValueError(f"no robot number {number}")
            robots[number] = replace(robots[number], join_s=np.inf)
        if self.state.sha256() != type(self)(self.world, self._seed).state.sha256():
            raise ValueError("robots can be delayed only at the start of a run")
        self._start(replace(self.world, robots=tuple(robots)))

    def dismiss_robot(self, number: int) -> None:
        """Make a robot leave at the end of the current cycle; may be called at any time in it.

        Raises:
            ValueError: it has already left.
        """
        if np.isfinite(self.state.presence.left_s[number]):
            raise ValueError(f"robot {self.world.robots[number].id!r} has already left")
        robots = list(self.world.robots)
        robots[number] = replace(robots[number], leave_s=self.end_s)
        self._build_robot_data(replace(self.world, robots=tuple(robots)))

    def teleport(self, name: str, place: Pose) -> None:
        """Move a robot or a pushable object to another pose.

        A robot is turned as a whole, without a change of its odometry; see `teleport`.

        Raises:
            ValueError: the pose is not free, or the object cannot be moved.
        """
        number = self.names.index(name) if name in self.names else -1
        if number in range(len(self.world.robots)):
            self._demand_presence(number)
            obj = teleport_robot(self.state, self.constants, number, place)
        else:
            if wrong := self._immovable(name):
                raise ValueError(wrong)
            obj = teleport_object(self.state, self.constants, number, place)
        if obj:
            raise ValueError(f"cannot move {name!r}: it would overlap {obj}")
        self.rebuild_scene_data(moved=True)

    def remove_obstacle(self, name: str) -> None:
        """Remove an obstacle from the world.

        Raises:
            ValueError: it does not exist, or is the edge of the world or a robot.
        """
        self.state.obstacles = without(self.state.obstacles, self.world, name)
        self.rebuild_scene_data(moved=False)

    def charges(self, number: int) -> tuple[float, float]:
        """Return the state of charge of a robot's computer and motor batteries, 0 to 1."""
        rows = np.array([number], dtype=np.intp)
        batteries, now_s = self.devices.sensor_board.batteries, np.array([self.time_s])
        left = batteries.left(self.state, self.constants, rows, now_s)
        computers, motors = left[0].tolist()
        return computers, motors

    def charge(self, number: int, share: float) -> None:
        """Set the state of charge of a robot's motor battery, 0 to 1.

        Raises:
            ValueError: the battery is unlimited, or the robot is not in the world.
        """
        self._demand_presence(number)
        self.is_weary = True
        batteries = self.devices.sensor_board.batteries
        batteries.charge(self.state, self.constants, number, at_s=self.time_s, share=share)

    def set_heat(self, name: str, heat: float) -> None:
        """Set the heat of a robot or an object, 0 or more."""
        self.state.heat.left[self.names.index(name)] = heat

    def snapshot(self, served: Sequence[Served]) -> Snapshot:
        """Return all that is needed to come back to this time."""
        physics, events = self.physics.snapshot(), self.log.snapshot()
        self._packed = packed(self.state, like=self._packed)
        return Snapshot(self.world, self._packed, physics, tuple(served), events)

    def restore(self, snapshot: Snapshot) -> None:
        """Go back to a snapshot of an environment with the same world and seed.

        Robots that had been added before the snapshot are present again, later ones are not.
        """
        before, self.state = self.state, snapshot.state.state()
        self.is_weary = True
        self.state.replace(before)
        if snapshot.world is not self.world:
            self._build_robot_data(snapshot.world)
        elif not self._has_same_objects():
            self._build_scene_data(Scene(self.world_now, self.state.presence.present))
        self._due_s = self._timetable.due_s(self.state.presence)
        self.physics.restore(snapshot.physics)
        self.log.restore(snapshot.events)
        self.rays.forget()

    def advance_to(self, rows: IndexArray, to_s: FloatArray, *, renews: bool = False) -> None:
        """Fire timers and turn the wheels of robots, up to times in this cycle.

        Args:
            rows: which robots, rising, k of them.
            to_s: the time of each, not before the last one, (k,).
            renews: whether their command timeouts restart then.
        """
        state, constants = self.state, self.constants
        last_s = constants.last_time_s(state.cycle)
        some = ALL if len(rows) == len(state.drive.clock_s) else rows
        done = drive.advance_freely(state, constants, some, to_s, last_s, renews=renews)
        if done == ADVANCED:
            return
        # Sensors measure during the motion of the wheels, so before that is advanced.
        self.devices.advance(state, constants, self.rays, rows, to_s)
        drive.advance(state, constants, some, to_s)
        if renews:
            drive.renew_deadline(state, rows)

    def go_limp_if_empty(self, rows: IndexArray, at_s: FloatArray) -> None:
        """Make the axes of robots with empty batteries limp."""
        batteries = self.devices.sensor_board.batteries
        if not (self.is_weary and len(rows)) or batteries.last:
            return
        empty = rows[batteries.empty(self.state, self.constants, rows, at_s)]
        if len(empty):
            drive.go_limp(self.state, self.constants, empty)

    def _demand_presence(self, number: int) -> None:
        if not self.state.presence.present[number]:
            raise ValueError(f"robot {self._robot_ids[number]!r} is not in the world")

    def _immovable(self, name: str) -> str:
        """Return why an object cannot be moved; empty if it can."""
        if name not in self.pushables:
            return unknown("robot or movable object", name, (*self._robot_ids, *self.pushables))
        number = self.pushables.index(name)
        if self.constants.scene.pushables[number].part_of:
            return f"{name!r} is part of {self.constants.scene.pushables[number].part_of!r}"
        holders = np.flatnonzero((self.state.bodies.holds.object == number).any(axis=1)).tolist()
        return f"{self._robot_ids[holders[0]]!r} holds {name!r}" if holders else ""

    def _build_robot_data(self, world: WorldModel) -> None:
        """Build all that is derived from the set of robots."""
        self.world, self.is_weary = world, True
        self.constants = RobotConstants.of(world, self._seed)
        self.rolling = RollingNoise(world, self._seed)
        self.devices = DeviceBoard(world, self._seed, self.log)
        self.handlers = handlers_of(self.devices)
        self.waits = waits_of(self.devices)
        self.simple = simple_commands(self.devices, self.constants.numbers)
        self.axes = tuple(robot.model.drive.axis_names for robot in world.robots)
        self.line = SerialLine(world)
        self._timetable = Timetable(world)
        self._due_s = self._timetable.due_s(self.state.presence)
        self._build_scene_data(Scene(self.world_now, self.state.presence.present))

    def _build_scene_data(self, scene: Scene) -> None:
        """Build all that is derived from the scene."""
        self._furnished = self.state.obstacles, self.state.presence.present
        self.names = scene.names
        self.constants = replace(self.constants, scene=scene, shapes=ShapeTable.of(scene))
        self.physics = Physics(scene.world, scene, self.state.bodies)
        self.rays = RayCaster(scene, self.devices.fans, self._threads)
        self.goals = GoalJudge(self.world, self.names, self.constants, self._floor)

    def rebuild_scene_data(self, moved: bool) -> None:
        """Rebuild it if objects were added or removed, or a robot was moved."""
        if self._has_same_objects():
            if moved:
                self.physics.start_from(self.state.bodies)
                self.rays.forget()
            return
        scene = Scene(self.world_now, self.state.presence.present)
        if scene.names != self.names:
            self.state.renumber(self.names, scene.names)
        self._build_scene_data(scene)

    def _has_same_objects(self) -> bool:
        """Return whether the scene still has the same objects."""
        obstacles, present = self._furnished
        same = np.array_equal(self.state.presence.present, present)
        return same and self.state.obstacles.same_as(obstacles)

    @property
    def due_s(self) -> float:
        """Return the time of the next join or leave, infinite for never."""
        return self._due_s

    def has_pending_joins(self) -> bool:
        """Return whether it is time for a robot to join or to leave."""
        return self.time_s >= self._due_s - ROUNDING_S

    def update_roster(self) -> None:
        """Remove and add the robots whose time to leave or to join has come."""
        self.is_weary = True
        now_s = self.time_s
        self._timetable.leave(self.state, now_s, self.log)
        joined = self._timetable.join(self.state, self.constants, now_s, self.log)
        self.rebuild_scene_data(moved=False)
        self._begin(joined)
        self._due_s = self._timetable.due_s(self.state.presence)

    def _begin(self, rows: IndexArray) -> None:
        """Start the devices of robots that are new in the world."""
        if len(rows):
            self.devices.begin(self.state, self.constants, self.rays, rows, self.time_s)
