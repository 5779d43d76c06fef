"""What the physics works on: bodies, what drives them in a cycle, and what they touched in it."""

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
    """Everything that moves, in the order of `Scene`: the robots, then what can be pushed.

    Attributes:
        position_m: shape (bodies, 2).
        angle_rad: shape (bodies,); that of a robot, which is round, is where its mount pointed when
            any robot held something last.
        velocity_mps: shape (bodies, 2).
        spin_radps: shape (bodies,).
        slipping: robots that something held back from the velocity of their wheels, (robots,).
        touching: robots that touched anything in the last cycle, (robots,).
        settled: whether things rest without pressing into anything, shape (1,).
        holds: which things robots hold.
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
        """Return some of the bodies, all robots among them; the others are gone."""
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

    def with_robot(self, start: Pose) -> Self:
        """Return the same with a further robot, which rests."""
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
        """Takes from robots what motion and contacts they have."""
        self.velocity_mps[robots] = 0.0
        self.slipping[robots] = self.touching[robots] = False

    def copy(self) -> Self:
        """Return a copy that shares nothing."""
        return type(self)(*(getattr(self, field.name).copy() for field in fields(self)))


@dataclass(frozen=True, slots=True)
class Pull:
    """What the drives of the robots do in a cycle; never changed.

    Attributes:
        way_m: the way that each robot's wheels take it, in the world frame, (robots, 2).
        facing_rad: the direction in which its wheels roll, (robots,).
        limp: whether nothing drives or holds them, (robots,).
        mount_rad: where their mounts point at the end of the cycle, (robots,); None when nobody
            holds anything.
        hand: x, y [m] and direction [rad] of their hands in the frame of the mount at the end of
            the cycle, (robots, 3); None when no robot has one.
    """

    way_m: FloatArray
    facing_rad: FloatArray
    limp: BoolArray
    mount_rad: FloatArray | None = None
    hand: FloatArray | None = None


@dataclass(frozen=True, slots=True)
class Contacts:
    """What robots touched in a cycle, one row for each robot and thing, sorted by both.

    Attributes:
        robot: number of the robot.
        other: what it touched, an index into `Scene.names`.
        x_m: where, in the world frame.
        y_m: the same.
        torn: robots out of whose fingers something was torn, rising.
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
    """A cycle in which something was near enough to touch, so that the space ran; never changed.

    Attributes:
        cycle: how many cycles after the space was made it was.
        pull: what the drives did.
        bodies: as they were before; None where they were as the run of the cycle before left them.
    """

    cycle: int
    pull: Pull
    bodies: Bodies | None


@dataclass(frozen=True, slots=True)
class PhysicsSnapshot:
    """What there is to know of a space beside the bodies.

    Attributes:
        start: the bodies when it was made.
        cycles: how many cycles ago.
        ran: those in which it ran.
        room_m: a distance that no robot can use up before something is near it.
    """

    start: Bodies
    cycles: int
    ran: tuple[Ran, ...]
    room_m: float
