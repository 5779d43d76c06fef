"""State of the physics: bodies, the drives' motion in a cycle, and contacts."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.world import Pose
from crs_cc.sim.state.holds import Holds


@dataclass(slots=True)
class Bodies:
    """All movable bodies, in the order of `Scene`: the robots, then the movable objects.

    Attributes:
        position_m: shape (bodies, 2).
        angle_rad: shape (bodies,); for a robot, which is round, the mount's direction when any
            robot last held an object.
        velocity_mps: shape (bodies, 2).
        spin_radps: shape (bodies,).
        slipping: robots that contacts keep from the velocity of their wheels, (robots,).
        touching: robots with a contact in the last cycle, (robots,).
        settled: whether objects are at rest without pressing on others, shape (1,).
        holds: the objects that robots hold.
    """

    position_m: FloatArray
    angle_rad: FloatArray
    velocity_mps: FloatArray
    spin_radps: FloatArray
    slipping: BoolArray
    touching: BoolArray
    settled: BoolArray
    holds: Holds

    @classmethod
    def at_start(cls, scene: Scene) -> Self:
        """Return the bodies of a world before the first cycle."""
        count = len(scene.start)
        return cls(
            scene.start[:, :2].copy(),
            scene.start[:, 2].copy(),
            np.zeros((count, 2)),
            np.zeros(count),
            np.zeros(scene.robots, dtype=np.bool_),
            np.zeros(scene.robots, dtype=np.bool_),
            np.array([count == scene.robots]),
            Holds.nothing(scene.robots),
        )

    def take(self, rows: IndexArray) -> Self:
        """Return a selection of the bodies, including all robots."""
        robots = len(self.slipping)
        return type(self)(
            self.position_m[rows],
            self.angle_rad[rows],
            self.velocity_mps[rows],
            self.spin_radps[rows],
            self.slipping.copy(),
            self.touching.copy(),
            np.array([len(rows) == robots]),
            self.holds.renumbered(np.isin(np.arange(robots, len(self.angle_rad)), rows)),
        )

    def part(self, rows: IndexArray, robots: IndexArray) -> Self:
        """Return copies of some robots, which hold nothing, and of some objects.

        Args:
            rows: the bodies.
            robots: the first of them, which are robots.
        """
        return type(self)(
            self.position_m[rows],
            self.angle_rad[rows],
            self.velocity_mps[rows],
            self.spin_radps[rows],
            self.slipping[robots],
            self.touching[robots],
            self.settled.copy(),
            Holds.nothing(len(robots)),
        )

    def put(self, rows: IndexArray, robots: IndexArray, part: Self) -> None:
        """Copy the results of a part."""
        for name in ("position_m", "angle_rad", "velocity_mps", "spin_radps"):
            getattr(self, name)[rows] = getattr(part, name)
        self.slipping[robots], self.touching[robots] = part.slipping, part.touching
        self.settled[:] = part.settled

    def with_robot(self, start: Pose) -> Self:
        """Return a copy with one more robot, which is at rest."""
        robots = len(self.slipping)
        return type(self)(
            np.insert(self.position_m, robots, (start.x_m, start.y_m), axis=0),
            np.insert(self.angle_rad, robots, start.heading_rad),
            np.insert(self.velocity_mps, robots, 0.0, axis=0),
            np.insert(self.spin_radps, robots, 0.0),
            np.append(self.slipping, False),
            np.append(self.touching, False),
            self.settled,
            self.holds.with_another(),
        )

    def stop(self, robots: IndexArray) -> None:
        """Clear the velocities and contacts of robots."""
        self.velocity_mps[robots] = 0.0
        self.slipping[robots] = self.touching[robots] = False

    def copy(self) -> Self:
        """Return a deep copy."""
        return type(self)(*(getattr(self, field.name).copy() for field in fields(self)))


@dataclass(frozen=True, slots=True)
class Pull:
    """The motion commanded by the robots' drives in a cycle; immutable.

    Attributes:
        way_m: displacement of each robot by its wheels, in the world frame, (robots, 2).
        facing_rad: the rolling direction of its wheels, (robots,).
        limp: whether the motors are off, (robots,).
        mount_rad: direction of their mounts at the end of the cycle, (robots,); None if no robot
            holds an object.
        hand: x, y [m] and direction [rad] of their hands in the frame of the mount at the end of
            the cycle, (robots, 3); None if no robot has one.
    """

    way_m: FloatArray
    facing_rad: FloatArray
    limp: BoolArray
    mount_rad: FloatArray | None = None
    hand: FloatArray | None = None

    def part(self, robots: IndexArray) -> Self:
        """Return the motion of some robots, which hold nothing."""
        return type(self)(self.way_m[robots], self.facing_rad[robots], self.limp[robots])


@dataclass(frozen=True, slots=True)
class Contacts:
    """Contacts of robots in a cycle, one row for each robot and object, sorted by both.

    Attributes:
        robot: number of the robot.
        other: the touched object, an index into `Scene.names`.
        x_m: the contact point in the world frame.
        y_m: the contact point in the world frame.
        torn: robots from whose grippers an object was torn, rising.
    """

    robot: IndexArray
    other: IndexArray
    x_m: FloatArray
    y_m: FloatArray
    torn: IndexArray


_NOBODY: Final = np.zeros(0, np.intp)
NO_CONTACTS: Final = Contacts(_NOBODY, _NOBODY, np.zeros(0), np.zeros(0), _NOBODY)


@dataclass(frozen=True, slots=True)
class Ran:
    """A cycle in which objects were near enough to touch, so that the space was stepped; immutable.

    Attributes:
        cycle: its number, counted from the creation of the space.
        pull: the motion of the drives.
        bodies: the bodies before it; None if they were as the run of the cycle before left them.
        near: the robots among them, and what else they may have touched; None for all.
    """

    cycle: int
    pull: Pull
    bodies: Bodies | None
    near: IndexArray | None = None


@dataclass(frozen=True, slots=True)
class PhysicsSnapshot:
    """The state of a physics space apart from the bodies.

    Attributes:
        start: the bodies at its creation.
        cycles: number of cycles since then.
        ran: those in which it was stepped.
        room_m: a distance that every robot can move without coming near an object.
    """

    start: Bodies
    cycles: int
    ran: tuple[Ran, ...]
    room_m: float
